//! A ring in a jaw chuck: linear in the force of its jaws, and as symmetric as these stand.

use std::f64::consts::TAU;

use proptest::prelude::*;

use super::{ROUND_OFF, alike, model, observed, sum, times};

#[derive(Clone, Debug)]
pub(super) struct Ring {
    jaws: usize,
    /// Outer diameter, wall and width, mm.
    outer: f64,
    wall: f64,
    width: f64,
    /// Arc over which a jaw presses, deg.
    arc: f64,
    /// Young's modulus, GPa.
    modulus: f64,
}

pub(super) fn ring() -> impl Strategy<Value = Ring> {
    (2usize..7, 60.0..200.0, 0.05..0.2, 10.0..60.0, 1.0..25.0).prop_map(|(jaws, outer, wall, width, arc)| Ring {
        jaws,
        outer,
        wall: wall * outer,
        width,
        arc,
        modulus: 210.0,
    })
}

impl Ring {
    pub(super) fn text(&self) -> String {
        let Self { jaws, outer, wall, width, arc, modulus } = self;
        format!(
            "process = \"ring\"\n\
             workpiece = {{ material = {{ base = \"steel\", youngs_modulus = \"{modulus} GPa\" }}, outer_diameter = \"{outer} mm\", inner_diameter = \"{} mm\", width = \"{width} mm\" }}\n\
             chuck = {{ jaws = {jaws}, jaw_force = \"3 kN\" }}\n\
             mesh = {{ circumferential = 120, radial = 2, order = 2 }}\n\
             [effects.jaw-contact-arc]\narc = \"{arc} deg\"\n",
            outer - 2.0 * wall,
        )
    }

    /// Deviations at angles (rad) under a force of each jaw (N), released or clamped.
    fn deviations(&self, angles: &[f64], force: f64, clamped: f64) -> Vec<f64> {
        let [force, state] = [force, clamped].map(|value| vec![value; angles.len()]);
        observed(&model(&self.text()), "deviation", &[("angle", angles), ("jaw_force", &force), ("state", &state)])
    }
}

/// Angles (rad) from 0 to a turn, off the nodes.
fn angles() -> Vec<f64> {
    (0..24).map(|i| (0.013 + f64::from(i) * TAU / 24.0).rem_euclid(TAU)).collect()
}

proptest! {
    #![proptest_config(super::random(60))]

    #[test]
    fn equal_jaws_press_the_ring_alike(ring in ring(), clamped in prop::sample::select(vec![0.0, 1.0])) {
        let turned = |by: f64| angles().iter().map(|angle| (angle + by).rem_euclid(TAU)).collect::<Vec<f64>>();
        let own = ring.deviations(&angles(), 3000.0, clamped);
        alike(&own, &ring.deviations(&turned(TAU / ring.jaws as f64), 3000.0, clamped), ROUND_OFF)?;
        let mirrored: Vec<f64> = angles().iter().map(|angle| TAU - angle).collect();
        alike(&own, &ring.deviations(&mirrored, 3000.0, clamped), ROUND_OFF)?;
    }

    #[test]
    fn forces_of_jaws_superpose(ring in ring(), first in 200.0..4000.0, second in 200.0..4000.0) {
        for clamped in [0.0, 1.0] {
            let [one, other, both] = [first, second, first + second].map(|f| ring.deviations(&angles(), f, clamped));
            alike(&sum(&one, &other), &both, ROUND_OFF)?;
        }
    }

    /// Every other jaw of a chuck presses as a chuck of half as many jaws.
    #[test]
    fn jaws_that_differ_in_turn_are_two_chucks(ring in ring(), half in 2usize..4, percent in -150.0..150.0) {
        let half = Ring { jaws: half, ..ring };
        let chuck = Ring { jaws: 2 * half.jaws, ..half.clone() };
        let text = format!("{}[effects.jaw-imbalance]\ndifference = \"{percent} %\"\n", chuck.text());
        let forces = vec![3000.0; 24];
        let own = observed(&model(&text), "deviation", &[("angle", &angles()), ("jaw_force", &forces)]);
        let turned: Vec<f64> = angles().iter().map(|angle| angle - TAU / chuck.jaws as f64).collect();
        let [strong, weak] = [0.5, -0.5].map(|side| 3000.0 * (1.0 + side * percent / 100.0));
        let two = sum(&half.deviations(&angles(), strong, 0.0), &half.deviations(&turned, weak, 0.0));
        alike(&own, &two, ROUND_OFF)?;
    }

    /// Rings of one shape under one strain are of one shape: lengths by s, the modulus by e, forces by s²·e,
    /// deviations by s.
    #[test]
    fn larger_and_stiffer_rings_deviate_in_proportion(ring in ring(), s in 0.5..3.0, e in 0.4..2.0) {
        let Ring { outer, wall, width, modulus, .. } = ring;
        let larger = Ring { outer: s * outer, wall: s * wall, width: s * width, modulus: e * modulus, ..ring.clone() };
        let own = ring.deviations(&angles(), 1000.0, 0.0);
        alike(&times(s, &own), &larger.deviations(&angles(), s * s * e * 1000.0, 0.0), ROUND_OFF)?;
    }
}
