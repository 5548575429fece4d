//! Frames: loose shafts are refused by name, wrong input is refused, solved frames are in equilibrium on
//! their laws.

use super::power_joint;
use fem::element::BeamPiece;
use fem::joint::Joint;
use fem::solve::frame::{Frame, FrameError, SolveError, SupportKind};

const PIECE: BeamPiece = BeamPiece { length: 0.1, flexural_rigidity: 26.4e3, shear_rigidity: 9e7 };

fn shaft() -> Frame {
    Frame::new(&[PIECE; 6]).unwrap()
}

fn joint() -> Joint {
    power_joint(f64::INFINITY, 0.2e-6, 0.5)
}

type Build = fn(Frame) -> Result<Frame, FrameError>;

#[test]
fn loose_shafts_are_named() {
    let table: [(Build, &str); 9] = [
        (Ok, "shaft is free to translate and to rotate: it has no support"),
        (|f| f.rotational_spring(3, 1e5), "shaft is free to translate"),
        (|f| f.fix_rotation(3), "shaft is free to translate"),
        (|f| f.fix_rotation(3)?.translational_spring(0, 0.0), "shaft is free to translate"),
        (|f| f.translational_spring(0, 6e7), "shaft is free to rotate about x = 0 m"),
        (|f| f.fix_translation(6), "shaft is free to rotate about x = 0.6 m"),
        (|f| f.joint(3, joint()), "shaft is free to rotate about x = 0.3 m"),
        (|f| f.translational_spring(3, 1e7)?.joint(3, joint()), "shaft is free to rotate about x = 0.3 m"),
        (|f| f.translational_spring(3, 1e7)?.translational_spring(6, 0.0), "shaft is free to rotate about x = 0.3 m"),
    ];
    for (supports, message) in table {
        let error = supports(shaft()).unwrap().solve(&[(2, 500.0)]).unwrap_err();
        assert_eq!(error.to_string(), message);
    }
    let held: [Build; 4] = [
        |f| f.fix_translation(0)?.fix_rotation(4),
        |f| f.rotational_spring(0, 1e5)?.translational_spring(3, 1e7),
        |f| f.joint(0, joint())?.joint(6, joint()),
        |f| f.joint(0, joint())?.fix_rotation(0),
    ];
    for supports in held {
        assert!(supports(shaft()).unwrap().solve(&[(2, 500.0)]).is_ok());
    }
}

#[test]
fn wrong_input_is_refused() {
    assert_eq!(Frame::new(&[]).unwrap_err(), FrameError::NoPieces);
    for (length, flexural_rigidity, shear_rigidity) in [
        (0.0, 1.0, 1.0),
        (-1.0, 1.0, 1.0),
        (f64::INFINITY, 1.0, 1.0),
        (1.0, f64::INFINITY, 1.0),
        (1.0, -1.0, 1.0),
        (1.0, 1.0, 0.0),
        (1.0, 1.0, f64::NAN),
    ] {
        let piece = BeamPiece { length, flexural_rigidity, shear_rigidity };
        assert!(matches!(Frame::new(&[PIECE, piece]), Err(FrameError::Piece { piece: 1, .. })), "{piece:?}");
    }
    let table: [(Build, &str); 6] = [
        (|f| f.fix_translation(7), "there is no node 7: the shaft has nodes 0 to 6"),
        (|f| f.translational_spring(0, -1.0), "node 0: a spring stiffness must not be negative, not -1"),
        (|f| f.rotational_spring(0, f64::NAN), "node 0: a spring stiffness must not be negative, not NaN"),
        (|f| f.fix_translation(0)?.fix_translation(0), "node 0 is fixed and has another support in the same direction"),
        (|f| f.fix_translation(0)?.joint(0, joint()), "node 0 is fixed and has another support in the same direction"),
        (
            |f| f.rotational_spring(0, 1.0)?.fix_rotation(0),
            "node 0 is fixed and has another support in the same direction",
        ),
    ];
    for (supports, message) in table {
        assert_eq!(supports(shaft()).unwrap_err().to_string(), message);
    }
    let held = shaft().fix_translation(0).unwrap().joint(6, joint()).unwrap();
    assert_eq!(held.solve(&[(9, 1.0)]).unwrap_err(), SolveError::UnknownNode { node: 9, last: 6 });
    assert!(matches!(held.solve(&[(1, f64::NAN)]).unwrap_err(), SolveError::Load { node: 1, .. }));
    assert_eq!(held.factor().err(), Some(SolveError::Nonlinear));
}

/// A linear congruential generator: the tables below need variety, not quality.
struct Lcg(u64);

impl Lcg {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn pick(&mut self, values: &[f64]) -> f64 {
        values[(self.unit() * values.len() as f64) as usize]
    }
}

/// Shafts on three and more joints of any kind, pressed and pulled: balance and every joint on its law.
#[test]
fn random_frames_on_joints_converge() {
    let mut random = Lcg(1);
    let (mut most, mut pulled) = (0, 0);
    // of the whole shaft, L³/EI (m/N)
    let flexibility = 0.6_f64.powi(3) / PIECE.flexural_rigidity;
    for case in 0..600 {
        let elements = 12 * random.pick(&[1.0, 3.0, 15.0]) as usize;
        let piece = BeamPiece { length: 0.6 / elements as f64, ..PIECE };
        let mut frame = Frame::new(&vec![piece; elements]).unwrap();
        let mut laws = Vec::new();
        for place in [0, 2, 3, 4, 6] {
            let law = power_joint(
                random.pick(&[f64::INFINITY, 1e9, 4e7, 1e5]),
                random.pick(&[0.0, 1e-9, 0.2e-6, 5e-6]),
                random.pick(&[0.1, 0.3, 0.5, 0.7, 1.0]),
            );
            let needed = place == 0 || place == 6;
            if needed || random.unit() < 0.4 {
                frame = frame.joint(place * elements / 6, law.clone()).unwrap();
                laws.push(law);
            }
        }
        let size = random.pick(&[1e-9, 1e-3, 1.0, 500.0, 1e6]);
        let loads: Vec<_> = (0..2)
            .map(|load| {
                let node = (random.unit() * elements as f64) as usize;
                // supports stand on even nodes: the first load is never on one
                (if load == 0 { node | 1 } else { node }, size * (random.unit() - 0.3))
            })
            .collect();
        let solution = frame.solve(&loads).unwrap_or_else(|error| panic!("case {case}: {error}: {laws:?} {loads:?}"));
        most = most.max(solution.convergence.iterations);
        pulled += solution.reactions.iter().filter(|reaction| reaction.pulls()).count();
        let total: f64 = loads.iter().map(|load| load.1).sum();
        let balance: f64 = solution.reactions.iter().map(|reaction| reaction.value).sum();
        assert!((balance - total).abs() <= 1e-9 * size, "case {case}: {balance} for {total}");
        for (reaction, law) in solution.reactions.iter().zip(&laws) {
            assert_eq!(reaction.support, SupportKind::Joint);
            let w = solution.displacement[reaction.node];
            let [low, high] = [-2e-12, 2e-12].map(|part| law.displacement(reaction.value + part * size));
            let tolerance =
                1e-9 * solution.displacement.iter().fold(1e-10 * size * flexibility, |a, &w| a.max(w.abs()));
            assert!(low - tolerance <= w && w <= high + tolerance, "case {case}: {reaction:?} on {law:?} at {w}");
        }
    }
    println!("most iterations {most}, {pulled} joints pulled");
    assert!(pulled > 50);
}
