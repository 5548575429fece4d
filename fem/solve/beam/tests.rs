use super::*;
use crate::element::BeamPiece;
use crate::joint::Contact;

const RIGIDITY: f64 = 68_750.0;

/// Longer than any case, and slender.
fn bar() -> Arc<Bending> {
    let piece = BeamPiece { length: 0.6, flexural_rigidity: RIGIDITY, shear_rigidity: f64::INFINITY };
    Arc::new(Bending::new(&[piece]))
}

/// Numbers in [0, 1) that are the same in every run: the fractions of the multiples of the golden ratio.
struct Drawn(u32);

impl Drawn {
    fn next(&mut self) -> f64 {
        self.0 += 1;
        (f64::from(self.0) * 0.618_033_988_749_894_9).fract()
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// Rigid, spring, contact, or both in series.
fn joint(kind: usize, drawn: &mut Drawn) -> Joint {
    let contact = Contact { coefficient: drawn.between(1e-8, 2e-6), exponent: drawn.between(0.3, 1.0) };
    let spring = 1.0 / drawn.between(2e7, 2e9);
    match kind % 4 {
        0 => Joint::default(),
        1 => Joint { spring_compliance: spring, contacts: Vec::new() },
        2 => Joint { spring_compliance: 0.0, contacts: vec![contact] },
        _ => Joint { spring_compliance: spring, contacts: vec![contact] },
    }
}

/// Two to eight supports and one to four loads, of which some leave supports and some tip the beam.
fn case(i: usize) -> (Vec<Support>, Vec<Load>) {
    let mut drawn = Drawn(97 * i as u32);
    let count = 2 + i % 7;
    let support = |k: usize, drawn: &mut Drawn| Support {
        at: (k as f64 + drawn.between(0.1, 0.9)) * 0.6 / count as f64,
        // Half of the cases stand level.
        lowered: if i.is_multiple_of(2) { 0.0 } else { drawn.between(-5e-5, 5e-5) },
        joint: joint(i + if i.is_multiple_of(3) { k } else { 0 }, drawn),
    };
    let supports = (0..count).map(|k| support(k, &mut drawn)).collect();
    let loads = (0..1 + i % 4).map(|_| Load { at: drawn.between(0.0, 0.6), force: drawn.between(0.0, 8000.0) });
    (supports, loads.collect())
}

#[test]
fn supports_press_or_stand_free_and_all_balances() {
    let (mut lifted, mut tipped) = (0, 0);
    for i in 0..2000 {
        let (supports, loads) = case(i);
        let settled = match settle(&bar(), &supports, &loads) {
            Ok(settled) => settled,
            Err(BeamError::Tips { at, from, to }) => {
                assert!(at < from || at > to);
                tipped += 1;
                continue;
            }
            Err(error) => panic!("case {i}: {error}"),
        };
        let total: f64 = loads.iter().map(|l| l.force).sum();
        let size = supports.iter().map(|s| settled.deflection(s.at).abs()).fold(1e-9, f64::max);
        let (mut force, mut moment) = (-total, -loads.iter().map(|l| l.force * l.at).sum::<f64>());
        for (support, reaction) in supports.iter().zip(&settled.reactions) {
            let w = settled.deflection(support.at) - support.lowered;
            force += reaction.force;
            moment += reaction.force * support.at;
            assert!(reaction.force >= 0.0, "case {i}: a support pulls with {}", reaction.force);
            let lies = match reaction.force {
                0.0 => w <= 1e-9 * size,
                q => (w - support.joint.displacement(q)).abs() <= 1e-9 * size,
            };
            assert!(lies, "case {i}: w = {w:e} where {:?} carries {}", support.joint, reaction.force);
            lifted += usize::from(w < -1e-9 * size);
        }
        assert!(force.abs() <= 1e-9 * total && moment.abs() <= 1e-9 * total, "case {i}: {force:e} N, {moment:e} N m");
    }
    assert!(lifted > 300 && tipped > 100, "{lifted} lifted, {tipped} tipped");
}

#[test]
fn slope_and_moment_are_those_of_the_deflection() {
    let (supports, loads) = case(12);
    let settled = settle(&bar(), &supports, &loads).unwrap();
    for x in [0.07, 0.21, 0.333, 0.58] {
        let h = 1e-4;
        let (a, b, c) = (settled.deflection(x - h), settled.deflection(x), settled.deflection(x + h));
        // The third derivative is at most half of the forces over EI.
        let left_out = loads.iter().map(|l| l.force).sum::<f64>() / RIGIDITY * h * h / 6.0;
        assert!(((c - a) / (2.0 * h) - settled.slope(x)).abs() <= left_out + 1e-14 / h);
        let moment = RIGIDITY * (a - 2.0 * b + c) / (h * h);
        assert!((moment - settled.moment(x)).abs() < 1e-3 * settled.moment(x).abs() + 1e-3, "{moment}");
    }
    // Nothing bends the free ends.
    assert!(settled.moment(0.0).abs() < 1e-6 && settled.moment(0.6).abs() < 1e-6);
}

#[test]
fn nothing_presses_nothing() {
    let (supports, _) = case(5);
    let settled = settle(&bar(), &supports, &[Load { at: 0.2, force: 0.0 }]).unwrap();
    let [first, .., last] = &supports[..] else { panic!("two supports") };
    for support in [first, last] {
        assert!((settled.deflection(support.at) - support.lowered).abs() < 1e-18);
    }
    assert_eq!(settled.reactions[0].force, 0.0);
}

#[test]
fn a_high_support_in_the_middle_bends_what_two_clamps_hold_down() {
    // Three-point bending: 48EI·h/L³ under the middle, and half of it at either end.
    let (length, high, force) = (0.5, 30e-6, 4000.0);
    let support = |at, lowered| Support { at, lowered, joint: Joint::default() };
    let supports = [support(0.05, 0.0), support(0.05 + 0.5 * length, -high), support(0.05 + length, 0.0)];
    let loads = [0.05, 0.05 + length].map(|at| Load { at, force });
    let settled = settle(&bar(), &supports, &loads).unwrap();
    let middle = 48.0 * RIGIDITY * high / length.powi(3);
    assert!((settled.reactions[1].force / middle - 1.0).abs() < 1e-9);
    assert!((settled.reactions[0].force - (force - 0.5 * middle)).abs() < 1e-6);
    // Clamps that are too weak for that leave the part on the middle and on one end, or tip it.
    let weak = settle(&bar(), &supports, &[Load { at: 0.05, force: 0.1 * middle }]).unwrap();
    assert_eq!(weak.reactions[2].force, 0.0);
    assert!(weak.reactions[2].displacement < 0.0);
}

#[test]
fn a_load_above_an_end_support_is_that_supports_own() {
    let (mut supports, _) = case(10);
    supports.iter_mut().for_each(|s| s.joint = Joint::default());
    let first = supports[0].at;
    let settled = settle(&bar(), &supports, &[Load { at: first, force: 700.0 }]).unwrap();
    assert!((settled.reactions[0].force - 700.0).abs() < 1e-6);
}
