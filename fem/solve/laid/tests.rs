use super::*;
use crate::element::BeamPiece;
use crate::element::plane::{Elasticity, PlaneState, Quad8};
use crate::joint::Contact;
use crate::mesh::SteppedMesh;

const RIGIDITY: f64 = 68_750.0;

/// Longer than any case, and slender.
fn bar() -> Arc<Flexible> {
    let piece = BeamPiece { length: 0.6, flexural_rigidity: RIGIDITY, shear_rigidity: f64::INFINITY };
    Arc::new(Flexible::Beam(Bending::new(&[piece])))
}

fn under(at: f64) -> Spot {
    Spot::point(Face::Underside, at)
}

fn load(at: f64, force: f64) -> Load {
    Load { spot: Spot::point(Face::Top, at), force }
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
        spot: under((k as f64 + drawn.between(0.1, 0.9)) * 0.6 / count as f64),
        // Half of the cases stand level.
        lowered: if i.is_multiple_of(2) { 0.0 } else { drawn.between(-5e-5, 5e-5) },
        joint: joint(i + if i.is_multiple_of(3) { k } else { 0 }, drawn),
        friction: 0.0,
    };
    let supports = (0..count).map(|k| support(k, &mut drawn)).collect();
    let loads = (0..1 + i % 4).map(|_| load(drawn.between(0.0, 0.6), drawn.between(0.0, 8000.0)));
    (supports, loads.collect())
}

