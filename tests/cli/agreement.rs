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

/// Part of a noise by which values that are written to five digits move it.
const WRITTEN: f64 = 0.01;

/// The rows of a file without its uncertainties.
fn without_u(rows: &str) -> String {
    let head: Vec<&str> = rows.lines().next().unwrap().split(',').collect();
    let is_kept = |i: &usize| !(head[*i].starts_with("u ") || head[*i].starts_with("u_"));
    let line = |line: &str| {
        let cells: Vec<&str> = line.split(',').collect();
        (0..cells.len()).filter(is_kept).map(|i| cells[i]).collect::<Vec<_>>().join(",") + "\n"
    };
    rows.lines().map(line).collect()
}

/// Noise, error and chi2 of a model are the same in every command, wherever the noise comes from; and where one says that the
/// model fails none says that it does not.
#[test]
fn all_commands_tell_one_noise_and_one_error() {
    let (mut with_fit, mut all) = (0, 0);
    for case in cases().into_iter().filter(|case| case.parent().unwrap().ends_with("hidden")) {
        let place = Place::new();
        place.write("model.toml", std::fs::read(case.join("model.toml")).unwrap());
        let rows = std::fs::read_to_string(case.join("measured.csv")).unwrap();
        let few = |rows: &str| rows.lines().take(9).map(|line| format!("{line}\n")).collect::<String>();
        for (name, rows) in
            [("as it is", rows.clone()), ("without u", without_u(&rows)), ("eight rows", few(&without_u(&rows)))]
        {
            place.write("measured.csv", rows);
            let told = |command: &str| place.fem(&[command, "model.toml", "--with", "measured.csv", "--json"]);
            let found: Json = serde_json::from_str(&told("diagnose").out).unwrap();
            // What a model leaves open is fitted first.
            let fitted = told("fit");
            let (model, noise): (Json, Json) = if fitted.status == 0 {
                with_fit += 1;
                let fit: Json = serde_json::from_str(&fitted.out).unwrap();
                (fit.clone(), fit["noise"].clone())
            } else {
                let comparison: Json = serde_json::from_str(&told("compare").out).unwrap();
                (comparison["models"][0].clone(), comparison["noise"].clone())
            };
            let case = format!("{}, {name}", case.display());
            assert_eq!(found["noise"]["source"], noise["source"], "{case}");
            let pairs = [
                (&found["noise"]["sigma"], &noise["sigma"]),
                (&found["before"]["rms"], &model["rms"]),
                (&found["before"]["chi2_per_dof"], &model["chi2_per_dof"]),
            ];
            for (own, other) in pairs.map(|(own, other)| (own.as_f64().unwrap(), other.as_f64().unwrap())) {
                // Two searches come to rest in one minimum.
                assert!((own - other).abs() < 1e-3 * other, "{case}: {own} and {other}");
            }
            all += 1;
            match model["adequate"].as_bool() {
                Some(true) => assert_eq!(found["verdict"], "adequate", "{case}"),
                Some(false) => assert_ne!(found["verdict"], "adequate", "{case}"),
                None => assert!(
                    found["missing"].as_array().unwrap().iter().all(|m| m["probability"].as_f64() < Some(0.9)),
                    "{case}"
                ),
            }
        }
    }
    assert!(all >= 18 && with_fit >= 6, "{all} {with_fit}");
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
        let [told, found] =
            [&diagnosis["after"]["sigma"], &comparison["noise"]["sigma"]].map(|own| own.as_f64().unwrap());
        // Beside effects of the measurement a diagnosis estimates the level free of what was fitted, a comparison of all that is left.
        let is_alone = comparison["measurement"].as_array().unwrap().is_empty();
        assert!(!is_alone || (told / found - 1.0).abs() < WRITTEN, "{}: noise {told} and {found}", case.display());
        if diagnosis["after"]["verdict"] == "adequate" {
            complete += 1;
            assert_ne!(comparison["models"][0]["adequate"], false, "{}", case.display());
        }
    }
    assert!(complete >= 8, "{complete}");
}
