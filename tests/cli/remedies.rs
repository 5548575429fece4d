//! `fem correct --remedies`.

use serde_json::Value as Json;

use super::fem::{Answer, Mistake, Place, model};

fn parsed(answer: &Answer) -> Json {
    assert_eq!(answer.status, 0, "{}", answer.err);
    serde_json::from_str(&answer.out).unwrap()
}

fn number(value: &Json) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// The number before a unit.
fn value(text: &Json) -> f64 {
    text.as_str().unwrap().split(' ').next().unwrap().parse().unwrap()
}

/// A shaft that gives way by the force alone, which follows feed^0.6: the cut of 300 mm takes 300/(900·feed) min.
const SHAFT: &str = r#"
process = "turning"
workpiece = { material = "steel", segments = [{ length = "300 mm", diameter = "30 mm" }] }
workholding = { type = "centres" }
cut = { depth = "0.4 mm", feed = "0.2 mm/rev", spindle_speed = "900 rpm", force = { C = 800.0, x = 0.9, y = 0.6 } }
"#;
const FEED: &str = "[[setting]]\nquantity = \"cut.feed\"\nfrom = \"0.05 mm/rev\"\nto = \"0.6 mm/rev\"\n";

/// At a limit of a minute more the feed is 300/(900·(300/(900·0.2) + 1)) = 0.125 mm/rev, and all errors fall by (0.125/0.2)^0.6.
#[test]
fn the_feed_at_a_limit_of_minutes_is_that_of_the_law() {
    let place = Place::new();
    place.write("shaft.toml", format!("{SHAFT}{FEED}"));
    let found = parsed(&place.fem(&["correct", "shaft.toml", "--remedies", "--minutes", "1", "--json"]));
    let action = &found["actions"][0];
    assert_eq!([&action["setting"], &action["from"]], ["cut.feed", "0.2 mm/rev"], "{action}");
    assert!((value(&action["to"]) - 0.125).abs() < 1.1e-3, "{action}");
    let feed = value(&action["to"]);
    let fell = number(&action["rms"]) / number(&found["now"]["rms"]);
    assert!((fell - (feed / 0.2).powf(0.6)).abs() < 1e-6, "{fell}");
    let minutes = 300.0 / 900.0 * (1.0 / feed - 1.0 / 0.2);
    assert!((number(&action["minutes"]) - minutes).abs() < 1e-6 && minutes <= 1.0, "{action}");
    let gain = number(&found["now"]["rms"]) - number(&action["rms"]);
    assert!((number(&action["gain"]) - gain).abs() < 1e-15);
    // Without a limit the least error is at the end of the range, and that is said.
    let all = parsed(&place.fem(&["correct", "shaft.toml", "--remedies", "--json"]));
    assert_eq!([&all["actions"][0]["to"], &all["actions"][0]["at_limit"]], [&"0.05 mm/rev".into(), &Json::Bool(true)]);
}

/// Of a shaft that is well within its tolerance, the feed with which it just is so takes the fewest minutes: the part of the
/// tolerance that is used follows feed^0.6 as the errors do.
#[test]
fn within_the_tolerance_the_fewest_minutes_are_taken() {
    let place = Place::new();
    place.write("shaft.toml", format!("{SHAFT}tolerance = {{ cylindricity = \"14 um\" }}\n{FEED}"));
    let found = parsed(&place.fem(&["correct", "shaft.toml", "--remedies", "--json"]));
    let used = number(&found["now"]["tolerance_used"]);
    assert!(used < 0.8, "{used}");
    let action = &found["actions"][0];
    let limit = 0.2 * used.powf(-1.0 / 0.6);
    assert!((0.97..=1.0).contains(&(value(&action["to"]) / limit)), "{action} {limit}");
    assert!(number(&action["minutes"]) < 0.0 && action["probability_in"] == 1.0, "{action}");
    // Along the front less time leaves more.
    let front = found["pareto"].as_array().unwrap();
    assert!(front.len() > 3 && front.is_sorted_by(|a, b| number(&a["minutes"]) < number(&b["minutes"])));
    assert!(front.is_sorted_by(|a, b| number(&a["tolerance_used"]) > number(&b["tolerance_used"])));
}

/// A ring whose bore is what three jaws of 3 kN leave, and nothing else.
const RING: &str = r#"
process = "ring"
workpiece = { material = "steel", outer_diameter = "100 mm", inner_diameter = "84 mm", width = "20 mm" }
chuck = { jaws = 3, jaw_force = "3000 N" }
"#;

