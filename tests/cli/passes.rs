//! Several passes as a user meets them: refinement under both names, what is left, and passes that cannot be.

use serde_json::Value as Json;

use super::fem::{Mistake, Place, model};

#[test]
fn the_summary_of_three_passes() {
    let place = Place::new();
    place.write("passes.toml", model("passes.toml"));
    let answer = place.fem(&["run", "passes.toml"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    insta::assert_snapshot!(answer.out);
    let json: Json = serde_json::from_str(&place.read("out/passes/summary.json")).unwrap();
    let passes = &json["findings"]["passes"];
    let list = passes["list"].as_array().unwrap();
    assert_eq!(list.len(), 3);
    let of = |entry: &Json, key: &str| entry[key].as_f64().unwrap();
    for pair in list.windows(2) {
        assert_eq!(of(&pair[0], "after"), of(&pair[1], "before"));
    }
    // Both names of refinement, of each pass and of all.
    for entry in list.iter().chain([passes]) {
        assert!((of(entry, "K") * of(entry, "q") - 1.0).abs() < 1e-12);
    }
    let product: f64 = list.iter().map(|p| of(p, "K")).product();
    assert!((product - of(passes, "K")).abs() < 1e-12);
    // The table's last pass is the profile.
    let table = place.read("out/passes/passes.csv");
    let last: f64 = table.lines().last().unwrap().rsplit(',').next().unwrap().parse().unwrap();
    let profile = place.read("out/passes/profile.csv");
    let error: f64 = profile.lines().last().unwrap().split(',').nth(4).unwrap().parse().unwrap();
    assert!((last - error).abs() < 1e-9, "{last} and {error}");
}

#[test]
fn a_profile_is_a_measurement_of_its_own_model() {
    let place = Place::new();
    place.write("passes.toml", model("passes.toml"));
    assert_eq!(place.fem(&["run", "passes.toml", "-o", "out"]).status, 0);
    let compared = place.fem(&["compare", "passes.toml", "--with", "out/profile.csv", "--json"]).out;
    let json: Json = serde_json::from_str(&compared).unwrap();
    assert!(json["models"][0]["rms"].as_f64().unwrap() < 1e-9, "{compared}");
}

/// Stock that is thinner than the finished shaft stays as it is, whatever else moves the tool.
#[test]
fn what_the_tool_does_not_reach_is_left() {
    let place = Place::new();
    let worn = "\n[effects.tool-wear]\nrun_in = \"20 um\"\nrun_in_path = \"10 m\"\nrate = \"0 um/km\"\n";
    place.write("passes.toml", model("passes.toml") + worn);
    let row = "x [mm],blank [mm],diameter_error [um],u [um]\n";
    place.write("thin.csv", format!("{row}100,49.9,-100,1\n200,49.995,-5,1\n300,50,0,1\n"));
    let compared = place.fem(&["compare", "passes.toml", "--with", "thin.csv", "--json"]).out;
    let json: Json = serde_json::from_str(&compared).unwrap();
    assert!(json["models"][0]["rms"].as_f64().unwrap() < 1e-9, "{compared}");
}

/// P = P₀·t_d/t₀ and t_d = t + Δ·cos(2θ) − y with y = P/j: the force runs between 2000·(1 ± 0.25)/1.02 N; lobes that are
/// deeper than the cut leave the tool in the air.
#[test]
fn forces_are_told_all_around_a_lobed_blank() {
    let place = Place::new();
    let lathe = |amplitude: f64| {
        format!(
            "process = \"turning\"\n[workpiece]\nmaterial = \"steel\"\n\
             segments = [{{ length = \"300 mm\", diameter = \"2000 mm\" }}]\n\
             lobes = [{{ lobes = 2, amplitude = \"{amplitude} mm\" }}]\n[workholding]\ntype = \"centres\"\n\
             [cut]\ndepth = \"1 mm\"\nfeed = \"0.2 mm/rev\"\nspindle_speed = \"600 rpm\"\nradial_force = \"2 kN\"\n\
             [effects.force-feedback]\nexponent = 1.0\n[effects.carriage-compliance]\nstiffness = \"100 N/um\"\n"
        )
    };
    let run = |amplitude: f64| {
        place.write("lobed.toml", lathe(amplitude));
        let answer = place.fem(&["run", "lobed.toml", "--json"]);
        assert_eq!(answer.status, 0, "{}", answer.err);
        serde_json::from_str::<Json>(&answer.out).unwrap()
    };
    let told = run(0.25);
    let force = |key: &str| told["findings"]["radial_force"][key].as_f64().unwrap();
    for (key, depth) in [("smallest", 0.75), ("largest", 1.25)] {
        // The shaft is a disc: what it yields is some 1e-4 of what the carriage does.
        let expected = 2000.0 * depth / 1.02;
        assert!((force(key) / expected - 1.0).abs() < 1e-4, "{key}: {} N, not {expected} N", force(key));
    }
    assert_eq!(told["warnings"], serde_json::json!([]));
    let deep = run(1.25);
    let warning = deep["warnings"][0].as_str().unwrap();
    assert!(warning.contains("does not touch the work at 101 of 101 positions"), "{warning}");
}

#[test]
fn what_copies_nothing_is_warned_of() {
    let place = Place::new();
    place.write("passes.toml", model("passes.toml").split("[effects.force-feedback]").next().unwrap());
    let answer = place.fem(&["run", "passes.toml"]);
    assert_eq!(answer.status, 0);
    assert!(answer.err.contains("without the effect `force-feedback` nothing is copied"), "{}", answer.err);
}

/// (in the model, replaced by, part of the message, part of the remedy)
const CASES: &[Mistake] = &[
    ("depth = \"2 mm\"", "dept = \"2 mm\"", "`dept` is no key of `pass[0]`", "did you mean `depth`?"),
    ("depth = \"0.8 mm\"", "depth = \"-0.8 mm\"", "`depth` is -0.8 mm", "above zero"),
    (
        "force = { C = 950.0, x = 0.9, y = 0.75 }",
        "radial_force = \"300 N\"",
        "what the force is at another feed is not known",
        "add radial_force",
    ),
    ("exponent = 0.9", "exponent = 1.0", "x is 0.9 in the force law", "write exponent = 0.9"),
    ("exponent = 0.9", "exponent = \"0.8 +- 0.1\"", "x is 0.9 in the force law", "radial_force"),
    ("waves = 3", "waves = -3", "`waves` is -3", "zero or more"),
    (
        "# blank_points = [{ at = \"0 mm\", error = \"0.1 mm\" }, { at = \"400 mm\"",
        "blank_points = [{ at = \"0 mm\", error = \"0.1 mm\" }, { at = \"401 mm\"",
        "the place lies beyond the shaft",
        "400 mm long",
    ),
    (
        "# blank_points = [{ at = \"0 mm\", error = \"0.1 mm\" }, { at = \"400 mm\"",
        "blank_points = [{ at = \"10 mm\", error = \"0.1 mm\" }, { at = \"5 mm\"",
        "the places do not rise",
        "each once",
    ),
];

#[test]
fn bad_input_is_told_with_its_remedy() {
    let good = model("passes.toml");
    let place = Place::new();
    place.refuses(("run", "passes.toml"), &good, CASES);
}

/// An exponent that a search may move is the law's own in the file.
#[test]
fn one_exponent_may_be_known_roughly() {
    let place = Place::new();
    place.write("passes.toml", model("passes.toml").replace("exponent = 0.9", "exponent = \"0.9 +- 0.05\""));
    assert_eq!(place.fem(&["run", "passes.toml"]).status, 0);
}

/// At its mark an oval blank meets the tool as one does that is larger by the ovality all around, on both sides; its
/// prediction is the same, and another than that of a true one.
#[test]
fn an_oval_blank_is_predicted_as_it_meets_the_tool() {
    let place = Place::new();
    let profile = |blank: &str| {
        let model = format!(
            "process = \"turning\"\nworkpiece = {{ material = \"steel\", segments = \
             [{{ length = \"200 mm\", diameter = \"40 mm\" }}]{blank} }}\nworkholding.type = \"chuck\"\n\
             cut = {{ depth = \"1 mm\", feed = \"0.2 mm/rev\", spindle_speed = \"800 rpm\", radial_force = \"300 N\" }}\n\
             effects.carriage-compliance.stiffness = \"20 N/um\"\neffects.force-feedback.exponent = 0.9\n"
        );
        place.write("shaft.toml", model);
        let answer = place.fem(&["run", "shaft.toml"]);
        assert_eq!(answer.status, 0, "{}", answer.err);
        place.read("out/shaft/profile.csv")
    };
    let oval = profile(", lobes = [{ lobes = 2, amplitude = \"50 um\" }]");
    let large = "[{ at = \"0 mm\", error = \"100 um\" }, { at = \"200 mm\", error = \"100 um\" }]";
    assert_eq!(oval, profile(&format!(", blank_points = {large}")));
    assert_ne!(oval, profile(""));
}
