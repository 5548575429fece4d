//! The batch in time: schedule, wear, growth and drift, against schedules integrated by hand.

use super::rig::*;
use crate::processes::turning::schedule::Schedule;
use crate::validation::{Case, Tolerance};

/// Ø40 × 500 mm at 0.2 mm/rev and 500 rpm: 5 min of cutting. Every 8 min a part, 20 min of rest after the
/// second.
const BATCH: &str = r#"
    workpiece = { material = "steel", segments = [{ length = "500 mm", diameter = "40 mm" }] }
    workholding = { type = "centres" }
    cut = { depth = "0.5 mm", feed = "0.2 mm/rev", spindle_speed = "500 rpm", radial_force = "400 N" }
    batch = { parts = 3, cycle_time = "8 min", pauses = [{ after = 2, duration = "20 min" }] }
"#;

pub fn cases() -> Vec<Case> {
    let pi = std::f64::consts::PI;
    let plain = lathe(BATCH, "");
    let schedule = |of: fn(&Schedule) -> f64| plain.as_ref().map_or(f64::NAN, |l| of(&l.setup().schedule));
    let whole = pi * 0.04 * 0.5 / 0.2e-3;
    let time = ((16.0 + 20.0 + 2.0) * 60.0, schedule(|s| s.time(3, 0.3)), "s");
    let path = (2.4 * whole, schedule(|s| s.path(3, 0.3)), "m");
    let source = "pi D dx / feed";
    let mut cases = vec![
        row("third part after a pause, x = 0.3 m", "time", time, ROUND_OFF, "by hand"),
        row("third part, x = 0.3 m", "cutting path", path, ROUND_OFF, source),
        row("stepped shaft, whole pass", "cutting path", (stepped_path(), stepped(), "m"), ROUND_OFF, source),
    ];
    cases.extend(wear(2.4 * whole));
    cases.extend(edge(2.4 * whole));
    cases.extend(growth());
    cases.extend(drift());
    cases
}

fn stepped_path() -> f64 {
    std::f64::consts::PI * (0.04 * 0.15 + 0.05 * 0.3) / 0.2e-3
}

fn stepped() -> f64 {
    let text = BATCH.replace(
        "{ length = \"500 mm\", diameter = \"40 mm\" }",
        "{ length = \"150 mm\", diameter = \"40 mm\" }, { length = \"300 mm\", diameter = \"50 mm\" }",
    );
    lathe(&text, "").map_or(f64::NAN, |l| l.setup().schedule.path(1, 0.0))
}

/// The third period, and the land from which wear is told: one part and two paths by hand.
fn edge(path: f64) -> Vec<Case> {
    let onset = 200.0;
    let breakdown = |exponent: f64| {
        let effect = format!(
            "[tool-breakdown]\nwear = \"80 um\"\nonset = \"{onset} m\"\nexponent = {exponent}\n[tool-wear]\nrate = \"10 um/km\""
        );
        shift(&lathe(BATCH, &effect), 3, 0.3)
    };
    let beyond = |exponent: f64| 2.0 * (80e-6 * (1e-3 * (path - onset)).powf(exponent) + 1e-8 * path);
    let third = "power law beyond the onset, ours; steady wear by seed 002 (32)";
    let land = "land = [{ path = \"0 m\", width = \"40 um\" }, { path = \"2 km\", width = \"200 um\" }]";
    let with = |more: &str| format!("{BATCH}\nedge = {{ clearance_angle = \"8 deg\", {more} }}");
    let by_land = shift(&lathe(&with(land), "[wear-land]"), 3, 0.3);
    let tangent = 8f64.to_radians().tan();
    let drawn_back = 2.0 * (40e-6 + 160e-6 * path / 2000.0) * tangent;
    // 10 um/km reach 0.1 mm of land at U = 0.1 mm·tan α.
    let lasting = lathe(&with("largest_land = \"0.1 mm\""), "[tool-wear]\nrate = \"10 um/km\"");
    let life = 1e-4 * tangent / 1e-8;
    let told = |key: &str| crate::validation::bench::figure(&lasting, "wear_land", key);
    let land_law = "seed 002 (31): U = h tan(alpha)";
    vec![
        diameter_error("third period, exponent 2, part 3", (beyond(2.0), breakdown(2.0)), third),
        diameter_error("third period, exponent 1.5, part 3", (beyond(1.5), breakdown(1.5)), third),
        diameter_error("wear land over the path, part 3, x = 0.3 m", (drawn_back, by_land), land_law),
        row("largest land of 0.1 mm", "cutting path", (life, told("life"), "m"), ROUND_OFF, land_law),
        row("largest land of 0.1 mm", "path left", (life - path / 2.4 * 3.0, told("left"), "m"), LIFE, land_law),
    ]
}

