//! The pages that people read, as snapshots.

use super::fem::{Place, model};

#[test]
fn the_summary_of_the_main_example() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml"));
    let answer = place.fem(&["run", "lathe.toml"]);
    assert_eq!((answer.status, answer.err.as_str()), (0, ""));
    insta::assert_snapshot!(answer.out);
}

#[test]
fn the_docs_show_what_the_program_prints() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml"));
    let printed = place.fem(&["run", "lathe.toml"]).out;
    let page = include_str!("../../docs/outputs.md");
    let shown = page.split("```text\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
    for line in shown.lines().filter(|l| *l != "…") {
        assert!(printed.contains(line), "the page shows a line that is not printed: {line}");
    }
    assert!(shown.lines().count() > 10);
}

#[test]
fn help_and_catalogue() {
    let place = Place::new();
    insta::assert_snapshot!("help", place.fem(&["--help"]).out);
    insta::assert_snapshot!("help_run", place.fem(&["run", "--help"]).out);
    insta::assert_snapshot!("effects_turning", place.fem(&["effects", "turning"]).out);
    insta::assert_snapshot!("effect_tool_wear", place.fem(&["effects", "tool-wear"]).out);
}

#[test]
fn json_is_one_document_with_the_contracts_keys() {
    let place = Place::new();
    place.write("lathe.toml", model("lathe.toml"));
    let parse = |args: &[&str]| -> serde_json::Value { serde_json::from_str(&place.fem(args).out).unwrap() };
    let run = parse(&["run", "lathe.toml", "--json"]);
    assert_eq!(run["schema"], "fem-run/1");
    assert_eq!(run["findings"]["form"]["form"], "barrel");
    let written: serde_json::Value = serde_json::from_str(&place.read("out/lathe/summary.json")).unwrap();
    assert_eq!(run, written);
    let effects = parse(&["effects", "--json"]);
    let wear = effects.as_array().unwrap().iter().find(|e| e["effect"] == "tool-wear").unwrap();
    assert_eq!(wear["process"], "turning");
    assert_eq!(
        wear["parameters"][2],
        serde_json::json!({ "name": "rate", "unit": "um/km", "neutral": 0.0, "range": [0.5, 50.0], "about": "steady wear per cutting path", "default": null })
    );
    let validation = parse(&["validate", "--json"]);
    assert_eq!(validation["schema"], "fem-validation/1");
    assert_eq!(validation["total"].as_u64(), validation["cases"].as_array().map(|cases| cases.len() as u64));
    let case = &validation["cases"][0];
    for key in ["name", "quantity", "expected", "computed", "unit", "error", "tolerance", "source", "passed"] {
        assert!(!case[key].is_null(), "{key}");
    }
    assert_eq!(parse(&["schema"])["oneOf"][0]["title"], "turning");
}

#[test]
fn completions_know_the_commands() {
    let place = Place::new();
    for shell in ["bash", "zsh", "fish"] {
        let script = place.fem(&["completions", shell]).out;
        assert!(script.contains("validate") && script.contains("effects"), "{shell}");
    }
}

#[test]
fn every_process_has_a_starting_model_that_runs() {
    let place = Place::new();
    for process in fem::processes::ALL {
        let file = format!("{}.toml", process.name());
        assert_eq!(place.fem(&["new", process.name(), "-o", &file]).status, 0);
        let run = place.fem(&["run", &file]);
        assert_eq!((run.status, run.err.as_str()), (0, ""));
        let again = place.fem(&["new", process.name(), "-o", &file]);
        assert_eq!(again.status, 2, "a file that exists is not overwritten");
    }
}

