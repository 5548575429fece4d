//! Play on a circle [seed 000, fig. 3].

use super::rig::*;
use crate::processes::contour::Path;
use crate::validation::{Case, Tolerance};

/// R and gap, m.
const RADIUS: f64 = 0.15;
const GAP: f64 = 8e-6;
const SOURCE: &str = "seed 000, fig. 3";

pub fn cases() -> Vec<Case> {
    let text = circle(150.0, 1000.0, STIFF);
    let both = machine(&text, "[backlash-x]\ngap = \"8 um\"\n[backlash-y]\ngap = \"8 um\"");
    let x_only = machine(&text, "[backlash-x]\ngap = \"8 um\"");
    let path = Path::Circle { radius: RADIUS };
    let place = |angle: f64, axis: usize| {
        of_lap(&both, CCW, |lap| lap.position(lap.time(&path.at(angle.to_radians()))).0[axis])
    };
    let mut cases = Vec::new();
    // The four arcs, counter-clockwise: x and y each lie half a gap behind.
    for (angle, centre) in
        [(10.0, [0.5, -0.5]), (80.0, [0.5, -0.5]), (100.0, [0.5, 0.5]), (200.0, [-0.5, 0.5]), (300.0, [-0.5, -0.5])]
    {
        let [x, y] = [0, 1].map(|axis| place(angle, axis) - GAP * centre[axis]);
        cases.push(row(
            format!("play of 8 um, arc at {angle} deg"),
            "radius about a corner of the square",
            (RADIUS, x.hypot(y), "m"),
            ROUND_OFF,
            SOURCE,
        ));
    }
    // A flat from the reversal of x on, while the drive crosses the gap.
    let flat = (1.0 - GAP / RADIUS).acos().to_degrees();
    for part in [0.01, 0.5, 0.99] {
        let name = format!("play of 8 um, {part} of the flat at 0 deg");
        cases.push(row(name, "x", (RADIUS - 0.5 * GAP, place(part * flat, 0), "m"), ROUND_OFF, SOURCE));
    }
    let diameter = |machine, direction, angle: f64| {
        deviation(machine, direction, angle) + deviation(machine, direction, angle + 180.0)
    };
    let second = GAP * GAP / RADIUS;
    let mut add = |name: String, expected: f64, computed: f64, allowed: f64| {
        cases.push(row(
            name,
            "error of the diameter",
            (1e6 * expected, 1e6 * computed, "um"),
            Tolerance::Absolute(1e6 * allowed),
            "seed 000, fig. 3; tolerance gap^2/R",
        ));
    };
    for direction in WAYS {
        for (angle, expected) in [(0.0, -GAP), (90.0, -GAP), (45.0, 0.0), (135.0, 0.0)] {
            add(
                format!("play of 8 um in x and y, {} at {angle} deg", direction.word()),
                expected,
                diameter(&both, direction, angle),
                second,
            );
        }
    }
    add("play of 8 um in x, ccw at 0 deg".into(), -GAP, diameter(&x_only, CCW, 0.0), second);
    add("play of 8 um in x, ccw at 90 deg".into(), 0.0, diameter(&x_only, CCW, 90.0), second);
    cases.push(row(
        "play of 8 um in x",
        "step at the reversal",
        (1e6 * GAP, figure_of(&x_only, "reversals", "/list/0/step"), "um"),
        Tolerance::Absolute(1e6 * second),
        "seed 000, fig. 3: the whole gap; tolerance gap^2/R",
    ));
    cases.push(row(
        "play of 8 um in x",
        "flat",
        ((2.0 * GAP / RADIUS).sqrt().to_degrees(), figure_of(&x_only, "reversals", "/list/0/flat"), "deg"),
        Tolerance::Relative(GAP / RADIUS),
        "seed 000, fig. 3: sqrt(2*gap/R); tolerance gap/R",
    ));
    // Wider than the stroke: x stays in the middle, and of the circle a line along y is left, v/Kv off the
    // centre when x is commanded farthest.
    let stuck = machine(&text, "[backlash-x]\ngap = \"301 mm\"");
    let lag = 1.0 / 60.0 / STIFF;
    cases.push(micro(
        "play wider than the stroke of x, at 0 deg".into(),
        (lag - RADIUS, deviation(&stuck, CCW, 0.0)),
        1e-12,
        "x stands still",
    ));
    cases
}
