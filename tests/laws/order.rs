//! The order in which rows stand in a file changes neither a comparison nor a fit, nor what a diagnosis plainly sees.
//! (Beyond that a diagnosis may look at it: it is the order in which they were measured, in which noise is correlated
//! and a gauge jumps.)

use fem::compare::compare;
use fem::diagnose::{Diagnosis, Missing};
use fem::discover::diagnose;
use fem::fit::fit;
use fem::measure::Measurements;
use fem::model::{Data, Model};
use fem::process::{Rows, Values};
use fem::progress::Progress;
use proptest::prelude::*;

/// A process, a quantity of its starting model as it stands there, the same unknown, and what it truly is.
const CASES: [[&str; 4]; 9] = [
    ["turning", "stiffness = \"60 N/um\"", "stiffness = \"? N/um\"", "stiffness = \"25 N/um\""],
    ["ring", "arc = \"10 deg\"", "arc = \"? deg\"", "arc = \"30 deg\""],
    ["fixture", "c = \"0.2 um/N^n\"", "c = \"? um/N^n\"", "c = \"0.3 um/N^n\""],
    ["thermal", "coefficient = \"15 W/m^2/K\"", "coefficient = \"? W/m^2/K\"", "coefficient = \"28 W/m^2/K\""],
    ["axis", "gap = \"8 um\"", "gap = \"? um\"", "gap = \"14 um\""],
    ["rotary", "gap = \"15 arcsec\"", "gap = \"? arcsec\"", "gap = \"32 arcsec\""],
    ["contour", "gap = \"6 um\"", "gap = \"? um\"", "gap = \"11 um\""],
    ["cam", "loss = \"5 um\"", "loss = \"? um\"", "loss = \"400 um\""],
    ["stiffness", "gap = \"3 um\"", "gap = \"? um\"", "gap = \"5 um\""],
];

/// Rows that are measured.
const ROWS: usize = 60;

/// Noise of every row, in standard uncertainties.
fn noise() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(-1.7f64..1.7, ROWS)
}

/// Rows in their order, and in another.
fn orders() -> impl Strategy<Value = (Vec<usize>, Vec<usize>)> {
    let sorted: Vec<usize> = (0..ROWS).collect();
    (Just(sorted.clone()), Just(sorted).prop_shuffle())
}

/// What was measured of a model, with noise of a hundredth of its spread, in an order.
fn measured<'m>(model: &'m Model, truth: &Model, noise: &[f64], order: &[usize]) -> Data<'m> {
    let all = model.system.programme();
    let step = all.len().div_ceil(ROWS) | 1;
    let rows: Rows = all.some(&(0..all.len()).step_by(step).collect::<Vec<_>>());
    let observable = rows.observable[0];
    let rows = rows.some(&(0..rows.len()).filter(|row| rows.observable[*row] == observable).collect::<Vec<_>>());
    let exact = truth.forward().observe(&rows).unwrap();
    let ends = exact.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(*v), high.max(*v)));
    let sigma = 0.01 * (ends.1 - ends.0);
    let own: Vec<usize> = order.iter().copied().filter(|row| *row < rows.len()).collect();
    let observed = own.iter().map(|row| exact[*row] + sigma * noise[*row]).collect();
    let planned = Measurements::planned(&*model.process, "rows", rows.some(&own));
    Data::of(model, Measurements { observed, uncertainty: Some(Values::shared(sigma, own.len())), ..planned }).unwrap()
}

/// A model all of whose values are known: its guesses without what is written after `+-`.
fn known(text: &str) -> String {
    let part = |(i, part): (usize, &str)| match part.split_once(" +- ") {
        Some((value, rest)) if i % 2 == 1 => match rest.split_once(' ') {
            Some((_, unit)) => format!("{value} {unit}"),
            None => value.to_string(),
        },
        _ => part.to_string(),
    };
    let text: String = text.lines().filter(|line| !line.starts_with('#')).map(|line| format!("{line}\n")).collect();
    text.split('"').enumerate().map(part).collect::<Vec<_>>().join("\"")
}

fn parsed([name, written, ..]: &[&str; 4], other: &str) -> Model {
    let start = known(super::starting(name));
    assert!(start.contains(written), "{name}");
    super::model(&start.replacen(written, other, 1))
}

proptest! {
    #![proptest_config(super::random(16))]

    #[test]
    fn comparisons_and_fits_know_no_order(noise in noise(), (sorted, order) in orders()) {
        for case in &CASES {
            let [asked, truth] = [2, 3].map(|which| parsed(case, case[which]));
            let told = parsed(case, case[1]);
            let [one, other] = [&sorted, &order].map(|order| compare(&measured(&told, &truth, &noise, order)).unwrap());
            prop_assert!((one.rms / other.rms - 1.0).abs() < 1e-9, "{}", case[0]);
            prop_assert!((one.reduced_chi2 / other.reduced_chi2 - 1.0).abs() < 1e-8, "{}", case[0]);
            prop_assert_eq!(one.adequacy(), other.adequacy());
            let [one, other] = [&sorted, &order].map(|order| fit(&measured(&asked, &truth, &noise, order)).unwrap());
            let (a, b) = (&one.estimates[0], &other.estimates[0]);
            // A search ends at a hundredth of a standard uncertainty.
            prop_assert!((a.value - b.value).abs() <= 0.01 * a.std, "{}: {} and {} +- {}", case[0], a.value, b.value, a.std);
        }
    }
}

/// What a diagnosis names, each with what is as likely in its place.
fn classes(diagnosis: &Diagnosis) -> Vec<Vec<&str>> {
    fn class(missing: &Missing) -> Vec<&str> {
        let mut all: Vec<&str> = missing.indistinguishable_from.iter().map(|effect| &*effect.name).collect();
        all.push(&missing.effect.name);
        all.sort_unstable();
        all
    }
    diagnosis.missing.iter().map(class).collect()
}

/// A process, and an effect that its starting model lacks. Nothing that is the same in every row, for that
/// is known by when it was measured.
const MISSING: [[&str; 2]; 3] = [
    ["turning", "[effects.tool-wear]\nrate = \"8 um/km\"\n"],
    ["ring", "[effects.spindle-error]\namplitude = \"20 um\"\nphase = \"40 deg\"\n"],
    ["axis", "[effects.worn-screw]\ndepth = \"20 um\"\n"],
];

proptest! {
    #![proptest_config(super::random(1))]

    /// Where one effect of the machine is missing by far and the noise is white, a diagnosis comes to the
    /// same end in any order of rows.
    #[test]
    fn what_is_plainly_missing_is_named_in_any_order(noise in noise(), (sorted, order) in orders()) {
        for [name, effect] in &MISSING {
            let start = super::starting(name);
            let (told, truth) = (super::model(start), super::model(&format!("{start}\n{effect}")));
            let [one, other] = [&sorted, &order].map(|order| {
                diagnose(&measured(&told, &truth, &noise, order), 2, &Progress::default()).unwrap()
            });
            prop_assert_eq!(one.verdict, other.verdict, "{}", name);
            let (classes, others) = (classes(&one), classes(&other));
            prop_assert_eq!(&classes, &others, "{}", name);
            let is_named = classes.iter().flatten().any(|named| effect.contains(&format!("[effects.{named}]")));
            prop_assert!(is_named, "{classes:?} for {effect}");
            // A hundredth of a standard uncertainty raises the sum of squares by 1e-4, and that is of some
            // tens.
            prop_assert!((one.after.reduced_chi2 / other.after.reduced_chi2 - 1.0).abs() < 1e-4, "{}", name);
        }
    }
}
