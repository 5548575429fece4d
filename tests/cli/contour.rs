//! Contours as a user meets them: summary, files, pictures, bad input, corners.

use super::fem::{Mistake, Place, model};

#[test]
fn the_summary_of_the_circle_and_of_the_square() {
    let place = Place::new();
    for name in ["contour.toml", "rectangle.toml"] {
        place.write(name, model(name));
        let answer = place.fem(&["run", name]);
        assert_eq!((answer.status, answer.err.as_str()), (0, ""));
        insta::assert_snapshot!(name.trim_end_matches(".toml"), answer.out);
    }
    insta::assert_snapshot!("effects_contour", place.fem(&["effects", "contour"]).out);
}

#[test]
fn a_profile_is_a_measurement_of_its_own_model() {
    let place = Place::new();
    let square = model("rectangle.toml");
    let turned = square.replace("\"45 deg\"", "\"17 deg\"").replace("[\"ccw\"]", "[\"cw\", \"ccw\"]");
    let narrow = turned.replacen("\"100 mm\"", "\"30 mm\"", 1);
    let paths = [
        ("circle", model("contour.toml")),
        ("square", square),
        ("turned", turned),
        ("narrow", narrow),
        ("triangle", TRIANGLE.into()),
    ];
    for (name, text) in paths {
        place.write("model.toml", text);
        assert_eq!(place.fem(&["run", "model.toml", "-o", "out"]).status, 0, "{name}");
        let compared = place.fem(&["compare", "model.toml", "--with", "out/profile.csv", "--json", "-o", "compared"]);
        assert_eq!((compared.status, compared.err.as_str()), (0, ""), "{name}");
        let json: serde_json::Value = serde_json::from_str(&compared.out).unwrap();
        assert!(json["models"][0]["rms"].as_f64().unwrap() < 1e-9, "{name}: {}", compared.out);
    }
}

#[test]
fn pictures_are_drawn_of_what_is_predicted_and_of_what_is_measured() {
    let place = Place::new();
    place.write("contour.toml", model("contour.toml"));
    assert_eq!(place.fem(&["run", "contour.toml", "-o", "out"]).status, 0);
    let drawn = place.read("out/contour.svg");
    assert!(drawn.contains("circle of radius 150 mm, 1000 mm/min") && drawn.contains("predicted, cw"));
    assert!(drawn.contains("magnified 5\u{202f}000 times"));
    let measured = place.read("out/profile.csv");
    let rows = measured.lines().filter(|l| !l.starts_with('#')).count() - 1;
    // 360 places of each direction and where it peaks beside them: a line to each, the first again, and one in the
    // legend.
    let lines: usize = drawn.lines().filter(|l| l.contains("class=\"c ")).map(|l| l.matches('L').count()).sum();
    assert_eq!(lines, rows + 2);
    assert!((2 * 360 + 2..2 * 360 + 30).contains(&rows), "{rows}");
    place.write("m.csv", measured.replace("1000", "500").replace("\ncw,500", "\ncw,1000"));
    assert_eq!(place.fem(&["compare", "contour.toml", "--with", "m.csv", "-o", "out"]).status, 0);
    let drawn = place.read("out/compared.svg");
    assert!(drawn.contains("measured, ccw, 500 mm/min") && drawn.contains("predicted, cw, 1000 mm/min"), "{drawn}");
    assert_eq!(drawn.matches("h0").count(), rows + 2 * 3);
}

#[test]
fn the_profile_has_the_peaks_of_the_summary() {
    let place = Place::new();
    for name in ["contour.toml", "rectangle.toml"] {
        place.write(name, model(name));
        assert_eq!(place.fem(&["run", name, "-o", "out"]).status, 0);
        let mut reader = csv::Reader::from_path(place.path("out/profile.csv")).unwrap();
        let column = reader.headers().unwrap().iter().position(|h| h == "deviation [um]").unwrap();
        let deviations: Vec<f64> = reader.records().map(|r| r.unwrap()[column].parse().unwrap()).collect();
        let summary: serde_json::Value = serde_json::from_str(&place.read("out/summary.json")).unwrap();
        let extreme = |key: &str| summary["findings"][key]["value"].as_f64().unwrap();
        let span = extreme("largest") - extreme("smallest");
        // What misses no peak by more than the part of the span that is not worth a row.
        let high = deviations.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let low = deviations.iter().copied().fold(f64::INFINITY, f64::min);
        assert!(extreme("largest") - high <= 0.02 * span && low - extreme("smallest") <= 0.02 * span, "{name}");
        // The summary looks at points of its own, which lie as close as a hundredth of a degree.
        let near = 1e-3 * span;
        assert!(high <= extreme("largest") + near && low >= extreme("smallest") - near, "{name}: {high} {low}");
    }
}

