//! Laws of mechanics, of heat and of measurement that no process may break, over random systems: equilibrium, reciprocity,
//! balance of energy, symmetry, superposition and similarity, and that neither the units of a file nor the order of its
//! rows change anything.
//!
//! Every law holds exactly in the equations that are solved, so that only round-off stands between both sides: of a
//! solve with a few hundred unknowns some 1e-10 of the largest value. Where a sum of two nonlinear solves or a search
//! stands between, its own tolerance is named there.
//!
//! Some laws say nothing of some processes:
//!
//! | law | of |
//! |---|---|
//! | equilibrium, reciprocity | an axis, a rotary axis, a contour and a cam are geometry and time: no force acts but a given one |
//! | equilibrium | a ring reports no force but that of its jaws, which is given; `plane` holds the elements under it |
//! | reciprocity | a joint has one place; a ring is pressed outside and measured inside, and `plane` holds its elements |
//! | superposition | contours, cams and joints are not linear: play, the reach of a wheel, contacts |
//! | symmetry | the rigid chuck of a lathe has no image |
//! | balance of energy | only bodies that are heated and joints that are unloaded keep an account of it |

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod axis;
mod cam;
mod contour;
mod fixture;
mod order;
mod plane;
mod plate;
mod ring;
mod rotary;
mod stiffness;
mod thermal;
mod turning;
mod units;

use fem::input::Source;
use fem::model::Model;
use fem::process::{Absent, Datum, Rows, Values};
use fem::processes::ALL;
use fem::progress::Progress;
use proptest::prelude::*;
use proptest::test_runner::RngSeed;

/// Round-off of a solve, relative to the largest value.
const ROUND_OFF: f64 = 1e-9;

/// So many random systems, the same ones in every run.
fn random(cases: u32) -> ProptestConfig {
    ProptestConfig { cases, failure_persistence: None, rng_seed: RngSeed::Fixed(2026), ..ProptestConfig::default() }
}

/// The model of a text.
fn model(text: &str) -> Model {
    Model::parse(Source::new("model.toml", text)).unwrap_or_else(|error| panic!("{:?}\n{text}", error.problems))
}

/// The model to start from of a process.
fn starting(name: &str) -> &'static str {
    ALL.iter().find(|process| process.name() == name).unwrap().starting_model()
}

/// What rows at these coordinates (SI) would show: a column of each that varies, the others as they are if left out.
fn observed(model: &Model, observable: &str, given: &[(&str, &[f64])]) -> Vec<f64> {
    let number = model.process.observables().iter().position(|o| o.name == observable).unwrap();
    let count = given[0].1.len();
    let column = |coordinate: &fem::process::Coordinate| -> Values {
        let own = given.iter().find(|(name, _)| *name == coordinate.name);
        match (own, coordinate.absent) {
            (Some((_, values)), _) => values.to_vec().into(),
            (None, Absent::Value(value)) => Values::shared(value, count),
            (None, _) => Values::shared(f64::NAN, count),
        }
    };
    let rows = Rows::new(model.process.coordinates().iter().map(column), vec![number; count]);
    model.forward().observe(&rows).unwrap()
}

/// A quantity (SI) of a figure that a run reports.
fn reported(model: &Model, key: &str, name: &str) -> f64 {
    let report = model.run(&Progress::default()).unwrap().report;
    let figure = report.figures.iter().find(|figure| figure.key == key).unwrap_or_else(|| panic!("no figure {key}"));
    match figure.entries.iter().find(|(entry, _)| entry == name) {
        Some((_, Datum::Quantity(_, si))) => *si,
        other => panic!("{key}.{name}: {other:?}"),
    }
}

/// Whether values agree to a part of the largest of them.
fn alike(a: &[f64], b: &[f64], tolerance: f64) -> Result<(), TestCaseError> {
    let largest = a.iter().chain(b).fold(0.0f64, |most, value| most.max(value.abs()));
    prop_assert_eq!(a.len(), b.len());
    for (row, (one, other)) in a.iter().zip(b).enumerate() {
        prop_assert!(
            (one - other).abs() <= tolerance * largest,
            "row {row}: {one:e} and {other:e}, the largest {largest:e}"
        );
    }
    Ok(())
}

/// Sums of values, row by row.
fn sum(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a + b).collect()
}

/// Values times a factor.
fn times(factor: f64, values: &[f64]) -> Vec<f64> {
    values.iter().map(|value| factor * value).collect()
}