/// The bore is what the jaws leave, F·g, less three lobes of another cause, a·l: least at F = a·⟨g, l⟩/⟨g, g⟩.
#[test]
fn the_jaw_force_that_makes_up_for_another_cause_is_found() {
    let place = Place::new();
    place.write("ring.toml", RING);
    let bore = |name: &str| -> Vec<(f64, f64)> {
        assert_eq!(place.fem(&["run", name, "-o", "out", "--force"]).status, 0);
        let text = place.read("out/profile.csv");
        let cells = |line: &str| -> Vec<f64> { line.split(',').map(|own| own.parse().unwrap_or(f64::NAN)).collect() };
        let head: Vec<&str> = text.lines().next().unwrap().split(',').collect();
        let column = |name: &str| head.iter().position(|own| own.starts_with(name)).unwrap();
        let (angle, deviation) = (column("angle"), column("deviation"));
        text.lines().skip(1).map(cells).map(|own| (own[angle], own[deviation])).collect()
    };
    let own = bore("ring.toml");
    let lobes = |angle: f64| (3.0 * angle.to_radians()).cos();
    let product = |a: &dyn Fn(f64, f64) -> f64, b: &dyn Fn(f64, f64) -> f64| -> f64 {
        own.iter().map(|(angle, deviation)| a(*angle, *deviation) * b(*angle, *deviation)).sum()
    };
    let (g, l) = (|_: f64, deviation: f64| deviation, |angle: f64, _: f64| lobes(angle));
    let share = product(&g, &l) / product(&g, &g);
    // Lobes that make 0.6 of the force the best.
    let amplitude = 0.6 / share;
    let cause = format!("[effects.lobes]\nformula = \"-a * cos(3 * angle)\"\na = \"{amplitude} um\"\n");
    let setting = "[[setting]]\nquantity = \"chuck.jaw_force\"\nfrom = \"300 N\"\nto = \"4500 N\"\n";
    place.write("lobed.toml", format!("{RING}{cause}{setting}"));
    let found = parsed(&place.fem(&["correct", "lobed.toml", "--remedies", "--json"]));
    let action = &found["actions"][0];
    assert!((value(&action["to"]) / 1800.0 - 1.0).abs() < 0.01, "{action}");
}

/// Counts, words, what is written, and what makes no model or changes nothing.
#[test]
fn settings_of_every_form() {
    let place = Place::new();
    let settings = r#"
[[setting]]
quantity = "workholding.type"
values = ["centres", "chuck-and-centre", "chuck"]
minutes = "10 min"
[[setting]]
name = "steady rest"
write = { "workholding.steady_rests" = [{ at = "150 mm", stiffness = "40 N/um" }] }
quantity = "workholding.steady_rests[0].at"
from = "50 mm"
to = "280 mm"
minutes = "5 min"
minutes_per_part = "1 min"
[[setting]]
name = "two passes"
write = { pass = [{ depth = "1 mm" }] }
[[setting]]
name = "a rest beyond the shaft"
write = { workholding.steady_rests = [{ at = "310 mm", stiffness = "40 N/um" }] }
minutes = "1 min"
[[setting]]
quantity = "cut.spindle_speed"
from = "600 rpm"
to = "1200 rpm"
"#;
    place.write("shaft.toml", format!("{SHAFT}batch.parts = 2\n{settings}"));
    let wrong = place.fem(&["correct", "shaft.toml", "--remedies"]);
    assert!(wrong.status == 2 && wrong.err.contains("a rest beyond the shaft"), "{}", wrong.err);
    place.write("shaft.toml", format!("{SHAFT}batch.parts = 2\n{settings}").replace("310 mm", "30 mm"));
    let found = parsed(&place.fem(&["correct", "shaft.toml", "--remedies", "--json", "-o", "out"]));
    let own = |name: &str| found["actions"].as_array().unwrap().iter().find(|own| own["setting"] == name).cloned();
    // The middle of a shaft that is alike to both sides.
    let rest = own("steady rest").unwrap();
    assert!((value(&rest["to"]) - 150.0).abs() < 3.0 && rest["from"].is_null(), "{rest}");
    assert!((number(&rest["minutes"]) - 7.0).abs() < 1e-9, "{rest}");
    let held = own("workholding.type").unwrap();
    assert_eq!([&held["from"], &held["to"]], ["centres", "chuck-and-centre"]);
    assert!((number(&held["minutes"]) - 10.0).abs() < 1e-9);
    // Without a centre the shaft gives way to one side; a value that does so is no remedy, one that makes no model is told.
    // One more pass takes as long as the other, and no force feeds back: nothing is better.
    let refused = found["refused"].as_array().unwrap();
    let reason = |name: &str| {
        let own = refused.iter().find(|own| own["setting"] == name);
        own.map_or(String::new(), |own| own["reason"].as_str().unwrap().to_string())
    };
    assert!(reason("cut.spindle_speed").contains("changes nothing"), "{refused:?}");
    assert!(reason("two passes").contains("changes nothing"), "{refused:?}");
    // Both rests write the same, and are never set together; the other way of holding goes with either.
    let together = found["together"].as_array().unwrap();
    assert!(!together.is_empty());
    for own in together {
        let names: Vec<&str> =
            own["settings"].as_array().unwrap().iter().map(|s| s["setting"].as_str().unwrap()).collect();
        assert!(!(names.contains(&"steady rest") && names.contains(&"a rest beyond the shaft")), "{names:?}");
    }
    // The model with the best is a model, and makes what was promised.
    let best = &together[together.len() - 1];
    let again = parsed(&place.fem(&["correct", "out/remedied.toml", "--remedies", "--json"]));
    let (promised, made) = (number(&best["rms"]), number(&again["now"]["rms"]));
    assert!((made / promised - 1.0).abs() < 1e-6, "{promised} {made}");
    assert!(place.read("out/remedies.csv").starts_with("list,change,rms [um]"));
    assert!(place.read("out/remedies.svg").contains("<svg"));
    // A count, between two ends.
    place.write("ring.toml", format!("{RING}\n[[setting]]\nquantity = \"chuck.jaws\"\nfrom = 3\nto = 6\n"));
    let ring = parsed(&place.fem(&["correct", "ring.toml", "--remedies", "--json"]));
    assert_eq!([&ring["actions"][0]["from"], &ring["actions"][0]["to"]], ["3", "6"], "{}", ring["actions"]);
}

