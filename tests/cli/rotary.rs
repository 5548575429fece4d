//! The rotary axis as a user meets it: summary, files, bad input, tables of angles, and a diagnosis of a worm.

use serde_json::Value as Json;

use super::fem::{Mistake, Place, model};

#[test]
fn the_summary_of_the_axis() {
    let place = Place::new();
    place.write("rotary.toml", model("rotary.toml"));
    let answer = place.fem(&["run", "rotary.toml"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    insta::assert_snapshot!(answer.out);
    insta::assert_snapshot!("effects_rotary", place.fem(&["effects", "rotary"]).out);
}

#[test]
fn a_profile_is_a_measurement_of_its_own_model() {
    let place = Place::new();
    let pulled = model("rotary.toml").replace("runs = 5", "runs = 2\ntorque = \"30 N*m\"");
    for (text, columns) in [
        (model("rotary.toml"), "run,angle [deg],direction,time [min],deviation [arcsec]\n1,"),
        (pulled, "run,angle [deg],direction,time [min],torque [N*m],deviation [arcsec]\n1,"),
    ] {
        place.write("rotary.toml", text);
        assert_eq!(place.fem(&["run", "rotary.toml", "-o", "out", "--force"]).status, 0);
        assert!(place.read("out/profile.csv").starts_with(columns), "{}", place.read("out/profile.csv"));
        let compared = place.fem(&["compare", "rotary.toml", "--with", "out/profile.csv", "--json"]).out;
        let json: Json = serde_json::from_str(&compared).unwrap();
        assert!(json["models"][0]["rms"].as_f64().unwrap() < 1e-9, "{compared}");
    }
}

/// (play arcsec, friction N·m, which rules) on 4 N·m/arcsec
const CLEARANCES: &[(f64, f64, &str)] =
    &[(0.0, 0.0, "none"), (20.0, 10.0, "kinematic"), (1.0, 20.0, "elastic"), (5.0, 10.0, "both")];

#[test]
fn the_clearance_that_rules_is_told() {
    let text = model("rotary.toml").split("[effects").next().unwrap().to_string();
    let place = Place::new();
    for (gap, friction, rules) in CLEARANCES {
        let effects = format!(
            "[effects.backlash]\ngap = \"{gap} arcsec\"\n[effects.elastic-wind-up]\nfriction = \"{friction} N*m\"\n"
        );
        place.write("rotary.toml", format!("{text}{effects}"));
        let json: Json = serde_json::from_str(&place.fem(&["run", "rotary.toml", "--json"]).out).unwrap();
        assert_eq!(json["findings"]["lost_motion"]["rules"], *rules, "{gap} arcsec, {friction} N*m");
    }
}

#[test]
fn targets_on_one_part_of_the_worm_are_warned_of() {
    let place = Place::new();
    // Every 30 degrees, which are ten turns of the worm.
    let even = model("rotary.toml").replace("\"staggered\"", "\"even\"").replace("\"220 deg\"", "\"210 deg\"");
    let even = even.replace("positions = 12", "positions = 8").replace("\"-110 deg\"", "\"-90 deg\"");
    place.write("rotary.toml", even);
    let answer = place.fem(&["run", "rotary.toml"]);
    assert!(answer.err.contains("all targets stand apart by multiples of a turn of the worm"), "{}", answer.err);
    // There its error cannot be told from a shift, and the plan says what to measure.
    place.write("rotary.toml", place.read("rotary.toml").split("[effects").next().unwrap());
    let plan = place.fem(&["plan", "rotary.toml", "--noise", "0.5 arcsec", "--json"]).out;
    assert!(plan.contains("period of the gearing"), "{plan}");
}

/// (in the model, replaced by, part of the message, part of the remedy)
const CASES: &[Mistake] = &[
    ("range = \"220 deg\"", "rnage = \"220 deg\"", "`rnage` is no key of `axis`", "did you mean `range`?"),
    ("\"220 deg\"", "\"-220 deg\"", "`range` is -220 deg", "above zero"),
    ("\"220 deg\"", "\"220 mm\"", "not an angle", "write it in deg"),
    ("teeth = 120", "", "the worm wheel has no teeth", "add teeth = 180"),
    ("type = \"worm\"", "type = \"gears\"", "a drive of the type `gears` has none", "type = \"worm\""),
    ("teeth = 120", "teeth = 120\nstages = [{ driving = 0, driven = 5 }]", "`driving` is 0", "whole number from 1"),
    ("\"4 +- 1 N*m/arcsec\"", "\"4 N*m\"", "not a torsional stiffness", "write it in N*m/arcsec"),
    ("at = \"motor\"", "at = \"motor\"\nloop = \"closed\"", "leaves the drive outside", "leave `loop` out"),
    ("positions = 12", "positions = 0", "`positions` is 0", "whole number from 1"),
    ("\"horizontal\"", "\"vertical\"", "`unbalance` needs an axis across gravity", "remove the effect"),
    (
        "at = \"motor\"",
        "at = \"table\"\nloop = \"closed\"",
        "`worm-error` needs a drive whose errors show",
        "remove the effect",
    ),
    (
        "[effects.backlash]\ngap = \"14 +- 4 arcsec\"",
        "[effects.scale-eccentricity]\neccentricity = \"3 um\"\nphase = \"0 deg\"",
        "`scale-eccentricity` needs a scale on the table",
        "remove the effect",
    ),
    (
        "[effects.backlash]\ngap = \"14 +- 4 arcsec\"",
        "[effects.compliance]\nstiffness = \"3 N*m/arcsec\"",
        "`compliance` needs a drive that is taken as rigid",
        "remove the effect",
    ),
];

#[test]
fn bad_input_is_told_with_its_remedy() {
    let good = model("rotary.toml");
    let place = Place::new();
    place.refuses(("run", "rotary.toml"), &good, CASES);
    assert!(!place.files().iter().any(|f| f.starts_with("out")));
}

/// A full turn closes: a ratio that is off all along is refused there.
#[test]
fn a_ratio_is_off_on_a_part_of_a_turn_alone() {
    let place = Place::new();
    let with = |range: &str| {
        format!(
            "process = \"rotary\"\naxis = {{ range = \"{range}\" }}\ndrive = {{ type = \"direct\" }}\n\
             [effects.ratio-error]\nslope = \"0.2 arcsec/deg\"\n"
        )
    };
    place.write("rotary.toml", with("300 deg"));
    assert_eq!(place.fem(&["run", "rotary.toml"]).status, 0);
    place.write("rotary.toml", with("360 deg"));
    let answer = place.fem(&["run", "rotary.toml"]);
    assert!(answer.status == 2 && answer.err.contains("a full turn closes"), "{}", answer.err);
}

/// A whole turn each 30 degrees, twice: a wheel that is off by 20 arcsec, and 12 arcsec lost.
fn turn() -> String {
    let mut text = String::from("run,angle [deg],direction,deviation [arcsec]\n");
    for run in [1, 2] {
        for i in 0..=12 {
            let off = 20.0 * f64::from(30 * i).to_radians().sin();
            let by = if run == 1 { -0.2 } else { 0.2 };
            text += &format!("{run},{},+,{:.3}\n{run},{},-,{:.3}\n", 30 * i, off + by, 30 * i, off + 12.0 + by);
        }
    }
    text
}

#[test]
fn a_table_of_angles_is_in_degrees_and_arc_seconds() {
    let place = Place::new();
    let text = "process = \"rotary\"\naxis = { range = \"360 deg\" }\n\
                drive = { type = \"worm\", teeth = 90, pitch_radius = \"100 mm\" }\n\
                [effects.wheel-eccentricity]\neccentricity = \"? um\"\nphase = \"? deg\"\n[effects.backlash]\ngap = \"? arcsec\"\n";
    place.write("rotary.toml", text);
    place.write("measured.csv", turn());
    let ask = |control: &str| {
        place.fem(&[
            "compensate",
            "rotary.toml",
            "--with",
            "measured.csv",
            "-o",
            "out",
            "--force",
            "--for",
            control,
            "--axis",
            "C",
        ])
    };
    let page = ask("siemens-eec");
    assert_eq!(page.status, 0, "{}", page.err);
    for told in [
        "backlash value   12.0000 arcsec",
        "accuracy A on any 90 deg",
        "in deg and arcsec",
        "MD32450 BACKLASH to 0.003333 deg",
        "the table goes round a whole turn",
    ] {
        assert!(page.out.contains(told), "{told}: {}", page.out);
    }
    let file = place.read("out/siemens-eec.ini");
    // 20 arcsec too far at 90 degrees, where a positive value moves the axis back.
    assert!(
        file.contains("$AA_ENC_COMP[0,3,C]=0.005556\n") && file.contains("$AA_ENC_COMP_IS_MODULO[0,C]=1\n"),
        "{file}"
    );
    assert!(
        place.read("out/points.csv").starts_with("angle [deg],added [arcsec],increment [arcsec],backlash [arcsec]\n0,")
    );
    let json: Json = serde_json::from_str(&place.read("out/compensation.json")).unwrap();
    assert_eq!((&json["unit"], &json["position_unit"]), (&"arcsec".into(), &"deg".into()));
    assert!((json["reversal"]["backlash_value"].as_f64().unwrap() - 12.0).abs() < 1e-6);
    assert!(json["tolerance"]["per_angle"].is_number() && json["tolerance"]["per_length"].is_null());
    // LinuxCNC counts an angular joint in degrees: it goes 20 arcsec too far at 90.
    assert_eq!(ask("linuxcnc").status, 0);
    let line = place.read("out/linuxcnc.comp").lines().nth(3).unwrap().to_string();
    assert_eq!(line, "90.000000 90.005556 90.008889");
    for control in ["fanuc", "heidenhain", "mitsubishi", "mach4", "beckhoff"] {
        let answer = ask(control);
        assert!(answer.status == 2 && answer.err.contains("axes that travel along a line alone"), "{}", answer.err);
    }
}

#[test]
fn a_worm_is_found_in_the_turn_that_it_has() {
    let place = Place::new();
    place.write(
        "told.toml",
        "process = \"rotary\"\naxis = { range = \"20 deg\" }\ndrive = { type = \"worm\", teeth = 180 }\n",
    );
    let mut text = String::from("run,angle [deg],direction,deviation [arcsec],u [arcsec]\n");
    for run in 1..=3 {
        for i in 0..40 {
            let angle = 0.47 * f64::from(i);
            // A worm of 180 teeth turns once in 2 degrees; the rest scatters evenly over a second of arc.
            let noise = f64::from((37 * i + 101 * run) % 21 - 10) / 20.0;
            let off = 7.0 * (180.0 * angle.to_radians() + 0.6).sin() + noise;
            text += &format!("{run},{angle:.3},+,{off:.3},0.3\n");
        }
    }
    place.write("measured.csv", text);
    let found = place.fem(&["diagnose", "told.toml", "--with", "measured.csv", "--json"]).out;
    let json: Json = serde_json::from_str(&found).unwrap();
    assert_eq!(json["sets"][0]["effects"], serde_json::json!(["worm-error"]), "{found}");
}
