//! Budgets as a user meets them: the page, JSON, bad input, draws that no number of threads changes, and
//! models whose scatter is known.

use serde_json::Value as Json;

use super::fem::{Mistake, Place, model};

fn json(place: &Place, file: &str) -> Json {
    let answer = place.fem(&["budget", file, "--json"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    serde_json::from_str(&answer.out).unwrap()
}

#[test]
fn the_page_of_the_budget() {
    let place = Place::new();
    for name in ["budget.toml", "budget-lathe.toml", "lathe.toml"] {
        place.write(name, model(name));
    }
    let answer = place.fem(&["budget", "budget.toml"]);
    assert_eq!(answer.status, 0);
    assert!(answer.err.contains("`fixture` is systematic, and stands under the root"), "{}", answer.err);
    insta::assert_snapshot!(answer.out);
    insta::assert_snapshot!("budget_of_a_model", place.fem(&["budget", "budget-lathe.toml"]).out);
}

#[test]
fn a_starting_budget_adds_up() {
    let place = Place::new();
    assert!(place.fem(&["new", "budget", "-o", "b.toml"]).out.contains("next: fem budget b.toml"));
    let answer = place.fem(&["budget", "b.toml"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
}

#[test]
fn digits_do_not_depend_on_threads_but_on_the_seed() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml"));
    place.write("budget.toml", model("budget-lathe.toml").replace("samples = 20000", "samples = 3000"));
    let on = |threads: &str| {
        let mut command = place.command(&["budget", "budget.toml", "--json"]);
        super::fem::answer(command.env("RAYON_NUM_THREADS", threads).output().unwrap()).out
    };
    assert_eq!(on("1"), on("5"));
    place.write("budget.toml", model("budget-lathe.toml").replace("samples = 20000", "samples = 3000\nseed = 2"));
    assert_ne!(on("1"), json(&place, "budget.toml")["monte_carlo"]["mean"].to_string());
}

#[test]
fn json_has_the_keys_that_are_documented() {
    let place = Place::new();
    place.write("budget.toml", model("budget.toml"));
    let found = json(&place, "budget.toml");
    assert_eq!(found["schema"], "fem-budget/1");
    for key in ["t", "risk", "unit", "handbook", "monte_carlo", "pessimism", "contributions", "drill", "warnings"] {
        assert!(!found[key].is_null(), "{key}");
    }
    assert_eq!(found["drill"]["computed"], "wear");
    assert!((found["drill"]["wear"].as_f64().unwrap() - 22.0).abs() < 1e-9);
    let shares: f64 =
        found["contributions"].as_array().unwrap().iter().map(|c| c["variance_share"].as_f64().unwrap()).sum();
    assert!((shares - 1.0).abs() < 1e-9);
}

/// A spring whose stiffness is 80 ± 8 N/um gives way by F/k: not normal, and more on the mean than F/80.
#[test]
fn a_model_is_drawn_through_its_own_law() {
    let place = Place::new();
    let spring = "process = \"stiffness\"\njoint = { stiffness = \"80 +- 8 N/um\" }\ntest = { max_force = \"1 kN\" }\n";
    place.write("spring.toml", spring);
    let text = "budget = { samples = 20000 }\n[model]\nfile = \"spring.toml\"\nat = { force = \"800 N\" }\n";
    place.write("budget.toml", text);
    let found = json(&place, "budget.toml");
    // E[1/k] and E[1/k²] by the trapezoidal rule over six standard deviations.
    let (mut first, mut second, mut weight) = (0.0, 0.0, 0.0);
    for i in 0..=6000 {
        let z = -6.0 + 12.0 * f64::from(i) / 6000.0;
        let (w, y) = ((-0.5 * z * z).exp(), 800.0 / (80.0 + 8.0 * z));
        (first, second, weight) = (first + w * y, second + w * y * y, weight + w);
    }
    let (mean, std) = (first / weight, (second / weight - (first / weight).powi(2)).sqrt());
    for (key, expected) in [("mean", mean), ("std", std)] {
        let figure = |name: &str| found["monte_carlo"][key][name].as_f64().unwrap();
        let (value, error) = (figure("value"), figure("standard_error"));
        assert!((value - expected).abs() < 3.0 * error, "{key}: {value} for {expected}, {error}");
    }
    // What three standard deviations do: 800/56 and 800/104 less 10 um.
    let swing = &found["contributions"].as_array().unwrap().iter().find(|c| c["kind"] == "random").unwrap();
    let end = |key: &str| swing[key].as_f64().unwrap();
    assert!((end("from") - (800.0 / 56.0 - 10.0)).abs() < 1e-9 && (end("to") - (800.0 / 104.0 - 10.0)).abs() < 1e-9);
    // Taken as uniform with the same standard deviation, and a coordinate that varies with it.
    let inputs = "[[input]]\nparameter = \"joint.stiffness\"\ndistribution = \"uniform\"\n[[input]]\ncoordinate = \"force\"\nhalf_field = \"60 N\"\n";
    place.write("budget.toml", format!("{text}{inputs}"));
    let found = json(&place, "budget.toml");
    let figure = |name: &str| found["monte_carlo"]["std"][name].as_f64().unwrap();
    // k uniform over 80 ± 8√3, Q normal with 20 N: E[Q²]·E[1/k²] − (E[Q]·E[1/k])².
    let half = 8.0 * 3f64.sqrt();
    let inverse = ((80.0 + half) / (80.0 - half)).ln() / (2.0 * half);
    let square = 1.0 / (80.0 * 80.0 - half * half);
    let expected = ((800.0 * 800.0 + 400.0) * square - (800.0 * inverse).powi(2)).sqrt();
    assert!((figure("value") - expected).abs() < 3.0 * figure("standard_error"), "{} for {expected}", figure("value"));
}

#[test]
fn draws_without_a_model_are_drawn_again_and_told() {
    let place = Place::new();
    let spring = "process = \"stiffness\"\njoint = { stiffness = \"8 +- 4 N/um\" }\ntest = { max_force = \"1 kN\" }\n";
    place.write("spring.toml", spring);
    place.write("budget.toml", "[model]\nfile = \"spring.toml\"\nat = { force = \"1 N\" }\n");
    let answer = place.fem(&["budget", "budget.toml"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    assert!(answer.err.contains("draws fell where the model has no value"), "{}", answer.err);
}

/// A seat at a rigid centre, where only the carriage yields: (23) pass by pass. Its wear is u·L, its spread along
/// the shaft that of the slope.
const SEAT: &str = r#"process = "turning"
[workpiece]
material = "steel"
segments = [{ length = "500 mm", diameter = "40 mm" }]
blank_points = [{ at = "0 mm", error = "0.6 +- 0.05 mm" }]
[workholding]
type = "centres"
[[pass]]
depth = "1 mm"
[cut]
depth = "0.5 mm"
feed = "0.2 mm/rev"
spindle_speed = "600 rpm"
radial_force = "400 N"
[effects.carriage-compliance]
stiffness = "2 N/um"
[effects.force-feedback]
exponent = 1.0
[effects.tool-wear]
rate = "6 um/km"
[effects.guideway-taper]
slope = "20 um/m"
"#;

/// Blank, passes, wear and form of one file, each as a term: the sum by hand, and the same parts drawn.
#[test]
fn several_models_give_their_terms() {
    let place = Place::new();
    place.write("seat.toml", SEAT);
    let text = r#"
budget = { samples = 5000 }
[[model]]
name = "cut"
file = "seat.toml"
at = { x = "500 mm", path = "0 m" }
[[model]]
name = "cut again"
file = "seat.toml"
at = { x = "500 mm", path = "0 m" }
[[model]]
name = "wear"
file = "seat.toml"
effect = "tool-wear"
at = { x = "500 mm", path = "1.5 km" }
kind = "random"
lambda = 0.25
factor = 0.5
[[model]]
name = "form"
file = "seat.toml"
effect = "guideway-taper"
figure = "spread"
[[input]]
coordinate = "radial_force"
model = "cut again"
value = "400 N"
half_field = "0 N"
"#;
    place.write("budget.toml", text);
    let found = json(&place, "budget.toml");
    // Of all it meets, depth and all, a pass of C = 0.8 N/um against 2 N/um leaves 0.8/2.8.
    let left = 0.8 / 2.8;
    // The taper takes as much off the depth of either pass, so that what it adds itself is copied back in part.
    let taper = 2.0 * 20.0 * 0.5;
    let before = taper + left * (2000.0 + 600.0 - taper);
    let cut = taper + left * (1000.0 + before - taper);
    let form = taper * (1.0 - left * left);
    // One blank varies in both figures: what it does to them adds up, not their squares.
    let blank = 2.0 * left * left * 150.0;
    let wear = 2.0 * 6.0 * 1.5 * 0.5 * (1.0 - left * left);
    let expected =
        [("systematic", 2.0 * cut + form), ("random", 3.0 * f64::sqrt(blank * blank / 9.0 + 0.25 * wear * wear))];
    for (key, expected) in expected {
        let value = found["handbook"][key].as_f64().unwrap();
        assert!((value / expected - 1.0).abs() < 1e-9, "{key}: {value} for {expected}");
    }
    let drawn = |key: &str, name: &str| found["monte_carlo"][key][name].as_f64().unwrap();
    for (key, expected) in [("mean", expected[0].1), ("std", expected[1].1 / 3.0)] {
        let (value, error) = (drawn(key, "value"), drawn(key, "standard_error"));
        assert!((value - expected).abs() < 3.0 * error, "{key}: {value} for {expected}, {error}");
    }
    assert_eq!(found["models"].as_array().unwrap().len(), 4);
    let cases: &[Mistake] = &[
        ("name = \"cut again\"", "name = \"cut\"", "two models are called `cut`", "a `name` of its own"),
        ("model = \"cut again\"", "model = \"cutt\"", "`cutt` is no model of this budget", "known are cut"),
        ("effect = \"tool-wear\"", "effect = \"tool-ware\"", "has no effect `tool-ware`", "did you mean `tool-wear`?"),
        ("figure = \"spread\"", "figure = \"spread\"\nat = { part = 2 }", "has no such rows", "name a part"),
        ("lambda = 0.25", "lambda = 0.75", "`lambda` is 0.75", "at most 0.5"),
        ("lambda = 0.25", "lambda = 0.25\ndistribution = \"normal\"", "the law is given twice", "keep either"),
        ("kind = \"random\"\n", "", "a systematic figure has no law", "add kind"),
    ];
    place.refuses(("budget", "budget.toml"), text, cases);
}

/// (in the budget, replaced by, part of the message, part of the remedy)
const CASES: &[Mistake] = &[
    ("kind = \"random\"", "kind = \"rondom\"", "`kind` is", "did you mean \"random\"?"),
    ("value = \"9 um\"", "value = \"9 N\"", "not a small length", "write it in um"),
    ("value = \"9 um\"", "value = \"-9 um\"", "`value` is -9 um", "zero or more"),
    ("value = \"9 um\"", "value = \"9 +- 1 um\"", "is written with `+-` or `?`", "a budget takes fields"),
    ("value = \"9 um\"\n", "", "the error has no size", "give one of `value`"),
    (
        "value = \"9 um\"\n",
        "value = \"9 um\"\ntemplate = { making = \"1 um\", mounting = \"1 um\" }\n",
        "several sizes",
        "give one of",
    ),
    ("group = \"setup\"", "group = \"setap\"", "`setap` is no group", "did you mean `setup`?"),
    ("c_max = \"0.24 um/N^n\"", "c_max = \"0.1 um/N^n\"", "the largest is below the least", "exchange the two"),
    ("upper = \"60 um\"", "upper = \"-70 um\"", "the tolerance is empty", "above `lower`"),
    ("drill_tolerance = \"18 um\"\n", "", "too little is known of the drill", "give two of"),
    ("t = 3.0", "t = 0.0", "`t` is 0", "above 0 and at most 6"),
    ("[drill]", "[dril]", "`dril` is no key of this file", "did you mean `drill`?"),
];

#[test]
fn bad_input_is_told_with_its_remedy() {
    let place = Place::new();
    place.refuses(("budget", "budget.toml"), &model("budget.toml"), CASES);
    place.write("budget.toml", "title = \"nothing\"\n");
    assert!(place.fem(&["budget", "budget.toml"]).err.contains("the budget is empty"));
}

/// (in the budget of a model, replaced by, part of the message, part of the remedy)
const MODEL_CASES: &[Mistake] = &[
    ("file = \"lathe.toml\"", "file = \"lath.toml\"", "cannot be read", "relative to the folder"),
    ("x = \"300 mm\"", "x = \"3000 mm\"", "not on the shaft", "let the model cover it"),
    ("x = \"300 mm\", ", "", "`x` is missing in `model.at`", "add x"),
    ("part = 12", "prt = 12", "`prt` is no key of `model.at`", "did you mean `part`?"),
    ("\"radial_force\"", "\"radial_farce\"", "is no quantity under which `turning` is observed", "radial_force"),
    ("half_field = \"90 N\"", "half_field = \"900 N\"", "`radial_force` is below zero", "narrow the field"),
    (
        "coordinate = \"radial_force\"",
        "parameter = \"effects.tool-wear.rate\"",
        "does not mark `effects.tool-wear.rate`",
        "write it there as",
    ),
    ("[model]", "[model]\nobservable = \"height\"", "observes no such length", "known are"),
];

#[test]
fn what_is_wrong_with_a_model_in_a_budget_is_told() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml"));
    place.refuses(("budget", "budget.toml"), &model("budget-lathe.toml"), MODEL_CASES);
    // A model that is wrong is told of in its own file.
    place.write("lathe.toml", model("lathe.toml").replace("\"60 +- 10 N/um\"", "\"60 +- 10 mm\""));
    place.write("budget.toml", model("budget-lathe.toml"));
    let answer = place.fem(&["budget", "budget.toml"]);
    assert!(answer.status == 2 && answer.err.contains("lathe.toml:45"), "{}", answer.err);
}

/// A shaft in a chuck bends in proportion to the force, and so does what its ends differ by: a tenth of the force as
/// standard uncertainty is three tenths of the spread at three standard deviations.
#[test]
fn a_spread_follows_what_the_model_knows_roughly() {
    let place = Place::new();
    let model = "process = \"turning\"\n\
        workpiece = { material = \"steel\", segments = [{ length = \"200 mm\", diameter = \"40 mm\" }] }\n\
        workholding.type = \"chuck\"\n\
        cut = { depth = \"1 mm\", feed = \"0.2 mm/rev\", spindle_speed = \"800 rpm\", radial_force = \"300 +- 30 N\" }\n";
    place.write("shaft.toml", model);
    place.write("budget.toml", "budget = { samples = 2000 }\n[model]\nfile = \"shaft.toml\"\nfigure = \"spread\"\n");
    let found = json(&place, "budget.toml");
    let [spread, random] = ["systematic", "random"].map(|key| found["handbook"][key].as_f64().unwrap());
    assert!(spread > 1.0 && (random / spread - 0.3).abs() < 1e-6, "{random} of {spread}");
}

/// Three terms under the root, 3, 4 and 12 um of normal laws: without the last 5 um are left, and it alone may stay as √(10² − 5²) of
/// its 12 for the total to keep 10 um.
#[test]
fn what_to_buy_down_is_told() {
    let place = Place::new();
    let term = |name: &str, value: f64| {
        format!("[[error]]\nname = \"{name}\"\nkind = \"random\"\ndistribution = \"normal\"\nvalue = \"{value} um\"\n")
    };
    let terms = term("a", 3.0) + &term("b", 4.0) + &term("c", 12.0);
    place.write("b.toml", format!("[budget]\nt = 3\ntolerance = {{ lower = \"-10 um\", upper = \"10 um\" }}\n{terms}"));
    let found = json(&place, "b.toml");
    let bought = found["to_buy_down"].as_array().unwrap();
    let of = |i: usize, key: &str| bought[i][key].as_f64().unwrap();
    assert_eq!((bought[0]["name"].as_str(), bought[1]["name"].as_str()), (Some("c"), Some("b")));
    assert!((of(0, "total_without") - 5.0).abs() < 1e-9 && (of(0, "total_with_half") - 61f64.sqrt()).abs() < 1e-9);
    assert!((of(0, "may_stay") - 75f64.sqrt() / 12.0).abs() < 1e-9 && bought[1]["may_stay"].is_null(), "{bought:?}");
    let page = place.fem(&["budget", "b.toml"]).out;
    assert!(page.contains("at most 72 % of it") && page.contains("not by it alone"), "{page}");
    // Whoever asks for a correction of a budget is shown the way.
    let wrong = place.fem(&["correct", "b.toml"]);
    assert!(wrong.status == 2 && wrong.err.contains("`fem budget` adds it up"), "{}", wrong.err);
}
