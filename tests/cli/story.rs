//! The story of `models/story`: from a machine believed to be rigid, by what the diagnosis says, to the
//! noise.

use super::fem::{Place, model, words};

const RIGID: &str = "rigid.toml";
const DATA: &str = "measured.csv";

fn place() -> Place {
    let place = Place::new();
    place.write(RIGID, model("story/rigid.toml"));
    place.write(DATA, model("story/measured.csv"));
    place
}

#[test]
fn the_measurements_are_those_of_the_generator() {
    assert_eq!(model("story/measured.csv"), generator::story::measured());
}

#[test]
fn each_step_is_the_command_that_the_diagnosis_gives() {
    let place = place();
    let mut models = vec![RIGID.to_string()];
    for left in (0..=3).rev() {
        let at = models.last().unwrap().clone();
        let answer = place.fem(&["diagnose", &at, "--with", DATA, "--verbose"]);
        assert_eq!(answer.status, 0, "{}", answer.err);
        if left == 3 {
            insta::assert_snapshot!("story", answer.out);
        }
        let Some(command) = answer.out.lines().find(|l| l.trim_start().starts_with("fem add")) else {
            assert!(left == 0 && answer.out.contains("nothing is missing"), "{}", answer.out);
            break;
        };
        let found = answer.out.lines().filter(|l| l.starts_with("cause ")).count();
        assert_eq!(found, left, "{}", answer.out);
        let words = words(command);
        let args: Vec<&str> = words[1..].iter().map(String::as_str).collect();
        assert_eq!(place.fem(&args).status, 0);
        models.push(words.last().unwrap().clone());
    }
    assert_eq!(models.len(), 4);
    let mut args = vec!["compare"];
    args.extend(models.iter().map(String::as_str));
    args.extend(["--with", DATA]);
    let shown = place.fem(&args).out;
    insta::assert_snapshot!("story-compared", shown);
    let readme = include_str!("../../README.md");
    for line in shown.lines().filter(|l| l.contains(".toml")).take(4) {
        assert!(readme.contains(line.trim()), "README does not show: {line}");
    }
}

#[test]
fn the_answer_is_read_at_a_glance() {
    let answer = place().fem(&["diagnose", RIGID, "--with", DATA]);
    assert!(answer.status == 0 && answer.out.lines().count() <= 25, "{}", answer.out);
    assert!(answer.out.lines().skip(1).all(|line| line.chars().count() <= 100), "{}", answer.out);
    insta::assert_snapshot!("story-short", answer.out);
}

/// A spring of the headstock moves the diameter by 2·F/k·(1 − x/L)², by statics; the first place is 20 mm of 500 mm
/// from it.
#[test]
fn a_cause_tells_what_it_does_to_the_part() {
    let answer = place().fem(&["diagnose", RIGID, "--with", DATA, "--json"]);
    let json: serde_json::Value = serde_json::from_str(&answer.out).unwrap();
    let missing = json["missing"].as_array().unwrap().iter().find(|m| m["effect"] == "headstock-compliance").unwrap();
    let change = &missing["largest_change"];
    let stiffness = missing["parameters"]["stiffness"]["value"].as_f64().unwrap();
    let by_hand = 2.0 * 450.0 / stiffness * 0.96f64.powi(2);
    assert!((change["value"].as_f64().unwrap() / by_hand - 1.0).abs() < 1e-6, "{change}, by hand {by_hand}");
    assert_eq!((&change["unit"], &change["observable"]), (&"um".into(), &"diameter_error".into()));
}

#[test]
fn the_completed_model_comes_down_to_the_noise() {
    let place = place();
    let answer = place.fem(&["diagnose", RIGID, "--with", DATA, "--add-to", "better.toml", "--json"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let json: serde_json::Value = serde_json::from_str(&answer.out).unwrap();
    assert_eq!((json["schema"].as_str(), json["verdict"].as_str()), (Some("fem-diagnosis/1"), Some("missing-effect")));
    let names: Vec<&str> = json["missing"].as_array().unwrap().iter().map(|m| m["effect"].as_str().unwrap()).collect();
    for cause in generator::story::causes() {
        let missing = &json["missing"][names.iter().position(|n| *n == cause.effect).unwrap()];
        for (name, value) in cause.parameters {
            let interval = &missing["parameters"][name]["interval95"];
            let (low, high) = (interval[0].as_f64().unwrap(), interval[1].as_f64().unwrap());
            assert!(low <= value && value <= high, "{}: {name} = {value} is not in {interval}", cause.effect);
        }
    }
    let compared = place.fem(&["compare", "better.toml", "--with", DATA, "--json"]);
    let compared: serde_json::Value = serde_json::from_str(&compared.out).unwrap();
    assert_eq!(compared["models"][0]["adequate"], serde_json::json!(true));
    // What is written is the model and more, comments and order kept.
    assert!(place.read("better.toml").contains(model("story/rigid.toml").trim_end()));
    // Nothing that is read is written over.
    for command in ["diagnose", "fit"] {
        for (new, is_read) in [(RIGID, false), (DATA, true)] {
            let add = |force: &[&str]| {
                place.fem(&[&[command, "better.toml", "--with", DATA, "--add-to", new], force].concat()).status
            };
            // Nor is another file without leave.
            assert_eq!((add(&[]), add(&["--force"])), (2, i32::from(is_read) * 2));
        }
    }
    assert_eq!(place.read(DATA), model("story/measured.csv"));
}

#[test]
fn a_plan_says_what_would_be_seen_and_what_would_look_alike() {
    let place = place();
    place.write("design.csv", "part,x [mm]\n1,20\n1,150\n1,250\n1,350\n1,480\n2,20\n2,250\n2,480\n");
    let answer = place.fem(&["plan", RIGID, "--with", "design.csv", "--noise", "1 um"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    insta::assert_snapshot!("plan", answer.out);
    let json = place.fem(&["plan", RIGID, "--noise", "0.5 um", "--json"]);
    let json: serde_json::Value = serde_json::from_str(&json.out).unwrap();
    assert_eq!(json["schema"], "fem-plan/1");
    assert!((json["noise"]["sigma"].as_f64().unwrap() - 0.5).abs() < 1e-12 && json["noise"]["unit"] == "um");
    // Diameters alone never tell these two apart.
    let twins = serde_json::json!(["guideway-taper", "tailstock-offset"]);
    assert!(json["alike"].as_array().unwrap().iter().any(|a| a["effects"] == twins), "{}", json["alike"]);
    for wrong in ["1 N", "-1 um", "? um"] {
        assert_eq!(place.fem(&["plan", RIGID, "--noise", wrong]).status, 2, "{wrong}");
    }
}