/// A force that is given is that of the depth and the feed beside it.
#[test]
fn what_has_no_law_is_refused_with_what_to_write() {
    let place = Place::new();
    let given = SHAFT.replace("force = { C = 800.0, x = 0.9, y = 0.6 }", "radial_force = \"200 N\"");
    place.write("shaft.toml", format!("{given}{FEED}"));
    let told = place.fem(&["correct", "shaft.toml", "--remedies"]);
    assert_eq!(told.status, 0, "{}", told.err);
    assert!(told.out.contains("no setting alone makes it better"), "{}", told.out);
    let words = told.out.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("cut.feed cannot be judged: `radial_force` stays what it is"), "{words}");
    assert!(words.contains("write force = { C = 1250.0, x = 0.9, y = 0.75 }"), "{words}");
}

/// What is known roughly is drawn: a setting whose quantity is rough stays as rough, and a part in the middle of doubt is
/// counted as one.
#[test]
fn what_is_known_roughly_counts() {
    let place = Place::new();
    let rough = r#"
tolerance = { cylindricity = "12 um" }
[effects.tailstock-compliance]
stiffness = "30 +- 12 N/um"
[[setting]]
quantity = "effects.tailstock-compliance.stiffness"
from = "20 N/um"
to = "400 N/um"
"#;
    place.write("shaft.toml", format!("{SHAFT}{rough}"));
    let found = parsed(&place.fem(&["correct", "shaft.toml", "--remedies", "--json", "-o", "out"]));
    let now = &found["now"];
    assert!(number(&now["tolerance_used_95"]) > number(&now["tolerance_used"]), "{now}");
    // What a process knows to do beside its settings has no such numbers.
    let judged = found["actions"].as_array().unwrap().iter().filter(|own| !own["tolerance_used_95"].is_null());
    for own in judged.chain([now]) {
        let (surely, probability) = (number(&own["tolerance_used_95"]), number(&own["probability_in"]));
        assert!(surely > 1.0 || probability > 0.9, "{own}");
        assert!(surely < 1.0 || probability < 0.99, "{own}");
    }
    let better = place.read("out/remedied.toml");
    assert!(
        better.lines().any(|line| line.starts_with("stiffness") && line.contains("+-") && !line.contains("30 +-")),
        "{better}"
    );
}

/// Of a long batch some parts are looked at, which is said; a shaft that is the same on every part leaves the same.
#[test]
fn of_many_parts_some_are_looked_at() {
    let place = Place::new();
    let left = |parts: usize| {
        place.write("shaft.toml", format!("{SHAFT}batch.parts = {parts}\n{FEED}"));
        let found = parsed(&place.fem(&["correct", "shaft.toml", "--remedies", "--minutes", "60", "--json"]));
        (number(&found["now"]["rms"]), found["parts"].clone(), found["parts_looked_at"].clone())
    };
    let (few, many) = (left(3), left(90));
    assert!((few.0 / many.0 - 1.0).abs() < 1e-9, "{few:?} {many:?}");
    assert_eq!((few.1, few.2, many.1, many.2), (3.into(), 3.into(), 90.into(), 16.into()));
    assert!(place.fem(&["correct", "shaft.toml", "--remedies"]).out.contains("16 of 90 parts were looked at"));
}

