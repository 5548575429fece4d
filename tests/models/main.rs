//! Every model that comes with the program runs and gives the number that its header states.

#![allow(clippy::unwrap_used, clippy::expect_used)]

use std::path::Path;

use fem::model::Model;
use fem::progress::Progress;

/// `# Largest diameter error: +173.587 um`, in the first lines of the file.
fn stated(text: &str) -> Option<(String, f64)> {
    let line = text.lines().take(5).find_map(|l| l.strip_prefix("# Largest "))?;
    let (what, value) = line.split_once(": ")?;
    Some((what.to_string(), value.split(' ').next()?.parse().ok()?))
}

#[test]
fn every_model_gives_the_number_of_its_header() {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("models");
    let mut models = 0;
    for entry in std::fs::read_dir(directory).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|e| e != "toml") {
            continue;
        }
        let model = Model::load(&path).unwrap_or_else(|e| panic!("{e}"));
        let (what, value) = stated(&model.source.text).unwrap_or_else(|| panic!("{} states no number", path.display()));
        let run = model.run(&Progress::default()).unwrap();
        let largest = run.outcome.findings.iter().find(|f| f.key == "largest").unwrap();
        let computed = largest.json["value"].as_f64().unwrap();
        assert!((computed - value).abs() < 6e-4, "{}: {what} is {computed}, stated {value}", path.display());
        models += 1;
    }
    assert!(models >= 3);
}
