//! Events of a batch that nobody wrote down: named, and placed between the right parts.

use fem::diagnose::{Diagnosis, MOST_EFFECTS, Missing, diagnose};
use fem::input::Source;
use fem::measure::Measurements;
use fem::model::{Data, Model};
use fem::progress::Progress;
use generator::turning::corrected::{self, CORRECTION};
use generator::{Case, TURNING};

use crate::score;

/// The effect that is sought.
const EFFECT: &str = "offset-correction";

/// What was found of a correction.
#[derive(Default, Debug)]
struct Found {
    cases: usize,
    /// It is named, or stands in the class of what is.
    in_class: usize,
    /// It is named, and placed within one part.
    placed: usize,
    /// Nothing but its class is named.
    alone: usize,
}

fn parameter(missing: &Missing, name: &str) -> f64 {
    let own = missing.estimates.iter().find(|e| e.parameter.path.ends_with(&format!(".{name}"))).unwrap();
    own.parameter.kind.from_si(own.value)
}

/// How far from the truth a correction is placed, in parts; `None` where it is not named.
fn misplaced(diagnosis: &Diagnosis, after: f64) -> Option<f64> {
    let own = diagnosis.missing.iter().find(|missing| missing.effect.name == EFFECT)?;
    Some((parameter(own, "after") - after).abs())
}

fn count(lambda: f64, seeds: impl Iterator<Item = u64>) -> Found {
    let mut found = Found::default();
    let mut of = |case: &Case, seed: u64| {
        let diagnosis = score::diagnosis(case).unwrap();
        let after = case.truth.hidden[0].parameters[0].1;
        let classes: Vec<Vec<&str>> = diagnosis.missing.iter().map(score::class).collect();
        let [in_class, placed, alone] = [
            classes.iter().any(|class| class.contains(&EFFECT)),
            misplaced(&diagnosis, after).is_some_and(|off| off <= 1.0),
            classes.len() == 1,
        ];
        found.cases += 1;
        found.in_class += usize::from(in_class);
        found.placed += usize::from(placed);
        found.alone += usize::from(alone);
        if !(in_class && placed && alone) {
            println!("λ {lambda} {seed}: after {after}, off by {:?}, {classes:?}", misplaced(&diagnosis, after));
        }
    };
    seeds
        .filter_map(|seed| Some((TURNING.single(EFFECT, lambda, seed)?, seed)))
        .for_each(|(case, seed)| of(&case, seed));
    found
}

/// At the rate that is asked for, nine of ten, fewer than five of eight would be chance in one seed of five hundred.
#[test]
fn a_correction_is_named_between_the_right_parts() {
    let found = count(15.0, 0..8);
    assert!(found.cases == 8 && found.placed >= 5 && found.in_class >= 5, "{found:?}");
}

#[test]
#[ignore = "minutes long; prints the rates of README.md"]
fn the_whole_of_corrections() {
    for lambda in [8.0, 15.0, 40.0] {
        println!("λ = {lambda}: {:?}", count(lambda, (1000..1060).step_by(crate::every())));
    }
}

/// A machine whose springs and guideways are known, whose edge wears, and in whose batch the offset was corrected: both
/// are named, the correction where it was and as large as it was, and nothing else of the machine.
#[test]
fn a_correction_does_not_hide_the_wear_of_a_whole_machine() {
    for seed in 0..3 {
        let (model, data) = corrected::files(seed);
        let model = Model::parse(Source::new("corrected.toml", model)).unwrap();
        let data = Measurements::parse(Source::new("corrected.csv", data), &*model.process).unwrap();
        let data = Data::of(&model, data).unwrap();
        let diagnosis = diagnose(&data, MOST_EFFECTS, &Progress::default()).unwrap();
        let mut classes: Vec<Vec<&str>> = diagnosis.missing.iter().map(score::class).collect();
        classes.sort();
        assert_eq!(misplaced(&diagnosis, CORRECTION.0 as f64), Some(0.0), "{seed}: {classes:?}");
        assert!(classes.len() == 2 && classes.iter().any(|class| class.contains(&"tool-wear")), "{seed}: {classes:?}");
        let own = diagnosis.missing.iter().find(|missing| missing.effect.name == EFFECT).unwrap();
        let diameter = own.estimates.iter().find(|e| e.parameter.path.ends_with(".diameter")).unwrap();
        let (low, high) = (diameter.interval.low.unwrap(), diameter.interval.high.unwrap());
        // Three standard uncertainties: one seed of a hundred would leave them by chance.
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low) * 3.0 / 1.96);
        assert!((1e-6 * CORRECTION.1 - middle).abs() < half, "{seed}: {low:e} to {high:e}");
    }
}
