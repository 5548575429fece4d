//! Events between parts: corrections of the offset in machines that are rigid, that yield and that copy, new inserts.

use super::rig::*;
use crate::processes::turning::rows::PART;
use crate::validation::Case;

/// Ø40 × 500 mm at 0.2 mm/rev, three parts; the words in capitals are replaced.
const BATCH: &str = r#"
    PASSES
    workpiece = { material = "steel", segments = [{ length = "500 mm", diameter = "40 mm" }] }
    workholding = { type = "centres" }
    cut = { depth = "0.5 mm", feed = "0.2 mm/rev", spindle_speed = "500 rpm", radial_force = "400 N" }
    batch = { parts = 3, cycle_time = "20 min", EVENTS }
"#;
const CORRECTED: &str = "corrections = [{ after = 1, diameter = \"-10 um\" }]";
const CORRECTION: f64 = -10e-6;

pub fn cases() -> Vec<Case> {
    [corrections(), inserts()].concat()
}

fn batch(passes: &str, events: &str, effects: &str) -> Option<Lathe> {
    lathe(&BATCH.replace("PASSES", passes).replace("EVENTS", events), effects)
}

/// By how much part 3 is larger than part 1 at a rigid centre, x = L, m.
fn between_parts(lathe: &Option<Lathe>) -> f64 {
    let on = |lathe: &Lathe, part: f64| observed(lathe, 0.5, &[(PART, part)]);
    lathe.as_ref().map_or(f64::NAN, |lathe| on(lathe, 3.0) - on(lathe, 1.0))
}

/// At a rigid centre only the carriage yields: j = 20 N/um, C = P₀/t₀ = 0.8 N/um. A nose that is moved by s takes s off
/// the depth, and the gap falls by C·s/(j + C); of what a pass leaves the next one copies C/(j + C).
fn corrections() -> Vec<Case> {
    let copied: f64 = 0.8 / 20.8;
    let spring = "[carriage-compliance]\nstiffness = \"20 N/um\"\n";
    let feedback = format!("{spring}[force-feedback]\nexponent = 1.0");
    let pass = "pass = [{ depth = \"1 mm\", radial_force = \"800 N\" }]";
    let effect = "[offset-correction]\nafter = 1\ndiameter = \"-10 um\"";
    let case = |name: &str, passes: &str, (events, effects): (&str, &str), share: f64, source| {
        diameter_error(name, (share * CORRECTION, between_parts(&batch(passes, events, effects))), source)
    };
    let geometry = "the nose stands elsewhere by half of it";
    let depth = "seed 002 (23): y = C (t - s)/(j + C)";
    let passes = "seed 002 (25)-(27), two passes";
    let two = 1.0 - copied * copied;
    vec![
        case("offset corrected, rigid machine", "", (CORRECTED, ""), 1.0, geometry),
        case("offset corrected, force as set", "", (CORRECTED, spring), 1.0, geometry),
        case("offset corrected, force fed back", "", (CORRECTED, &feedback), 1.0 - copied, depth),
        case("offset corrected, force fed back, two passes", pass, (CORRECTED, &feedback), two, passes),
        case("offset-correction, two passes", pass, ("", &format!("{feedback}\n{effect}")), two, passes),
    ]
}

/// 10 um/km; part 3 at x = 0.3 m is the first of the new insert, which has cut 0.4 of a pass.
fn inserts() -> Vec<Case> {
    let whole = std::f64::consts::PI * 0.04 * 0.5 / 0.2e-3;
    let worn = "[tool-wear]\nrate = \"10 um/km\"";
    let changed = batch("", "inserts = [{ after = 2, diameter = \"3 um\" }]", worn);
    let effect = format!("{worn}\n[insert-change]\nafter = 2");
    let path = changed.as_ref().map_or(f64::NAN, |lathe| lathe.setup().schedule.path(3, 0.3));
    let by_effect = shift(&batch("", "", &effect), 3, 0.3);
    let source = "seed 002 (31), (32): the path of one edge";
    vec![
        row("insert changed, part 3, x = 0.3 m", "cutting path", (0.4 * whole, path, "m"), ROUND_OFF, source),
        diameter_error(
            "insert changed, sits off by 3 um",
            (2e-8 * 0.4 * whole + 3e-6, shift(&changed, 3, 0.3)),
            source,
        ),
        diameter_error("insert-change, part 3, x = 0.3 m", (2e-8 * 0.4 * whole, by_effect), source),
    ]
}
