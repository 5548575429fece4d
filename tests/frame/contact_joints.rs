//! Joints in redundant and light-load cases, against scalar equations solved by bisection.

use super::power_joint;
use super::table::{Row, check};
use fem::element::BeamPiece;
use fem::solve::frame::Frame;

const L: f64 = 0.6;
const EI: f64 = 26.4e3;

fn beam(elements: usize) -> Frame {
    let piece = BeamPiece { length: L, flexural_rigidity: EI, shear_rigidity: f64::INFINITY };
    Frame::new(&piece.divided(elements).collect::<Vec<_>>()).unwrap()
}

/// Root of a rising function between `low` and `high`.
fn root(function: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if function(middle) > 0.0 { high = middle } else { low = middle }
    }
    0.5 * (low + high)
}

/// Chuck and centre: clamped at 0, joint at L, load P at a. Q L³/3EI + y(Q) = P a²(3L − a)/6EI.
#[test]
fn clamped_shaft_on_a_joint() {
    // (k N/m, c m/N^n, n, P N, loaded node of 20, elements a node)
    let table = [
        (f64::INFINITY, 0.2e-6, 0.5, 500.0, 10, 1),
        (f64::INFINITY, 0.2e-6, 0.5, 500.0, 10, 10),
        (40e6, 0.2e-6, 0.5, 500.0, 15, 1),
        (40e6, 0.2e-6, 0.5, -500.0, 15, 1),
        (f64::INFINITY, 0.2e-6, 0.5, -500.0, 15, 1),
        (40e6, 3e-6, 0.3, 500.0, 19, 1),
        (40e6, 30e-6, 0.1, 500.0, 10, 1),
        (f64::INFINITY, 50e-6, 0.5, 1.0, 10, 1),
        (f64::INFINITY, 0.2e-6, 0.5, 1e-12, 10, 1),
        (f64::INFINITY, 0.2e-6, 0.5, 1e-12, 1, 1),
        (f64::INFINITY, 0.2e-6, 0.5, 1e6, 10, 1),
        (10e6, 0.0, 0.5, 500.0, 12, 1),
        (f64::INFINITY, 1e-8, 1.0, 500.0, 12, 1),
        (f64::INFINITY, 1e-12, 0.5, 500.0, 12, 1),
    ];
    let mut rows = Vec::new();
    for (stiffness, c, n, load, place, finer) in table {
        let law = power_joint(stiffness, c, n);
        let (last, node) = (20 * finer, place * finer);
        let a = L * place as f64 / 20.0;
        let free = load * a * a * (3.0 * L - a) / (6.0 * EI);
        let exact =
            root(|q| q * L.powi(3) / (3.0 * EI) + law.displacement(q) - free, -2.0 * load.abs(), 2.0 * load.abs());
        let frame = beam(last).fix_translation(0).unwrap().fix_rotation(0).unwrap().joint(last, law.clone()).unwrap();
        let solution = frame.solve(&[(node, load)]).unwrap();
        let case = format!("k {stiffness:.0e} c {c:.0e} n {n} P {load:.0e} at {place} ({})", solution.convergence);
        rows.push(Row::new(case, solution.reactions[2].value, exact, 1e-10));
        assert_eq!(solution.reactions[2].pulls(), load < 0.0);
    }
    check(&rows);
}

/// n = 1 is a spring of stiffness 1/c, c = 0 one of stiffness k, and both in series.
#[test]
fn linear_joints_are_springs() {
    let mut rows = Vec::new();
    for (stiffness, c, spring) in [(f64::INFINITY, 1.0 / 6e7, 6e7), (4e7, 0.0, 4e7), (4e7, 1.0 / 6e7, 2.4e7)] {
        let law = power_joint(stiffness, c, 1.0);
        let joints = beam(200).joint(0, law.clone()).unwrap().translational_spring(200, 3e7).unwrap();
        let springs = beam(200).translational_spring(0, spring).unwrap().translational_spring(200, 3e7).unwrap();
        for node in [40, 100, 200] {
            let [joint, spring] = [&joints, &springs].map(|frame| frame.solve(&[(node, 500.0)]).unwrap());
            let case = format!("k {stiffness:.1e}, c {c:.1e}, node {node}");
            rows.push(Row::new(case, joint.displacement[node], spring.displacement[node], 1e-12));
        }
    }
    check(&rows);
}

/// Between centres the reactions are statically determinate however soft the contact: P(1 − x/L) and P x/L.
#[test]
fn light_and_end_loads_between_centres() {
    let mut rows = Vec::new();
    for n in [0.1, 0.3, 0.5, 0.9] {
        for load in [1e-12, 1e-3, 500.0, 1e6] {
            for (node, elements) in [(1, 20), (10, 20), (20, 20), (50, 200), (250, 1000), (1000, 1000)] {
                let law = power_joint(f64::INFINITY, 0.2e-6, n);
                let frame = beam(elements).joint(0, law.clone()).unwrap().joint(elements, law.clone()).unwrap();
                let s = node as f64 / elements as f64;
                let sink = |share: f64| share * law.displacement(share * load);
                let exact = sink(1.0 - s) + sink(s) + load * (s * (1.0 - s)).powi(2) * L.powi(3) / (3.0 * EI);
                let solution = frame.solve(&[(node, load)]).unwrap();
                let case = format!("n {n} P {load:.0e} at {node}/{elements} ({})", solution.convergence);
                rows.push(Row::new(case, solution.displacement[node], exact, 1e-11));
            }
        }
    }
    check(&rows);
}
