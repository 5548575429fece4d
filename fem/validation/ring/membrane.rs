//! Membrane chucks: the plate by elements along its radius, the ring by collocation, both of another program, and what follows.

use std::f64::consts::{PI, TAU};

use super::rig::*;
use crate::processes::ring::rows::SPEED;
use crate::validation::{Case, Tolerance};

/// Of 300 cubic elements along the radius, beside twice as many.
const ELEMENTS: Tolerance = Tolerance::Relative(1e-6);
/// Of the ring's elements, as against Michell's series.
const MESH: Tolerance = Tolerance::Relative(1e-4);
const PLATE: &str = "D*(w\" + w'/r - m^2*w/r^2)^2 by cubic elements along the radius, every wave of the jaws";
const RING: &str = "equations of equilibrium by Chebyshev collocation, every wave of the pads";

pub fn cases() -> Vec<Case> {
    [plates(), rings(), held()].concat()
}

/// The ring of a bore (mm) in jaws on a plate of Ø250 × 10 mm, with more keys of the chuck and of the membrane.
fn membrane(bore: f64, jaws: usize, [chuck_keys, keys]: [&str; 2]) -> Option<Chuck> {
    let plate = format!(
        "membrane = {{ diameter = \"250 mm\", thickness = \"10 mm\", jaw_circle = \"140 mm\", jaw_length = \"50 mm\", \
         interference = \"100 um\", {keys} }}{chuck_keys}"
    );
    let thrown = "[centrifugal-unloading]\njaw_moment = \"20 kg*mm\"";
    let text = ring(bore, jaws).replace("jaw_force = \"3 kN\"", &plate);
    // The short waves of a pad's ends take elements as small in a thick wall as in a thin one.
    let thick = text.replace("circumferential = 360, radial = 6", "circumferential = 720, radial = 12");
    chuck(if bore < 80.0 { &thick } else { &text }, thrown)
}

fn plates() -> Vec<Case> {
    let stiffness = |name: &str, expected: f64, chuck: &Option<Chuck>, source| {
        let pair = (expected, figure_of(chuck, "membrane", "/stiffness"), "N/um");
        row(name, "stiffness at a jaw", pair, ELEMENTS, source)
    };
    let around = membrane(84.0, 6, ["", "pad = \"20 mm\""]);
    let six = membrane(84.0, 6, ["", "root = \"50 mm\", pad = \"20 mm\""]);
    let three = membrane(84.0, 3, ["", "root = \"20 mm\", pad = \"10 mm\""]);
    let rigidity = 210e9 * 1e-6 / (12.0 * (1.0 - 0.09));
    let even = 1e-6 * 4.0 * PI * rigidity / (6.0 * 0.05 * 0.05 * (1.0 - (70f64 / 125.0).powi(2)));
    let kilonewton = figure_of(&around, "jaw_force", "/standstill") / 1000.0;
    let per_kilonewton = |key| figure_of(&around, "membrane", key) / kilonewton;
    let push = membrane(
        84.0,
        6,
        ["", "root = \"50 mm\", pad = \"20 mm\", push = { force = \"15 kN\", diameter = \"40 mm\" }"],
    );
    let open = |key| figure_of(&push, "membrane", key);
    let name = "plate of 250 x 10 mm pushed by 15 kN on 40 mm";
    vec![
        stiffness(
            "six jaws whose roots reach around",
            even,
            &around,
            "M*b*(1 - b^2/a^2)/2D, Timoshenko & Woinowsky-Krieger",
        ),
        stiffness("six jaws on roots of 50 mm", 22.478_571_0, &six, PLATE),
        stiffness("three jaws on roots of 20 mm", 27.118_744_4, &three, PLATE),
        row("six jaws of 1 kN", "bow of the plate", (50.385_417, per_kilonewton("/bow"), "um"), ELEMENTS, PLATE),
        row("six jaws of 1 kN", "stress of the plate", (22.666_210, per_kilonewton("/stress"), "MPa"), ELEMENTS, PLATE),
        row(name, "stroke of the jaws", (119.877_096, open("/stroke"), "um"), ELEMENTS, PLATE),
        row(name, "bow of the plate", (213.505_755, open("/bow_open"), "um"), ELEMENTS, PLATE),
        row(name, "stress of the plate", (125.262_61, open("/stress_open"), "MPa"), Tolerance::Relative(1e-5), PLATE),
    ]
}

fn rings() -> Vec<Case> {
    let case = |(name, expected, chuck): (&str, f64, Option<Chuck>)| {
        let pair = (expected, figure_of(&chuck, "membrane", "/ring_stiffness"), "N/um");
        row(name, "stiffness of the ring", pair, MESH, RING)
    };
    [
        ("ring under six pads of 20 mm", 527.687_74, membrane(84.0, 6, ["", "pad = \"20 mm\""])),
        ("ring under three pads of 10 mm", 104.886_70, membrane(84.0, 3, ["", "pad = \"10 mm\""])),
        (
            "ring on four pads of 15 mm in its bore",
            1_037.254_45,
            membrane(70.0, 4, [", grip = \"inside\"", "pad = \"15 mm\""]),
        ),
    ]
    .map(case)
    .to_vec()
}

/// The two in series, at rest and while the chuck turns.
fn held() -> Vec<Case> {
    let keys = "root = \"50 mm\", pad = \"20 mm\", jaw_centre = \"25 mm\"";
    let held = membrane(84.0, 6, ["", keys]);
    let (own, ring) = (1e-6 / 22.478_571_0, 1e-6 / 527.687_74);
    let force = 50e-6 / (own + ring);
    let omega = 1500.0 * TAU / 60.0;
    let left = 1.0 - 0.5 * own / (own + ring) * 0.02 * omega * omega / force;
    let at = |speed: f64| deviations(&held, &[0.1], &[(SPEED, speed)])[0];
    let series = Tolerance::Relative(1e-5);
    let name = "six jaws sprung by 50 um on the radius";
    vec![
        row(
            name,
            "force of a jaw",
            (force, figure_of(&held, "jaw_force", "/standstill"), "N"),
            series,
            "interference/(c + c_r)",
        ),
        row(
            name,
            "the ring gives way by",
            (1e6 * ring * force, figure_of(&held, "membrane", "/ring_gives_way"), "um"),
            MESH,
            "c_r*F",
        ),
        row(
            "the same at 1500 rpm with 20 kg mm half way out",
            "part of the deviation",
            (left, at(omega) / at(0.0), "-"),
            series,
            "F - h/l*c/(c + c_r)*m*r*omega^2",
        ),
    ]
}
