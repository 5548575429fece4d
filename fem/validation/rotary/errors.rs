//! Errors of worm, gears and scale, each alone: how often they come back in a turn, and how large they are.

use super::rig::*;
use crate::positioning::Direction::{Backward, Forward};
use crate::validation::{Case, Tolerance};

pub fn cases() -> Vec<Case> {
    [gearing(), wheels_and_rings(), zeros()].concat()
}

const FREE: (f64, f64) = (0.0, 0.0);

/// The rule of a maker of scales, and his example.
const RULE: &str = "HEIDENHAIN, Position Encoders for Servo Drives: 412*e/D";

fn arcsec(name: &str, expected: f64, computed: f64, source: &'static str) -> Case {
    row(name, "deviation", (expected, computed, "arcsec"), ROUND_OFF, source)
}

/// Periods: 360·starts/teeth of a worm, and what its gears make of that.
fn gearing() -> Vec<Case> {
    let wave = |name: &str| format!("[{name}]\namplitude = \"8 arcsec\"\nphase = \"30 deg\"");
    let of = |tables, name: &str| axis(tables, &wave(name));
    let at = |axis: &Option<Machine>, angle| deviation(axis, angle, Forward, FREE);
    let [worm, second] = ["worm-error", "worm-second-harmonic"].map(|name| of(WORM, name));
    let starts = of(GEARED, "worm-error");
    let [mesh, pinion] = ["tooth-error", "gear-eccentricity"].map(|name| of(GEARED, name));
    let [tooth, last, motor, lines] =
        ["tooth-error", "gear-eccentricity", "motor-gear-eccentricity", "interpolation-error"]
            .map(|name| of(TRAIN, name));
    let ring = of(WORM, "interpolation-error");
    // 8 sin 30 at every whole period, 8 sin 120 a quarter on, 8 sin 210 half a period on.
    let (whole, quarter, half) = (4.0, 8.0 * 120f64.to_radians().sin(), -4.0);
    let kinematics = "kinematics: period 360/n";
    vec![
        arcsec("worm 1:120, at 0", whole, at(&worm, 0.0), kinematics),
        arcsec("worm 1:120, 3 deg on", whole, at(&worm, 3.0), kinematics),
        arcsec("worm 1:120, 40 turns and a quarter on", quarter, at(&worm, 120.75), kinematics),
        arcsec("worm 1:120, half a turn on, backwards", half, deviation(&worm, 1.5, Backward, FREE), kinematics),
        arcsec("second harmonic of the worm, half a turn on", whole, at(&second, 1.5), kinematics),
        arcsec("second harmonic of the worm, a quarter of a turn on", half, at(&second, 0.75), kinematics),
        arcsec("worm of two starts 2:90, 8 deg on", whole, at(&starts, 8.0), kinematics),
        arcsec("worm of two starts 2:90, 4 deg on", half, at(&starts, 4.0), kinematics),
        arcsec("gears before that worm, a mesh on", whole, at(&mesh, 360.0 / (48.0 * 45.0)), kinematics),
        arcsec("gears before that worm, a turn of the pinion on", whole, at(&pinion, 360.0 / (4.0 * 45.0)), kinematics),
        arcsec("last pair 18:90, ten teeth and a half on", half, at(&tooth, 42.0), kinematics),
        arcsec("last pair 18:90, a turn of the pinion on", whole, at(&last, 72.0), kinematics),
        arcsec("last pair 18:90, a turn and a quarter on", quarter, at(&last, 90.0), kinematics),
        arcsec("train of 4 times 5, a turn of the motor back", whole, at(&motor, -18.0), kinematics),
        arcsec("train of 4 times 5, half a turn of the motor on", half, at(&motor, 9.0), kinematics),
        arcsec("ring of 1024 lines, 100 lines on", whole, at(&ring, 36_000.0 / 1024.0), kinematics),
        arcsec(
            "encoder of 500 lines on the motor, a line and a half on",
            half,
            at(&lines, 1.5 * 360.0 / 10_000.0),
            kinematics,
        ),
    ]
}

