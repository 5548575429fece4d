//! The screw as a bar: closed forms, and the assembled chain of elements.

use super::rig::*;
use crate::solve::Bar;
use crate::validation::Case;

pub fn cases() -> Vec<Case> {
    let ea = rigidity();
    let per_newton = |m: f64| 1e9 * m;
    let one = |x: f64| Bar { axial_rigidity: ea, held: vec![0.05] }.compliance(x);
    let two = |x: f64| Bar { axial_rigidity: ea, held: vec![0.0, 0.9] }.compliance(x);
    let chain = |held: Vec<f64>, loaded: usize| {
        let nodes: Vec<f64> = (0..=90).map(|i| 0.01 * f64::from(i)).collect();
        let bar = Bar { axial_rigidity: ea, held };
        bar.displacements(&nodes, loaded, 1.0)[loaded]
    };
    let bar = |name: &str, expected: f64, computed: f64, source| {
        row(name, "stretch per newton", (per_newton(expected), per_newton(computed), "nm/N"), ROUND_OFF, source)
    };
    let free = "x/(EA)";
    let held = "ab/(EA(a + b))";
    vec![
        bar("screw with one bearing, nut 750 mm away", 0.75 / ea, one(0.8), free),
        bar("screw with one bearing, nut on the other side", 0.35 / ea, one(-0.3), free),
        bar("screw with two bearings, nut midway", 0.45 * 0.45 / (0.9 * ea), two(0.45), held),
        bar("screw with two bearings, nut off the middle", 0.2 * 0.7 / (0.9 * ea), two(0.2), held),
        bar("screw with two bearings, nut beyond them", 0.1 / ea, two(1.0), free),
        bar("chain of 90 elements, one bearing, nut at 600 mm", 0.6 / ea, chain(vec![0.0], 60), free),
        bar(
            "chain of 90 elements, two bearings, nut at 200 mm",
            0.2 * 0.7 / (0.9 * ea),
            chain(vec![0.0, 0.9], 20),
            held,
        ),
        row(
            "screw with two bearings, softest place against one bearing",
            "ratio of compliances",
            (0.25, two(0.45) / Bar { axial_rigidity: ea, held: vec![0.0] }.compliance(0.9), "-"),
            ROUND_OFF,
            "4EA/L in the middle against EA/L at the end",
        ),
    ]
}
