//! The ring as a user meets it: summary, files, bad input, and the least-squares circle.

use super::fem::{Mistake, Place, model};

#[test]
fn the_summary_of_the_ring() {
    let place = Place::new();
    place.write("ring.toml", model("ring.toml"));
    let answer = place.fem(&["run", "ring.toml"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    insta::assert_snapshot!(answer.out);
    insta::assert_snapshot!("effects_ring", place.fem(&["effects", "ring"]).out);
}

#[test]
fn a_profile_is_a_measurement_of_its_own_model() {
    let place = Place::new();
    for reference in ["least-squares-circle", "absolute"] {
        place.write("ring.toml", model("ring.toml").replace("least-squares-circle", reference));
        assert_eq!(place.fem(&["run", "ring.toml", "-o", "out"]).status, 0);
        let compared = place.fem(&["compare", "ring.toml", "--with", "out/profile.csv", "--json"]).out;
        let json: serde_json::Value = serde_json::from_str(&compared).unwrap();
        assert!(json["models"][0]["rms"].as_f64().unwrap() < 1e-9, "{compared}");
    }
}

/// Deviations (um) of the bore over angles of 10°, of two set-ups without jaw force.
fn measured(shift: impl Fn(f64, f64) -> f64) -> String {
    let mut text = String::from("run,angle [deg],jaw_force [kN],deviation [um],u [um]\n");
    for run in [1.0, 2.0] {
        for i in 0..36 {
            let angle = f64::from(10 * i);
            text.push_str(&format!("{run},{angle},0,{},0.1\n", shift(run, angle.to_radians())));
        }
    }
    text
}

#[test]
fn the_circle_of_each_set_up_does_not_count() {
    // Jaws without force: what is measured is each set-up's own circle, a wave of three lobes, and nothing
    // else.
    let text = model("ring.toml").split("[effects").next().unwrap().to_string();
    let place = Place::new();
    place.write("ring.toml", &text);
    let three = |angle: f64| (3.0 * angle).cos();
    place.write("m.csv", measured(|run, angle| 7.0 * run + 4.0 * angle.cos() - 3.0 * run * angle.sin() + three(angle)));
    let compare = |model: &str| -> serde_json::Value {
        serde_json::from_str(&place.fem(&["compare", model, "--with", "m.csv", "--json", "-o", "out"]).out).unwrap()
    };
    let seen = &compare("ring.toml")["models"][0];
    assert!((seen["rms"].as_f64().unwrap() - 0.5f64.sqrt()).abs() < 1e-9, "{seen}");
    // 72 rows less two times three: 72·0.5/0.1² over 66.
    assert!((seen["chi2_per_dof"].as_f64().unwrap() - 3600.0 / 66.0).abs() < 1e-6, "{seen}");
    let first = place.read("out/residuals.csv").lines().nth(1).unwrap().to_string();
    assert!(
        first.starts_with("1,0,0,") && (first.rsplit(',').next().unwrap().parse::<f64>().unwrap() - 1.0).abs() < 1e-9
    );
    place.write("absolute.toml", text.replace("\"least-squares-circle\"", "\"absolute\""));
    assert!(compare("absolute.toml")["models"][0]["rms"].as_f64().unwrap() > 5.0);
}

#[test]
fn phases_come_round() {
    // A crest at 100 deg is one at -80 deg.
    let text = model("ring.toml").split("[effects").next().unwrap().to_string();
    let place = Place::new();
    place.write("ring.toml", format!("{text}\n[effects.spindle-error]\namplitude = \"? um\"\nphase = \"? deg\"\n"));
    let wobble = |run: f64, angle: f64| 0.1 * (17.0 * angle + run).sin();
    place.write("m.csv", measured(|run, angle| 5.0 * (2.0 * (angle - 100f64.to_radians())).cos() + wobble(run, angle)));
    let fit = place.fem(&["fit", "ring.toml", "--with", "m.csv", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&fit.out).unwrap();
    let phase = &json["parameters"][1];
    assert!((phase["value"].as_f64().unwrap() + 80.0).abs() < 0.1, "{phase}");
    let end = |i: usize| phase["interval95"][i].as_f64().unwrap();
    assert!(end(0) < -80.0 && -80.0 < end(1) && end(1) - end(0) < 1.0, "{phase}");
}

/// (in the model, replaced by, part of the message, part of the remedy)
const CASES: &[Mistake] = &[
    ("inner_diameter", "iner_diameter", "`iner_diameter` is no key of `workpiece`", "did you mean `inner_diameter`?"),
    ("\"84 mm\"", "\"100 mm\"", "the bore is as wide as the ring", "below the outer diameter of 100 mm"),
    ("\"84 mm\"", "\"84 kg\"", "not a length", "write it in mm"),
    ("width = \"20 mm\"", "", "`width` is missing in `workpiece`", "add width"),
    ("jaws = 3", "jaws = 1", "`jaws` is 1", "whole number from 2 to 100"),
    ("jaws = 3", "jaws = 4", "`jaw-position` is known of three jaws", "remove the effect"),
    ("\"3 kN\" ", "\"-3 kN\" ", "`jaw_force` is -3000 N", "zero or more"),
    ("circumferential = 360", "circumferential = 20", "20 elements around are too few for 3 jaws", "at least 24"),
    ("radial = 6", "radial = 999", "elements are more than 40000", "360 around and 6 across"),
    ("order = 2", "order = 3", "`order` is 3", "whole number from 1 to 2"),
    (
        "\"least-squares-circle\" ",
        "\"least-square-circle\" ",
        "`reference` is",
        "did you mean \"least-squares-circle\"?",
    ),
    ("lobes = 2", "lobes = 1", "`lobes` is 1", "whole number from 2"),
    ("spindle_speed = \"400 rpm\"", "", "`centrifugal-unloading` needs the spindle speed", "remove the effect"),
    (
        "effects.jaw-position]\nerror_2 = \"0.6 deg\"\nerror_3 = \"-0.4 deg\"",
        "effects.jaw-imbalance]\ndifference = \"9 %\"",
        "`jaw-imbalance` is of four jaws or more",
        "remove the effect",
    ),
    ("force_per_depth = \"1 kN/mm\"", "", "`copying` needs the force of the cut", "remove the effect"),
    ("[effects.copying]\nstiffness", "[effects.cutting-heat]\ntemperature_rise", "`temperature_rise`", "K"),
    ("arc = \"24 +- 4 deg\"", "arc = \"24 +- 4 mm\"", "not an angle", "write it in deg"),
    ("jaws = 3", "grip = \"outer\"\njaws = 3", "`grip` is", "\"outside\""),
    (
        "\"least-squares-circle\" ",
        "\"absolute\"\ngauge = \"v-block\" ",
        "a bore does not lie in a V-block",
        "grip = \"inside\"",
    ),
    (
        "\"least-squares-circle\" ",
        "\"absolute\"\nblock_angle = \"60 deg\" ",
        "no V-block measures here",
        "gauge = \"v-block\"",
    ),
    ("[effects.copying]", "[effects.tool-wear]", "is an effect of `turning`, not of `ring`", "fem effects ring"),
];

#[test]
fn bad_input_is_told_with_its_remedy() {
    let good = model("ring.toml");
    let place = Place::new();
    place.refuses(("run", "ring.toml"), &good, CASES);
    assert!(!place.files().iter().any(|f| f.starts_with("out")));
}

#[test]
fn what_cannot_be_computed_is_told() {
    let place = Place::new();
    for (from, to, message) in [
        ("\"24 +- 4 deg\"", "\"130 deg\"", "jaws that press over 130.0 deg each overlap"),
        ("\"0.6 deg\"", "\"-80 deg\"", "cannot press in equilibrium"),
        ("\"84 mm\"", "\"99.5 mm\"", "no ring any more"),
    ] {
        place.write("ring.toml", model("ring.toml").replacen(from, to, 1));
        let answer = place.fem(&["run", "ring.toml"]);
        assert_eq!(answer.status, 1, "{}", answer.err);
        assert!(answer.err.split_whitespace().collect::<Vec<_>>().join(" ").contains(message), "{}", answer.err);
    }
}

/// A ring that is held by its bore is spread as it would be squeezed, and turned on its outside; what jaws throw outwards holds it
/// the more, and a V-block shows three waves twice.
#[test]
fn a_ring_is_held_by_its_bore() {
    let place = Place::new();
    let text = model("ring.toml").replace("jaws = 3", "grip = \"inside\"\njaws = 3");
    let text = text.replace("\"400 rpm\"", "\"4000 rpm\"").replacen(
        "[effects.jaw",
        "[tolerance]\nroundness = \"60 um\"\n[effects.jaw",
        1,
    );
    place.write(
        "arbor.toml",
        text.replacen(
            "reference = \"least-squares-circle\"",
            "reference = \"least-squares-circle\"\ngauge = \"v-block\"",
            1,
        ),
    );
    let answer = place.fem(&["run", "arbor.toml"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    insta::assert_snapshot!(answer.out);
    assert_eq!(place.fem(&["compare", "arbor.toml", "--with", "out/arbor/profile.csv"]).status, 0);
}

/// Four independent jaws, one pair tightened harder: the bore is an oval, and the weaker pair lets go first.
#[test]
fn pairs_of_independent_jaws_differ() {
    let place = Place::new();
    let (position, imbalance) =
        ("jaw-position]\nerror_2 = \"0.6 deg\"\nerror_3 = \"-0.4 deg\"", "jaw-imbalance]\ndifference = \"20 %\"");
    let text = model("ring.toml").replace("jaws = 3", "jaws = 4").replace("three-jaw", "four-jaw");
    let text = text.replace(position, imbalance);
    place.write("four.toml", &text);
    let answer = place.fem(&["run", "four.toml"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    insta::assert_snapshot!(answer.out);
    place.write("four.toml", text.replace("\"400 rpm\"", "\"2100 rpm\""));
    let answer = place.fem(&["run", "four.toml"]);
    assert!(answer.err.contains("at 2100 rpm the weaker jaws no longer press: above 2026 rpm"), "{}", answer.err);
    place.write("four.toml", text.replace("\"20 %\"", "\"220 %\""));
    assert!(place.fem(&["run", "four.toml"]).err.contains("`difference` is"));
}

/// (in the model, replaced by, part of the message, part of the remedy)
const OF_MEMBRANES: &[Mistake] = &[
    (
        "jaws = 6",
        "jaws = 6\njaw_force = \"1 kN\"",
        "follows from [chuck.membrane], and stands here too",
        "leave `jaw_force` out",
    ),
    ("jaw_circle = \"140 mm\"", "jaw_circle = \"260 mm\"", "the jaws stand on 260 mm", "within the clamped edge"),
    ("root = \"50 mm\"", "root = \"80 mm\"", "6 jaws of that width overlap", "at most 73.3"),
    ("diameter = \"40 mm\"", "diameter = \"150 mm\"", "the push acts where the jaws stand", "within the circle"),
    ("interference = \"100 +- 10 um\" ", "", "`interference` is missing", "add interference"),
    (
        "[effects.centrifugal",
        "[effects.jaw-contact-arc]\narc = \"10 deg\"\n[effects.centrifugal",
        "so does `pad` in [chuck.membrane]",
        "remove the effect",
    ),
];

/// Jaws on a plate that springs back press with what the interference asks of plate and ring.
#[test]
fn a_membrane_holds_a_ring() {
    let place = Place::new();
    let good = model("membrane.toml");
    place.refuses(("run", "membrane.toml"), &good, OF_MEMBRANES);
    place.write("membrane.toml", &good);
    let answer = place.fem(&["run", "membrane.toml"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    insta::assert_snapshot!(answer.out);
    place.write("membrane.toml", good.replace("\"15 kN\"", "\"5 kN\""));
    let answer = place.fem(&["run", "membrane.toml"]);
    assert!(answer.err.contains("it does not go in"), "{}", answer.err);
    place.write("membrane.toml", good.replace("thickness = \"10 mm\"", "thickness = \"25 mm\""));
    let answer = place.fem(&["run", "membrane.toml"]);
    assert!(answer.err.contains("it shears, which is left out"), "{}", answer.err);
}

#[test]
fn a_ring_that_is_let_go_is_warned_of() {
    let place = Place::new();
    place.write("ring.toml", model("ring.toml").replace("\"400 rpm\"", "\"4000 rpm\""));
    let answer = place.fem(&["run", "ring.toml"]);
    assert_eq!(answer.status, 0);
    assert!(answer.err.contains("the ring is let go"), "{}", answer.err);
}

#[test]
fn a_column_that_no_chuck_can_give_is_refused() {
    let place = Place::new();
    place.write("ring.toml", model("ring.toml"));
    place.write("m.csv", "angle [deg],jaw_force [N],deviation [um]\n0,-3,1\n");
    let answer = place.fem(&["compare", "ring.toml", "--with", "m.csv"]);
    assert_eq!(answer.status, 2);
    assert!(answer.err.contains("`jaw_force` is below zero"), "{}", answer.err);
}

/// A boring bar on a slide, a spindle in its bearing, for a ring whose blank is oval.
const MACHINE: &str = r#"
[structure]
material = "steel"
clamped = ["bed"]
[structure.nodes]
bed = ["300 mm", "-200 mm"]
nose = ["0 mm", "0 mm"]
slide = ["300 mm", "0 mm"]
tip = ["60 mm", "0 mm"]
[structure.bearing]
at = "nose"
along = "y"
stiffness = "200 N/um"
[structure.thrust]
at = "nose"
along = "x"
stiffness = "300 N/um"
[structure.square]
at = "nose"
along = "turning"
stiffness = "5000 kN*m/rad"
[structure.column]
between = ["bed", "slide"]
width = "200 mm"
height = "200 mm"
[structure.bar]
between = ["slide", "tip"]
diameter = "40 mm"
[structure.ports]
tool = "tip"
spindle = "nose"
"#;

#[test]
fn a_machine_may_be_drawn_around_a_ring() {
    let place = Place::new();
    let ring = model("ring.toml").split("[effects").next().unwrap().to_string();
    let ring = ring.replace("circumferential = 360\nradial = 6", "circumferential = 72\nradial = 2");
    let good = format!("{ring}{MACHINE}");
    place.write("ring.toml", &good);
    let answer = place.fem(&["run", "ring.toml", "-o", "out"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    let told = answer.out.lines().find(|line| line.trim_start().starts_with("structure")).unwrap();
    insta::assert_snapshot!("structure_of_a_ring", told);
    // The drawing and a tool of the stiffness that is told are one.
    let summary: serde_json::Value = serde_json::from_str(&place.read("out/summary.json")).unwrap();
    let stiffness = summary["findings"]["structure"]["stiffness"].as_f64().unwrap();
    place.write("plain.toml", format!("{ring}\n[effects.copying]\nstiffness = \"{stiffness} N/um\"\n"));
    place.fem(&["run", "plain.toml", "-o", "plain"]);
    let [drawn, plain] = ["out", "plain"].map(|folder| place.column(&format!("{folder}/profile.csv"), "deviation"));
    assert!(drawn.iter().zip(&plain).all(|(a, b)| (a - b).abs() < 1e-9), "{drawn:?}");
    assert!(plain.iter().any(|own| own.abs() > 1.0), "{plain:?}");
    let mistakes = [
        ("force_per_depth = \"1 kN/mm\"", "", "the force of the cut is not said", "force_per_depth = \"1 kN/mm\""),
        ("tool = \"tip\"", "tool = \"bar\"", "members do not say where on them it stands", "name a node"),
        ("tool = \"tip\"\n", "", "`tool` is missing", "add tool = \"NODE\""),
        (
            "stiffness = \"200 N/um\"",
            "stiffness = \"200 N/um\"\nc = \"0.2 um/N^n\"\nn = 0.5\npreload = \"1 kN\"",
            "`structure.bearing` is no spring, and how hard the cut presses on it is not said",
            "add radial_force =",
        ),
        (
            "force_per_depth = \"1 kN/mm\"",
            "force_per_depth = \"1 kN/mm\"\nradial_force = \"200 N\"",
            "joints of a [structure] that are no springs, and there are none",
            "leave it out",
        ),
    ];
    place.refuses(("run", "ring.toml"), &good, &mistakes);
    // A contact in the bearing, pressed by the mean force: softer than the bearing alone, and told where.
    let contact = "stiffness = \"200 N/um\"\nc = \"0.2 um/N^n\"\nn = 0.5\npreload = \"1 kN\"";
    let seated = good
        .replace("stiffness = \"200 N/um\"", contact)
        .replace("force_per_depth = \"1 kN/mm\"", "force_per_depth = \"1 kN/mm\"\nradial_force = \"200 N\"");
    place.write("seated.toml", &seated);
    let answer = place.fem(&["run", "seated.toml", "-o", "seated"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    let told = answer.out.lines().find(|line| line.trim_start().starts_with("structure")).unwrap();
    insta::assert_snapshot!("contact_around_a_ring", told);
    // Values that are sought are asked for, and mistakes told once.
    for (known, sought) in [("0.2 um/N^n", "? um/N^n"), ("= \"200 N\"", "= \"? N\""), ("200 N/um", "? N/um")] {
        place.write("sought.toml", seated.replace(known, sought));
        let answer = place.fem(&["run", "sought.toml"]);
        assert!(answer.status != 0 && answer.err.contains("is unknown (`?`)"), "{}", answer.err);
    }
    place.write("none.toml", seated.replace("= \"200 N\"", "= \"0 N\""));
    let answer = place.fem(&["run", "none.toml"]);
    assert_eq!((answer.status, answer.err.matches("radial_force").count()), (2, 2), "{}", answer.err);
}

/// Short jaws squeeze a wide ring where they press: sections differ, and a file says with `z` which of them it has.
#[test]
fn a_wide_ring_in_short_jaws_differs_along_it() {
    let place = Place::new();
    let wide = model("wide-ring.toml");
    place.write("ring.toml", &wide);
    let answer = place.fem(&["run", "ring.toml", "-o", "out"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    insta::assert_snapshot!(answer.out);
    // The jaws held along all of it leave a ring that is the same everywhere, and that a plane one agrees with as far as its
    // sections hinder each other little.
    let all = wide.replace("jaw_width = \"15 mm\"", "jaw_width = \"60 mm\"");
    let plane = wide.replace("jaw_width = \"15 mm\"", "").replace("jaw_from = \"0 mm\"", "");
    let form = |text: &str| {
        place.write("other.toml", text);
        let answer = place.fem(&["run", "other.toml", "-o", "other"]);
        assert_eq!(answer.status, 0, "{}", answer.err);
        place.column("other/profile.csv", "deviation [um]").into_iter().fold(0.0, f64::max)
    };
    assert!((form(&all) / form(&plane) - 1.0).abs() < 0.05, "{} {}", form(&all), form(&plane));
    let rows: String = [0, 30, 60].map(|angle| format!("{angle},55,0.0\n")).concat();
    place.write("m.csv", format!("angle [deg],z [mm],deviation [um]\n{rows}"));
    assert_eq!(place.fem(&["compare", "ring.toml", "--with", "m.csv"]).status, 0);
    place.write("m.csv", "angle [deg],z [mm],deviation [um]\n0,75,0.0\n");
    let told = ("z = 75 mm is not on the ring, which is 60 mm wide", "");
    place.is_refused(&["compare", "ring.toml", "--with", "m.csv"], "beyond the ring", told);
    place.refuses(
        ("run", "ring.toml"),
        &wide,
        &[
            (
                "jaw_width = \"15 mm\"",
                "jaw_width = \"75 mm\"",
                "press up to 75 mm, and the ring is 60 mm wide",
                "face at the chuck",
            ),
            ("jaw_width = \"15 mm\"", "", "not said over which length", "add jaw_width"),
            ("at = \"7.5 mm\"", "at = \"70 mm\"", "the section lies at 70 mm", "face at the chuck"),
        ],
    );
}