fn wheels_and_rings() -> Vec<Case> {
    let off = |name: &str, size: &str| format!("[{name}]\n{size}\nphase = \"0 deg\"");
    let wheel = axis(WORM, &off("wheel-eccentricity", "eccentricity = \"15 um\""));
    let ring = axis(WORM, &off("scale-eccentricity", "eccentricity = \"4 um\""));
    let oval = axis(WORM, &off("scale-second-harmonic", "amplitude = \"3 arcsec\""));
    let both = axis(
        WORM,
        &(off("wheel-eccentricity", "eccentricity = \"15 um\"")
            + "\n"
            + &off("scale-eccentricity", "eccentricity = \"8 um\"")),
    );
    let at = |axis: &Option<Machine>, angle| deviation(axis, angle, Forward, FREE);
    let small = axis(
        &WORM.replace("radius = \"80 mm\"", "radius = \"19.25 mm\""),
        &off("scale-eccentricity", "eccentricity = \"1 um\""),
    );
    let circle = "geometry of an eccentric circle, e/r";
    vec![
        arcsec("wheel of 150 mm, 15 um off, at 90 deg", 1e-4 * ARCSEC, at(&wheel, 90.0), circle),
        arcsec("wheel of 150 mm, 15 um off, at 210 deg", -0.5e-4 * ARCSEC, at(&wheel, 210.0), circle),
        arcsec("ring of 80 mm, 4 um off, at 270 deg", -0.5e-4 * ARCSEC, at(&ring, 270.0), circle),
        row(
            "ring of 160 mm across, 4 um off",
            "largest deviation",
            // The rule is printed to three digits.
            (412.0 * 4.0 / 160.0, at(&ring, 90.0), "arcsec"),
            Tolerance::Relative(2e-3),
            RULE,
        ),
        row(
            "ring of 38.5 mm across, 1 um off",
            "largest deviation",
            (10.7, at(&small, 90.0), "arcsec"),
            Tolerance::Absolute(0.05),
            RULE,
        ),
        arcsec("wheel and ring off alike, at 90 deg", 2e-4 * ARCSEC, at(&both, 90.0), "geometry: both add"),
        arcsec("oval ring, at 45 deg", 3.0, at(&oval, 45.0), "sin(2*angle)"),
        arcsec("oval ring, half a turn on", 3.0, at(&oval, 225.0), "sin(2*angle)"),
        arcsec("oval ring, at 90 deg", 0.0, at(&oval, 90.0), "sin(2*angle)"),
    ]
}

fn zeros() -> Vec<Case> {
    let drift = axis(WORM, "[thermal-drift]\nsize = \"-20 arcsec\"\ntime_constant = \"25 min\"");
    let ratio = axis(TRAIN, "[ratio-error]\nslope = \"0.3 arcsec/deg\"");
    let shift = axis(WORM, "[reference-shift]\noffset = \"-7.5 arcsec\"");
    let closed = WORM.replace("at = \"table\"", "at = \"table\", loop = \"closed\"");
    let ring = "[scale-eccentricity]\neccentricity = \"4 um\"\nphase = \"0 deg\"";
    let regulated = axis(&closed, ring);
    let first_order = "1 - exp(-t/tau)";
    vec![
        arcsec("drift, cold", 0.0, deviation(&drift, 40.0, Forward, FREE), first_order),
        arcsec(
            "drift after 50 min",
            -20.0 * (1.0 - (-2.0f64).exp()),
            deviation(&drift, 300.0, Backward, (50.0, 0.0)),
            first_order,
        ),
        arcsec("ratio off by 0.3 arcsec/deg at -90 deg", -27.0, deviation(&ratio, -90.0, Forward, FREE), "slope*angle"),
        arcsec("ratio off by 0.3 arcsec/deg at 80 deg", 24.0, deviation(&ratio, 80.0, Backward, FREE), "slope*angle"),
        arcsec("reference of a table off", -7.5, deviation(&shift, 123.0, Backward, (9.0, 0.0)), "the same everywhere"),
        arcsec(
            "a loop closed by the ring, under a torque",
            0.5e-4 * ARCSEC,
            deviation(&regulated, 90.0, Forward, (0.0, 50.0)),
            "a control holds what its scale shows",
        ),
    ]
}
