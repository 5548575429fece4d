//! Several passes, each copying what the one before has left: by hand, at a rigid centre where only the
//! carriage yields.

use super::rig::*;
use crate::processes::turning::refinement::Refinement;
use crate::processes::turning::report::roundness::Roundness;
use crate::processes::turning::rows::ANGLE;
use crate::validation::{Case, Tolerance};

/// j = 20 N/um; C = P₀/t₀ = 400 N / 0.5 mm = 0.8 N/um.
const CARRIAGE: &str = "[carriage-compliance]\nstiffness = \"20 N/um\"\n[force-feedback]\nexponent = EXPONENT";

/// The uniform shaft with a blank and earlier passes.
fn turned(blank: &str, passes: &str, exponent: f64) -> Option<Lathe> {
    let text = UNIFORM
        .replace("HELD", "centres")
        .replace("diameter = \"40 mm\" }]", &format!("diameter = \"40 mm\" }}], {blank}"));
    lathe(&format!("{text}\n{passes}"), &CARRIAGE.replace("EXPONENT", &exponent.to_string()))
}

/// Diameter error at the tailstock end, um.
fn end(lathe: &Option<Lathe>) -> f64 {
    profile(lathe).last().map_or(f64::NAN, |e| 1e6 * e)
}

pub fn cases() -> Vec<Case> {
    let large = "blank_points = [{ at = \"0 mm\", error = \"0.1 mm\" }, { at = \"500 mm\", error = \"0.6 mm\" }]";
    let wave = "blank = [{ waves = 2, amplitude = \"0.3 mm\", phase = \"60 deg\" }]";
    let two = "[[pass]]\ndepth = \"1 mm\"\n[[pass]]\ndepth = \"0.8 mm\"";
    let forced = "[[pass]]\ndepth = \"2 mm\"\nfeed = \"0.4 mm/rev\"\nradial_force = \"2.4 kN\"";
    // Of what it meets, depth and all, a pass of C = 0.8 N/um leaves 0.8/20.8.
    let left = 0.8 / 20.8;
    let pass = |depth: f64, error: f64| left * (2.0 * depth + error);
    let thrice = |blank: f64| pass(500.0, pass(800.0, pass(1000.0, blank)));
    // C = 2.4 kN / 2 mm = 1.2 N/um in the first of two.
    let stronger = pass(500.0, 1.2 / 21.2 * (4000.0 + 600.0));
    let root = |set: f64, e: f64| 2.0 * bisect(0.0, set, |y| y - 400.0 * ((set - y).max(0.0) / 500.0).powf(e) / 20.0);
    let curved = root(500.0 + 0.5 * root(1000.0 + 300.0, 0.75), 0.75);
    let first = "[[pass]]\ndepth = \"1 mm\"";
    let um = |name: &str, expected: f64, computed: f64, source| {
        row(name, "diameter error", (expected, computed, "um"), Tolerance::Relative(1e-12), source)
    };
    let out = |name: &str, expected: f64, computed: f64, source| {
        row(name, "out of round", (expected, computed, "um"), DIFFERENCE, source)
    };
    let linear = "seed 002 (23), pass by pass";
    let copies = |passes: &str| Refinement::of(turned(large, passes, 1.0)?.machine(), &[0.5]).ok()?;
    let inherited = |passes: &str| copies(passes).map_or(f64::NAN, |r| r.inherited);
    let time = |passes: &str| turned(large, passes, 1.0).map_or(f64::NAN, |l| l.setup().schedule.start(1) / 60.0);
    let lobed = |lobes: usize| format!("lobes = [{{ lobes = {lobes}, amplitude = \"100 um\" }}]");
    // At the rigid centre, where only the carriage yields.
    let section = |lathe: &Lathe| Roundness::of(lathe.machine(), &[0.5]).ok()??.figure(&[0.5]).value_at("largest");
    let roundness = |lobes: usize, passes: &str, e: f64| {
        turned(&lobed(lobes), passes, e).as_ref().and_then(section).unwrap_or(f64::NAN)
    };
    // Crest and valley of the blank, each turned by itself.
    let bent = 0.5 * (root(500.0 + 100.0, 0.75) - root(500.0 - 100.0, 0.75));
    let across = |lobes: usize, angle: f64| {
        let at = [(ANGLE, angle.to_radians())];
        turned(&lobed(lobes), "", 1.0).map_or(f64::NAN, |lathe| 1e6 * observed(&lathe, 0.5, &at))
    };
    vec![
        out("oval blank of +-100 um, one pass", left * 200.0, roundness(2, "", 1.0), "seed 002 (24)-(27)"),
        out(
            "oval blank of +-100 um, three passes",
            left.powi(3) * 200.0,
            roundness(2, two, 1.0),
            "seed 002 (27), cubed",
        ),
        out("oval blank of +-100 um, exponent 0.75", bent, roundness(2, "", 0.75), "seed 002 (22), (24), by bisection"),
        um("oval blank, diameter across its crests", pass(500.0, 200.0), across(2, 0.0), linear),
        um("oval blank, diameter at 30 deg", pass(500.0, 100.0), across(2, 30.0), linear),
        um(
            "blank of three lobes, diameter anywhere",
            pass(500.0, 0.0),
            across(3, 20.0),
            "odd lobes: a constant diameter",
        ),
        um("one pass, blank 0.6 mm too large", pass(500.0, 600.0), end(&turned(large, "", 1.0)), linear),
        um("one pass, blank with a wave", pass(500.0, 150.0), end(&turned(wave, "", 1.0)), linear),
        um("three passes, blank 0.6 mm too large", thrice(600.0), end(&turned(large, two, 1.0)), linear),
        um("three passes, true blank", thrice(0.0), end(&turned("blank = []", two, 1.0)), linear),
        um("two passes, the first with its own force", stronger, end(&turned(large, forced, 1.0)), linear),
        um("two passes, exponent 0.75", curved, end(&turned(large, first, 0.75)), "seed 002 (22), by bisection"),
        row("one pass", "part inherited", (left, inherited(""), "-"), DIFFERENCE, "seed 002 (27)"),
        row("three passes", "part inherited", (left.powi(3), inherited(two), "-"), DIFFERENCE, "seed 002 (27), cubed"),
        row(
            "two passes before the last, 0.2 mm/rev at 600 rpm",
            "start of the last",
            (2.0 * 500.0 / 120.0, time(two), "min"),
            ROUND_OFF,
            "two passes of 500 mm at 120 mm/min",
        ),
    ]
}

/// A ratio of differences between roots that are exact to a hundred-millionth.
const DIFFERENCE: Tolerance = Tolerance::Relative(1e-7);