#[test]
fn supports_press_or_stand_free_and_all_balances() {
    let (mut lifted, mut tipped) = (0, 0);
    for i in 0..2000 {
        let (supports, loads) = case(i);
        let settled = match settle(&bar(), Supports::firm(&supports), &loads) {
            Ok(settled) => settled,
            Err(LaidError::Tips { at, from, to }) => {
                assert!(at < from || at > to);
                tipped += 1;
                continue;
            }
            Err(error) => panic!("case {i}: {error}"),
        };
        let total: f64 = loads.iter().map(|l| l.force).sum();
        let size = supports.iter().map(|s| settled.deflection(s.spot.at).abs()).fold(1e-9, f64::max);
        let (mut force, mut moment) = (-total, -loads.iter().map(|l| l.force * l.spot.at).sum::<f64>());
        for (support, reaction) in supports.iter().zip(&settled.reactions) {
            let w = settled.deflection(support.spot.at) - support.lowered;
            force += reaction.force;
            moment += reaction.force * support.spot.at;
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
    let settled = settle(&bar(), Supports::firm(&supports), &loads).unwrap();
    let bent = settled.bent().unwrap();
    for x in [0.07, 0.21, 0.333, 0.58] {
        let h = 1e-4;
        let (a, b, c) = (settled.deflection(x - h), settled.deflection(x), settled.deflection(x + h));
        // The third derivative is at most half of the forces over EI.
        let left_out = loads.iter().map(|l| l.force).sum::<f64>() / RIGIDITY * h * h / 6.0;
        assert!(((c - a) / (2.0 * h) - bent.slope(x)).abs() <= left_out + 1e-14 / h);
        let moment = RIGIDITY * (a - 2.0 * b + c) / (h * h);
        assert!((moment - bent.moment(x)).abs() < 1e-3 * bent.moment(x).abs() + 1e-3, "{moment}");
    }
    // Nothing bends the free ends.
    assert!(bent.moment(0.0).abs() < 1e-6 && bent.moment(0.6).abs() < 1e-6);
}

#[test]
fn nothing_presses_nothing() {
    let (supports, _) = case(5);
    let settled = settle(&bar(), Supports::firm(&supports), &[load(0.2, 0.0)]).unwrap();
    let [first, .., last] = &supports[..] else { panic!("two supports") };
    for support in [first, last] {
        assert!((settled.deflection(support.spot.at) - support.lowered).abs() < 1e-18);
    }
    assert_eq!(settled.reactions[0].force, 0.0);
}

#[test]
fn a_high_support_in_the_middle_bends_what_two_clamps_hold_down() {
    // Three-point bending: 48EI·h/L³ under the middle, and half of it at either end.
    let (length, high, force) = (0.5, 30e-6, 4000.0);
    let support = |at, lowered| Support { spot: under(at), lowered, joint: Joint::default(), friction: 0.0 };
    let supports = [support(0.05, 0.0), support(0.05 + 0.5 * length, -high), support(0.05 + length, 0.0)];
    let loads = [0.05, 0.05 + length].map(|at| load(at, force));
    let settled = settle(&bar(), Supports::firm(&supports), &loads).unwrap();
    let middle = 48.0 * RIGIDITY * high / length.powi(3);
    assert!((settled.reactions[1].force / middle - 1.0).abs() < 1e-9);
    assert!((settled.reactions[0].force - (force - 0.5 * middle)).abs() < 1e-6);
    // Clamps that are too weak for that leave the part on the middle and on one end, or tip it.
    let weak = settle(&bar(), Supports::firm(&supports), &[load(0.05, 0.1 * middle)]).unwrap();
    assert_eq!(weak.reactions[2].force, 0.0);
    assert!(weak.reactions[2].displacement < 0.0);
}

#[test]
fn a_load_above_an_end_support_is_that_supports_own() {
    let (mut supports, _) = case(10);
    supports.iter_mut().for_each(|s| s.joint = Joint::default());
    let first = supports[0].spot.at;
    let settled = settle(&bar(), Supports::firm(&supports), &[load(first, 700.0)]).unwrap();
    assert!((settled.reactions[0].force - 700.0).abs() < 1e-6);
}

#[test]
fn a_part_on_one_high_support_rocks() {
    let (mut supports, _) = case(10);
    supports.truncate(3);
    let at = |i: usize| 0.05 + 0.1 * i as f64;
    for (i, own) in supports.iter_mut().enumerate() {
        *own = Support { spot: Spot::point(Face::Underside, at(i)), lowered: 0.0, ..own.clone() };
        own.joint = Joint::default();
    }
    supports[1].lowered = -1e-3;
    let rests = |x: f64| settle(&bar(), Supports::firm(&supports), &[load(x, 100.0)]);
    assert!(matches!(rests(at(1)), Err(LaidError::Rocks { at: x }) if (x - at(1)).abs() < 1e-12));
    // A little beside it is clear on which side it lies.
    let [left, right] = [at(1) - 1e-3, at(1) + 1e-3].map(|x| rests(x).unwrap());
    assert!(left.reactions[0].force > 0.0 && left.reactions[2].displacement < 0.0);
    assert!(right.reactions[2].force > 0.0 && right.reactions[0].displacement < 0.0);
}

/// A block of 0.3 by 0.06 m and a step, of E = 2e11 and b = 0.04 m, in 8-node quadrilaterals of 15 mm.
fn block() -> Arc<Flexible> {
    let mesh = SteppedMesh { pieces: &[(0.2, 0.06), (0.1, 0.03)], size: 0.015, element: &Quad8 }.build().unwrap();
    let law = Elasticity::new(PlaneState::Stress, 1.0, 0.3, 0.0, 1.0).unwrap();
    let faces = Faces::of(&mesh).unwrap();
    Arc::new(Flexible::Body(Body::new(Arc::new(Unit::new(Arc::new(mesh), &faces, law).unwrap()), 2e11, 0.04)))
}

fn pad(face: Face, at: f64, width: f64) -> Spot {
    Spot { width, ..Spot::point(face, at) }
}

#[test]
fn a_body_obeys_maxwell_and_moves_as_its_nodes_do() {
    let part = block();
    let spots = [pad(Face::Underside, 0.04, 0.02), pad(Face::Top, 0.11, 0.013), pad(Face::Top, 0.25, 0.01)];
    let spots = [spots[0], spots[1], spots[2], spots[0].along(), pad(Face::Underside, 0.27, 0.03).along()];
    let influence = part.influence(&spots);
    assert!((influence.clone() - influence.transpose()).amax() < 1e-11 * influence.amax());
    for friction in [0.0, 0.2] {
        let support = |at, joint| Support { spot: pad(Face::Underside, at, 0.02), lowered: 0.0, joint, friction };
        let spring = Joint { spring_compliance: 1e-8, contacts: Vec::new() };
        let supports = [support(0.04, Joint::default()), support(0.15, spring), support(0.26, Joint::default())];
        let loads = [(0.11, 9000.0), (0.25, 4000.0)].map(|(at, force)| Load { spot: pad(Face::Top, at, 0.01), force });
        let settled = settle(&part, Supports::firm(&supports), &loads).unwrap();
        let (mut force, mut moment, mut along) = (-13_000.0, -9000.0 * 0.11 - 4000.0 * 0.25, 0.0);
        for (support, reaction) in supports.iter().zip(&settled.reactions) {
            force += reaction.force;
            moment += reaction.force * support.spot.at;
            along += reaction.friction;
            assert!(reaction.friction.abs() <= friction * reaction.force * (1.0 + 1e-9));
        }
        assert!(force.abs().max(moment.abs()).max(along.abs()) < 1e-6, "{force} {moment} {along}");
        let body = settled.body().unwrap();
        let moved = settled.displaced(body).unwrap();
        for (node, [_, v]) in body.mesh().nodes().iter().zip(&moved) {
            let is_top = node[1] == if node[0] > 0.2 { 0.03 } else { 0.06 };
            let w = settled.deflection(node[0]);
            assert!(!is_top || (w + v).abs() < 1e-9 * w.abs().max(1e-6), "{node:?} {w} {v}");
        }
    }
}

#[test]
fn friction_stiffens_a_body_and_leaves_two_supports_in_balance() {
    let part = block();
    let sunk = |friction: f64| {
        let support =
            |at| Support { spot: pad(Face::Underside, at, 0.02), lowered: 0.0, joint: Joint::default(), friction };
        let load = Load { spot: pad(Face::Top, 0.12, 0.01), force: 8000.0 };
        let settled = settle(&part, Supports::firm(&[support(0.03), support(0.26)]), &[load]).unwrap();
        let [a, b] = [0, 1].map(|i| settled.reactions[i].friction);
        assert!((a + b).abs() < 1e-9, "{a} {b}");
        settled.deflection(0.12)
    };
    let all = [0.0, 0.1, 0.3, 10.0, 1000.0].map(sunk);
    assert!(all.windows(2).all(|two| two[1] <= two[0] * (1.0 + 1e-12)), "{all:?}");
    // Once both stick, more friction holds no more.
    assert!((all[4] / all[3] - 1.0).abs() < 1e-12);
}