/// Corners of 90, 36.9 and 53.1 deg, both ways round.
const TRIANGLE: &str = r#"process = "contour"
[path]
shape = "polygon"
corners = [{ x = "-20 mm", y = "-20 mm" }, { x = "60 mm", y = "-20 mm" }, { x = "-20 mm", y = "40 mm" }]
feed = "600 mm/min"
directions = ["ccw", "cw"]
[drives]
gain = "50 /s"
lead = "5 mm"
[effects.backlash-x]
gap = "8 um"
[effects.servo-mismatch]
mismatch = 0.1
"#;
const CORNERS: &str =
    "[{ x = \"-20 mm\", y = \"-20 mm\" }, { x = \"60 mm\", y = \"-20 mm\" }, { x = \"-20 mm\", y = \"40 mm\" }]";

/// (in the model, replaced by, part of the message, part of the remedy)
const POLYGONS: &[Mistake] = &[
    ("corners", "edges", "`edges` is no key of `path`", "its keys are"),
    (", { x = \"-20 mm\", y = \"40 mm\" }", "", "2 corners make no polygon", "give three corners or more"),
    ("y = \"40 mm\"", "y = \"-40 mm\"", "does not turn to the left at corner", "counter-clockwise"),
    ("\"40 mm\" }", "\"40 mm\" }, { x = \"-10 mm\", y = \"0 mm\" }", "does not turn to the left", "convex"),
    (
        CORNERS,
        "[{ x = \"10 mm\", y = \"-20 mm\" }, { x = \"60 mm\", y = \"-20 mm\" }, { x = \"10 mm\", y = \"40 mm\" }]",
        "not inside of side 3",
        "until it lies inside",
    ),
    // A pentagram turns to the left at each of its corners, and twice round.
    (
        CORNERS,
        "[{ x = \"0 mm\", y = \"50 mm\" }, { x = \"-29.4 mm\", y = \"-40.5 mm\" }, { x = \"47.6 mm\", y = \"15.5 mm\" }, \
         { x = \"-47.6 mm\", y = \"15.5 mm\" }, { x = \"29.4 mm\", y = \"-40.5 mm\" }]",
        "the sides cross each other",
        "counter-clockwise",
    ),
    ("\"600 mm/min\"", "\"60 m/min\"", "a side of 60.000 mm is too short", "slow down"),
];

