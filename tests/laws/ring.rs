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

    /// A bar that a contact holds copies a blank by the law of the contact: the force of the cut grows with the depth that is left.
    #[test]
    fn a_contact_behind_the_tool_copies_by_its_law(
        ring in ring(), c in 0.05..0.4, n in 0.4..0.9, force in 50.0..400.0, blanks in prop::collection::vec(-80.0..80.0, 8),
    ) {
        let machine = format!(
            "[structure]\nmaterial = \"steel\"\n[structure.nodes]\ntip = [\"0 mm\", \"0 mm\"]\n[structure.ports]\ntool = \"tip\"\n\
             [structure.along]\nat = \"tip\"\nalong = \"x\"\nstiffness = \"1 N/um\"\n\
             [structure.square]\nat = \"tip\"\nalong = \"turning\"\nstiffness = \"1 N*m/rad\"\n\
             [structure.slide]\nat = \"tip\"\nalong = \"y\"\nstiffness = \"40 N/um\"\nc = \"{c} um/N^n\"\nn = {n}\n",
        );
        let cut = format!("measurement = {{ reference = \"absolute\" }}\ncut = {{ force_per_depth = \"2 kN/mm\", radial_force = \"{force} N\" }}\n");
        let text = ring.text().replace("mesh = ", &format!("{cut}mesh = ")) + &machine;
        let blank: Vec<f64> = blanks.iter().map(|own| 1e-6 * own).collect();
        let own = observed(&model(&text), "deviation", &[("blank", &blank), ("jaw_force", &[0.0; 8])]);
        let yields = |force: f64| force / 4e7 + 1e-6 * c * force.powf(n);
        let left = |blank: &f64| {
            // A tool that does not reach the blank leaves it: before the mean cut by the mean depth.
            if force + 2e6 * (yields(force) - blank) <= 0.0 {
                return blank - force / 2e6;
            }
            // What gives way more, y, of a depth that is larger by -blank: halved down from all of it to nothing.
            let (mut low, mut high) = (0.0f64.min(-blank), 0.0f64.max(-blank));
            for _ in 0..200 {
                let y = 0.5 * (low + high);
                let pressed: f64 = force + 2e6 * (-blank - y);
                let more = yields(pressed.max(0.0)) - yields(force);
                if y > more { high = y } else { low = y }
            }
            -0.5 * (low + high)
        };
        alike(&own, &blank.iter().map(left).collect::<Vec<f64>>(), 1e-9)?;
        // What is held by its bore is cut from outside: larger radii are more to cut.
        let inside = text.replace("jaw_force", "grip = \"inside\", jaw_force");
        let own = observed(&model(&inside), "deviation", &[("blank", &blank), ("jaw_force", &[0.0; 8])]);
        alike(&own, &blank.iter().map(|blank| -left(&-blank)).collect::<Vec<f64>>(), 1e-9)?;
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
