//! `fem discover`: laws that are in no catalogue, told, held back, or not there.

use serde_json::Value as Json;

use super::fem::{Place, model, words};

/// Scatter of variance one, the same on every machine.
struct Scatter(u64);

impl Scatter {
    fn even(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as f64 / f64::from(1_u32 << 31)
    }

    fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.even()).sum::<f64>() - 6.0
    }
}

/// An axis without any error of its own.
fn ideal() -> String {
    model("axis.toml").split("[effects").next().unwrap_or_default().to_string()
}

/// Runs over eleven places to and fro, measured to 0.5 um; the table is loaded anew for each, and the room is what it is.
fn measured(runs: usize, seed: u64, law: impl Fn(f64, f64, f64) -> f64) -> String {
    let mut scatter = Scatter(seed);
    let mut text = "run,direction,position [mm],load [kg],room [degC],deviation [um],u [um]\n".to_string();
    for run in 1..=runs {
        let (load, room) = (5.0 + 45.0 * scatter.even(), 18.0 + 8.0 * scatter.even());
        for (direction, back) in [("+", false), ("-", true)] {
            for k in 0..11 {
                let place = 60 * if back { 10 - k } else { k };
                let deviation = law(f64::from(place), load, room) + 0.5 * scatter.normal();
                text += &format!("{run},{direction},{place},{load:.2},{room:.2},{deviation:.4},0.5\n");
            }
        }
    }
    text
}

/// The table sags under its load, most in the middle of the stroke.
fn sag(place: f64, load: f64, _room: f64) -> f64 {
    0.004 * load * load * (std::f64::consts::PI * place / 600.0).sin()
}

fn discovered(place: &Place, more: &[&str]) -> Json {
    let arguments = [&["discover", "axis.toml", "--with", "measured.csv", "--json"], more].concat();
    let answer = place.fem(&arguments);
    serde_json::from_str(&answer.out).unwrap_or_else(|error| panic!("{error}: {}\n{}", answer.out, answer.err))
}

#[test]
fn a_law_is_found_and_predicts_rows_that_were_never_shown() {
    let place = Place::new();
    place.write("axis.toml", ideal());
    place.write("measured.csv", measured(12, 7, sag));
    place.write("unseen.csv", measured(12, 8, sag));
    let found = discovered(&place, &["--add-to", "better.toml"]);
    assert_eq!(found["law"]["variables"], serde_json::json!(["load", "position"]), "{found:#}");
    assert_eq!(found["missing"], serde_json::json!([]));
    let left_out = &found["law"]["left_out"];
    assert!(left_out["after"].as_f64() < Some(1.3) && left_out["before"].as_f64() > Some(3.0), "{found:#}");
    let compared = place.fem(&["compare", "axis.toml", "better.toml", "--with", "unseen.csv", "--json"]);
    let compared: Json = serde_json::from_str(&compared.out).unwrap();
    let chi2 = |i: usize| compared["models"][i]["chi2_per_dof"].as_f64().unwrap();
    assert!(chi2(0) > 10.0 && chi2(1) < 1.4, "{compared:#}");
    // The command that it prints is one.
    let command = found["command"].as_str().unwrap().to_string();
    let all = words(&command);
    let arguments: Vec<&str> = all.iter().skip(1).map(String::as_str).collect();
    assert_eq!(place.fem(&arguments).status, 0, "{command}");
}

#[test]
fn where_nothing_is_left_no_law_is_told() {
    let place = Place::new();
    place.write("axis.toml", ideal());
    for seed in 1..4 {
        place.write("measured.csv", measured(8, seed, |_, _, _| 0.0));
        let found = discovered(&place, &[]);
        assert_eq!((&found["verdict"], &found["law"]), (&"adequate".into(), &Json::Null), "{found:#}");
    }
}

#[test]
fn a_law_of_few_settings_is_held_back() {
    let place = Place::new();
    place.write("axis.toml", ideal());
    // Five runs, each off by what it is off by.
    let zeros = |_: f64, load: f64, room: f64| 5.0 * (1e4 * (load + room)).sin();
    place.write("measured.csv", measured(5, 3, zeros));
    let found = discovered(&place, &["--add-to", "better.toml"]);
    assert_eq!(found["law"], Json::Null, "{found:#}");
    assert!(found["held_back"].is_string() || found["law_held_back"].is_null(), "{found:#}");
    assert!(!place.files().contains(&"better.toml".to_string()), "nothing is written where no law is told");
}

#[test]
fn an_answer_for_people() {
    let place = Place::new();
    place.write("axis.toml", ideal());
    place.write("measured.csv", measured(12, 7, sag));
    let answer = place.fem(&["discover", "axis.toml", "--with", "measured.csv"]);
    insta::assert_snapshot!(answer.out);
}

