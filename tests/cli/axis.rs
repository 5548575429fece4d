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
    assert!(answer.err.contains("all targets stand apart by multiples of the lead"), "{}", answer.err);
    // There a turn's error cannot be told from a shift, and the plan says what to measure.
    place.write("axis.toml", place.read("axis.toml").split("[effects").next().unwrap());
    let plan = place.fem(&["plan", "axis.toml", "--noise", "0.5 um", "--json"]).out;
    assert!(plan.contains("each at another part of the screw's turn"), "{plan}");
}

/// Backlash is often read at one place: a dial, forwards and back, a few times.
#[test]
fn one_target_is_a_test() {
    let place = Place::new();
    let ideal = model("axis.toml").split("[effects").next().unwrap().replace("positions = 11", "positions = 1");
    assert!(ideal.contains("positions = 1\n"), "{ideal}");
    place.write("axis.toml", &ideal);
    let run = place.fem(&["run", "axis.toml", "--json"]);
    assert_eq!(run.status, 0, "{}", run.err);
    // Play of 12 um, read to a tenth, at one place a little beyond the travel that was told in round numbers.
    let readings = [[0.1, 12.0], [-0.1, 11.9], [0.0, 12.2], [0.1, 12.1], [-0.1, 11.8]];
    let row = |(i, [there, back]): (usize, &[f64; 2])| format!("{0},705,+,{there},0.1\n{0},705,-,{back},0.1\n", i + 1);
    let rows: String = readings.iter().enumerate().map(row).collect();
    place.write("dial.csv", format!("run,position [mm],direction,deviation [um],u [um]\n{rows}"));
    let found = place.fem(&["diagnose", "axis.toml", "--with", "dial.csv", "--json"]);
    let json: Json = serde_json::from_str(&found.out).unwrap();
    let missing = &json["missing"][0];
    let alike = missing["indistinguishable_from"].to_string();
    assert!(missing["effect"] == "backlash" || alike.contains("backlash"), "{}", found.out);
    let table = place.fem(&["compensate", "axis.toml", "--with", "dial.csv"]);
    assert!(table.status <= 1 && table.out.contains("reversal"), "{} {}", table.out, table.err);
    place.write("far.csv", "run,position [mm],direction,deviation [um]\n1,750,+,0\n");
    let far = place.fem(&["compare", "axis.toml", "--with", "far.csv"]);
    assert!(far.status == 2 && far.err.contains("the axis travels from"), "{}", far.err);
}

/// (in the model, replaced by, part of the message, part of the remedy)
const CASES: &[Mistake] = &[
    ("travel = \"700 mm\"", "travle = \"700 mm\"", "`travle` is no key of `axis`", "did you mean `travel`?"),
    ("\"700 mm\"", "\"-700 mm\"", "`travel` is -700 mm", "above zero"),
    ("\"700 mm\"", "\"700 N\"", "not a length", "write it in mm"),
    ("lead = \"10 mm\"", "", "`lead` is missing in `screw`", "add lead"),
    ("positions = 11", "positions = 0", "`positions` is 0", "whole number from 1"),
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
    (
        "[effects.backlash]\ngap = \"8 +- 2 um\"",
        "[effects.worn-screw]\ndepth = \"-8 um\"",
        "`depth` is -8 um",
        "zero or more",
    ),
];

#[test]
fn bad_input_is_told_with_its_remedy() {
    let good = model("axis.toml");
    let place = Place::new();
    place.refuses(("run", "axis.toml"), &good, CASES);
    assert!(!place.files().iter().any(|f| f.starts_with("out")));
}

/// A screw whose temperature was recorded.
const SCREW: &str = r#"process = "axis"
[axis]
travel = "500 mm"
[screw]
material = "steel"
diameter = "32 mm"
lead = "10 mm"
temperature = { file = "screw.csv", value = "nut side" }
[test]
positions = 6
runs = 3
reading = "30 s"
"#;
const RECORD: &str = "time [min],nut side [degC]\n0,20\n10,24\n30,25\n";