#[test]
fn the_path_of_a_lifted_nose_is_a_conic() {
    let place = Place::new();
    let conic = |effects: &str| -> serde_json::Value {
        let cut = "depth = \"0.5 mm\", feed = \"0.2 mm/rev\", spindle_speed = \"600 rpm\", radial_force = \"0 N\"";
        place.write(
            "model.toml",
            format!(
                "process = \"turning\"\nworkpiece = {{ material = \"steel\", segments = [{{ length = \"500 mm\", \
                 diameter = \"40 mm\" }}] }}\nworkholding = {{ type = \"centres\", guideway_spacing = \"400 mm\" }}\n\
                 cut = {{ {cut} }}\n{effects}"
            ),
        );
        let run: serde_json::Value = serde_json::from_str(&place.fem(&["run", "model.toml", "--json"]).out).unwrap();
        run["findings"]["conic"].clone()
    };
    let (lifted, tapered) = ("effects.guideway-height.slope = \"2 mm/m\"", "effects.guideway-taper.slope = \"1 mm/m\"");
    let both = conic(&format!("{lifted}\n{tapered}"));
    assert_eq!((&both["conic"], &both["i1_unit"]), (&"hyperbola".into(), &"mm^2".into()));
    // A lift that round-off hides leaves the two lines of a cone.
    assert_eq!(conic(&format!("{}\n{tapered}", lifted.replace('2', "1e-5")))["conic"], "lines");
    // Without a lift, and where the guideway is no line, there is nothing to tell.
    assert!(conic(tapered).is_null());
    assert!(conic(&format!("{lifted}\neffects.bed-sag = {{ front = \"40 um\", rear = \"40 um\" }}")).is_null());
}

#[test]
fn the_form_of_a_profile_is_told_by_how_it_turns() {
    let model = |held: &str, segments: &str, rest: &str| {
        format!(
            "process = \"turning\"\nworkpiece = {{ material = \"steel\", segments = [{segments}] }}\nworkholding = {{ {held} }}\ncut = {{ depth = \"0.5 mm\", feed = \"0.2 mm/rev\", spindle_speed = \"600 rpm\", radial_force = \"400 N\" }}\n{rest}"
        )
    };
    let slender = "{ length = \"400 mm\", diameter = \"30 mm\" }";
    let stiff = "{ length = \"300 mm\", diameter = \"120 mm\" }";
    let springs = |head: &str, tail: &str| {
        format!(
            "effects.headstock-compliance.stiffness = \"{head} N/um\"\neffects.tailstock-compliance.stiffness = \"{tail} N/um\""
        )
    };
    let cases = [
        (model("type = \"centres\"", slender, ""), "barrel"),
        (model("type = \"chuck-and-centre\"", slender, ""), "barrel"),
        (model("type = \"centres\"", stiff, &springs("50", "50")), "corset"),
        (model("type = \"centres\"", stiff, &springs("50", "35")), "saddle"),
        (model("type = \"chuck\"", slender, ""), "cone"),
        (
            model(
                "type = \"chuck\"",
                "{ length = \"150 mm\", diameter = \"60 mm\" }, { length = \"100 mm\", diameter = \"20 mm\" }",
                "",
            ),
            "cone",
        ),
        (
            model("type = \"centres\", steady_rests = [{ at = \"200 mm\", stiffness = \"90 N/um\" }]", slender, ""),
            "wavy",
        ),
        (model("type = \"centres\"", slender, "").replace("400 N", "0 N"), "cylinder"),
    ];
    let place = Place::new();
    for (text, word) in cases {
        place.write("model.toml", &text);
        let json: serde_json::Value = serde_json::from_str(&place.fem(&["run", "model.toml", "--json"]).out).unwrap();
        assert_eq!(json["findings"]["form"]["form"], word, "{text}");
    }
}

#[test]
fn a_page_of_very_many_points_stays_light() {
    let place = Place::new();
    let text = model("lathe.toml");
    let lathe: Vec<&str> = text.lines().filter(|line| !line.starts_with("pauses")).collect();
    place.write(
        "m.toml",
        lathe.join("\n").replace("positions = 101", "positions = 40000").replace("parts = 12", "parts = 1"),
    );
    let answer = place.fem(&["report", "m.toml", "-o", "page.html"]);
    assert_eq!(answer.status, 0, "{}", answer.err);
    let page = place.read("page.html");
    assert!(page.len() < 2_000_000, "{} bytes", page.len());
    assert!(page.contains(" of 40000 points tell their values"), "{}", page.len());
}
