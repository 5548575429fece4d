//! Drives that friction winds up, leads of their own, and the force of the cut.

use super::rig::*;
use crate::processes::contour::Path;
use crate::validation::Case;

/// R, m.
const RADIUS: f64 = 0.15;
const ANGLES: [f64; 3] = [30.0, 135.0, 260.0];

pub fn cases() -> Vec<Case> {
    [winding(), leads(), cutting()].concat()
}

/// A circle with a screw of Ø32 in x that is held 400 mm off the centre, and a lead of 8 mm in y.
fn text() -> String {
    circle(150.0, 1000.0, STIFF).replace(
        "lead = \"10 mm\"",
        "lead = \"10 mm\", y = { lead = \"8 mm\" }, \
         x = { screw = { material = \"steel\", diameter = \"32 mm\", fixed_at = \"-400 mm\" } }",
    ) + "cut = { normal_force = \"200 N\", tangential_force = \"120 N\" }\n"
}

/// Clearance and elastic clearance in series: where x turns round its slide stands at x = ±R ∓ h(x), h =
/// δ/2 + F/k + F·(x + 0.4)/(EA), linear in x.
fn winding() -> Vec<Case> {
    let (gap, friction, stiffness) = (6e-6, 600.0, 2e8);
    let rigidity = 210e9 * std::f64::consts::PI * 0.016f64.powi(2);
    let wound = "[elastic-lost-motion-x]\nfriction = \"600 N\"\nstiffness = \"200 N/um\"\n";
    let both = machine(&text(), &format!("{wound}[backlash-x]\ngap = \"6 um\""));
    let stands = |sign: f64, gap: f64| {
        let short = 0.5 * gap + friction / stiffness + friction * 0.4 / rigidity;
        (sign * RADIUS - sign * short) / (1.0 + sign * friction / rigidity)
    };
    let path = Path::Circle { radius: RADIUS };
    let mut cases = Vec::new();
    for (angle, sign) in [(0.0f64, 1.0), (180.0, -1.0)] {
        let place = of_lap(&both, CCW, |lap| lap.position(lap.time(&path.at(angle.to_radians() + 1e-5))).0[0]);
        let source = "seed 000, fig. 2a and 2b in series; geometry";
        let name = format!("play of 6 um and 600 N on a screw, flat at {angle} deg");
        cases.push(row(name, "x", (stands(sign, gap), place, "m"), ROUND_OFF, source));
    }
    let elastic = |sign: f64| 2e6 * friction * (1.0 / stiffness + (stands(sign, gap) + 0.4) / rigidity);
    // Where the drive turns round, and not the slide some micrometres behind it.
    let tolerance = crate::validation::Tolerance::Relative(1e-5);
    for (key, end, sign) in [("greatest_elastic", "far from", 1.0), ("least_elastic", "close to", -1.0)] {
        let computed = figure_of(&both, "lost_motion", &format!("/x/{key}"));
        let name = format!("600 N on a screw of 32 mm, {end} its bearing");
        let source = "seed 000, fig. 2b: 2F/C(x)";
        cases.push(row(name, "elastic clearance", (elastic(sign), computed, "um"), tolerance, source));
    }
    // Two contacts that press on each other with 400 N give way by c·F/(4·√P) on either side.
    let nut = "fixed_at = \"-400 mm\", nut = { preload = \"400 N\", c = \"0.25 um/N^n\", n = 0.5 }";
    let pressed = machine(&text().replace("fixed_at = \"-400 mm\"", nut), wound);
    let [with, without] =
        [pressed, machine(&text(), wound)].map(|m| figure_of(&m, "lost_motion", "/x/greatest_elastic"));
    let expected = 2.0 * 0.25 * friction / (4.0 * 20.0);
    let source = "seed 000, fig. 5, with c sqrt(Q): 2cF/(4 sqrt(P))";
    cases.push(row("preloaded nut", "elastic clearance", (expected, with - without, "um"), tolerance, source));
    cases
}

/// At the top y stands at 150 mm, 18.75 turns of its own screw and 15 of that of x.
fn leads() -> Vec<Case> {
    let waving = machine(&text(), "[cyclic-error-y]\namplitude = \"2 um\"\nphase = \"30 deg\"");
    let expected = 2e-6 * (1.5 * std::f64::consts::PI + 30f64.to_radians()).sin();
    let computed = deviation(&waving, CCW, 90.0);
    vec![micro(
        "wave of y by a lead of its own".into(),
        (expected, computed),
        1e-12,
        "seed 000, wave of the feedback: sin(2*pi*y/lead + phase)",
    )]
}

/// 200 N outwards and 120 N against the travel, on 50 N/um along x and 25 along y.
fn cutting() -> Vec<Case> {
    let effect = "[cutting-deflection]\nstiffness_x = \"50 N/um\"\nstiffness_y = \"25 N/um\"";
    let round = machine(&text(), effect);
    let mut cases = Vec::new();
    for (direction, sign) in WAYS.into_iter().zip([1.0, -1.0]) {
        for angle in ANGLES {
            let (sine, cosine) = angle.to_radians().sin_cos();
            let across = 200.0 * (cosine * cosine / 5e7 + sine * sine / 2.5e7);
            let along = 120.0 * sine * cosine * (1.0 / 5e7 - 1.0 / 2.5e7);
            let name = format!("force of a cut on a circle, {} at {angle} deg", direction.word());
            let computed = deviation(&round, direction, angle);
            // Sideways 9 um at most, of which the circle shows 9²/2R um².
            cases.push(micro(
                name,
                (across + sign * along, computed),
                81e-12 / (2.0 * RADIUS),
                "statics; tolerance d^2/2R",
            ));
        }
    }
    // The side that faces 30 deg, counter-clockwise along (−sin 30, cos 30).
    let square = rectangle(30.0, STIFF) + "cut = { normal_force = \"200 N\", tangential_force = \"120 N\" }\n";
    let square = machine(&square, effect);
    let (sine, cosine) = 30f64.to_radians().sin_cos();
    let expected =
        200.0 * (cosine * cosine / 5e7 + sine * sine / 2.5e7) + 120.0 * sine * cosine * (1.0 / 5e7 - 1.0 / 2.5e7);
    let computed = deviation(&square, CCW, 30.0);
    cases.push(micro("force of a cut on a sloping side".into(), (expected, computed), 1e-12, "statics"));
    cases
}
