//! Forces recorded along the part, in the place of one number.

use std::f64::consts::PI;

use super::fem::{Mistake, Place, model};

/// A shaft between rigid centres whose force was measured along it.
const SHAFT: &str = r#"process = "turning"
[workpiece]
material = { base = "steel", youngs_modulus = "210 GPa", poisson_ratio = 0.3 }
segments = [{ length = "600 mm", diameter = "40 mm" }]
[workholding]
type = "centres"
[cut]
depth = "1 mm"
feed = "0.2 mm/rev"
spindle_speed = "600 rpm"
radial_force = { file = "force.csv" }
[sweep]
positions = 13
"#;

/// Straight from 500 N at the headstock to 200 N at 300 mm, and up again.
const FORCE: &str = "x [mm],radial_force [N]\n0,500\n300,200\n600,350\n";

#[test]
fn a_shaft_bends_under_the_force_that_was_recorded_at_the_tool() {
    let place = Place::new();
    place.write("shaft.toml", SHAFT);
    place.write("force.csv", FORCE);
    let answer = place.fem(&["run", "shaft.toml", "-o", "out"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let [x, error] = ["x", "diameter_error"].map(|name| place.column("out/profile.csv", name));
    assert_eq!(x.len(), 13);
    for (x, error) in x.into_iter().zip(error) {
        // Simply supported, y = F x² (L − x)² / (3 E I L) + F x (L − x) / (κ G A L), κ = 6 (1 + ν) / (7 + 6 ν) by
        // Cowper; twice that on the diameter. mm, N, MPa.
        let force = if x < 300.0 { 500.0 - x } else { 200.0 + 0.5 * (x - 300.0) };
        let (area, inertia) = (0.25 * PI * 40f64.powi(2), PI * 40f64.powi(4) / 64.0);
        let (shear, coefficient) = (210e3 / 2.6, 7.8 / 8.8);
        let legs = x * (600.0 - x) / 600.0;
        let compliance = legs.powi(2) * 600.0 / (3.0 * 210e3 * inertia) + legs / (coefficient * shear * area);
        let expected = 2e3 * force * compliance;
        assert!((error - expected).abs() < 1e-5 * (1.0 + expected), "{x} mm: {error}, {expected} um");
    }
}

#[test]
fn a_part_gives_way_under_the_force_of_the_cutter_that_was_recorded_there() {
    let place = Place::new();
    let constant = model("fixture.toml");
    assert!(constant.contains("force = \"350 N\""));
    place.write("constant.toml", &constant);
    place.write(
        "recorded.toml",
        constant.replace("force = \"350 N\"", "force = { file = \"force.csv\", value = \"cutter\" }"),
    );
    place.write("force.csv", "x [mm],cutter [N]\n0,100\n200,500\n600,150\n");
    assert_eq!(place.fem(&["run", "recorded.toml", "-o", "out"]).status, 0);
    let force = place.column("out/profile.csv", "cutter_force");
    assert!(force[0] < force[force.len() / 3] && force[force.len() / 3] > force[force.len() - 1]);
    // Rows that carry their own force are milled alike, whatever the model says.
    for name in ["constant.toml", "recorded.toml"] {
        let compared = place.fem(&["compare", name, "--with", "out/profile.csv", "--json"]).out;
        let json: serde_json::Value = serde_json::from_str(&compared).unwrap();
        assert!(json["models"][0]["rms"].as_f64().unwrap() < 1e-9, "{compared}");
    }
}

/// (in the model, replaced by, part of the message, part of the remedy)
const CASES: &[Mistake] = &[
    ("force.csv", "farce.csv", "farce.csv: the file cannot be read", "relative to the folder of the model file"),
    ("\"600 mm\", d", "\"700 mm\", d", "force.csv", "record"),
    ("{ file", "{ fil = \"a\", file", "`fil` is no key of `cut.radial_force`", "its keys are file, x, value"),
];

#[test]
fn records_that_do_not_fit_are_refused() {
    let place = Place::new();
    place.write("force.csv", FORCE);
    place.refuses(("run", "shaft.toml"), SHAFT, CASES);
    place.write("shaft.toml", SHAFT);
    place.write("force.csv", FORCE.replace("200", "-200"));
    let answer = place.fem(&["run", "shaft.toml"]);
    assert!(answer.status == 2 && answer.err.contains("force.csv"), "{}", answer.err);
}
