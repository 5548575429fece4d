//! Several tests of one machine: the story of `models/tailstock`, and what is refused.

use super::fem::{Answer, Place, model};

const FILES: [&str; 5] = ["lathe.toml", "shafts.toml", "shafts.csv", "tailstock.toml", "tailstock.csv"];
const BOTH: [&str; 7] =
    ["diagnose", "shafts.toml", "--with", "shafts.csv", "tailstock.toml", "--with", "tailstock.csv"];

pub fn place() -> Place {
    let place = Place::new();
    FILES.iter().for_each(|file| place.write(file, model(&format!("tailstock/{file}"))));
    place
}

fn refused(place: &Place, args: &[&str], message: &str, remedy: &str) {
    let Answer { status, err, .. } = place.fem(args);
    assert!(status == 2 && err.contains(message) && err.contains(remedy), "{status} {err}");
}

#[test]
fn the_measurements_are_those_of_the_generator() {
    let story = generator::machine::story();
    assert_eq!((model("tailstock/shafts.csv"), model("tailstock/tailstock.csv")), (story.turned, story.loaded));
}

#[test]
fn a_class_of_the_shafts_becomes_one_name_with_the_tailstock() {
    let place = place();
    let texts = |of: &serde_json::Value| -> Vec<String> {
        of.as_array().unwrap().iter().map(|name| name.as_str().unwrap().to_string()).collect()
    };
    let names = |args: &[&str]| {
        let answer = place.fem(&[args, &["--json"]].concat());
        assert_eq!(answer.status, 0, "{}", answer.err);
        let json: serde_json::Value = serde_json::from_str(&answer.out).unwrap();
        let missing = json["missing"].as_array().unwrap();
        assert_eq!((json["verdict"].as_str(), missing.len()), (Some("missing-effect"), 1), "{}", answer.out);
        let named = missing[0]["effect"].as_str().unwrap().to_string();
        (named, texts(&missing[0]["indistinguishable_from"]), json)
    };
    let (named, _, alone) = names(&["diagnose", "shafts.toml", "--with", "shafts.csv"]);
    let group = texts(&alone["groups"][0]["effects"]);
    assert!(group.len() > 3 && group.contains(&named) && alone.get("tests").is_none(), "{group:?}");
    let (named, class, json) = names(&BOTH);
    assert_eq!((&*named, &class[..]), ("tailstock-contact", &[][..]));
    // What the generator gave the tailstock, from both tests together.
    for (name, truth) in [("c", 0.2), ("n", 0.6)] {
        let interval = &json["missing"][0]["parameters"][name]["interval95"];
        let (low, high) = (interval[0].as_f64().unwrap(), interval[1].as_f64().unwrap());
        assert!(low <= truth && truth <= high, "{name} {interval}");
    }
    let places = json["missing"][0]["acts_in"].as_array().unwrap();
    let acts: Vec<_> = places.iter().map(|p| (p["model"].as_str().unwrap(), p["effect"].as_str().unwrap())).collect();
    assert_eq!(acts, [("shafts.toml", "tailstock-contact"), ("tailstock.toml", "contact-joint")]);
    // Each test by itself comes down to its own noise.
    for test in json["tests"].as_array().unwrap() {
        let [before, after, noise] = ["rms_before", "rms_after", "noise"].map(|key| test[key].as_f64().unwrap());
        assert!(before > 3.0 * noise && after < 1.3 * noise, "{test}");
    }
}

#[test]
fn the_commands_complete_the_model_of_each_test() {
    let place = place();
    insta::assert_snapshot!("tailstock-short", place.fem(&BOTH).out);
    let answer = place.fem(&[&BOTH[..], &["--verbose"]].concat());
    insta::assert_snapshot!("tailstock", answer.out);
    let commands: Vec<&str> = answer.out.lines().filter_map(|line| line.strip_prefix("  fem ")).collect();
    let (last, adds) = commands.split_last().unwrap();
    assert_eq!(adds.len(), 2);
    for command in adds {
        let words = super::fem::words(command);
        let args: Vec<&str> = words.iter().map(String::as_str).collect();
        let answer = place.fem(&args);
        assert_eq!(answer.status, 0, "{command}: {}", answer.err);
    }
    let words = super::fem::words(last);
    let args: Vec<&str> = words.iter().map(String::as_str).collect();
    let completed = place.fem(&args);
    assert!(
        completed.status == 0 && completed.out.contains("nothing is missing"),
        "{} {}",
        completed.out,
        completed.err
    );
}

#[test]
fn the_order_of_the_tests_does_not_matter() {
    let place = place();
    let other = ["diagnose", "tailstock.toml", "--with", "tailstock.csv", "shafts.toml", "--with", "shafts.csv"];
    let said = |args: &[&str]| {
        let out = place.fem(&[args, &["--verbose"]].concat()).out;
        let causes = out.lines().skip_while(|line| !line.starts_with("cause ")).take(4);
        causes.filter(|line| !line.starts_with("  in ")).map(str::to_string).collect::<Vec<_>>()
    };
    assert!(said(&BOTH).len() == 3 && said(&BOTH) == said(&other), "{:?} {:?}", said(&BOTH), said(&other));
}

