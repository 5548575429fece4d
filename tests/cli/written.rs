//! Effects that users write.

use super::fem::{Place, model};

const RIPPLE: &str = "\n[effects.ripple]\nabout = \"the leadscrew is drunken\"\nformula = \"a*sin(2*pi*x/pitch)\"\na = \"3 um\"\npitch = \"120 mm\"\n";

/// (in the effect, replaced by, part of the message)
const MISTAKES: &[(&str, &str, &str)] = &[
    ("2*pi*x/pitch", "2*pi*x/pich", "`pich` is neither a coordinate of turning nor a parameter"),
    ("2*pi*x/pitch", "2*pi*x", "`sin` of a quantity in m"),
    ("sin(2*pi*x/pitch)", "sin(2*pi*x/pitch", "a parenthesis is not closed"),
    ("a*sin(2*pi*x/pitch)", "sin(2*pi*x/pitch)", "the formula gives a quantity in 1"),
    ("a*sin(2*pi*x/pitch)", "a*x/pitch + pitch/x", "a quantity in m meets one in 1"),
    ("a*sin(2*pi*x/pitch)", "a*x/pitch part", "`part` stands where an operator should"),
    ("a*sin(2*pi*x/pitch)", "a*2", "`pitch` does not occur in the formula"),
    ("pitch = ", "part = ", "`part` is a coordinate of turning"),
    ("a = \"3 um\"", "a = \"3 umm\"", "`umm`"),
    ("formula = \"a*sin(2*pi*x/pitch)\"\n", "", "`ripple` is no effect known here"),
];

#[test]
fn mistakes_in_a_formula_are_shown_at_their_place() {
    let place = Place::new();
    for (given, wrong, message) in MISTAKES {
        assert!(RIPPLE.contains(given), "{given}");
        place.write("lathe.toml", model("lathe.toml") + &RIPPLE.replacen(given, wrong, 1));
        let answer = place.fem(&["run", "lathe.toml"]);
        let page = answer.err.split_whitespace().collect::<Vec<_>>().join(" ");
        assert_eq!(answer.status, 2, "{wrong}: {}", answer.err);
        assert!(page.contains(message), "{wrong}: {}", answer.err);
    }
}

#[test]
fn places_and_waves_are_found_wherever_they_are() {
    let place = Place::new();
    let own = |law: &str| format!("{}\n[effects.mine]\nformula = \"{law}\"\n", model("story/rigid.toml"));
    let cases = [
        ("a*sin(2*pi*x/b)", [("a", 3.0, "um"), ("b", 70.0, "mm")]),
        ("a*step(x - b)", [("a", 4.0, "um"), ("b", 212.0, "mm")]),
        ("a*cos(2*pi*x/400e-3*m/m - b)", [("a", 3.0, "um"), ("b", 50.0, "deg")]),
    ];
    for (law, parameters) in cases {
        let law = law.replace("x/400e-3*m/m", "x/l");
        let length = if law.contains("/l") { "l = \"400 mm\"\n" } else { "" };
        let lines = |free: bool| {
            let line = |(name, value, unit): &(&str, f64, &str)| {
                let value = if free { "?".to_string() } else { value.to_string() };
                format!("{name} = \"{value} {unit}\"\n")
            };
            parameters.iter().map(line).collect::<String>()
        };
        place.write("true.toml", own(&law) + length + &lines(false));
        place.write("free.toml", own(&law) + length + &lines(true));
        assert_eq!(place.fem(&["run", "true.toml", "-o", "out"]).status, 0);
        let fit = place.fem(&["fit", "free.toml", "--with", "out/profile.csv", "--json"]);
        let fit: serde_json::Value = serde_json::from_str(&fit.out).unwrap();
        assert!(fit["rms"].as_f64().unwrap() < 1e-4, "{law}: {fit:#}");
    }
}

#[test]
fn a_written_effect_is_run_fitted_compared_and_diagnosed_like_any() {
    let place = Place::new();
    place.write("rippled.toml", model("slender-shaft.toml") + RIPPLE);
    let run = place.fem(&["run", "rippled.toml", "-o", "out", "--json"]);
    assert_eq!(run.status, 0, "{}", run.err);
    let run: serde_json::Value = serde_json::from_str(&run.out).unwrap();
    let share = run["shares"].as_array().unwrap().iter().find(|s| s["effect"] == "ripple").unwrap();
    // 3 um over whole periods and a little: its mean square is half of its height's.
    assert!((share["largest"].as_f64().unwrap() - 3.0).abs() < 0.01, "{share}");
    place.write(
        "free.toml",
        place.read("rippled.toml").replace("\"3 um\"", "\"? um\"").replace("\"120 mm\"", "\"? mm\""),
    );
    let fit = place.fem(&["fit", "free.toml", "--with", "out/profile.csv", "--json"]);
    let fit: serde_json::Value = serde_json::from_str(&fit.out).unwrap();
    let value = |name: &str| {
        let all = fit["parameters"].as_array().unwrap();
        all.iter().find(|p| p["parameter"] == name).unwrap()["value"].as_f64().unwrap()
    };
    assert!((value("effects.ripple.a") - 3.0).abs() < 1e-6 && (value("effects.ripple.pitch") - 120.0).abs() < 1e-6);
    let compared = place.fem(&["compare", "rippled.toml", "--with", "out/profile.csv", "--json"]);
    let compared: serde_json::Value = serde_json::from_str(&compared.out).unwrap();
    assert!(compared["models"][0]["rms"].as_f64().unwrap() < 1e-6);
    let diagnosed = place.fem(&["diagnose", "free.toml", "--with", "out/profile.csv", "--json"]);
    let diagnosed: serde_json::Value = serde_json::from_str(&diagnosed.out).unwrap();
    assert_eq!(diagnosed["verdict"], "adequate");
}

#[test]
fn phases_of_formulas_come_round() {
    let place = Place::new();
    let own = "\n[effects.mine]\nformula = \"a*cos(2*pi*x/l - b)\"\na = \"3 um\"\nl = \"300 mm\"\n";
    place.write("true.toml", format!("{}{own}b = \"50 deg\"\n", model("story/rigid.toml")));
    place.write("far.toml", format!("{}{own}b = \"400 +- 50 deg\"\n", model("story/rigid.toml")));
    assert_eq!(place.fem(&["run", "true.toml", "-o", "out"]).status, 0);
    let fit = place.fem(&["fit", "far.toml", "--with", "out/profile.csv", "--json"]);
    let fit: serde_json::Value = serde_json::from_str(&fit.out).unwrap();
    let value = fit["parameters"][0]["value"].as_f64().unwrap();
    assert!((value - 50.0).abs() < 0.01, "{fit:#}");
}

#[test]
fn powers_are_refused_for_what_they_are() {
    let place = Place::new();
    for (power, why) in [("1000", "to a power beyond 12"), ("0.5", "to a power that is no whole number")] {
        let own = format!("\n[effects.mine]\nformula = \"a*x^{power}\"\na = \"3 um\"\n");
        place.write("mine.toml", model("story/rigid.toml") + &own);
        let answer = place.fem(&["run", "mine.toml"]);
        assert!(answer.status == 2 && answer.err.contains(why), "{}", answer.err);
    }
}
