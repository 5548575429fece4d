//! The feed axis as a user meets it: summary, files, bad input, and a diagnosis of play.

use serde_json::Value as Json;

use super::fem::{Mistake, Place, model};

#[test]
fn the_summary_of_the_axis() {
    let place = Place::new();
    place.write("axis.toml", model("axis.toml"));
    let answer = place.fem(&["run", "axis.toml"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    insta::assert_snapshot!(answer.out);
    insta::assert_snapshot!("effects_axis", place.fem(&["effects", "axis"]).out);
}

#[test]
fn a_profile_is_a_measurement_of_its_own_model() {
    let place = Place::new();
    place.write("axis.toml", model("axis.toml"));
    assert_eq!(place.fem(&["run", "axis.toml", "-o", "out"]).status, 0);
    assert!(place.read("out/profile.csv").starts_with("run,position [mm],direction,time [min],deviation [um]\n1,"));
    let compared = place.fem(&["compare", "axis.toml", "--with", "out/profile.csv", "--json"]).out;
    let json: Json = serde_json::from_str(&compared).unwrap();
    assert!(json["models"][0]["rms"].as_f64().unwrap() < 1e-9, "{compared}");
}

/// (play um, friction N, which rules)
const CLEARANCES: &[(f64, f64, &str)] =
    &[(0.0, 0.0, "none"), (20.0, 100.0, "kinematic"), (1.0, 2000.0, "elastic"), (5.0, 500.0, "both")];

#[test]
fn the_clearance_that_rules_is_told() {
    let text = model("axis.toml").split("[effects").next().unwrap().to_string();
    let place = Place::new();
    for (gap, friction, rules) in CLEARANCES {
        let effects = format!(
            "[effects.backlash]\ngap = \"{gap} um\"\n[effects.elastic-lost-motion]\nfriction = \"{friction} N\"\nstiffness = \"250 N/um\"\n"
        );
        place.write("axis.toml", format!("{text}{effects}"));
        let json: Json = serde_json::from_str(&place.fem(&["run", "axis.toml", "--json"]).out).unwrap();
        assert_eq!(json["findings"]["lost_motion"]["rules"], *rules, "{gap} um, {friction} N");
    }
}

#[test]
fn targets_on_one_part_of_the_turn_are_warned_of() {
    let place = Place::new();
    place.write("axis.toml", model("axis.toml").replace("\"staggered\"", "\"even\""));
    let answer = place.fem(&["run", "axis.toml"]);
    assert!(answer.err.contains("all targets are multiples of the lead"), "{}", answer.err);
    // There a turn's error cannot be told from a shift, and the plan says what to measure.
    place.write("axis.toml", place.read("axis.toml").split("[effects").next().unwrap());
    let plan = place.fem(&["plan", "axis.toml", "--noise", "0.5 um", "--json"]).out;
    assert!(plan.contains("each at another part of the screw's turn"), "{plan}");
}

/// (in the model, replaced by, part of the message, part of the remedy)
const CASES: &[Mistake] = &[
    ("travel = \"700 mm\"", "travle = \"700 mm\"", "`travle` is no key of `axis`", "did you mean `travel`?"),
    ("\"700 mm\"", "\"-700 mm\"", "`travel` is -700 mm", "above zero"),
    ("\"700 mm\"", "\"700 N\"", "not a length", "write it in mm"),
    ("lead = \"10 mm\"", "", "`lead` is missing in `screw`", "add lead"),
    ("positions = 11", "positions = 1", "`positions` is 1", "whole number from 2"),
    ("\"staggered\"", "\"stagered\"", "`spacing` is", "did you mean \"staggered\"?"),
    (
        "fixed_at = \"0 mm\"",
        "fixed_at = \"0 mm\"\nalso_fixed_at = \"780 mm\"",
        "`thermal-growth` needs a screw that is free to grow",
        "remove the effect",
    ),
    (
        "fixed_at = \"0 mm\"",
        "fixed_at = \"0 mm\"\nalso_fixed_at = \"0 mm\"",
        "both bearings stand at one place",
        "name the other end",
    ),
    ("friction = \"450 +- 100 N\"", "", "`friction` is missing", "add friction"),
    ("gap = \"8 +- 2 um\"", "gap = \"-8 um\"", "`gap` is -8 um", "zero or more"),
];

#[test]
fn bad_input_is_told_with_its_remedy() {
    let good = model("axis.toml");
    let place = Place::new();
    place.refuses(("run", "axis.toml"), &good, CASES);
    assert!(!place.files().iter().any(|f| f.starts_with("out")));
}

/// (header and rows, part of what is told)
const ROWS: &[(&str, &str)] = &[
    ("position [mm],deviation [um]\n0,1\n", "the column `direction` is missing"),
    ("direction,deviation [um]\n+,1\n", "the column `position` is missing"),
    ("position [mm],direction,deviation [um]\n0,left,1\n", "`left` in `direction` is no direction"),
    ("position [mm],direction,time [min],deviation [um]\n0,+,-1,1\n", "`time` is below zero"),
];

#[test]
fn rows_that_are_no_approach_are_refused() {
    let place = Place::new();
    place.write("axis.toml", model("axis.toml"));
    for (rows, message) in ROWS {
        place.write("m.csv", rows);
        let answer = place.fem(&["compare", "axis.toml", "--with", "m.csv"]);
        let told = answer.err.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(answer.status, 2, "{told}");
        assert!(told.contains(message), "{told}");
    }
}

#[test]
fn what_cannot_be_a_deviation_is_told() {
    let place = Place::new();
    place.write("axis.toml", model("axis.toml").replace("\"18 um/m\"", "\"2 m/m\""));
    let answer = place.fem(&["run", "axis.toml"]);
    assert_eq!(answer.status, 1, "{}", answer.err);
    assert!(answer.err.contains("as large as the travel"), "{}", answer.err);
}
