//! `fem compensate`: the evaluation of a published test, what tables leave, and what they cannot do.

use serde_json::Value as Json;

use super::fem::{Place, model};

const AXIS: &str = r#"
process = "axis"
axis = { travel = "600 mm" }
screw = { material = "steel", diameter = "32 mm", lead = "10 mm", fixed_at = "0 mm" }
"#;

/// A test of 11 targets from both sides in five runs, from its deviation (um) at x (m), forwards (1) or
/// backwards (-1), in a run.
fn test(deviation: impl Fn(f64, f64, usize) -> f64) -> String {
    let mut text = String::from("run,position [mm],direction,deviation [um]\n");
    for run in 1..=5 {
        for (sign, name) in [(1.0, "+"), (-1.0, "-")] {
            for i in 0..11 {
                // Off the multiples of the lead.
                let mm = 60.0 * f64::from(i) - 3.7 * f64::from(i % 3);
                text.push_str(&format!("{run},{mm},{name},{}\n", deviation(1e-3 * mm, sign, run)));
            }
        }
    }
    text
}

/// Repeats as they should be: within 0.2 um.
fn noise(run: usize) -> f64 {
    [0.1, -0.1, 0.05, -0.05, 0.0][run - 1]
}

fn compensated(place: &Place, data: &str) -> Json {
    place.write("axis.toml", AXIS);
    place.write("m.csv", data);
    let answer = place.fem(&["compensate", "axis.toml", "--with", "m.csv", "--json"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    serde_json::from_str(&answer.out).unwrap()
}

fn published(place: &Place) {
    place.write("stage.toml", model("stage/stage.toml"));
    place.write("m.csv", model("stage/measured.csv"));
}

#[test]
fn a_published_test_by_the_standard() {
    let place = Place::new();
    published(&place);
    let answer = place.fem(&["compensate", "stage.toml", "--with", "m.csv"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    let page = include_str!("../../docs/compensation.md");
    let shown = page.split("```text\n").find(|block| block.starts_with("ISO 230-2")).unwrap();
    for line in shown.split("```").next().unwrap().lines().filter(|l| *l != "…") {
        assert!(answer.out.contains(line), "the page shows a line that is not printed: {line}");
    }
    insta::assert_snapshot!(answer.out);
    let json: Json =
        serde_json::from_str(&place.fem(&["compensate", "stage.toml", "--with", "m.csv", "--json"]).out).unwrap();
    assert_eq!(json["schema"], "fem-compensation/1");
    // Printed in its report, and by the standard's formulas from its readings.
    for (symbol, expected) in [("B", 0.0122), ("M", 0.0277), ("A", 0.0888), ("E", 0.0368), ("R", 0.0688)] {
        let value = json["iso230"]["quantities"][symbol]["value"].as_f64().unwrap();
        assert!((value - expected).abs() < 1e-4, "{symbol}: {value}");
    }
}

#[test]
fn each_verdict_has_its_axis() {
    type Deviation = fn(f64, f64, usize) -> f64;
    let cases: [(&str, &str, Deviation); 7] = [
        ("within-tolerance", "", |x, _, run| 10.0 * x + noise(run)),
        // A long scale and even play: a table and a value do it.
        ("compensation-suffices", "", |x, s, run| 90.0 * x + if s < 0.0 { 12.0 } else { 0.0 } + noise(run)),
        // A wave that no two targets meet alike: what a table says between them is a guess.
        ("unknown-between-targets", "", |x, _, run| 25.0 * (48.0 * x).sin() + noise(run)),
        // Play worn in the middle: 30 um there, none at the ends.
        ("needs-both-directions", "uneven_reversal", |x, s, run| {
            (if s < 0.0 { 30.0 * (5.2 * x).sin().max(0.0) } else { 0.0 }) + noise(run)
        }),
        ("repair-first", "scatter", |_, _, run| [4.0, -5.0, 3.0, -4.0, 2.0][run - 1]),
        // The axis warms: 4 um more in each run.
        ("repair-first", "drift", |_, _, run| 4.0 * run as f64 + noise(run)),
        ("repair-first", "uneven_reversal", |x, s, run| {
            (if s < 0.0 { 30.0 * (5.2 * x).sin().max(0.0) } else { 0.0 }) + [4.0, -5.0, 3.0, -4.0, 2.0][run - 1]
        }),
    ];
    let place = Place::new();
    for (verdict, cause, deviation) in cases {
        let json = compensated(&place, &test(deviation));
        assert_eq!(json["verdict"], verdict, "{cause}: {}", json["causes"]);
        let first = json["causes"][0]["cause"].as_str().unwrap_or_default();
        assert_eq!(first, cause, "{verdict}");
    }
    // A single run has no scatter.
    let once: String = test(|_, _, _| 3.0)
        .lines()
        .filter(|l| l.starts_with("run") || l.starts_with("1,"))
        .map(|l| format!("{l}\n"))
        .collect();
    let json = compensated(&place, &once);
    assert_eq!((json["verdict"].as_str(), &json["iso230"]["quantities"]["R"]["value"]), (Some("unknown"), &Json::Null));
}

/// What a table of points, each with what is added, adds at a position.
fn linear(points: &[(f64, f64)], at: f64) -> f64 {
    let i = points.iter().position(|p| p.0 >= at).unwrap_or(points.len() - 1).max(1);
    let ((a, va), (b, vb)) = (points[i - 1], points[i]);
    va + (vb - va) * (at - a) / (b - a)
}

#[test]
fn the_tables_do_what_is_predicted_of_them() {
    let place = Place::new();
    let deviation =
        |x: f64, s: f64, run| 60.0 * x - 80.0 * x * x + if s < 0.0 { 9.0 + 5.0 * x } else { 0.0 } + noise(run);
    let json = compensated(&place, &test(deviation));
    assert_eq!(place.fem(&["compensate", "axis.toml", "--with", "m.csv", "-o", "out"]).status, 0);
    let written: Json = serde_json::from_str(&place.read("out/compensation.json")).unwrap();
    assert_eq!(written, json);
    let cells = |file: &str| -> Vec<Vec<f64>> {
        place.read(file).lines().skip(1).map(|l| l.split(',').filter_map(|c| c.parse().ok()).collect()).collect()
    };
    let table = cells("out/points.csv");
    let points: Vec<(f64, f64)> = table.iter().map(|r| (r[0], r[1])).collect();
    let backlash = table[0][3];
    // b = 9 to 9 + 5·0.5963: midway, and half the range.
    let end = 9.0 + 5.0 * 0.5963;
    assert!((backlash - 0.5 * (9.0 + end)).abs() < 1e-6, "{backlash}");
    assert!((json["reversal"]["unavoidable_rest"].as_f64().unwrap() - 0.5 * (end - 9.0)).abs() < 1e-9);
    // The measured means with the table, by hand, range over E after.
    let mut left = Vec::new();
    for (mm, added) in &points {
        for sign in [1.0, -1.0] {
            let with = added - if sign < 0.0 { backlash } else { 0.0 };
            left.push(deviation(1e-3 * mm, sign, 5) + with);
        }
    }
    let range = left.iter().fold(f64::MIN, |m: f64, v| m.max(*v)) - left.iter().fold(f64::MAX, |m: f64, v| m.min(*v));
    let after = json["schemes"][0]["after"]["E"]["value"].as_f64().unwrap();
    assert!((range - after).abs() < 1e-6, "{range} and {after}");
    // What is written of the model is the model with the table: here an ideal axis, and the table alone.
    for row in cells("out/predicted.csv").iter().step_by(7) {
        if row.len() == 6 {
            continue;
        }
        let added = linear(&points, row[0]);
        assert!((row[2] - added).abs() < 1e-5 || (row[2] - added + backlash).abs() < 1e-5, "{row:?} {added}");
    }
    let triplets = place.read("out/linuxcnc.comp");
    assert_eq!(triplets.lines().count(), 11);
    for line in triplets.lines() {
        let v: Vec<f64> = line.split(' ').map(|c| c.parse().unwrap()).collect();
        let [forward, backward] = [1.0, -1.0].map(|s| v[0] + 1e-3 * deviation(1e-3 * v[0], s, 5));
        assert!((v[1] - forward).abs() < 1e-6 && (v[2] - backward).abs() < 1e-6, "{line}");
    }
}

#[test]
fn a_controller_rounds() {
    let place = Place::new();
    place.write("axis.toml", format!("{AXIS}controller = {{ resolution = \"1 um\" }}\n"));
    place.write("m.csv", test(|x, s, run| 33.3 * x + if s < 0.0 { 7.7 } else { 0.0 } + noise(run)));
    assert_eq!(place.fem(&["compensate", "axis.toml", "--with", "m.csv", "-o", "out"]).status, 0);
    for line in place.read("out/points.csv").lines().skip(1) {
        let v: Vec<f64> = line.split(',').map(|c| c.parse().unwrap()).collect();
        assert!(v[1].fract() == 0.0 && v[3] == 8.0, "{line}");
    }
}

#[test]
fn the_clearance_that_grows_is_friction() {
    // EA of Ø32 steel is 1.689e8 N: 800 N stretch it by 4.737 um a metre, there and back 9.474 um.
    let place = Place::new();
    let ea = 210e9 * std::f64::consts::PI * 0.016f64.powi(2);
    let deviation = move |x: f64, s: f64, run: usize| -s * 1e6 * 800.0 * x / ea + noise(run);
    let json = compensated(&place, &test(deviation));
    let lost = &json["lost_motion"];
    assert_eq!((&lost["grows"], lost["rules"].as_str()), (&Json::Bool(true), Some("elastic")));
    assert!((lost["friction"]["value"].as_f64().unwrap() - 800.0).abs() < 1e-6, "{lost}");
}

#[test]
fn what_is_no_axis_is_refused_and_nothing_is_written_over() {
    let place = Place::new();
    place.write("ring.toml", model("ring.toml"));
    place.write("m.csv", "angle [deg],deviation [um]\n0,1\n");
    let answer = place.fem(&["compensate", "ring.toml", "--with", "m.csv", "-o", "out"]);
    assert_eq!(answer.status, 2);
    assert!(answer.err.contains("for axes that are tested by going to targets"), "{}", answer.err);
    place.write("axis.toml", AXIS);
    place.write("points.csv", test(|_, _, run| noise(run)));
    let answer = place.fem(&["compensate", "axis.toml", "--with", "points.csv", "-o", "."]);
    assert_eq!(answer.status, 2);
    assert!(answer.err.contains("is itself what is read"), "{}", answer.err);
    // A place that is taken by a file.
    place.write("taken", "");
    let answer = place.fem(&["compensate", "axis.toml", "--with", "points.csv", "-o", "taken"]);
    assert_eq!(answer.status, 1, "{}", answer.err);
    assert_eq!(place.files(), ["axis.toml", "m.csv", "points.csv", "ring.toml", "taken"]);
}

/// Steps of 20 um leave 10 um either way, and the axis itself is good to half a micrometre.
#[test]
fn entries_that_are_too_coarse_are_no_broken_mechanics() {
    let place = Place::new();
    let data = test(|x, _, run| 120.0 * x + noise(run));
    place.write("m.csv", &data);
    for (resolution, verdict) in [("1 um", "compensation-suffices"), ("30 um", "needs-finer-resolution")] {
        place.write("axis.toml", format!("{AXIS}controller = {{ resolution = \"{resolution}\" }}\n"));
        let answer = place.fem(&["compensate", "axis.toml", "--with", "m.csv", "--json"]);
        let json: Json = serde_json::from_str(&answer.out).unwrap();
        assert_eq!(json["verdict"], verdict, "{}", answer.err);
    }
}

/// A model that misses 6 um of a wave says so, whether or not the readings have a time each.
#[test]
fn runs_at_other_times_repeat_each_other() {
    let place = Place::new();
    let plain = test(|x, _, run| 6.0 * (10.0 * x).sin() + noise(run));
    let timed: String = plain
        .lines()
        .enumerate()
        .map(|(i, line)| if i == 0 { format!("time [min],{line}\n") } else { format!("{i},{line}\n") })
        .collect();
    for data in [plain, timed] {
        let json = compensated(&place, &data);
        let cautions = json["cautions"].to_string();
        assert!(cautions.contains("does not explain what was measured"), "{cautions}");
    }
}

#[test]
fn targets_off_the_travel_are_refused() {
    let place = Place::new();
    place.write("axis.toml", AXIS);
    place.write("m.csv", "position [mm],direction,deviation [um]\n0,+,0\n300,+,1\n997.6,+,2\n");
    let answer = place.fem(&["compare", "axis.toml", "--with", "m.csv"]);
    assert_eq!(answer.status, 2);
    assert!(answer.err.contains("the axis travels from 0 to 600 mm"), "{}", answer.err);
}

/// From 300 mm on the slide goes harder and loses 14 um more: a friction all along would be thousands of newtons.
#[test]
fn a_place_of_extra_drag_is_found_and_no_part_named() {
    let ea = 210e9 * std::f64::consts::PI * 0.016f64.powi(2);
    let deviation = move |x: f64, s: f64, run: usize| {
        let lost = 2.0 + 2e6 * 600.0 * x / ea + if x > 0.3 { 14.0 } else { 0.0 };
        (if s < 0.0 { lost } else { 0.0 }) + noise(run)
    };
    let place = Place::new();
    let json = compensated(&place, &test(deviation));
    let lost = &json["lost_motion"];
    assert_eq!((lost["rules"].as_str(), lost["kinematic"].as_str()), (Some("unclear"), Some("compatible-with-none")));
    assert!(lost["misfit"].as_f64().unwrap() > 5.0 && lost["explained_by_scatter"] == false, "{lost}");
    let step = &lost["step"];
    let number = |key: &str| step[key].as_f64().unwrap();
    assert!((number("height") - 14.0).abs() < 1e-6 && (number("constant") - 2.0).abs() < 1e-6, "{step}");
    assert!((number("friction") - 600.0).abs() < 1e-3 && number("misfit") < 1e-6, "{step}");
    // Targets at 292.6 and 360 mm.
    assert!((number("from") - 292.6).abs() < 1e-9 && (number("to") - 360.0).abs() < 1e-9, "{step}");
    let answer = place.fem(&["compensate", "axis.toml", "--with", "m.csv"]);
    for words in ["below zero, and compatible with none", "no part can be named", "a step of +14.0000 um between"] {
        assert!(answer.out.contains(words), "{words}: {}", answer.out);
    }
    assert!(!answer.out.contains("the elastic part rules"), "{}", answer.out);
}

/// An axis of 20 um of play and a scale of 60 um/m: measured, entered, measured again with the entries active, and
/// entered again. The sum of both is what the first test alone would give, and what is added the second time nothing.
#[test]
fn what_is_entered_is_what_was_there_and_what_is_added() {
    let place = Place::new();
    let bare = |x: f64, s: f64| 60.0 * x + if s < 0.0 { 20.0 } else { 0.0 };
    // The control takes 25 um for the play and adds −30 um/m from 0 to 300 mm, and no more beyond.
    let active = |x: f64, s: f64| -30.0 * x.min(0.3) - if s < 0.0 { 25.0 } else { 0.0 };
    let controller = "[controller]\nbacklash = \"25 um\"\nsteps = { reference = \"240 mm\", interval = \"120 mm\" }\n\
                      points = [{ at = \"0 mm\", added = \"0 um\" }, { at = \"300 mm\", added = \"-9 um\" }]\n";
    place.write("axis.toml", format!("{AXIS}{controller}"));
    place.write("m.csv", test(|x, s, run| bare(x, s) + active(x, s) + noise(run)));
    let answer = place.fem(&["compensate", "axis.toml", "--with", "m.csv", "--json", "-o", "out"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let json: Json = serde_json::from_str(&place.read("out/compensation.json")).unwrap();
    assert!((json["reversal"]["backlash_value"].as_f64().unwrap() + 5.0).abs() < 1e-9);
    // The play of the axis itself, not what the control makes of it; and no backlash value below zero is entered.
    assert!((json["lost_motion"]["constant"]["value"].as_f64().unwrap() - 20.0).abs() < 1e-9);
    assert!(!json["cautions"].to_string().contains("runs ahead"), "{}", json["cautions"]);
    let entered = json["schemes"][0]["entered"].as_array().unwrap();
    for entry in entered {
        let [at, forward, backward] =
            ["position", "added_forward", "added_backward"].map(|key| entry[key].as_f64().unwrap());
        // Linear between targets, so that what is added at 300 mm is that of targets beside it: a straight line too.
        assert!((forward + 0.06 * at).abs() < 0.3 && (forward - backward - 20.0).abs() < 1e-9, "{entry}");
        if at != 300.0 {
            assert!((forward + 0.06 * at).abs() < 1e-9, "{entry}");
        }
    }
    assert!(entered.iter().any(|e| e["position"] == 300.0), "{entered:?}");
    // From 240 mm, points at 0, 120, … 480 mm: 7.2 um less from each to the next, but for the kink at 300 mm.
    let steps: Vec<Vec<f64>> = place
        .read("out/increments.csv")
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
        .collect();
    assert_eq!(steps.iter().map(|s| s[0]).collect::<Vec<_>>(), [-2.0, -1.0, 0.0, 1.0, 2.0]);
    assert!(steps[2][2] == 0.0 && (steps[1][2] - 7.2).abs() < 0.3 && (steps[3][3] + 7.2).abs() < 0.3, "{steps:?}");
    assert!(place.read("out/entered.csv").lines().count() == 1 + entered.len());
}

#[test]
fn increments_are_counted_in_the_controllers_units() {
    let place = Place::new();
    let steps = |keys: &str| {
        format!("{AXIS}[controller]\nsteps = {{ reference = \"100 mm\", interval = \"50 mm\", {keys} }}\n")
    };
    place.write("axis.toml", steps("detection_unit = \"0.1 um\", magnification = 2"));
    place.write("m.csv", test(|x, _, run| 30.0 * x + noise(run)));
    let answer = place.fem(&["compensate", "axis.toml", "--with", "m.csv", "-o", "out"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let text = place.read("out/increments.csv");
    assert!(text.starts_with("number,position [mm],from_reference [um],increment [um],counts"), "{text}");
    let rows: Vec<Vec<f64>> =
        text.lines().skip(1).map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
    let reference = rows.iter().position(|row| row[0] == 0.0).unwrap();
    let mut sum = 0.0;
    for row in &rows[reference + 1..] {
        sum += row[4];
        assert!((0.2 * sum - row[2]).abs() <= 0.1 + 1e-9, "{row:?}");
    }
    // 1.5 um from point to point are 7 or 8 counts of 0.2 um.
    assert!(answer.err.contains("raise `magnification`") || answer.out.contains("raise `magnification`"), "{answer:?}");
    place.write("axis.toml", steps("magnification = 2"));
    let answer = place.fem(&["compensate", "axis.toml", "--with", "m.csv"]);
    assert!(answer.status == 2 && answer.err.contains("add detection_unit"), "{}", answer.err);
}

#[test]
fn a_controllers_table_must_rise() {
    let place = Place::new();
    let points = "points = [{ at = \"100 mm\", added = \"1 um\" }, { at = \"50 mm\", added = \"2 um\" }]";
    place.write("axis.toml", format!("{AXIS}[controller]\n{points}\n"));
    place.write("m.csv", test(|_, _, run| noise(run)));
    let answer = place.fem(&["compensate", "axis.toml", "--with", "m.csv"]);
    assert_eq!(answer.status, 2);
    assert!(answer.err.contains("the positions do not rise"), "{}", answer.err);
}

#[test]
fn controls_that_are_named_get_their_files() {
    let place = Place::new();
    published(&place);
    let command = ["compensate", "stage.toml", "--with", "m.csv", "-o", "out", "--for"];
    let asked = |controls| place.fem(&[&command[..], &[controls, "--axis", "X1"]].concat());
    let answer = asked("siemens-eec,heidenhain");
    assert_eq!(answer.status, 0, "{}", answer.err);
    assert!(place.read("out/siemens-eec.ini").contains("\n$AA_ENC_COMP_STEP[0,X1]=5.12\n"));
    assert!(
        place.read("out/heidenhain.com").starts_with("BEGIN HEIDENHAIN .COM MM\nNR AXISPOS BACKLASH X1\n0 -10.0000 ")
    );
    assert!(!place.path("out/linuxcnc.comp").exists());
    for words in ["for siemens-eec, SINUMERIK", "um at the targets", "set MD38000", "Look at one point"] {
        assert!(answer.out.contains(words), "{words}: {}", answer.out);
    }
    let json: Json = serde_json::from_str(&place.read("out/compensation.json")).unwrap();
    assert_eq!(json["controls"][1]["control"], "heidenhain");
    assert_eq!(json["controls"][0]["files"][0], "siemens-eec.ini");
    // What cannot be held is refused, and nothing is written.
    let before = place.read("out/compensation.json");
    for (controls, words) in [
        ("fanuc", "fanuc cannot hold this table"),
        ("fanuc", "add `steps` to [controller]"),
        ("sienens-eec", "a similar value exists: 'siemens-eec'"),
    ] {
        let answer = asked(controls);
        assert!(answer.status == 2 && answer.err.contains(words), "{}", answer.err);
    }
    assert_eq!(place.read("out/compensation.json"), before);
    let answer =
        place.fem(&["compensate", "stage.toml", "--with", "m.csv", "-o", "out", "--for", "mach4", "--axis", "a]b"]);
    assert!(answer.status == 2 && answer.err.contains("1 to 16 letters"), "{}", answer.err);
}

/// Readings of a gauge that shows 50 um where the axis stands right, as they stand on its dial [seed 001, fig. 1].
#[test]
fn what_a_gauge_shows_at_zero_is_asked_for_and_taken_off() {
    let place = Place::new();
    let deviation = |x: f64, sign: f64, run: usize| 6.0 * x - 3.25 * (sign - 1.0) + noise(run);
    let right = compensated(&place, &test(deviation));
    place.write("raw.csv", test(|x, sign, run| 50.0 + deviation(x, sign, run)));
    let asked = place.fem(&["compensate", "axis.toml", "--with", "raw.csv"]);
    assert!(
        asked.err.contains("all readings lie about") && asked.err.contains("reading_at_zero = \"0 um\""),
        "{}",
        asked.err
    );
    assert_eq!(asked.status, 1);
    let said = |zero: &str| -> Json {
        place.write("said.toml", format!("{AXIS}test = {{ reading_at_zero = \"{zero}\" }}\n"));
        let answer = place.fem(&["compensate", "said.toml", "--with", "raw.csv", "--json"]);
        assert_eq!(answer.status, 0, "{}", answer.err);
        serde_json::from_str(&answer.out).unwrap()
    };
    let numbers = |json: &Json| -> Vec<f64> {
        let mut found = Vec::new();
        let mut open = vec![json.clone()];
        while let Some(value) = open.pop() {
            match value {
                Json::Number(number) => found.push(number.as_f64().unwrap()),
                Json::Array(all) => open.extend(all),
                Json::Object(all) => open.extend(all.into_iter().map(|(_, value)| value)),
                _ => {}
            }
        }
        found
    };
    let tables = |json: &Json| -> Vec<f64> {
        json["schemes"].as_array().unwrap().iter().flat_map(|scheme| numbers(&scheme["entries"])).collect()
    };
    let (a, b) = (tables(&right), tables(&said("50 um")));
    assert!(a.len() > 20 && a.len() == b.len());
    assert!(a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-9), "{a:?}\n{b:?}");
    // Who says that these are deviations has them compensated.
    assert_ne!(tables(&said("0 um")), a);
    // A prediction is what the gauge shows, and reads back as such.
    let run = place.fem(&["run", "said.toml"]);
    assert!(run.status == 0 && run.out.contains("largest deviation        +0.000 um"), "{}", run.out);
}
