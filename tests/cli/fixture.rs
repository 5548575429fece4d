//! The fixture as a user meets it: summary, files, bad input, parts that lift off or tip.

use super::fem::{Mistake, Place, model};

#[test]
fn the_summary_of_the_fixture() {
    let place = Place::new();
    place.write("fixture.toml", model("fixture.toml"));
    let answer = place.fem(&["run", "fixture.toml"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    insta::assert_snapshot!(answer.out);
    insta::assert_snapshot!("effects_fixture", place.fem(&["effects", "fixture"]).out);
}

#[test]
fn a_profile_is_a_measurement_of_its_own_model() {
    let place = Place::new();
    // Clamps of one force, and clamps that differ.
    for text in [model("fixture.toml"), model("fixture.toml").replacen("\"4 kN\"", "\"5 kN\"", 1)] {
        place.write("fixture.toml", text);
        assert_eq!(place.fem(&["run", "fixture.toml", "-o", "out"]).status, 0);
        let compared = place.fem(&["compare", "fixture.toml", "--with", "out/profile.csv", "--json"]).out;
        let json: serde_json::Value = serde_json::from_str(&compared).unwrap();
        assert!(json["models"][0]["rms"].as_f64().unwrap() < 1e-9, "{compared}");
    }
}

/// The scatter over a batch is the largest less the smallest of what the model predicts under the ends of its ranges, with
/// the cutter on the part.
#[test]
fn the_scatter_is_that_of_milled_parts() {
    let place = Place::new();
    // On two supports heights fall all along with the force, so that the ends of its range decide.
    let text = model("fixture.toml").replacen("[[support]]\nat = \"300 mm\"\n", "", 1);
    let run = |text: String| -> serde_json::Value {
        place.write("fixture.toml", text);
        serde_json::from_str(&place.fem(&["run", "fixture.toml", "--json"]).out).unwrap()
    };
    let told = run(text.clone())["findings"]["scatter"]["height"].as_f64().unwrap();
    let heights = |force: &str, coefficient: &str| {
        run(text.replace("\"4 kN\"", force).replace("\"0.2 +- 0.05 um/N^n\"", coefficient));
        place.column("out/fixture/profile.csv", "height_error").split_off(121)
    };
    let forces = ["\"3.5 kN\"", "\"4.5 kN\""];
    let ends = forces.map(|force| ["\"0.15 um/N^n\"", "\"0.25 um/N^n\""].map(|c| heights(force, c))).concat();
    let spread = |x: usize| {
        let at = |end: &Vec<f64>| end[x];
        ends.iter().map(at).fold(f64::MIN, f64::max) - ends.iter().map(at).fold(f64::MAX, f64::min)
    };
    let widest = (0..121).map(spread).fold(0.0, f64::max);
    assert!((told - widest).abs() < 1e-9, "{told} um, by its own predictions {widest} um");
}

/// A part with bosses, clamped half way between its supports: its bosses come out askew, and parallel where a clamp stands above
/// each support.
#[test]
fn bosses_come_out_askew_where_the_clamp_is_wrong() {
    let place = Place::new();
    let wrong = model("bosses.toml");
    place.write("bosses.toml", wrong.clone());
    let answer = place.fem(&["run", "bosses.toml", "-o", "wrong"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    insta::assert_snapshot!(answer.out);
    let clamp = "at = \"160 mm\"\nforce = \"3 kN\"";
    let right = "at = \"30 mm\"\nforce = \"1.5 kN\"\n[[clamp]]\nat = \"290 mm\"\nforce = \"1.5 kN\"";
    place.write("right.toml", wrong.replacen(clamp, right, 1));
    let answer = place.fem(&["run", "right.toml", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&answer.out).unwrap();
    let askew = json["findings"]["faces"]["list"][1]["parallel"].as_f64().unwrap();
    assert!(askew.abs() < 1e-9, "{askew}");
}

/// A support's own spring is one beside which the others are rigid; and a force that is recorded over the cutter's place is, row
/// by row, the force of that place.
#[test]
fn supports_may_differ_and_clamps_may_change_their_force() {
    let place = Place::new();
    let heights = |text: String| -> Vec<f64> {
        place.write("part.toml", text);
        let answer = place.fem(&["run", "part.toml", "-o", "out"]);
        assert_eq!((answer.status, answer.err.as_str()), (0, ""));
        place.column("out/profile.csv", "height_error")
    };
    let part = |support: &str, first: &str, effects: &str| {
        format!(
            "process = \"fixture\"\nworkpiece = {{ material = \"steel\", length = \"400 mm\", width = \"60 mm\", height = \"50 mm\" }}\n\
             support = [{{ at = \"50 mm\"{support} }}, {{ at = \"350 mm\"{support} }}]\n\
             clamp = [{{ at = \"150 mm\", force = {first} }}, {{ at = \"250 mm\", force = \"2 kN\" }}]\n\
             sweep = {{ positions = 5 }}\n{effects}"
        )
    };
    let by_effects = "[effects.support-compliance]\nstiffness = \"300 N/um\"\n[effects.contact-joint]\nc = \"0.3 um/N^n\"\nn = 0.6\n";
    let by_itself = ", stiffness = \"300 N/um\", c = \"0.3 um/N^n\", n = 0.6";
    let (one, other) = (heights(part("", "\"3 kN\"", by_effects)), heights(part(by_itself, "\"3 kN\"", "")));
    assert_eq!(one.len(), 5);
    one.iter().zip(&other).for_each(|(a, b)| assert!((a - b).abs() < 1e-9, "{a} {b}"));
    place.write("clamp.csv", "x [mm],force [kN]\n0,1\n400,5\n");
    let recorded = heights(part("", "{ file = \"clamp.csv\" }", ""));
    for (i, height) in recorded.iter().enumerate() {
        let there = heights(part("", &format!("\"{} kN\"", 1 + i), ""))[i];
        assert!((height - there).abs() < 1e-9, "{i}: {height} {there}");
    }
}

/// (in the model with bosses, replaced by, part of the message, part of the remedy)
const BOSSES: &[Mistake] = &[
    (
        "width = \"60 mm\"",
        "width = \"60 mm\"\nlength = \"320 mm\"",
        "`length` stands beside `segments`",
        "leave `length` out",
    ),
    ("height = \"25 mm\"", "heigth = \"25 mm\"", "`heigth` is no key", "did you mean `height`?"),
    ("at = \"290 mm\"", "at = \"330 mm\"", "330 mm is beyond the part", "the part is 320 mm long"),
    ("at = \"290 mm\"", "at = \"290 mm\"\nn = 0.5", "there is no contact", "add `c`"),
    (
        "[sweep]",
        "[cutter]\nfrom = \"100 mm\"\nto = \"200 mm\"\n[sweep]",
        "nothing of the part is 50 mm high from 100 mm to 200 mm",
        "the highest segments",
    ),
];

#[test]
fn parts_with_bosses_that_cannot_be_are_told() {
    let good = model("bosses.toml");
    let place = Place::new();
    place.refuses(("run", "bosses.toml"), &good, BOSSES);
    // A height measured in the valley.
    place.write("bosses.toml", good);
    place.write("measured.csv", "x [mm],height_error [um]\n10,3\n160,2\n300,3\n");
    let answer = place.fem(&["compare", "bosses.toml", "--with", "measured.csv"]);
    assert_eq!(answer.status, 2);
    assert!(
        answer.err.contains("at x = 160 mm the part is 25 mm high, and its top, which is milled, at 50 mm"),
        "{}",
        answer.err
    );
}

/// (in the model, replaced by, part of the message, part of the remedy)
const CASES: &[Mistake] = &[
    ("height = \"40 mm\"", "hight = \"40 mm\"", "`hight` is no key of `workpiece`", "did you mean `height`?"),
    ("\"600 mm\"", "\"600 N\"", "not a length", "write it in mm"),
    ("at = \"560 mm\"", "at = \"660 mm\"", "660 mm is beyond the part", "the part is 600 mm long"),
    ("at = \"300 mm\"", "at = \"40 mm\"", "two supports stand at 40 mm", "a place of its own"),
    ("\"4 kN\"", "\"-4 kN\"", "`force` is -4000 N", "zero or more"),
    ("max = \"4.5 kN\"", "max = \"3 kN\"", "the largest is below the smallest", "exchange `min` and `max`"),
    ("force = \"350 N\"", "force = \"350 N\"\nfrom = \"700 mm\"", "beside the part, at 700 mm", "from 0 mm to 600 mm"),
    ("force = \"350 N\"", "force = \"350 N\"\ndepth = \"0 mm\"", "`depth` is 0 mm", "above zero"),
    (
        "force = \"350 N\"",
        "force = \"350 N\"\nblank = [{ waves = 2, amplitude = \"50 um\" }]",
        "a depth that is not known",
        "add depth = \"1 mm\" to [cutter]",
    ),
    (
        "force = \"350 N\"",
        "depth = \"1 mm\"\nblank_points = [{ at = \"700 mm\", error = \"50 um\" }]",
        "the place lies beyond the part",
        "the part is 600 mm long",
    ),
    (
        "[effects.locator-wear]",
        "[effects.force-feedback]\nexponent = 1.0\n[effects.locator-wear]",
        "`force-feedback` needs the depth of the cut",
        "remove the effect",
    ),
    (
        "[effects.locator-wear]",
        "[effects.cutter-tilt]\nalong = \"200 um/m\"\nacross = \"0 um/m\"\n[effects.locator-wear]",
        "`cutter-tilt` needs the cutter's diameter",
        "remove the effect",
    ),
    ("rate = \"12 um/1000\"", "rate = \"12 um/km\"", "not a wear per part", "um/1000"),
    ("[effects.locator-wear]", "[effects.locator-ware]", "`locator-ware` is no effect", "did you mean `locator-wear`?"),
];

#[test]
fn bad_input_is_told_with_its_remedy() {
    let good = model("fixture.toml");
    let place = Place::new();
    place.refuses(("run", "fixture.toml"), &good, CASES);
    let one = good.replace("[[support]]\nat = \"300 mm\"\n", "").replace("[[support]]\nat = \"560 mm\"\n", "");
    place.write("fixture.toml", one);
    let answer = place.fem(&["run", "fixture.toml"]);
    assert!(answer.status == 2 && answer.err.contains("one support does not hold a part"), "{}", answer.err);
    assert!(!place.files().iter().any(|f| f.starts_with("out")));
}

/// A cutter over the whole width of 80 mm that stands aslant along the feed and across it.
#[test]
fn a_cutter_that_is_not_square_leaves_the_top_hollow_and_aslant() {
    let place = Place::new();
    let tilt = "\n[effects.cutter-tilt]\nalong = \"200 um/m\"\nacross = \"-50 um/m\"\n";
    let with = |diameter: &str| {
        model("fixture.toml").replace("[cutter]\n", &format!("[cutter]\ndiameter = \"{diameter}\"\n")) + tilt
    };
    place.write("fixture.toml", with("79 mm"));
    let answer = place.fem(&["run", "fixture.toml"]);
    assert!(
        answer.status == 2 && answer.err.contains("whole width of 80 mm at once, and this one has 79 mm"),
        "{}",
        answer.err
    );
    place.write("fixture.toml", with("100 mm"));
    let run = place.fem(&["run", "fixture.toml", "-o", "out", "--json"]);
    assert_eq!(run.status, 0, "{}", run.err);
    let form = &serde_json::from_str::<serde_json::Value>(&run.out).unwrap()["findings"]["form"];
    // 50 - sqrt(50^2 - 40^2) = 20 mm at 200 um/m; 80 mm at -50 um/m.
    for (key, expected) in [("hollow", 4.0), ("across", -4.0)] {
        assert!((form[key].as_f64().unwrap() - expected).abs() < 1e-6, "{form}");
    }
    let profile = place.read("out/profile.csv");
    assert!(profile.lines().any(|line| line.contains("y [mm]")) && profile.contains("-40"), "{profile}");
    let compared = place.fem(&["compare", "fixture.toml", "--with", "out/profile.csv", "--json"]).out;
    let json: serde_json::Value = serde_json::from_str(&compared).unwrap();
    assert!(json["models"][0]["rms"].as_f64().unwrap() < 1e-9, "{compared}");
    place.write("off.csv", "x [mm],y [mm],height_error [um]\n100,41,1\n");
    let answer = place.fem(&["compare", "fixture.toml", "--with", "off.csv"]);
    assert!(answer.status == 2 && answer.err.contains("whose edges lie 40 mm from its middle"), "{}", answer.err);
}

#[test]
fn a_part_that_tips_or_a_clamp_beside_it_is_refused() {
    let place = Place::new();
    let clamps = "[[clamp]]\nat = \"480 mm\"\nforce = \"4 kN\"\n";
    for (from, to, message) in [
        (clamps, "", "the part tips: what presses on it acts at x = 3.678 mm"),
        ("offset = \"4 mm\"", "offset = \"-130 mm\"", "the clamp drawn at 120.000 mm stands at -10.000 mm"),
        ("height = \"40 mm\"", "height = \"4 mm\"", "no part on its supports is so far off"),
    ] {
        let text = model("fixture.toml").replacen(from, to, 1);
        let text = if to.is_empty() { text.replace("at = \"120 mm\"", "at = \"0 mm\"") } else { text };
        place.write("fixture.toml", text);
        let answer = place.fem(&["run", "fixture.toml"]);
        assert_eq!(answer.status, 1, "{}", answer.err);
        assert!(answer.err.split_whitespace().collect::<Vec<_>>().join(" ").contains(message), "{}", answer.err);
    }
}

#[test]
fn a_support_that_the_part_leaves_is_warned_of() {
    let place = Place::new();
    let text = model("fixture.toml").replace("at = \"480 mm\"\nforce = \"4 kN\"", "at = \"480 mm\"\nforce = \"10 N\"");
    place.write("fixture.toml", text);
    let answer = place.fem(&["run", "fixture.toml"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    assert!(answer.err.contains("lifts off the support at 560.0 mm"), "{}", answer.err);
    assert!(answer.out.contains("carries nothing"), "{}", answer.out);
}

#[test]
fn the_cutter_presses_where_it_stands() {
    let place = Place::new();
    let bare = model("fixture.toml").split("[effects").next().unwrap().to_string();
    place.write("fixture.toml", bare);
    // An indicator at 300 mm, above the rigid middle support, sees nothing of the cutter; one beside the
    // cutter sees it.
    let rows = "x [mm],cutter_force [N],cutter_x [mm],clamp_force [N],height_error [um]\n\
                300,800,170,4000,0\n170,800,170,4000,0\n170,800,430,4000,0\n170,0,170,4000,0\n";
    place.write("m.csv", rows);
    let answer = place.fem(&["compare", "fixture.toml", "--with", "m.csv", "-o", "out"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let predicted: Vec<f64> = place
        .read("out/residuals.csv")
        .lines()
        .skip(1)
        .map(|line| line.split(',').nth(5).unwrap().parse().unwrap())
        .collect();
    assert!(predicted[0].abs() < 1e-9);
    assert!(predicted[1] > predicted[3] + 1.0 && predicted[2] < predicted[3], "{predicted:?}");
}

#[test]
fn rows_off_the_part_are_refused() {
    let place = Place::new();
    place.write("fixture.toml", model("fixture.toml"));
    for (row, message) in [("700,1,0", "x = 700 mm is not on the part"), ("10,-1,0", "`clamp_force` is below zero")] {
        place.write("m.csv", format!("x [mm],clamp_force [N],height_error [um]\n{row}\n"));
        let answer = place.fem(&["compare", "fixture.toml", "--with", "m.csv"]);
        assert_eq!(answer.status, 2);
        assert!(answer.err.contains(message), "{}", answer.err);
    }
}

/// What is corrected are the faces that are milled: a valley between them is no place of the contour.
#[test]
fn a_correction_keeps_to_the_faces_of_the_top() {
    let place = Place::new();
    place.write("bosses.toml", model("bosses.toml"));
    assert_eq!(place.fem(&["run", "bosses.toml", "-o", "out"]).status, 0);
    let answer = place.fem(&["correct", "bosses.toml", "-o", "corrected"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let places = place.column("corrected/correction.csv", "x");
    assert!(places.iter().all(|x| !(60.0 < *x && *x < 260.0)), "{places:?}");
    let [low, high] =
        [f64::min, f64::max].map(|of| place.column("out/profile.csv", "height_error").into_iter().reduce(of).unwrap());
    // The same part is told by both commands.
    for told in [low, high] {
        assert!(answer.out.contains(&format!("{told:+.3}")), "{told:+.3}\n{}", answer.out);
    }
}

/// Two places on three pallets, measured on 18 parts, by hand: c*sqrt(Q) less how high place and pallet stand, and wear.
fn measured_in_places() -> String {
    let (places, pallets) = ([(20.0, 0.0, 0.0), (260.0, 5.2, -22.0)], [(0.0, 0.0), (4.1, 9.0), (-6.3, 0.0)]);
    let mut text = "part,place,pallet,x [mm],clamp_force [N],height_error [um],u [um]\n".to_string();
    let mut scatter = generator::random::Random::new("places", 1);
    for number in 0..18 {
        let (place, pallet, part) = (number % 2, number / 2 % 3, 20 * (number + 1));
        let force: f64 = [4000.0, 3500.0, 4500.0][number / 6];
        for x in (10..200).step_by(30).map(f64::from) {
            let (at, high, tilt) = places[place];
            let raised = high + 1e-3 * tilt * x + pallets[pallet].0 + 1e-3 * pallets[pallet].1 * (at + x);
            let error = 0.23 * force.sqrt() - raised + 3.7e-3 * part as f64 + 0.3 * scatter.normal();
            text += &format!("{part},{},{},{x},{force},{error:.4},0.3\n", place + 1, pallet + 1);
        }
    }
    text
}

#[test]
fn a_program_carries_no_contours_of_several_places() {
    let place = Place::new();
    place.write("model.toml", model("two-places.toml"));
    place.write("top.ngc", "G17 G21\nG0 X-50. Y0. Z2.\nG1 Z0. F800\nX250.\nG0 Z50.\nM30\n");
    let refused = place.fem(&["correct", "model.toml", "--program", "top.ngc", "-o", "corrected"]);
    assert_eq!(refused.status, 2);
    insta::assert_snapshot!(refused.err);
    assert!(!place.path("corrected").exists());
}

#[test]
fn what_places_and_pallets_are_off_by_is_told_and_found() {
    let place = Place::new();
    place.write("model.toml", model("two-places.toml"));
    place.write("measured.csv", measured_in_places());
    insta::assert_snapshot!(place.fem(&["run", "model.toml", "-o", "out"]).out);
    assert!(place.read("out/profile.csv").starts_with("part,x [mm],place,pallet"));
    // A model of one place does not take them for its own.
    let text = place.read("model.toml");
    let (sites, sizes) = (text.find("[[place]]").unwrap(), text.find("[[size]]").unwrap());
    place.write("one.toml", [&text[..sites], &text[sizes..]].concat());
    let refused = place.fem(&["diagnose", "one.toml", "--with", "measured.csv"]);
    assert_eq!(refused.status, 2);
    insta::assert_snapshot!("places_of_no_model", refused.err);
    // What nobody has measured of them is found.
    let level = "high = \"0 um\"\ntilt = \"0 um/m\"\n";
    let blank = format!(
        "[[place]]\nat = \"20 mm\"\n[[place]]\nat = \"260 mm\"\n{level}[[pallet]]\n[[pallet]]\n{level}[[pallet]]\n{level}\n"
    );
    place.write("level.toml", [&text[..sites], &blank, &text[sizes..]].concat());
    insta::assert_snapshot!("places_found", place.fem(&["diagnose", "level.toml", "--with", "measured.csv"]).out);
}

/// A force that every row states is no part of the fit, whatever the model says of it.
#[test]
fn a_fit_says_that_every_row_states_the_force() {
    let place = Place::new();
    let rough = model("fixture.toml").replace("force = \"4 kN\"", "force = \"4 +- 0.5 kN\"");
    place.write("fixture.toml", rough);
    let rows = (1..8).map(|i| format!("{},{},{}\n", 60 * i, 400 * i, i % 3)).collect::<String>();
    place.write("m.csv", format!("x [mm],clamp_force [N],height_error [um]\n{rows}"));
    let answer = place.fem(&["fit", "fixture.toml", "--with", "m.csv"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    assert_eq!(answer.out.matches("no row depends on it: a column states it").count(), 2, "{}", answer.out);
}

/// A machine gives way otherwise under each place, and is drawn under one.
#[test]
fn several_places_on_a_drawn_machine_are_refused() {
    let place = Place::new();
    let places = "[[place]]\nat = \"0 mm\"\n[[place]]\nat = \"260 mm\"\n";
    place.write("mill.toml", format!("{}\n{places}", model("portal-mill.toml")));
    let told = ("gives way otherwise under another place", "write a model for each place");
    place.is_refused(&["run", "mill.toml"], "two places", told);
}