/// What a diagnosis says is missing, by kind and name.
fn diagnosed(place: &Place, more: &[&str]) -> (String, Vec<[String; 2]>) {
    let arguments = [&["diagnose", "axis.toml", "--with", "measured.csv", "--json"], more].concat();
    let answer = place.fem(&arguments);
    let told: Json = serde_json::from_str(&answer.out).unwrap_or_else(|error| panic!("{error}: {}", answer.err));
    let word = |json: &Json| json.as_str().unwrap_or_default().to_string();
    let missing = told["missing"].as_array().into_iter().flatten();
    (word(&told["verdict"]), missing.map(|own| [word(&own["kind"]), word(&own["effect"])]).collect())
}

#[test]
fn a_diagnosis_tells_a_law_and_blames_no_instrument() {
    let place = Place::new();
    place.write("axis.toml", ideal());
    place.write("measured.csv", measured(12, 7, sag));
    place.write("unseen.csv", measured(12, 8, sag));
    let (verdict, missing) = diagnosed(&place, &["--add-to", "better.toml"]);
    assert_eq!((verdict.as_str(), missing), ("unexplained", vec![["law".to_string(), "law".to_string()]]));
    let compared = place.fem(&["compare", "better.toml", "--with", "unseen.csv", "--json"]);
    let compared: Json = serde_json::from_str(&compared.out).unwrap();
    assert!(compared["models"][0]["chi2_per_dof"].as_f64() < Some(1.4), "{compared:#}");
    insta::assert_snapshot!(place.fem(&["diagnose", "axis.toml", "--with", "measured.csv"]).out);
}

#[test]
fn zeros_of_runs_are_no_law() {
    let place = Place::new();
    place.write("axis.toml", ideal());
    for seed in 3..5 {
        let zeros = |_: f64, load: f64, room: f64| 2.0 * (1e4 * (load + room)).sin();
        place.write("measured.csv", measured(8, seed, zeros));
        let (_, missing) = diagnosed(&place, &[]);
        assert!(missing.iter().any(|[_, effect]| effect == "zero-shift"), "{missing:?}");
        assert!(missing.iter().all(|[kind, _]| kind != "law"), "{missing:?}");
    }
}

/// A file of laws that somebody has in mind.
const LAWS: &str = r#"
[sag]
about = "the table sags under its load"
formula = "a*load^n*sin(pi*position/span)"
a = "? um"
n = "1 to 3"
span = "500 to 700 mm"

[shrinkage]
formula = "a*humidity"
a = "? um"

[of-the-room]
formula = "a*(room - t0)"
a = "? um/K"
t0 = "20 degC"
"#;

#[test]
fn a_law_of_ones_own_is_told_under_its_name() {
    let place = Place::new();
    place.write("axis.toml", ideal());
    place.write("measured.csv", measured(12, 7, sag));
    place.write("laws.toml", LAWS.replace("load^n", "(load/l0)^n").replace("n = \"1", "l0 = \"50 kg\"\nn = \"1"));
    let found = discovered(&place, &["--candidates", "laws.toml", "--add-to", "better.toml"]);
    assert_eq!(found["law"]["candidate"], "sag", "{found:#}");
    let n = found["law"]["parameters"].as_array().into_iter().flatten();
    let exponent =
        |own: &Json| own["parameter"] == "effects.sag.n" && (own["value"].as_f64().unwrap() - 2.0).abs() < 0.1;
    assert!(n.into_iter().any(exponent), "{found:#}");
    let tried = found["tried"].as_array().unwrap();
    let why = tried[1]["left_out_because"].as_str().unwrap_or_default();
    assert!(why.contains("`humidity` is neither a coordinate"), "{found:#}");
    assert!(tried[2]["chi2_per_dof"].as_f64() > Some(10.0), "{found:#}");
    let (_, missing) = diagnosed(&place, &["--candidates", "laws.toml"]);
    assert_eq!(missing, vec![["law".to_string(), "sag".to_string()]]);
}

#[test]
fn a_law_of_ones_own_beyond_its_range_is_none() {
    let place = Place::new();
    place.write("axis.toml", ideal());
    place.write("measured.csv", measured(12, 7, sag));
    let law = "formula = \"a*(load/l0)^n*sin(pi*position/span)\"\na = \"? um\"\nl0 = \"50 kg\"\nspan = \"600 mm\"\n";
    place.write("laws.toml", format!("[sag]\n{law}n = \"0.2 to 1.5\"\n"));
    let found = discovered(&place, &["--candidates", "laws.toml"]);
    let why = found["tried"][0]["left_out_because"].as_str().unwrap_or_default();
    assert!(why.contains("beyond 0.2 to 1.5"), "{found:#}");
    assert_eq!(found["law"]["candidate"], Json::Null);
}