/// (in the model, replaced by, part of the message, part of the remedy)
const SCREWS: &[Mistake] = &[
    ("runs = 3", "runs = 6", "from 0 min to 30 min, and is needed from 0 min to 36 min", "record it as far as that"),
    (
        "lead = \"10 mm\"",
        "lead = \"10 mm\"\nalso_fixed_at = \"600 mm\"",
        "held at either end",
        "leave `temperature` out",
    ),
    ("{ file = \"screw.csv\", value = \"nut side\" }", "\"-300 degC\"", "nothing is that cold", "-273.15"),
];

#[test]
fn a_screw_grows_with_its_recorded_temperature() {
    let place = Place::new();
    place.write("screw.csv", RECORD);
    place.refuses(("run", "axis.toml"), SCREW, SCREWS);
    place.write("axis.toml", SCREW);
    assert_eq!(place.fem(&["run", "axis.toml", "-o", "out"]).status, 0);
    // The first reading stands at the bearing; the sixth, at 500 mm after 3 min, has grown by 1.2 K.
    let deviation = |row: usize| {
        let profile = place.read("out/profile.csv");
        profile.lines().nth(row).unwrap().rsplit(',').next().unwrap().parse::<f64>().unwrap()
    };
    assert_eq!(deviation(1), 0.0);
    assert!((deviation(6) - 11.5 * 1.2 * 0.5).abs() < 1e-9, "{}", deviation(6));
    place.write("late.csv", "position [mm],direction,time [min],deviation [um]\n0,+,31,1\n");
    let answer = place.fem(&["compare", "axis.toml", "--with", "late.csv"]);
    assert!(answer.status == 2 && answer.err.contains("temperature ends at 30 min"), "{}", answer.err);
}

/// A slide whose drag was recorded: 200 N to 100 mm, 800 N from 400 mm on, 500 N on the mean.
const SLIDE: &str = r#"process = "axis"
[axis]
travel = "500 mm"
drag = { file = "drag.csv", value = "motor" }
[screw]
material = "steel"
diameter = "32 mm"
lead = "10 mm"
[test]
positions = 6
runs = 1
[effects.elastic-lost-motion]
friction = "500 N"
stiffness = "100 N/um"
"#;
const DRAG: &str = "position [mm],motor [N]\n-10,200\n100,200\n400,800\n500,800\n";

/// (in the model, replaced by, part of the message, part of the remedy)
const SLIDES: &[Mistake] = &[
    ("travel = \"500 mm\"", "travel = \"600 mm\"", "is needed from 0 mm to 600 mm", "record it as far as that"),
    ("{ file = \"drag.csv\", value = \"motor\" }", "\"-20 N\"", "`drag` is -20 N", "zero or more"),
    ("{ file = \"drag.csv\", value = \"motor\" }", "\"0 N\"", "nothing drags anywhere", "leave it out"),
    (
        "[screw]",
        "drag_points = [{ at = \"0 mm\", drag = \"1 N\" }, { at = \"500 mm\", drag = \"2 N\" }]\n[screw]",
        "`drag` says it already",
        "leave one of them out",
    ),
    (
        "drag = { file = \"drag.csv\", value = \"motor\" }",
        "drag_points = [{ at = \"0 mm\", drag = \"1 N\" }, { at = \"400 mm\", drag = \"2 N\" }]",
        "they do not reach over the travel",
        "from 0 mm to 500 mm",
    ),
    (
        "drag = { file = \"drag.csv\", value = \"motor\" }",
        "drag_points = [{ at = \"500 mm\", drag = \"1 N\" }, { at = \"0 mm\", drag = \"2 N\" }]",
        "the places do not rise",
        "each once",
    ),
];

