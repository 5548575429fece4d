//! Models against measurements whose truth is known. The measurements were made by code that shares nothing
//! with the program: closed forms and quadrature, with seeded noise.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod clothes;
mod compare;
mod diagnose;
mod fit;
mod import;
mod instrument;
mod instruments;
mod limits;
mod noise;
mod real;
mod relations;
mod slips;

use std::path::{Path, PathBuf};

use fem::input::Source;
use fem::measure::Measurements;
use fem::model::{Data, Model};
use serde_json::Value as Json;

/// A case with a hidden effect.
struct Hidden {
    model: Model,
    measurements: Measurements,
    truth: Json,
}

impl Hidden {
    fn data(&self) -> Data<'_> {
        Data::of(&self.model, self.measurements.clone()).unwrap()
    }
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/hidden")
}

fn truths() -> Vec<(String, Json)> {
    let all: Json = serde_json::from_str(&std::fs::read_to_string(folder().join("truth.json")).unwrap()).unwrap();
    all.as_object().unwrap().iter().map(|(k, v)| (k.clone(), v.clone())).collect()
}

/// The case with the hidden effects added to its model, their parameters unknown.
fn case_with_effects(name: &str, truth: &Json) -> Hidden {
    let directory = folder().join(name);
    let mut text = std::fs::read_to_string(directory.join("model.toml")).unwrap();
    for (effect, parameters) in truth["hidden"].as_object().unwrap() {
        text.push_str(&format!("\n[effects.{effect}]\n"));
        for (key, value) in parameters.as_object().unwrap() {
            text.push_str(&format!("{key} = \"? {}\"\n", value["unit"].as_str().unwrap()).replace("? \"", "?\""));
        }
    }
    let model = Model::parse(Source::new("model.toml", text)).unwrap();
    let measurements = Measurements::load(&directory.join("measured.csv"), &*model.process).unwrap();
    Hidden { model, measurements, truth: truth.clone() }
}

fn case(name: &str) -> (Model, Measurements) {
    let directory = folder().join(name);
    let model = Model::load(&directory.join("model.toml")).unwrap();
    let measurements = Measurements::load(&directory.join("measured.csv"), &*model.process).unwrap();
    (model, measurements)
}