#[test]
fn a_file_of_laws_that_is_wrong_is_told_with_its_places() {
    let place = Place::new();
    place.write("axis.toml", ideal());
    place.write("measured.csv", measured(4, 7, sag));
    for (laws, wanted) in [
        ("[a]\nformula = \"b*load\"\nb = \"3 to 1 um/kg\"\n", "the range \"3 to 1 um/kg\" has no extent"),
        ("[a]\nb = \"? um\"\n", "a candidate is a formula"),
        ("[a]\nformula = 3\n", "expected a text"),
        ("a = 3\n", "`a` is no table"),
        ("[a\n", "unclosed table"),
    ] {
        place.write("laws.toml", laws);
        let answer = place.fem(&["discover", "axis.toml", "--with", "measured.csv", "--candidates", "laws.toml"]);
        assert!(
            answer.status != 0 && answer.err.contains(wanted) && answer.err.contains("laws.toml"),
            "{}",
            answer.err
        );
    }
}

#[test]
fn zeros_that_follow_a_column_are_described() {
    let place = Place::new();
    place.write("axis.toml", ideal());
    // Three pallets that are changed between runs, in no order; what each is off by no law of three levels tells.
    let mut text = "run,direction,position [mm],pallet,deviation [um],u [um]\n".to_string();
    let mut scatter = Scatter(5);
    for run in 1..=12 {
        let pallet = [2, 1, 3, 3, 1, 2, 1, 3, 2, 2, 3, 1][run - 1];
        for k in 0..11 {
            let deviation = [4.0, -3.0, 1.0][pallet - 1] + 0.5 * scatter.normal();
            text += &format!("{run},+,{},{pallet},{deviation:.4},0.5\n", 60 * k);
        }
    }
    place.write("measured.csv", text);
    let answer = place.fem(&["diagnose", "axis.toml", "--with", "measured.csv", "--json"]);
    let told: Json = serde_json::from_str(&answer.out).unwrap();
    let blamed = told["missing"].as_array().into_iter().flatten().filter(|own| own["kind"] == "measurement").count();
    assert!(blamed == 0 && told["verdict"] != "missing-effect", "{told:#}");
}

/// A table whose worm has three lobes a turn, seen over a few teeth of its wheel.
fn lobes(seed: u64, law: impl Fn(f64) -> f64) -> (String, String) {
    let model = "title = \"Worm of 180 teeth\"\nprocess = \"rotary\"\n[axis]\nrange = \"13 deg\"\n\
                 [drive]\ntype = \"worm\"\nteeth = 180\n[test]\npositions = 2\n";
    let mut scatter = Scatter(seed);
    let mut text = "angle [deg],direction,deviation [arcsec],u [arcsec]\n".to_string();
    for k in 0..150 {
        let angle = 0.05 + 0.0857 * f64::from(k) + 0.01 * scatter.even();
        text += &format!("{angle:.5},+,{:.4},0.3\n", law(angle.to_radians()) + 0.3 * scatter.normal());
    }
    (model.into(), text)
}

/// A wave of what the model states, a part of the pitch of its wheel, is told as one: it neither rings nor fades.
#[test]
fn a_wave_over_a_piece_of_a_wheel_is_a_wave() {
    let place = Place::new();
    let (model, measured) = lobes(5, |angle| 3.0 * (3.0 * 180.0 * angle + 0.4).sin());
    place.write("axis.toml", model);
    place.write("measured.csv", measured);
    let found = discovered(&place, &[]);
    let formula = found["law"]["formula"].as_str().unwrap_or_default();
    assert!(formula.contains("sin(2*pi*angle/a_p + phi)") && !formula.contains("exp"), "{found:#}");
    // The pitch is 2 deg.
    assert!(found["command"].to_string().contains("'a_p=0.6666667 deg'"), "{found:#}");
}

/// A wave of any other period neither rings nor fades either.
#[test]
fn a_wave_that_keeps_its_size_does_not_ring() {
    let place = Place::new();
    let (model, measured) = lobes(6, |angle| 3.0 * (angle.to_degrees() * 3.7 + 0.4).sin());
    place.write("axis.toml", model);
    place.write("measured.csv", measured);
    let found = discovered(&place, &[]);
    let formula = found["law"]["formula"].as_str().unwrap_or_default();
    assert!(formula.contains("sin(2*pi*angle/a_p + phi)") && !formula.contains("exp"), "{found:#}");
}