#[test]
fn a_polygon_is_read_or_told_what_is_wrong_with_it() {
    let place = Place::new();
    place.refuses(("run", "model.toml"), TRIANGLE, POLYGONS);
    place.write("model.toml", TRIANGLE);
    let answer = place.fem(&["run", "model.toml"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    insta::assert_snapshot!("triangle", answer.out);
}

/// (model, replaced, by, part of the message, part of the remedy)
const CASES: &[(&str, &str, &str, &str, &str)] = &[
    ("contour", "radius", "raduis", "`raduis` is no key of `path`", "did you mean `radius`?"),
    ("contour", "\"150 mm\"", "\"-150 mm\"", "`radius` is -150 mm", "above zero"),
    ("contour", "\"1000 mm/min\"", "\"1000 mm\"", "not a feed rate", "write it in mm/min"),
    ("contour", "feed = \"1000 mm/min\"", "", "`feed` is missing in `path`", "add feed = \"1000 mm/min\""),
    ("contour", "\"circle\"", "\"cirkle\"", "`shape` is \"cirkle\"", "did you mean \"circle\"?"),
    ("contour", "\"circle\"", "\"rectangle\"", "`radius` is no key of `path`", "its keys are shape, width, height"),
    ("contour", "[\"ccw\", \"cw\"]", "[\"ccw\", \"cww\"]", "\"cww\" in `directions`", "did you mean \"cw\"?"),
    ("contour", "[\"ccw\", \"cw\"]", "[\"ccw\", \"ccw\"]", "\"ccw\" stands twice in `directions`", "name it once"),
    ("contour", "[\"ccw\", \"cw\"]", "[]", "`directions` is empty", "list some of \"ccw\", \"cw\""),
    ("contour", "[\"ccw\", \"cw\"]", "3", "in `directions` is none of its words", "take some of"),
    ("contour", "\"50 /s\" ", "\"50 mm\" ", "not a servo gain", "write it in /s"),
    ("contour", "lead = \"10 mm\"", "", "`cyclic-error-x` needs its period", "remove the effect"),
    (
        "contour",
        "[effects.squareness]\nangle = \"25 +- 10 um/m\"",
        "[effects.elastic-lost-motion-y]\nfriction = \"600 N\"\nstiffness = \"200 N/um\"",
        "`elastic-lost-motion-y` needs its screw",
        "remove the effect",
    ),
    (
        "contour",
        "[effects.squareness]\nangle = \"25 +- 10 um/m\"",
        "[effects.stick-slip-x]\namplitude = \"2 um\"\nphase = \"0 deg\"",
        "needs its frequency",
        "remove the effect",
    ),
    (
        "contour",
        "lead = \"10 mm\"",
        "lead = \"10 mm\"\nfeedback = \"scale\"",
        "the scale takes it out",
        "remove the effect",
    ),
    (
        "contour",
        "[effects.squareness]\nangle = \"25 +- 10 um/m\"",
        "[effects.cutting-deflection]\nstiffness_x = \"50 N/um\"\nstiffness_y = \"50 N/um\"",
        "needs the force of the cut",
        "remove the effect",
    ),
    ("contour", "\"10 um\"", "\"0 um\"", "`deviation` is 0 um", "above zero"),
    (
        "contour",
        "[effects.squareness]\nangle",
        "[effects.spindle-error]\nangle",
        "is an effect of `ring`",
        "fem effects contour",
    ),
    ("rectangle", "\"600 mm/min\"", "\"60 m/min\"", "a side of 100.000 mm is too short", "slow down"),
    ("rectangle", "width = \"100 mm\"", "", "`width` is missing in `path`", "add width"),
];

#[test]
fn bad_input_is_told_with_its_remedy() {
    let place = Place::new();
    for (name, from, to, message, remedy) in CASES {
        place.refuses(("run", "model.toml"), &model(&format!("{name}.toml")), &[(from, to, message, remedy)]);
    }
    assert!(!place.files().iter().any(|f| f.starts_with("out")));
}

#[test]
fn one_direction_may_stand_without_a_list() {
    let place = Place::new();
    place.write("contour.toml", model("contour.toml").replace("[\"ccw\", \"cw\"]", "\"cw\""));
    let answer = place.fem(&["run", "contour.toml"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    assert!(!answer.out.contains("ccw"), "{}", answer.out);
}

#[test]
fn what_cannot_be_computed_is_told() {
    let place = Place::new();
    for (from, to, message) in
        [("\"0.03 +- 0.01\"", "2.5", "the gain of y is -12.500 /s"), ("\"150 mm\"", "\"1 um\"", "no contour any more")]
    {
        place.write("contour.toml", model("contour.toml").replacen(from, to, 1));
        let answer = place.fem(&["run", "contour.toml"]);
        assert_eq!(answer.status, 1, "{}", answer.err);
        assert!(answer.err.split_whitespace().collect::<Vec<_>>().join(" ").contains(message), "{}", answer.err);
    }
}

#[test]
fn what_misleads_is_warned_of() {
    let place = Place::new();
    for (from, to, warning) in [
        ("\"6 +- 2 um\"", "\"301 mm\"", "x does not move"),
        ("\"250 +- 80 ms\"", "\"30 s\"", "the spike of y has not faded"),
        ("\"50 /s\" ", "\"0.5 /s\" ", "the axes lag by 12.5 deg"),
    ] {
        place.write("contour.toml", model("contour.toml").replacen(from, to, 1));
        let answer = place.fem(&["run", "contour.toml"]);
        assert!(answer.err.contains(warning), "{}{}", answer.err, answer.out);
    }
}

#[test]
fn rows_that_no_side_has_are_refused() {
    let place = Place::new();
    place.write("square.toml", model("rectangle.toml"));
    // The side at 45 deg begins at 0 deg: 1.5 mm along it is within ten lags of 0.2 mm, 2.5 mm is not.
    let angle = |along: f64| {
        let (across, along) = (50.0f64, along - 50.0);
        45.0 + along.atan2(across).to_degrees()
    };
    for (row, told) in [
        (format!("ccw,600,{}", angle(1.5)), Some("1.500 mm from a corner")),
        (format!("ccw,600,{}", angle(2.5)), None),
        (format!("cw,600,{}", angle(1.5)), None),
        (format!("cw,600,{}", angle(99.9)), Some("0.100 mm from a corner")),
        ("ccw,0,45".into(), Some("`feed` is not above zero")),
        ("ccw,90000,45".into(), Some("a side of 100.000 mm is too short")),
    ] {
        place.write("m.csv", format!("direction,feed [mm/min],angle [deg],deviation [um]\n{row},1\n"));
        let answer = place.fem(&["compare", "square.toml", "--with", "m.csv"]);
        match told {
            Some(told) => assert!(answer.status == 2 && answer.err.contains(told), "{row}: {}", answer.err),
            None => assert_eq!(answer.status, 0, "{row}: {}", answer.err),
        }
    }
}

#[test]
fn one_way_round_does_not_tell_servos_from_squareness() {
    // An ellipse of 5 um at 45 deg, measured counter-clockwise alone.
    let place = Place::new();
    let text = model("contour.toml").split("[effects").next().unwrap().to_string();
    place.write("contour.toml", text);
    let mut measured = String::from("angle [deg],deviation [um],u [um]\n");
    for i in 0..72 {
        let (angle, wobble) = (f64::from(5 * i).to_radians(), 0.28 * (17.0 * f64::from(i * i)).sin());
        measured.push_str(&format!("{},{},0.2\n", 5 * i, 5.0 * (2.0 * angle).sin() - 0.37 + wobble));
    }
    place.write("m.csv", measured);
    let answer = place.fem(&["diagnose", "contour.toml", "--with", "m.csv", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&answer.out).unwrap();
    let first = &json["missing"][0];
    let mut class: Vec<&str> = vec![first["effect"].as_str().unwrap()];
    class.extend(first["indistinguishable_from"].as_array().unwrap().iter().map(|n| n.as_str().unwrap()));
    class.sort_unstable();
    assert_eq!(class, ["servo-mismatch", "squareness"], "{}", answer.out);
    assert_eq!(json["next_measurement"]["coordinate"], "direction", "{}", answer.out);
}

/// Deviations (um) of a circle of 150 mm at 1000 mm/min behind servos of 50 /s whose x slide hangs on a
/// spring and rubs, stepped through time: at each step the slide stays if the spring pulls no harder than
/// the friction (N), and else slips until it does. The spring is a nut (N/um) and the steel screw of 32 mm
/// from 400 mm left of the centre.
fn rubbing(friction: f64, nut: f64, way: f64, degrees: &[f64]) -> Vec<f64> {
    const STEPS: usize = 72_000;
    let turn = std::f64::consts::TAU;
    let lag = 1000.0 / 60.0 / 150.0 / 50.0f64;
    let (amplitude, late) = (150e3 / lag.hypot(1.0), lag.atan());
    let at = |i: usize| turn * i as f64 / STEPS as f64;
    let (mut slide, mut places) = (0.0f64, vec![0.0; STEPS]);
    for i in 0..2 * STEPS {
        let drive = amplitude * (at(i % STEPS) - late).cos();
        let rigidity = 210e3 * std::f64::consts::PI * 16.0 * 16.0;
        let most = friction * (1.0 / nut + (slide / 1e3 + 400.0) * 1e3 / rigidity);
        if (drive - slide).abs() > most {
            slide = drive - most.copysign(drive - slide);
        }
        places[i % STEPS] = slide;
    }
    let of = |degrees: &f64| {
        let angle = (way * degrees).rem_euclid(360.0).to_radians();
        let i = (angle / turn * STEPS as f64).round() as usize % STEPS;
        places[i].hypot(amplitude * (at(i) - late).sin()) - 150e3
    };
    degrees.iter().map(of).collect()
}

#[test]
fn friction_on_a_long_screw_is_told_from_play() {
    let place = Place::new();
    let text = model("contour.toml").split("[effects").next().unwrap().to_string();
    let drives =
        "\nx = { screw = { material = \"steel\", diameter = \"32 mm\", fixed_at = \"-400 mm\" } }\n\n[tolerance]";
    place.write("contour.toml", text.replace("\n[tolerance]", drives));
    let degrees: Vec<f64> = (0..72).map(|i| 5.0 * f64::from(i) + 1.0).collect();
    let mut measured = String::from("angle [deg],direction,deviation [um],u [um]\n");
    for (way, sign) in [("ccw", 1.0), ("cw", -1.0)] {
        for (i, deviation) in rubbing(900.0, 300.0, sign, &degrees).into_iter().enumerate() {
            let noise = 0.4 * (17.0 * i as f64 + sign).sin();
            measured.push_str(&format!("{},{way},{},0.3\n", degrees[i], deviation + noise));
        }
    }
    place.write("m.csv", measured);
    let answer = place.fem(&["diagnose", "contour.toml", "--with", "m.csv", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&answer.out).unwrap();
    assert_eq!(json["missing"].as_array().unwrap().len(), 1, "{}", answer.out);
    let first = &json["missing"][0];
    assert_eq!(first["effect"], "elastic-lost-motion-x", "{}", answer.out);
    assert_eq!(first["indistinguishable_from"].as_array().unwrap().len(), 0, "{}", answer.out);
    let friction = &first["parameters"]["friction"];
    let [value, std] = ["value", "std"].map(|key| friction[key].as_f64().unwrap());
    assert!((value - 900.0).abs() < 3.0 * std && std < 200.0, "{value} {std}");
}

/// Deviations (um) of a circle of 150 mm behind servos of 50 /s, that of x with a gain that follows its
/// speed: Kv·(1 + change·|v|/1000 mm/min), stepped through time; feed in mm/min.
fn following(change: f64, feed: f64, way: f64, degrees: &[f64]) -> Vec<f64> {
    const STEPS: usize = 36_000;
    let omega = feed / 60.0 / 150.0;
    let step = std::f64::consts::TAU / omega / STEPS as f64;
    // v = e·K·(1 + change·|v|/feed).
    let speed = |error: f64, change: f64| 50.0 * error / (1.0 - 50.0 * change * error.abs() / (1000.0 / 60.0));
    let (mut at, mut places) = ([150.0, 0.0], vec![[0.0; 2]; STEPS]);
    for i in 0..2 * STEPS {
        places[i % STEPS] = at;
        let rate = |at: [f64; 2], time: f64| {
            let (sine, cosine) = (omega * time).sin_cos();
            [speed(150.0 * cosine - at[0], change), speed(way * 150.0 * sine - at[1], 0.0)]
        };
        let time = i as f64 * step;
        let first = rate(at, time);
        let middle = rate([0, 1].map(|k| at[k] + 0.5 * step * first[k]), time + 0.5 * step);
        at = [0, 1].map(|k| at[k] + step * middle[k]);
    }
    let of = |degrees: &f64| {
        let i = ((way * degrees).rem_euclid(360.0) / 360.0 * STEPS as f64).round() as usize % STEPS;
        1e3 * (places[i][0].hypot(places[i][1]) - 150.0)
    };
    degrees.iter().map(of).collect()
}

#[test]
fn what_follows_the_feed_is_named() {
    let place = Place::new();
    let text = model("contour.toml").split("[effects").next().unwrap().to_string();
    place.write("contour.toml", text.replace("\n[tolerance]", "\nfrequency = \"3 Hz\"\n\n[tolerance]"));
    let degrees: Vec<f64> = (0..72).map(|i| 5.0 * f64::from(i) + 1.0).collect();
    for (effect, change, jerk, parameter, truth) in
        [("gain-with-feed-x", 0.05, 0.0, "change", 0.05), ("stick-slip-x", 0.0, 1.5, "amplitude", 1.5)]
    {
        let mut measured = String::from("angle [deg],direction,feed [mm/min],deviation [um],u [um]\n");
        for (way, sign, feed) in [("ccw", 1.0, 1000.0), ("cw", -1.0, 1000.0), ("ccw", 1.0, 500.0)] {
            for (degrees, deviation) in degrees.iter().zip(following(change, feed, sign, &degrees)) {
                let angle = degrees.to_radians();
                let time = (sign * degrees).rem_euclid(360.0).to_radians() * 150.0 / (feed / 60.0);
                let wave = jerk * (std::f64::consts::TAU * 3.0 * time + 0.7).sin() * angle.cos();
                let noise = 0.25 * (17.0 * degrees + sign + feed).sin();
                measured.push_str(&format!("{degrees},{way},{feed},{},0.2\n", deviation + wave + noise));
            }
        }
        place.write("m.csv", measured);
        let answer = place.fem(&["diagnose", "contour.toml", "--with", "m.csv", "--json"]);
        let json: serde_json::Value = serde_json::from_str(&answer.out).unwrap();
        assert_eq!(json["missing"].as_array().unwrap().len(), 1, "{}", answer.out);
        let first = &json["missing"][0];
        assert_eq!(first["effect"], effect, "{}", answer.out);
        assert_eq!(first["indistinguishable_from"].as_array().unwrap().len(), 0, "{}", answer.out);
        let [value, std] = ["value", "std"].map(|key| first["parameters"][parameter][key].as_f64().unwrap());
        assert!((value - truth).abs() < 3.5 * std + 0.01 * truth, "{effect}: {value} {std}");
    }
}
