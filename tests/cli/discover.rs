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
    for seed in 3..6 {
        let zeros = |_: f64, load: f64, room: f64| 2.0 * (1e4 * (load + room)).sin();
        place.write("measured.csv", measured(8, seed, zeros));
        let (_, missing) = diagnosed(&place, &[]);
        assert!(missing.iter().any(|[_, effect]| effect == "zero-shift"), "{missing:?}");
        assert!(missing.iter().all(|[kind, _]| kind != "law"), "{missing:?}");
    }
}