#[test]
fn tests_that_do_not_belong_together_are_refused() {
    let place = place();
    refused(&place, &BOTH[..5], "2 models are named, and `--with` 1 times", "one file for each test");
    refused(&place, &[&BOTH[..], &["--add-to", "new"]].concat(), "--add-to writes one model", "commands");
    let with = |from: &str, to: &str| model("tailstock/tailstock.toml").replace(from, to);
    place.write("tailstock.toml", with("machine = \"lathe.toml\"\n", ""));
    refused(&place, &BOTH, "tailstock.toml names no machine", "write machine = \"lathe.toml\"");
    place.write("mill.toml", model("tailstock/lathe.toml"));
    place.write("tailstock.toml", with("lathe.toml", "mill.toml"));
    refused(&place, &BOTH, "shafts.toml is of lathe.toml, and tailstock.toml of mill.toml", "each by itself");
    place.write("tailstock.toml", with("\"tailstock\"", "\"quill\""));
    refused(&place, &BOTH, "lathe.toml has no unit `quill`", "write [machine.quill]");
    place.write("tailstock.toml", with("? N/um", "60 N/um"));
    place.write("again.toml", with("? N/um", "50 N/um"));
    place.write("again.csv", model("tailstock/tailstock.csv"));
    let twice = ["diagnose", "tailstock.toml", "--with", "tailstock.csv", "again.toml", "--with", "again.csv"];
    refused(
        &place,
        &twice,
        "`joint.stiffness` is 60 N/um in tailstock.toml and 50 N/um in again.toml",
        "in one of them",
    );
    let known = "\n[effects.tailstock-compliance]\nstiffness = \"50 N/um\"\n";
    place.write("shafts.toml", model("tailstock/shafts.toml") + known);
    refused(
        &place,
        &BOTH,
        "`tailstock-compliance.stiffness` is 50 N/um in shafts.toml and 60 N/um",
        "the same in both",
    );
}

#[test]
fn data_that_do_not_belong_together_are_refused() {
    let place = place();
    let twice = ["diagnose", "shafts.toml", "--with", "shafts.csv", "tailstock.toml", "--with", "./shafts.csv"];
    place.write("tailstock.toml", model("tailstock/shafts.toml"));
    refused(&place, &twice, "named twice", "count twice");
    place.write("tailstock.toml", model("tailstock/tailstock.toml"));
    let without: String = model("tailstock/tailstock.csv")
        .lines()
        .map(|line| format!("{}\n", line.rsplit_once(',').unwrap().0))
        .collect();
    place.write("tailstock.csv", without);
    refused(&place, &BOTH, "shafts.csv has a column u, and tailstock.csv has none", "--columns 'u=-'");
    // Without uncertainties each test has the noise that its own rows tell.
    let answer = place.fem(&[&BOTH[..], &["--columns", "u=-"]].concat());
    assert!(answer.status == 0 && answer.out.contains("missing: tailstock-contact;"), "{} {}", answer.out, answer.err);
    refused(&place, &[&BOTH[..], &["--columns", "v=-"]].concat(), "no file has a column `v`", "heading");
}

#[test]
fn a_machine_file_that_says_something_else_is_refused() {
    let place = place();
    let lathe = model("tailstock/lathe.toml");
    for (text, message) in [
        (lathe.replace("[machine.tailstock]", "[machine.tailstock]\nstiffness = \"60 N/um\""), "no values yet"),
        (lathe.replace("[machine]", "[machin]"), "`machin` is not known in a machine file"),
        (lathe.replace("\"Lathe 3\"", "3"), "`name` is no text"),
        (lathe.replace("[machine]", "[machine"), "lathe.toml:"),
        (String::new(), "there is no table [machine]"),
    ] {
        place.write("lathe.toml", text);
        refused(&place, &["run", "shafts.toml"], message, "help:");
    }
    let gone = model("tailstock/shafts.toml").replace("lathe.toml", "gone.toml");
    place.write("shafts.toml", gone);
    refused(&place, &["run", "shafts.toml"], "gone.toml", "relative to the folder of the model file");
}

#[test]
fn a_model_in_another_folder_still_finds_its_machine() {
    let place = place();
    std::fs::create_dir(place.path("new")).unwrap();
    let add = ["add", "shafts.toml", "setting-error", "offset=1 um", "-o", "new/shafts.toml"];
    assert_eq!(place.fem(&add).status, 0);
    assert!(place.read("new/shafts.toml").contains("machine = \"../lathe.toml\""));
    let together = ["diagnose", "new/shafts.toml", "--with", "shafts.csv", "tailstock.toml", "--with", "tailstock.csv"];
    assert_eq!(place.fem(&together).status, 0);
}
