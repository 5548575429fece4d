//! The sweep against the plain finite-element solve: random shafts, supports, rests and joints.

use fem::element::BeamPiece;
use fem::joint::{Contact, Joint, Rubbing};
use fem::solve::frame::Frame;
use fem::solve::{Condensed, Hold, Moved, Rest, Shaft, solve_joints};
use proptest::prelude::*;

/// A shaft of pieces of 5 to 60 mm with steps, and which pieces end at a rest and at the tool.
#[derive(Clone, Debug)]
struct Trial {
    pieces: Vec<BeamPiece>,
    hold: Hold,
    tailstock: bool,
    rests: Vec<(usize, f64)>,
    tool: usize,
    joints: [Joint; 2],
    load: f64,
}

fn joint() -> impl Strategy<Value = Joint> {
    let contact = (0.05e-6..2e-6, 0.3..0.95).prop_map(|(coefficient, exponent)| Contact { coefficient, exponent });
    (1e-9..1e-7, prop::collection::vec(contact, 0..2))
        .prop_map(|(spring_compliance, contacts)| Joint { spring_compliance, contacts })
}

fn trial() -> impl Strategy<Value = Trial> {
    let piece = (5e-3..60e-3, 0.02f64..0.08, prop::bool::ANY).prop_map(|(length, diameter, slender)| BeamPiece {
        length,
        flexural_rigidity: 1e10 * diameter.powi(4),
        shear_rigidity: if slender { f64::INFINITY } else { 5e10 * diameter.powi(2) },
    });
    let pieces = prop::collection::vec(piece, 6..14);
    // (hold, tailstock): centres, chuck, chuck and centre, tilting chuck and centre.
    let held = prop::sample::select(vec![
        (Hold::Free, true),
        (Hold::Compliance(0.0), false),
        (Hold::Compliance(0.0), true),
        (Hold::Compliance(1e-5), true),
    ]);
    let rests = prop::collection::vec((1usize..5, 1e6..1e8), 0..3);
    (pieces, held, rests, 0usize..1000, [joint(), joint()], 50.0..2000.0).prop_map(
        |(pieces, (hold, tailstock), rests, tool, joints, load)| {
            let tool = 1 + tool % (pieces.len() - 1);
            Trial { pieces, hold, tailstock, rests, tool, joints, load }
        },
    )
}

impl Trial {
    fn at(&self, node: usize) -> f64 {
        self.pieces[..node].iter().map(|p| p.length).sum()
    }

    fn shaft(&self) -> Shaft {
        let rests =
            self.rests.iter().map(|&(node, stiffness)| Rest { at: self.at(node), stiffness, offset: 0.0 }).collect();
        Shaft { pieces: self.pieces.clone(), hold: self.hold, tailstock: self.tailstock, rests }
    }

    /// Deflections at all nodes by the sweep's condensation.
    fn by_sweep(&self) -> Vec<f64> {
        let nodes: Vec<f64> = (0..=self.pieces.len()).map(|i| self.at(i)).collect();
        let condensed: Condensed = self.shaft().condense(&nodes).unwrap();
        let influence = condensed.influence[self.tool];
        let joints = self.joints.each_ref().map(Rubbing::free);
        let joints = solve_joints(&joints, influence, &condensed.constraint, (self.load, [0.0; 2]), None).unwrap();
        let [head, tail] = joints.displacements;
        let shape = condensed.line(self.tool, 1.0, &Moved::default());
        assert!((shape[self.tool] / condensed.compliance[self.tool] - 1.0).abs() < 1e-12);
        shape.iter().zip(&condensed.influence).map(|(unit, g)| unit * self.load + g[0] * head + g[1] * tail).collect()
    }

    /// The same by the plain solve.
    fn by_frame(&self) -> Vec<f64> {
        let last = self.pieces.len();
        let mut frame = Frame::new(&self.pieces).unwrap().joint(0, self.joints[0].clone()).unwrap();
        frame = match self.hold {
            Hold::Free => frame,
            Hold::Compliance(tilt) => frame.rotational_spring(0, 1.0 / tilt).unwrap(),
        };
        if self.tailstock {
            frame = frame.joint(last, self.joints[1].clone()).unwrap();
        }
        for &(node, stiffness) in &self.rests {
            frame = frame.translational_spring(node, stiffness).unwrap();
        }
        frame.solve(&[(self.tool, self.load)]).unwrap().displacement
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, rng_seed: prop::test_runner::RngSeed::Fixed(20), ..ProptestConfig::default() })]

    /// Both solve the same equations exactly, up to round-off: 1e-9 of the largest deflection, of which
    /// Newton's residuals (1e-12 and 1e-10 of the load) are the larger part.
    #[test]
    fn sweep_and_plain_solve_agree(trial in trial()) {
        let (sweep, frame) = (trial.by_sweep(), trial.by_frame());
        let largest = frame.iter().fold(0.0f64, |m, w| m.max(w.abs()));
        for (node, (a, b)) in sweep.iter().zip(&frame).enumerate() {
            prop_assert!((a - b).abs() <= 1e-9 * largest, "node {node}: {a:e} and {b:e}");
        }
    }
}