/// A difference of paths that are exact to round-off.
const LIFE: Tolerance = Tolerance::Relative(1e-10);

fn wear(path: f64) -> Vec<Case> {
    let worn = lathe(BATCH, "[tool-wear]\nrun_in = \"3 um\"\nrun_in_path = \"300 m\"\nrate = \"10 um/km\"");
    let steady = lathe(BATCH, "[tool-wear]\nrate = \"10 um/km\"");
    let source = "seed 002 (31), (32)";
    let expected = 2.0 * (3e-6 * (1.0 - (-path / 300.0).exp()) + 1e-8 * path);
    vec![
        diameter_error("tool wear, part 3, x = 0.3 m", (expected, shift(&worn, 3, 0.3)), source),
        diameter_error("steady wear alone, part 3, x = 0.3 m", (2e-8 * path, shift(&steady, 3, 0.3)), source),
    ]
}

/// τ = 4 min, 10 um. Cut 5 min, rest 3; cut 5, rest 3 + 20; cut.
fn growth() -> Vec<Case> {
    let growing = lathe(BATCH, "[tool-thermal-growth]\nelongation = \"10 um\"\ntime_constant = \"4 min\"");
    let (heat, cool) =
        (|xi: f64, t: f64| 10.0 + (xi - 10.0) * (-t / 4.0f64).exp(), |xi: f64, t: f64| xi * (-t / 4.0f64).exp());
    let second = cool(heat(0.0, 5.0), 3.0);
    let third = cool(heat(second, 5.0), 23.0);
    let source = "seed 002, length of the tool over a batch: tau xi' = e[cutting] - xi, by hand";
    let at = |name: &str, part, x, xi: f64| diameter_error(name, (-2e-6 * xi, shift(&growing, part, x)), source);
    vec![
        at("tool growth, part 1, end of the cut", 1, 0.0, heat(0.0, 5.0)),
        at("tool growth, part 2, x = 0.3 m", 2, 0.3, heat(second, 2.0)),
        at("tool growth, part 3 after a pause, start", 3, 0.5, third),
        at("tool growth, part 3 after a pause, x = 0.3 m", 3, 0.3, heat(third, 2.0)),
    ]
}

fn drift() -> Vec<Case> {
    let effect = "[spindle-thermal-drift]\ndrift = \"7 um\"\ntime_constant = \"30 min\"";
    let warming = 14e-6 * (1.0 - (-38.0f64 / 30.0).exp());
    let source = "seed 002, thermal deformation of the system";
    let chucked = lathe(&BATCH.replace("centres", "chuck"), effect);
    let start = (0.0, shift(&chucked, 1, 0.5), "m");
    vec![
        diameter_error(
            "spindle drift, part 3, x = 0.6 L",
            (0.4 * warming, shift(&lathe(BATCH, effect), 3, 0.3)),
            source,
        ),
        diameter_error("spindle drift in a chuck, part 3", (warming, shift(&chucked, 3, 0.3)), source),
        row("spindle drift at the start", "diameter error", start, Tolerance::Absolute(0.0), source),
    ]
}
