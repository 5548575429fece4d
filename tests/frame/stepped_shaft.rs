//! Stepped steel shaft between centres,  L = 0.6 m, D 40|50|40 mm (0.18, 0.24, 0.18 m),
//! E = 210 GPa, ν = 0.3, springs 60 and 40 N/µm or joints y = 0.2 µm·Q^0.5, 500 N under the tool.
//! Exact values by the unit-load method, printed there to 1e-7 µm and integrated here.

use super::power_joint;
use super::table::{Row, check};
use fem::element::BeamPiece;
use fem::solve::frame::{Frame, Solution, SolveError};
use std::f64::consts::PI;

const LENGTH: f64 = 0.6;
const LOAD: f64 = 500.0;
const E: f64 = 210e9;
const NU: f64 = 0.3;
const HEADSTOCK: f64 = 60e6;
const TAILSTOCK: f64 = 40e6;
const C: f64 = 0.2e-6;
const N: f64 = 0.5;
/// (start m, end m, diameter m)
const STEPS: [(f64, f64, f64); 3] = [(0.0, 0.18, 0.04), (0.18, 0.42, 0.05), (0.42, 0.6, 0.04)];

#[derive(Clone, Copy)]
enum Beam {
    EulerBernoulli,
    Timoshenko,
}

fn rigidities(diameter: f64, beam: Beam) -> (f64, f64) {
    let flexural = E * PI * diameter.powi(4) / 64.0;
    let kappa = 6.0 * (1.0 + NU) / (7.0 + 6.0 * NU);
    match beam {
        Beam::EulerBernoulli => (flexural, f64::INFINITY),
        Beam::Timoshenko => (flexural, kappa * E / (2.0 * (1.0 + NU)) * PI * diameter * diameter / 4.0),
    }
}

/// Shaft of `elements` (a multiple of 10) equal elements.
fn shaft(beam: Beam, elements: usize) -> Frame {
    let pieces: Vec<_> = STEPS
        .iter()
        .flat_map(|&(start, end, diameter)| {
            let (flexural_rigidity, shear_rigidity) = rigidities(diameter, beam);
            let piece = BeamPiece { length: end - start, flexural_rigidity, shear_rigidity };
            piece.divided(((end - start) / LENGTH * elements as f64).round() as usize)
        })
        .collect();
    assert_eq!(pieces.len(), elements);
    Frame::new(&pieces).unwrap()
}

fn on_springs(beam: Beam, elements: usize) -> Frame {
    let frame = shaft(beam, elements).translational_spring(0, HEADSTOCK).unwrap();
    frame.translational_spring(elements, TAILSTOCK).unwrap()
}

fn on_joints(beam: Beam, elements: usize) -> Frame {
    let joint = power_joint(f64::INFINITY, C, N);
    shaft(beam, elements).joint(0, joint.clone()).unwrap().joint(elements, joint).unwrap()
}

/// Bending and shear under the load at x: ∫M²/(P·EI) + V²/(P·κGA), in closed form on each step.
fn bending(x: f64, beam: Beam) -> f64 {
    let (left, right) = (LOAD * (1.0 - x / LENGTH), LOAD * x / LENGTH);
    let mut energy = 0.0;
    for (start, end, diameter) in STEPS {
        let (flexural, shear) = rigidities(diameter, beam);
        let (a, b) = (start.min(x), end.min(x));
        energy += left * left * ((b.powi(3) - a.powi(3)) / (3.0 * flexural) + (b - a) / shear);
        let (a, b) = (LENGTH - end.max(x), LENGTH - start.max(x));
        energy += right * right * ((b.powi(3) - a.powi(3)) / (3.0 * flexural) + (b - a) / shear);
    }
    energy / LOAD
}

fn exact_on_springs(x: f64, beam: Beam) -> f64 {
    let s = x / LENGTH;
    LOAD * ((1.0 - s).powi(2) / HEADSTOCK + s * s / TAILSTOCK) + bending(x, beam)
}

