//! Wide rings in short jaws, against bricks of another program: `tests/validation/calculix/wide_ring.py 2` (CalculiX 2.20, 20-node bricks of a
//! sixth, 48 around by 8 across by 40 along).

use super::rig::*;
use crate::processes::ring::rows::{SECTION, STATE};
use crate::validation::{Case, Tolerance};

/// How far the bore moves outwards, um, at angles from a jaw (deg) and places from the face at the chuck (mm).
const BRICKS: [(f64, [f64; 5]); 5] = [
    (0.0, [-23.370780, -14.177980, -7.277582, -3.370392, -1.009678]),
    (15.0, [-15.693935, -9.643230, -5.041255, -2.324396, -0.677028]),
    (30.0, [-1.435118, -0.589911, 0.017341, 0.144462, 0.123347]),
    (45.0, [10.075859, 7.140714, 4.711366, 2.540989, 0.919973]),
    (60.0, [14.380640, 10.103438, 6.571821, 3.514364, 1.248872]),
];
const PLACES: [f64; 5] = [0.0, 15.0, 30.0, 45.0, 60.0];

pub fn cases() -> Vec<Case> {
    let short = "chuck = { jaws = 3, jaw_force = \"3 kN\", jaw_width = \"15 mm\" }";
    let text = ring(84.0, 3)
        .replace("chuck = { jaws = 3, jaw_force = \"3 kN\" }", short)
        .replace("width = \"20 mm\" }", "width = \"60 mm\" }");
    let chuck = chuck(&text, "[jaw-contact-arc]\narc = \"20 deg\"");
    let of = |(degrees, bricks): &(f64, [f64; 5])| {
        let angle = degrees.to_radians();
        let at = |(place, expected): (&f64, &f64)| {
            let computed = deviations(&chuck, &[angle], &[(STATE, 1.0), (SECTION, 1e-3 * place)])[0];
            row(
                format!("wide ring in short jaws, {degrees} deg from a jaw, {place} mm along it"),
                "radial displacement",
                (*expected, 1e6 * computed, "um"),
                // From 24 by 4 by 20 bricks to these the largest changes by 4.3e-3 um: by a third of that from these on, at the rate
                // of first derivatives of elements of second order.
                Tolerance::Absolute(1.5e-3),
                "CalculiX 2.20, 20-node bricks",
            )
        };
        PLACES.iter().zip(bricks).map(at).collect::<Vec<_>>()
    };
    BRICKS.iter().flat_map(of).collect()
}