#[test]
fn a_slide_is_held_back_by_the_drag_that_was_recorded_there() {
    let place = Place::new();
    place.write("drag.csv", DRAG);
    place.refuses(("run", "axis.toml"), SLIDE, SLIDES);
    place.write("axis.toml", SLIDE);
    assert_eq!(place.fem(&["run", "axis.toml", "-o", "out"]).status, 0);
    let profile = place.read("out/profile.csv");
    let deviation = |row: usize| profile.lines().nth(row).unwrap().rsplit(',').next().unwrap().parse::<f64>().unwrap();
    // 200 N at 100 mm, 400 at 200, 800 at 500: F (1/C + x/(EA)), there and, from the sixth row on, back.
    let rigidity = 210e3 * 0.25 * std::f64::consts::PI * 32.0 * 32.0;
    for (row, force, x) in [(2, 200.0, 100.0), (3, 400.0, 200.0), (6, 800.0, 500.0), (7, -800.0, 500.0)] {
        let expected = -force * (1.0 / 100.0 + 1e3 * x / rigidity);
        assert!((deviation(row) - expected).abs() < 1e-9, "{row}: {}, {expected}", deviation(row));
    }
}

/// Noise of a standard deviation of about one, drawn once.
const NOISE: [f64; 12] = [0.4, -1.3, 0.7, 1.6, -0.2, -0.9, 1.1, 0.3, -1.7, 0.8, -0.5, -0.3];

/// Deviations of four runs to nine targets there and back: what the way back has at a part of the travel.
fn tested(back: impl Fn(f64) -> f64) -> String {
    let mut text = String::from("run,position [mm],direction,deviation [um],u [um]\n");
    let places: Vec<f64> = (0..9).map(|i| 37.0 * f64::from(i) + 3.0 * f64::from(i % 4)).collect();
    let mut drawn = (0..).map(|i: usize| NOISE[(i * 7 + i / 12) % 12]);
    for run in 1..=4 {
        for x in &places {
            text += &format!("{run},{x},+,{:.3},1\n", drawn.next().unwrap());
        }
        for x in places.iter().rev() {
            text += &format!("{run},{x},-,{:.3},1\n", back(x / 310.0) + drawn.next().unwrap());
        }
    }
    text
}

#[test]
fn play_of_either_sign_and_play_that_differs_are_named() {
    let place = Place::new();
    place.write(
        "axis.toml",
        "process = \"axis\"\naxis = { travel = \"310 mm\" }\n\
         screw = { material = \"steel\", diameter = \"32 mm\", lead = \"10 mm\" }\n",
    );
    let named = |back: &dyn Fn(f64) -> f64| -> Vec<(String, Json)> {
        place.write("m.csv", tested(back));
        let told = place.fem(&["diagnose", "axis.toml", "--with", "m.csv", "--json"]);
        let json: Json = serde_json::from_str(&told.out).unwrap();
        assert_eq!(json["verdict"], "missing-effect", "{}", told.out);
        let one = |m: &Json| (m["effect"].as_str().unwrap().to_string(), m["parameters"].clone());
        json["missing"].as_array().unwrap().iter().map(one).collect()
    };
    let near = |parameter: &Json, value: f64| (parameter["value"].as_f64().unwrap() - value).abs() < 1.5;
    let ahead = named(&|_| -25.0);
    assert!(ahead.len() == 1 && ahead[0].0 == "backlash" && near(&ahead[0].1["gap"], -25.0), "{ahead:?}");
    let uneven = named(&|s| 8.0 - 14.0 * (s - 0.5));
    assert_eq!(uneven.iter().map(|m| m.0.as_str()).collect::<Vec<_>>(), ["backlash", "uneven-backlash"]);
    assert!(near(&uneven[0].1["gap"], 8.0) && near(&uneven[1].1["change"], -14.0), "{uneven:?}");
    let worn = named(&|s| 4.0 + 20.0 * 4.0 * s * (1.0 - s));
    assert_eq!(worn.len(), 2, "{worn:?}");
    assert!(worn.iter().any(|(name, of)| name == "worn-screw" && near(&of["depth"], 20.0)), "{worn:?}");
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
