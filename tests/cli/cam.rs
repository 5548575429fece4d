//! Cams as a user meets them: summary, files, lift tables, bad input.

use super::fem::{Mistake, Place, model};

#[test]
fn the_summary_of_the_cam() {
    let place = Place::new();
    place.write("cam.toml", model("cam.toml"));
    let answer = place.fem(&["run", "cam.toml"]);
    assert_eq!(answer.status, 0);
    insta::assert_snapshot!(answer.out);
    // The nose cuts deeper than the layer, and that is told.
    assert!(answer.err.contains("more than the layer of 20.0 um"), "{}", answer.err);
    insta::assert_snapshot!("effects_cam", place.fem(&["effects", "cam"]).out);
    let program = place.read("out/cam/program.csv");
    assert_eq!(program.lines().count(), 1 + 133, "a header, the first point, and the end of each of 132 blocks");
    let last: Vec<f64> = program.lines().last().unwrap().split(',').map(|c| c.parse().unwrap()).collect();
    assert!((last[1] - 360.0).abs() < 1e-6 && (last[2] - 189.0).abs() < 1e-6, "{last:?}");
    assert!(place.read("out/cam/cam.svg").starts_with("<svg") || place.read("out/cam/cam.svg").starts_with("<?xml"));
}

#[test]
fn a_profile_is_a_measurement_of_its_own_model() {
    let place = Place::new();
    place.write("cam.toml", model("cam.toml"));
    assert_eq!(place.fem(&["run", "cam.toml", "-o", "out"]).status, 0);
    let compared = place.fem(&["compare", "cam.toml", "--with", "out/profile.csv", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&compared.out).unwrap();
    assert!(json["models"][0]["rms"].as_f64().unwrap() < 1e-6, "{}", compared.out);
    assert_eq!(compared.err, "");
}

/// A cam given by a table: the radius over the angle.
fn table_model(more: &str) -> String {
    format!(
        "process = \"cam\"\n[profile]\ntable = \"lift/cam.csv\"\n{more}\n[wheel]\nradius = \"100 mm\"\n[program]\nangle = \"1 deg\"\ncam_speed = \"20 rpm\"\n"
    )
}

/// An eccentric circle of 20 mm, 3 mm beside the axis.
fn table(rows: usize) -> String {
    let mut text = String::from("# lift\nangle [deg],radius [mm]\n");
    for i in 0..rows {
        let angle = 360.0 * i as f64 / rows as f64;
        let (sine, cosine) = angle.to_radians().sin_cos();
        text.push_str(&format!("{angle},{}\n", 3.0 * cosine + (400.0 - 9.0 * sine * sine).sqrt()));
    }
    text
}

#[test]
fn a_lift_table_stands_for_its_profile() {
    let place = Place::new();
    std::fs::create_dir(place.path("models")).unwrap();
    std::fs::create_dir(place.path("models/lift")).unwrap();
    place.write("models/lift/cam.csv", table(360));
    place.write("models/table.toml", table_model(""));
    // A roller of 8 mm whose centre runs on a circle of 20 mm grinds one of 12 mm.
    place.write("models/roller.toml", table_model("roller = \"8 mm\""));
    let circle = |radius: f64| {
        let chain = format!(
            "start = [\"{} mm\", \"0 mm\"]\nsegments = [{{ arc = {{ centre = [\"3 mm\", \"0 mm\"], sweep = \"360 deg\" }} }}]",
            3.0 + radius
        );
        table_model("").replace("table = \"lift/cam.csv\"", &chain)
    };
    place.write("models/circle.toml", circle(20.0));
    place.write("models/smaller.toml", circle(12.0));
    for (of_table, of_circle) in [("table", "circle"), ("roller", "smaller")] {
        let run = place.fem(&["run", &format!("models/{of_table}.toml"), "-o", "out"]);
        assert_eq!((run.status, run.err.as_str()), (0, ""));
        let circle = format!("models/{of_circle}.toml");
        let json: serde_json::Value =
            serde_json::from_str(&place.fem(&["compare", &circle, "--with", "out/profile.csv", "--json"]).out).unwrap();
        // The spline through 360 rows is the circle to a nanometre.
        assert!(json["models"][0]["rms"].as_f64().unwrap() < 1e-3, "{json}");
    }
}

#[test]
fn bad_lift_tables_are_told_by_their_lines() {
    let place = Place::new();
    std::fs::create_dir(place.path("lift")).unwrap();
    place.write("cam.toml", table_model(""));
    let good = table(36);
    let lines: Vec<&str> = good.lines().collect();
    let swapped = [&lines[..5], &[lines[7], lines[6]], &lines[7..]].concat().join("\n");
    let cases = [
        (good.replace("angle [deg]", "angle"), "no column `angle [unit]`"),
        (good.replace("[mm]", "[kg]"), "not a length"),
        (swapped, "the angles do not rise"),
        (good.replace("\n90,", "\nninety,"), "line 12: `ninety` is no finite number"),
        (lines[..10].join("\n"), "8 rows are too few for a cam"),
        ([&lines[..12], &lines[30..]].concat().join("\n"), "nothing is known from 90.00 to 280.00 deg"),
        (format!("{good}\n360,40\n"), "one turn apart and differ in radius"),
        (good.replace("\n90,", "\n90,-"), "the radius is not above zero"),
    ];
    for (text, message) in cases {
        place.write("lift/cam.csv", &text);
        let answer = place.fem(&["run", "cam.toml"]);
        let told = answer.err.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(answer.status == 2 && told.contains(message), "{message}: {told}");
    }
    std::fs::remove_file(place.path("lift/cam.csv")).unwrap();
    let answer = place.fem(&["run", "cam.toml"]);
    assert!(answer.status == 2 && answer.err.contains("relative to the folder"), "{}", answer.err);
}

/// (in the starting model, replaced by, part of the message, part of the remedy)
const CASES: &[Mistake] = &[
    ("\"14 mm\", \"0 mm\"] } },\n]", "\"13 mm\", \"0 mm\"] } },\n]", "turns by", "round the corner by an arc"),
    ("\"-14 mm\", \"-20 mm\"", "\"-14 mm\", \"0 mm\"", "the line has no length", "leave it out"),
    (
        "sweep = \"180 deg\" } },\n  { line = { to = [\"14 mm\"",
        "sweep = \"170 deg\" } },\n  { line = { to = [\"14 mm\"",
        "turns by",
        "tangent",
    ),
    (
        "  { line = { to = [\"14 mm\", \"0 mm\"] } },\n",
        "",
        "the chain is open: it ends at (14.000000 mm, -20.000000 mm), 20.0000 mm",
        "end it where it starts",
    ),
    (
        "{ arc = { centre = [\"0 mm\", \"0 mm\"], sweep = \"180 deg\" } }",
        "{ }",
        "a segment is either a line or an arc",
        "write { line",
    ),
    ("centre = [\"0 mm\", \"0 mm\"]", "centre = [\"0 mm\"]", "`centre` is no pair", "write centre = ["),
    ("centre = [\"0 mm\", \"0 mm\"]", "centre = [0, 0]", "a length is a string with its unit", "write centre = ["),
    ("start = [\"14 mm\"", "start = [\"14 kg\"", "not a length", "write it in mm"),
    ("radius = \"175 mm\"", "radius = \"? mm\"", "that is unknown (`?`) makes no cam", "wheel-wear"),
    ("step = \"0.5 mm\"", "", "does not say how blocks are chosen", "tolerance"),
    ("step = \"0.5 mm\"", "step = \"0.5 mm\"\nblocks = 20", "in more than one way how blocks are chosen", "keep one"),
    ("step = \"0.5 mm\"", "blocks = 3", "3 blocks are too few: 4 are needed", "joints = \"pass\""),
    ("step = \"0.5 mm\"", "step = \"0.05 um\"", "more than 20000 blocks", "take longer ones"),
    ("cam_speed = \"20 rpm\"", "", "does not say how fast it runs", "add cam_speed"),
    (
        "cam_speed = \"20 rpm\"",
        "cam_speed = \"20 rpm\"\nfeed = \"600 mm/min\"",
        "`cam_speed` and `feed` both say",
        "keep one",
    ),
    ("step = \"0.5 mm\"", "step = \"0.5 mm\"\nends = \"half\"", "half", "half-error"),
    (
        "[cut]\nstock = \"20 um\"",
        "[before]\nstep = \"1 mm\"\n\n[cut]",
        "the layer between the two passes is not known",
        "add stock",
    ),
    (
        "[effects.wheel-wear]\nloss",
        "[effects.tool-wear]\nloss",
        "is an effect of `turning`, not of `cam`",
        "fem effects cam",
    ),
];

#[test]
fn bad_input_is_told_with_its_remedy() {
    let place = Place::new();
    let good = place.fem(&["new", "cam"]).out;
    place.refuses(("run", "cam.toml"), &good, CASES);
    let without = good
        .replace("force_per_rate = \"10 +- 10 N/(mm^2/s)\"", "")
        .replace("wheel-wear]\nloss = \"5 +- 5 um\"", "grinding-deflection]\nstiffness = \"5 N/um\"");
    place.write("cam.toml", without);
    let answer = place.fem(&["run", "cam.toml"]);
    assert!(answer.status == 2 && answer.err.contains("needs the force of the cut"), "{}", answer.err);
}

#[test]
fn profiles_that_cannot_be_ground_are_refused_or_warned_of() {
    let place = Place::new();
    let model = |start: &str, segments: &str, wheel: f64| {
        format!(
            "process = \"cam\"\n[profile]\nstart = [{start}]\nsegments = [{segments}]\n[wheel]\nradius = \"{wheel} mm\"\n[program]\nstep = \"0.2 mm\"\ncam_speed = \"20 rpm\"\n"
        )
    };
    // The axis outside, and twice round.
    let arc = |sweep: &str| format!("{{ arc = {{ centre = [\"0 mm\", \"0 mm\"], sweep = \"{sweep}\" }} }}");
    place.write(
        "beside.toml",
        model("\"60 mm\", \"0 mm\"", "{ arc = { centre = [\"40 mm\", \"0 mm\"], sweep = \"360 deg\" } }", 50.0),
    );
    place.write("twice.toml", model("\"20 mm\", \"0 mm\"", &[arc("360 deg"), arc("360 deg")].join(","), 50.0));
    for (name, message) in [
        ("beside.toml", "towards the cam's axis or turns back"),
        ("twice.toml", "2.00 times round the axis and crosses itself"),
    ] {
        let answer = place.fem(&["run", name]);
        let told = answer.err.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(answer.status == 2 && told.contains(message), "{told}");
    }
    // Two noses of 20 mm about (±30, 0) mm and hollows of 50 mm radius about (0, ±63.2456) mm between them;
    // both arcs are tangent where the centres' line meets them.
    let hollow = |wheel: f64| {
        let (r, c, h) = (20.0, 30.0, (70.0f64 * 70.0 - 900.0).sqrt());
        // From the end of the right nose, which is 20/70 of the way to the upper hollow's centre.
        let (x, y) = (c - r * c / 70.0, r * h / 70.0);
        let half = (h / c).atan().to_degrees();
        let turn = 180.0 - 2.0 * half;
        let arc = |cx: f64, cy: f64, sweep: f64| {
            format!("{{ arc = {{ centre = [\"{cx} mm\", \"{cy} mm\"], sweep = \"{sweep} deg\" }} }}")
        };
        let about = 2.0 * (180.0 - half);
        let segments = [arc(0.0, h, -turn), arc(-c, 0.0, about), arc(0.0, -h, -turn), arc(c, 0.0, about)];
        model(&format!("\"{x} mm\", \"{y} mm\""), &segments.join(", "), wheel)
    };
    place.write("hollow.toml", hollow(40.0));
    let answer = place.fem(&["run", "hollow.toml"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    place.write("hollow.toml", hollow(80.0));
    let answer = place.fem(&["run", "hollow.toml"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    assert!(
        answer.err.contains("undercuts its neighbourhood, and no programme avoids it; take a wheel below 50.000 mm"),
        "{}",
        answer.err
    );
}

#[test]
fn a_row_that_no_grinder_can_give_is_refused() {
    let place = Place::new();
    place.write("cam.toml", model("cam.toml"));
    place.write("m.csv", "angle [deg],cam_speed [rpm],deviation [um]\n0,0,1\n");
    let answer = place.fem(&["compare", "cam.toml", "--with", "m.csv"]);
    assert_eq!(answer.status, 2);
    assert!(answer.err.contains("`cam_speed` is not above zero"), "{}", answer.err);
}

#[test]
fn a_programme_at_one_feed_takes_its_time_from_its_length() {
    let place = Place::new();
    let good = place.fem(&["new", "cam"]).out;
    place.write("cam.toml", good.replace("cam_speed = \"20 rpm\" ", "feed = \"600 mm/min\" "));
    let run = place.fem(&["run", "cam.toml", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&run.out).unwrap();
    let feed = &json["findings"]["feed"];
    assert!(
        (feed["least_mean"].as_f64().unwrap() - 600.0).abs() < 1e-6
            && (feed["greatest_mean"].as_f64().unwrap() - 600.0).abs() < 1e-6
    );
    // 2·14·π + 40 mm at 10 mm/s.
    let time = json["findings"]["program"]["time"].as_f64().unwrap();
    assert!((time - (28.0 * std::f64::consts::PI + 40.0) / 10.0).abs() < 1e-9, "{time}");
}