const MISTAKES: &[Mistake] = &[
    ("cut.feed", "cut.fed", "has no quantity `cut.fed`", "did you mean `cut.feed`?"),
    ("0.05 mm/rev", "0.05 mm", "`cut.feed`: `mm` measures", "write it in mm/rev"),
    ("0.05 mm/rev", "-0.05 mm/rev", "`cut.feed` cannot be -0.05 mm/rev", "keep within"),
    ("0.05 mm/rev", "0.05 +- 0.01 mm/rev", "a limit is known", "write"),
    ("0.05 mm/rev", "0.7 mm/rev", "the range ends before it begins", "the lower end first"),
    ("to = ", "too = ", "it is not said how far `cut.feed` can be changed", "either `from` and `to`, or `values`"),
    ("quantity = \"cut.feed\"\n", "", "it is not said what varies", "add quantity = "),
    ("from = ", "values = [\"0.1 mm/rev\"]\nfrom = ", "how far `cut.feed`", "either `from` and `to`, or `values`"),
    ("from = ", "measured = [\"0.1 mm/rev\"]\nfrom = ", "it has two ends", "write measured = ["),
    ("from = ", "minutes = \"3 mm\"\nfrom = ", "`minutes`", "write it in min"),
    ("from = ", "remove = \"batch\"\nfrom = ", "expected a list", "write remove = ["),
    (
        "from = ",
        "write = { process = \"ring\" }\nfrom = ",
        "changes neither the process",
        "name keys of the other tables",
    ),
    ("from = ", "write = { \"cut.depth\" = \"1 N\" }\nfrom = ", "makes no model", "write it in mm"),
    ("[[setting]]", "[[setting]]\nwrite = { a = 1 }\n[[setting]]", "the setting has no name", "add name ="),
    ("[[setting]]", "[[setting]]\nname = \"x\"\n[[setting]]", "the setting changes nothing", "give `quantity`"),
    (FEED, "", "does not say what the shop can change", "add [[setting]]"),
];

#[test]
fn mistakes_are_told_with_their_place() {
    let place = Place::new();
    let good = format!("{SHAFT}{FEED}");
    for (was, is, message, help) in MISTAKES {
        place.write("shaft.toml", good.replacen(was, is, if was.contains("cut.feed") { 9 } else { 1 }));
        let told = place.fem(&["correct", "shaft.toml", "--remedies"]);
        let err = told.err.split_whitespace().filter(|own| !["│", "|"].contains(own)).collect::<Vec<_>>().join(" ");
        assert_eq!(told.status, 2, "{is}: {} {}", told.out, told.err);
        assert!(err.contains(message), "{is}: {}", told.err);
        assert!(err.contains(help), "{is}: {}", told.err);
    }
    let place = Place::new();
    place.write("shaft.toml", good);
    assert_eq!(place.fem(&["correct", "shaft.toml", "--minutes", "3"]).status, 2);
    assert_eq!(place.fem(&["correct", "shaft.toml", "--remedies", "--minutes", "nan"]).status, 2);
}

/// Jaws that press less leave less, and at last no longer hold the cut: 1226 N are the least.
#[test]
fn what_loosens_the_work_is_no_remedy() {
    let place = Place::new();
    let force = "[[setting]]\nquantity = \"chuck.jaw_force\"\nfrom = \"200 N\"\nto = \"3 kN\"\n";
    place.write("ring.toml", format!("{}\n{force}", model("correction/ring.toml")));
    let answer = place.fem(&["correct", "ring.toml", "--remedies", "--json", "-o", "out"]);
    let found = parsed(&answer);
    let told: Vec<f64> = ["actions", "together", "pareto"]
        .iter()
        .flat_map(|list| found[list].as_array().unwrap().iter())
        .filter_map(|own| own["to"].as_str().or_else(|| own["settings"][0]["to"].as_str()))
        .map(|to| {
            let (number, unit) = to.split_once(' ').unwrap();
            number.parse::<f64>().unwrap() * if unit == "kN" { 1000.0 } else { 1.0 }
        })
        .collect();
    assert!(!told.is_empty() && told.iter().all(|force| *force >= 1225.0), "{told:?}");
    place.write("weak.toml", model("correction/ring.toml").replace("3 kN", "1 kN"));
    let weak = place.fem(&["run", "weak.toml", "-o", "weak"]);
    assert!(weak.status == 0 && weak.err.contains("the jaws do not hold the cut"), "{}", weak.err);
}
