//! Uniform beams with closed forms. EI = 2.1 kN m², generic load positions, 40 elements.

use super::table::{Row, check};
use fem::element::BeamPiece;
use fem::solve::frame::{Frame, FrameError, Solution, SolveError};

const L: f64 = 0.7;
const EI: f64 = 2100.0;
const KGA: f64 = 3.1e5;
const P: f64 = 130.0;
const ELEMENTS: usize = 40;

type Build = fn(Frame) -> Result<Frame, FrameError>;

fn beam(length: f64, flexural_rigidity: f64, shear_rigidity: f64, elements: usize) -> Frame {
    let pieces: Vec<_> = BeamPiece { length, flexural_rigidity, shear_rigidity }.divided(elements).collect();
    Frame::new(&pieces).unwrap()
}

fn solved(shear: f64, supports: Build, load_node: usize) -> Result<Solution, SolveError> {
    supports(beam(L, EI, shear, ELEMENTS)).unwrap().solve(&[(load_node, P)])
}

#[test]
fn deflection_under_the_load() {
    let cantilever: Build = |frame| frame.fix_translation(0)?.fix_rotation(0);
    let pinned: Build = |frame| frame.fix_translation(0)?.fix_translation(ELEMENTS);
    let propped: Build = |frame| frame.fix_translation(0)?.fix_rotation(0)?.fix_translation(ELEMENTS);
    let infinite_springs: Build =
        |frame| frame.translational_spring(0, f64::INFINITY)?.translational_spring(ELEMENTS, f64::INFINITY);
    let (node, rigid) = (13, f64::INFINITY);
    let a = L * node as f64 / ELEMENTS as f64;
    let b = L - a;
    // (case, shear rigidity, supports, loaded node, exact deflection, source)
    let table = [
        ("cantilever, tip: PL3/3EI", rigid, cantilever, ELEMENTS, P * L.powi(3) / (3.0 * EI)),
        ("cantilever, tip, shear: + PL/kGA", KGA, cantilever, ELEMENTS, P * L.powi(3) / (3.0 * EI) + P * L / KGA),
        ("cantilever, inside: Pa3/3EI [002 (14)]", rigid, cantilever, node, P * a.powi(3) / (3.0 * EI)),
        ("pinned, inside: Pa2b2/3EIL [002 (13)]", rigid, pinned, node, P * (a * b).powi(2) / (3.0 * EI * L)),
        ("pinned, shear: + Pab/kGAL", KGA, pinned, node, P * (a * b).powi(2) / (3.0 * EI * L) + P * a * b / (KGA * L)),
        ("pinned, middle: PL3/48EI [002 (12)]", rigid, pinned, ELEMENTS / 2, P * L.powi(3) / (48.0 * EI)),
        ("on infinite springs", rigid, infinite_springs, node, P * (a * b).powi(2) / (3.0 * EI * L)),
        (
            "propped: Pa3b2(4L-a)/12EIL3",
            rigid,
            propped,
            node,
            P * a.powi(3) * b * b * (4.0 * L - a) / (12.0 * EI * L.powi(3)),
        ),
    ];
    let rows = table.map(|(case, shear, supports, load, exact)| {
        Row::new(case, solved(shear, supports, load).unwrap().displacement[load], exact, 1e-12)
    });
    check(&rows);
}

#[test]
fn rotational_springs_and_reactions() {
    let (spring, end) = (5e4, ELEMENTS);
    let frame = beam(L, EI, f64::INFINITY, ELEMENTS).fix_translation(0).unwrap().rotational_spring(0, spring).unwrap();
    let held = frame.solve(&[(end, P)]).unwrap();
    let propped = |frame: Frame| frame.fix_translation(0)?.fix_rotation(0)?.fix_translation(ELEMENTS);
    let (a, b) = (0.5 * L, 0.5 * L);
    let middle = solved(f64::INFINITY, propped, ELEMENTS / 2).unwrap();
    check(&[
        Row::new(
            "cantilever on a rotational spring: PL3/3EI + PL2/k",
            held.displacement[end],
            P * L.powi(3) / (3.0 * EI) + P * L * L / spring,
            1e-12,
        ),
        Row::new("its force reaction: P", held.reactions[0].value, P, 1e-12),
        Row::new("its moment reaction: PL", held.reactions[1].value, P * L, 1e-12),
        Row::new(
            "slope at the tip: PL2/2EI + PL/k",
            held.rotation[end],
            P * L * L / (2.0 * EI) + P * L / spring,
            1e-12,
        ),
        Row::new(
            "propped, wall: Pb(3L2-b2)/2L3",
            middle.reactions[0].value,
            P * b * (3.0 * L * L - b * b) / (2.0 * L.powi(3)),
            1e-11,
        ),
        Row::new(
            "propped, wall moment: Pab(L+b)/2L2",
            middle.reactions[1].value,
            P * a * b * (L + b) / (2.0 * L * L),
            1e-11,
        ),
        Row::new(
            "propped, prop: Pa2(3L-a)/2L3",
            middle.reactions[2].value,
            P * a * a * (3.0 * L - a) / (2.0 * L.powi(3)),
            1e-11,
        ),
    ]);
}

/// Hibbeler, *Mechanics of Materials*, problem 12.16: prints 38.5 mm under the load. Exactly, with
/// reactions 2P/3 and P/3: rigid part (P/k)(4/9 + 1/9) = 37.037 mm, elastic part P a²b²/(3EIL) = 1.4222 mm.
#[test]
fn hibbeler_12_16() {
    let (load, stiffness, rigidity) = (3000.0, 45e3, 200e9 * 4.6875e-6);
    let frame = beam(3.0, rigidity, f64::INFINITY, 3)
        .translational_spring(0, stiffness)
        .and_then(|frame| frame.translational_spring(3, stiffness))
        .unwrap();
    let computed = frame.solve(&[(1, load)]).unwrap();
    let exact = load / stiffness * 5.0 / 9.0 + load * 4.0 / (3.0 * rigidity * 3.0);
    check(&[
        Row::new("under the load, exact", computed.displacement[1], exact, 1e-13),
        Row::new("under the load, as printed", computed.displacement[1], 38.5e-3, 0.05 / 38.5),
        Row::new("near spring: 2P/3", computed.reactions[0].value, 2000.0, 1e-13),
        Row::new("far spring: P/3", computed.reactions[1].value, 1000.0, 1e-13),
    ]);
}

#[test]
fn loads_add_and_zero_load_is_zero() {
    let frame = beam(L, EI, KGA, 10).fix_translation(0).unwrap().translational_spring(10, 1e7).unwrap();
    let factored = frame.factor().unwrap();
    let [one, two] = [(3, 40.0), (8, -25.0)].map(|load| factored.solve(&[load]).unwrap());
    let both = factored.solve(&[(3, 15.0), (8, -25.0), (3, 25.0)]).unwrap();
    for node in 0..=10 {
        let sum = one.displacement[node] + two.displacement[node];
        assert!((both.displacement[node] - sum).abs() <= 1e-18, "node {node}");
    }
    let none = factored.solve(&[]).unwrap();
    assert!(none.displacement.iter().all(|&w| w == 0.0));
    let at_fixed = factored.solve(&[(0, 7.0)]).unwrap();
    assert!((at_fixed.reactions[0].value - 7.0).abs() < 1e-15 && at_fixed.displacement[10] == 0.0);
}
