//! Two commands never contradict each other.

use std::path::{Path, PathBuf};

use serde_json::Value as Json;

use crate::fem::Place;

/// Folders with a model and measurements: real ones, and every fifth of those with a hidden effect.
fn cases() -> Vec<PathBuf> {
    let of = |folder: &str| {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(folder);
        let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        let mut all: Vec<PathBuf> = entries.filter(|path| path.join("model.toml").exists()).collect();
        all.sort();
        all
    };
    // Three take a good part of a minute each.
    let long = ["bar-albar", "motor", "axis-b02"];
    let real = of("real").into_iter().filter(|case| !long.iter().any(|own| case.ends_with(own)));
    real.chain(of("hidden").into_iter().step_by(5)).collect()
}

/// A diagnosis says that nothing is missing in the model that it writes: `compare` finds nothing missing there.
#[test]
fn what_a_diagnosis_calls_complete_compare_calls_adequate() {
    let mut complete = 0;
    for case in cases() {
        let place = Place::new();
        for file in ["model.toml", "measured.csv"] {
            place.write(file, std::fs::read(case.join(file)).unwrap());
        }
        let json = |args: &[&str]| -> Json { serde_json::from_str(&place.fem(args).out).unwrap() };
        let data = ["--with", "measured.csv", "--json"];
        let diagnosis = json(&[&["diagnose", "model.toml", "--add-to", "better.toml"][..], &data[..]].concat());
        let compared = place.fem(&[&["compare", "better.toml"][..], &data[..]].concat());
        if compared.err.contains("is unknown (`?`)") {
            // What the data leave open stays open, and nothing can be compared with it.
            continue;
        }
        let comparison: Json = serde_json::from_str(&compared.out).unwrap();
        if diagnosis["after"]["verdict"] == "adequate" {
            complete += 1;
            assert_ne!(comparison["models"][0]["adequate"], false, "{}", case.display());
        }
    }
    assert!(complete >= 8, "{complete}");
}