fn exact_on_joints(x: f64, beam: Beam) -> f64 {
    let s = x / LENGTH;
    let sink = |share: f64| share * C * (LOAD * share).powf(N);
    sink(1.0 - s) + sink(s) + bending(x, beam)
}

/// Rows for every tenth of the shaft against the integral.
fn sweep(
    name: &str,
    elements: usize,
    solve: impl Fn(&[(usize, f64)]) -> Result<Solution, SolveError>,
    exact: impl Fn(f64) -> f64,
    tolerance: f64,
) -> Vec<Row> {
    (1..=10)
        .map(|tenth| {
            let node = tenth * elements / 10;
            let solution = solve(&[(node, LOAD)]).unwrap();
            let x = LENGTH * tenth as f64 / 10.0;
            let case = format!("{name}, {elements} elements, x = {x:.2} m ({})", solution.convergence.iterations);
            Row::new(case, solution.displacement[node], exact(x), tolerance)
        })
        .collect()
}

#[test]
fn printed_values() {
    use Beam::{EulerBernoulli, Timoshenko};
    // um at L/4, L/2, 3L/4, L, as printed to 1e-7 um
    let springs = [
        ("Euler-Bernoulli", EulerBernoulli, [37.5214415, 51.0045771, 39.6047748, 12.5]),
        ("Timoshenko", Timoshenko, [38.1166809, 51.7181975, 40.2000143, 12.5]),
    ];
    let mut rows = Vec::new();
    for (name, beam, printed) in springs {
        let frame = on_springs(beam, 200);
        let factored = frame.factor().unwrap();
        for (quarter, expected) in (1..).zip(printed) {
            let node = 50 * quarter;
            let computed = factored.solve(&[(node, LOAD)]).unwrap().displacement[node];
            rows.push(Row::new(format!("{name}, {quarter}/4"), computed * 1e6, expected, 0.51e-7 / expected));
        }
    }
    let frame = on_joints(EulerBernoulli, 200);
    for (quarter, expected) in (1..).zip([35.516446, 48.9585214, 35.516446, 4.472136]) {
        let node = 50 * quarter;
        let computed = frame.solve(&[(node, LOAD)]).unwrap().displacement[node];
        rows.push(Row::new(format!("joints, {quarter}/4"), computed * 1e6, expected, 0.51e-6 / expected));
    }
    check(&rows);
}

#[test]
fn springs_against_the_integral() {
    for (beam, name) in [(Beam::EulerBernoulli, "Euler-Bernoulli"), (Beam::Timoshenko, "Timoshenko")] {
        for (elements, tolerance) in [(10, 1e-13), (200, 1e-13), (1000, 1e-12), (10_000, 1e-11)] {
            let frame = on_springs(beam, elements);
            let factored = frame.factor().unwrap();
            let exact = |x: f64| exact_on_springs(x, beam);
            check(&sweep(name, elements, |loads| factored.solve(loads), exact, tolerance));
        }
    }
}

#[test]
fn joints_against_the_integral() {
    for (beam, name) in [(Beam::EulerBernoulli, "Euler-Bernoulli"), (Beam::Timoshenko, "Timoshenko")] {
        for (elements, tolerance) in [(10, 1e-13), (200, 1e-13), (1000, 1e-12)] {
            let frame = on_joints(beam, elements);
            let exact = |x: f64| exact_on_joints(x, beam);
            check(&sweep(name, elements, |loads| frame.solve(loads), exact, tolerance));
        }
    }
}

/// Elements too many for double precision end in an error, never in a number.
#[test]
fn too_many_elements_are_refused() {
    let frame = on_springs(Beam::EulerBernoulli, 30_000);
    let outcome = frame.solve(&[(15_000, LOAD)]);
    assert!(
        matches!(outcome, Err(SolveError::NotConverged(_) | SolveError::NotPositiveDefinite { .. })),
        "{:?}",
        outcome.map(|solution| solution.convergence)
    );
}
