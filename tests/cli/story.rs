//! The story of `models/story`: from a machine believed to be rigid, by what the diagnosis says, to the
//! noise, and on to the same job made again as the correction says.

use fem::output::falling::Falling;
use fem::units::MICRO;
use serde_json::Value as Json;

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

fn parsed(text: &str) -> Json {
    serde_json::from_str(text).unwrap()
}

/// The story up to the corrected job: a place with the model that the diagnosis arrives at, and the correction.
fn corrected() -> (Place, Json) {
    let place = place();
    assert_eq!(place.fem(&["diagnose", RIGID, "--with", DATA, "--add-to", "better.toml"]).status, 0);
    let answer = place.fem(&["correct", "better.toml", "-o", "correction", "--json"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    place.write("corrected.csv", model("story/corrected.csv"));
    (place, parsed(&answer.out))
}

#[test]
fn the_corrected_shafts_are_made_by_what_the_correction_says() {
    let (place, correction) = corrected();
    // An offset holds until the next one.
    let told = correction["common_offsets"].as_array().unwrap();
    let number = |own: &Json, key: &str| own[key].as_f64().unwrap();
    let before = |part: usize| told.iter().rev().find(|own| number(own, "after_part") < part as f64).unwrap();
    let offsets: Vec<f64> = (1..=12).map(|part| 1e6 * number(before(part), "radius_change")).collect();
    let made = generator::story::corrected(&place.read("correction/contour.ngc"), &offsets);
    assert_eq!(model("story/corrected.csv"), made);
}

/// Measured against the drawing, by hand: every row within ±8 um, js6 of 50 mm; and the model foretells what is left.
#[test]
fn the_corrected_shafts_are_in_tolerance() {
    let (place, correction) = corrected();
    let errors: Vec<f64> = model("story/corrected.csv")
        .lines()
        .skip(2)
        .map(|line| line.split(',').nth(3).unwrap().parse().unwrap())
        .collect();
    assert!(errors.len() == 108 && errors.iter().all(|error| error.abs() < 8.0), "{errors:?}");
    let rms = (errors.iter().map(|error| error * error).sum::<f64>() / 108.0).sqrt();
    let compared = parsed(&place.fem(&["compare", "better.toml", "--with", "corrected.csv", "--json"]).out);
    assert_eq!((&compared["models"][0]["adequate"], &compared["tolerance"][0]["within"]), (&true.into(), &true.into()));
    let off = &compared["rms_from_middle"];
    assert!((off["value"].as_f64().unwrap() / rms - 1.0).abs() < 1e-9 && off["unit"] == "um", "{off} {rms}");
    // Forty times less than before, and not because the rows are told what was commanded.
    assert!(rms < 1e6 * correction["rms"]["before"].as_f64().unwrap() / 40.0, "{rms}");
    let uncorrected = parsed(&place.fem(&["compare", "better.toml", "--with", DATA, "--json"]).out);
    assert_eq!(uncorrected["tolerance"][0]["out"].as_array().unwrap().len(), 12, "{}", uncorrected["tolerance"]);
    // The same rows without what was commanded: the model foretells the job as it was.
    let untold = model("story/corrected.csv").replace("radius_change [um]", "remark");
    place.write("untold.csv", untold);
    let untold = parsed(&place.fem(&["compare", "better.toml", "--with", "untold.csv", "--json"]).out);
    assert!(untold["models"][0]["rms"].as_f64().unwrap() > 50.0, "{}", untold["models"][0]["rms"]);
    assert_eq!(untold["rms_from_middle"], compared["rms_from_middle"]);
}

/// `docs/story.svg`: the bars of the diagnosis, and what `fem compare` says of the corrected shafts. `SNAPSHOTS=overwrite` writes
/// it.
#[test]
fn the_picture_is_what_the_commands_say() {
    let (place, correction) = corrected();
    let found = parsed(&place.fem(&["diagnose", RIGID, "--with", DATA, "--json"]).out);
    let compared = parsed(&place.fem(&["compare", "better.toml", "--with", "corrected.csv", "--json"]).out);
    let number = |value: &Json| value.as_f64().unwrap();
    let first = ("a rigid lathe".to_string(), number(&found["before"]["rms"]));
    let added = found["missing"]
        .as_array()
        .unwrap()
        .iter()
        .map(|missing| (format!("+ {}", missing["effect"].as_str().unwrap()), number(&missing["rms_after"])));
    let before = ("uncorrected, predicted".to_string(), 1e6 * number(&correction["rms"]["before"]));
    let left = ("corrected, measured".to_string(), number(&compared["rms_from_middle"]["value"]));
    let picture = Falling {
        title: "error of the model against the measurements, root mean square".into(),
        steps: std::iter::once(first).chain(added).collect(),
        apart: Some(("error of the parts against the drawing".into(), vec![before, left])),
        noise: number(&found["noise"]["sigma"]),
        unit: MICRO.unit,
    };
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/story.svg");
    let kept = snapbox::Data::read_from(&path, Some(snapbox::data::DataFormat::Text));
    snapbox::Assert::new().action_env("SNAPSHOTS").eq(picture.svg().file(), kept);
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
