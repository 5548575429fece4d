//! The joint under test as a user meets it: summary, tables, bad input, friction that holds.

use super::fem::{Mistake, Place, model};

#[test]
fn the_summary_of_the_joint() {
    let place = Place::new();
    place.write("stiffness.toml", model("stiffness.toml"));
    let answer = place.fem(&["run", "stiffness.toml"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    insta::assert_snapshot!(answer.out);
    insta::assert_snapshot!("effects_stiffness", place.fem(&["effects", "stiffness"]).out);
}

#[test]
fn a_profile_is_a_measurement_of_its_own_model() {
    let place = Place::new();
    place.write("stiffness.toml", model("stiffness.toml"));
    assert_eq!(place.fem(&["run", "stiffness.toml", "-o", "out"]).status, 0);
    let compared = place.fem(&["compare", "stiffness.toml", "--with", "out/profile.csv", "--json"]).out;
    let json: serde_json::Value = serde_json::from_str(&compared).unwrap();
    assert!(json["models"][0]["rms"].as_f64().unwrap() < 1e-9, "{compared}");
    assert_eq!(json["observations"], 50);
}

#[test]
fn tangents_stand_in_a_table_where_the_joint_moves() {
    let place = Place::new();
    place.write("stiffness.toml", model("stiffness.toml"));
    place.fem(&["run", "stiffness.toml", "-o", "out"]);
    let table = place.read("out/tangent.csv");
    let rows: Vec<Vec<&str>> = table.lines().skip(1).map(|l| l.split(',').collect()).collect();
    // Of 24 steps of 50 N up friction (90 N) holds the first two, and of those down the first three and
    // half of the fourth.
    assert_eq!((rows.iter().filter(|r| r[1] == "load").count(), rows.len()), (22, 22 + 20), "{table}");
    let number = |row: &[&str], column: usize| row[column].parse::<f64>().unwrap();
    // 1025 N up: S = 935 N has relaxed the one side, and the other of 70 N/um and a contact's 0.5·0.15/√S is pressed
    // less by what 250 N have pressed before.
    let at = rows.iter().find(|r| r[0] == "1025" && r[1] == "load").unwrap();
    let expected = 1.0 / (1.0 / 70.0 + 0.5 * 0.15 / 935f64.sqrt());
    assert!((number(at, 3) - expected).abs() < 1e-9 && (number(at, 5) - expected).abs() < 1e-9, "{at:?}");
    let pressed = 250.0 / 70.0 + 0.15 * 250f64.sqrt();
    assert!((number(at, 4) - number(at, 2) - pressed).abs() < 1e-9, "{at:?}");
}

/// (in the model, replaced by, part of the message, part of the remedy)
const CASES: &[Mistake] = &[
    ("stiffness = \"70 +- 5 N/um\"", "", "`stiffness` is missing in `joint`", "add stiffness"),
    ("\"70 +- 5 N/um\"", "\"0 N/um\"", "`stiffness` is 0 N/um", "above zero"),
    ("\"1200 N\"", "\"1200 um\"", "not a force", "write it in N"),
    ("steps = 24", "steps = 0", "`steps` is 0", "whole number from 1"),
    ("steps = 24", "loading = \"both\"", "`loading` is \"both\"", "from-zero"),
    ("n = 0.5", "n = 1.5", "`n` is 1.5", "above 0 and at most 1"),
    ("\"90 N\"", "\"-90 N\"", "`force` is -90 N", "zero or more"),
    ("[effects.preload]", "[effects.preloaded]", "`preloaded` is no effect", "did you mean `preload`?"),
];

#[test]
fn bad_input_is_told_with_its_remedy() {
    let good = model("stiffness.toml");
    let place = Place::new();
    place.refuses(("run", "stiffness.toml"), &good, CASES);
    assert!(!place.files().iter().any(|f| f.starts_with("out")));
}

/// A joint of 80 N/um that settles by 3 um, read by a gauge that is 2 um off.
#[test]
fn settling_and_a_gauge_that_is_off_are_named() {
    let place = Place::new();
    place.write(
        "joint.toml",
        "process = \"stiffness\"\njoint = { stiffness = \"80 N/um\" }\ntest = { max_force = \"1000 N\" }\n",
    );
    // Noise of a standard deviation of about 0.1, drawn once.
    let noise = [0.08, -0.13, 0.05, 0.16, -0.02, -0.09, 0.11, 0.03, -0.17, 0.06, -0.05];
    let mut rows = String::from("force [N],branch,displacement [um],u [um]\n");
    for i in 0..=20 {
        let force = 50.0 * f64::from(i);
        rows +=
            &format!("{force},load,{:.3},0.1\n", force / 80.0 + 3.0 * force / 1000.0 + 2.0 + noise[i as usize % 11]);
    }
    for i in (0..=20).rev() {
        let force = 50.0 * f64::from(i);
        rows += &format!("{force},unload,{:.3},0.1\n", force / 80.0 + 3.0 + 2.0 + noise[(3 * i as usize + 4) % 11]);
    }
    place.write("m.csv", rows);
    let told = place.fem(&["diagnose", "joint.toml", "--with", "m.csv", "--json"]).out;
    let json: serde_json::Value = serde_json::from_str(&told).unwrap();
    assert_eq!(json["verdict"], "missing-effect", "{told}");
    let missing = json["missing"].as_array().unwrap();
    let value = |effect: &str, parameter: &str| {
        let own = missing.iter().find(|m| m["effect"] == effect).unwrap_or_else(|| panic!("{told}"));
        own["parameters"][parameter]["value"].as_f64().unwrap()
    };
    assert_eq!(missing.len(), 2, "{told}");
    assert!((value("settling", "depth") - 3.0).abs() < 0.15, "{told}");
    assert!((value("datum-offset", "offset") - 2.0).abs() < 0.15, "{told}");
}

#[test]
fn what_friction_holds_is_warned_of() {
    let place = Place::new();
    for (friction, warning) in [("1300 N", "holds the joint still"), ("700 N", "it does not come back")] {
        place.write("stiffness.toml", model("stiffness.toml").replace("\"90 N\"", &format!("\"{friction}\"")));
        let answer = place.fem(&["run", "stiffness.toml"]);
        assert_eq!(answer.status, 0);
        assert!(answer.err.contains(warning), "{}", answer.err);
    }
}

#[test]
fn forces_beyond_the_test_are_refused() {
    let place = Place::new();
    place.write("stiffness.toml", model("stiffness.toml"));
    place.write("m.csv", "force [kN],branch,displacement [um]\n1.3,unload,9\n1.34,load,9\n-0.1,load,0\n");
    let answer = place.fem(&["compare", "stiffness.toml", "--with", "m.csv"]);
    assert_eq!(answer.status, 2);
    let told = answer.err.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(told.contains("1340 N is beyond the test, which ends at max_force = 1200 N"), "{told}");
    assert!(told.contains("`force` is below zero"), "{told}");
    // Where the largest force was rounded, loading ends where the rows do: both branches meet there.
    place.write("m.csv", "force [kN],branch,displacement [um]\n1.28,load,9\n1.28,unload,9\n");
    let rounded = place.fem(&["compare", "stiffness.toml", "--with", "m.csv", "-o", "out"]);
    assert!(rounded.status <= 1, "{}", rounded.err);
    let residuals = place.read("out/residuals.csv");
    let predicted: Vec<&str> = residuals.lines().skip(1).filter_map(|line| line.split(',').nth(3)).collect();
    assert_eq!(predicted[0], predicted[1], "{residuals}");
}

#[test]
fn a_preload_has_taken_the_clearance_up() {
    let place = Place::new();
    let with_gap = model("stiffness.toml") + "\n[effects.gap]\ngap = \"3 um\"\n";
    place.write("both.toml", &with_gap);
    place.write("none.toml", model("stiffness.toml"));
    let [both, none] = ["both.toml", "none.toml"].map(|file| place.fem(&["run", file, "--json"]));
    assert!(both.err.contains("`gap` changes nothing"), "{}", both.err);
    let [both, none] = [both, none].map(|a| serde_json::from_str::<serde_json::Value>(&a.out).unwrap());
    assert!(none["findings"]["largest"]["value"].is_number());
    assert_eq!(both["findings"]["largest"], none["findings"]["largest"]);
    // Without the preload the 3 um are lost on every reversal.
    let lost = |json: &serde_json::Value| json["findings"]["preload"]["without"]["lost_motion"].as_f64().unwrap();
    assert!((lost(&both) - lost(&none) - 3.0).abs() < 1e-9);
}

#[test]
fn a_reversed_force_is_read_and_what_needs_a_first_loading_refused() {
    let place = Place::new();
    let reversed = model("stiffness.toml").replace("max_force", "loading = \"reversed\"\nmax_force");
    place.write("stiffness.toml", &reversed);
    let ran = place.fem(&["run", "stiffness.toml", "-o", "out"]);
    assert_eq!((ran.status, ran.err.as_str()), (0, ""));
    assert!(ran.out.contains("lost motion") && ran.out.contains("where the force changes its sign"), "{}", ran.out);
    let compared = place.fem(&["compare", "stiffness.toml", "--with", "out/profile.csv", "--json"]).out;
    let json: serde_json::Value = serde_json::from_str(&compared).unwrap();
    assert!(json["models"][0]["rms"].as_f64().unwrap() < 1e-9, "{compared}");
    // 24 steps either way from no force, up and down.
    assert_eq!(json["observations"], 98);
    place.write("stiffness.toml", reversed + "\n[effects.settling]\ndepth = \"2 um\"\n");
    let refused = place.fem(&["run", "stiffness.toml"]);
    assert_eq!(refused.status, 2);
    assert!(refused.err.contains("needs a first loading"), "{}", refused.err);
}

/// Friction that the force never overcomes: nothing moves, and nothing is told with a sign.
#[test]
fn a_reversed_force_that_friction_holds_does_no_work() {
    let place = Place::new();
    let held = "process = \"stiffness\"\njoint.stiffness = \"80 N/um\"\n\
        test = { max_force = \"100 N\", loading = \"reversed\" }\neffects.dry-friction.force = \"200 N\"\n";
    place.write("held.toml", held);
    let ran = place.fem(&["run", "held.toml"]);
    assert_eq!(ran.status, 0, "{}", ran.err);
    assert!(ran.out.contains("work of friction         0.0 uJ") && !ran.out.contains("-0.0 uJ"), "{}", ran.out);
}

#[test]
fn fitted_values_with_which_nothing_runs_are_told_and_not_written() {
    let place = Place::new();
    let far = model("stiffness.toml").replace("70 +- 5 N/um", "70 +- 15 N/um").replace("1200 N", "1e9 N");
    assert!(far.contains("1e9 N"), "{far}");
    place.write("joint.toml", far);
    let row = |force: f64, way: &str| format!("{force},{way},{:.4},0.1\n", force / 60.0 + 0.15 * force.sqrt());
    let rows: String =
        (0..=20).map(|k| row(50.0 * f64::from(k), "load") + &row(50.0 * f64::from(k), "unload")).collect();
    place.write("measured.csv", format!("force [N],direction,displacement [um],u [um]\n{rows}"));
    let fitted = place.fem(&["fit", "joint.toml", "--with", "measured.csv", "--add-to", "fitted.toml"]);
    assert_eq!(fitted.status, 1, "{}", fitted.err);
    assert!(
        fitted.err.contains("cannot be run, and is not written") && fitted.err.contains("no joint"),
        "{}",
        fitted.err
    );
    assert!(fitted.out.contains("joint.stiffness") && !place.path("fitted.toml").exists(), "{}", fitted.out);
}
