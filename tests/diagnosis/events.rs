//! Events of a batch that nobody wrote down: named, and placed between the right parts.

use fem::diagnose::{Diagnosis, MOST_EFFECTS, Missing};
use fem::discover::diagnose;
use fem::input::Source;
use fem::measure::Measurements;
use fem::model::{Data, Model};
use fem::progress::Progress;
use generator::turning::changed;
use generator::turning::corrected::{self, CORRECTION};
use generator::{NoiseKind, TURNING, Trouble};

use crate::score;

/// A correction of the offset.
const CORRECTED: &str = "offset-correction";

/// What was found of an event.
#[derive(Default, Debug)]
struct Found {
    cases: usize,
    /// It is named, or stands in the class of what is.
    in_class: usize,
    /// It, or an event in whose class it stands, is named, and placed within one part.
    placed: usize,
    /// Nothing but its class is named.
    alone: usize,
}

impl Found {
    /// Counts a diagnosis of a case in which something happened after a part, and tells of it where it is not right.
    fn count(&mut self, diagnosis: &Diagnosis, (effect, after): (&str, f64), case: &str) {
        let classes: Vec<Vec<&str>> = diagnosis.missing.iter().map(score::class).collect();
        let misplaced = misplaced(diagnosis, effect, after);
        let [in_class, placed, alone] = [
            classes.iter().any(|class| class.contains(&effect)),
            misplaced.is_some_and(|off| off <= 1.0),
            classes.len() == 1,
        ];
        self.cases += 1;
        self.in_class += usize::from(in_class);
        self.placed += usize::from(placed);
        self.alone += usize::from(alone);
        if !(in_class && placed && alone) {
            println!("{case}: {effect} after {after}, off by {misplaced:?}, {classes:?}");
        }
    }
}

fn parameter(missing: &Missing, name: &str) -> f64 {
    let own = missing.estimates.iter().find(|e| e.parameter.path.ends_with(&format!(".{name}"))).unwrap();
    own.parameter.kind.from_si(own.value)
}

/// How far from the truth an event is placed, in parts: where it is named, or another event in whose class it stands;
/// `None` where neither is.
fn misplaced(diagnosis: &Diagnosis, effect: &str, after: f64) -> Option<f64> {
    let named = diagnosis.missing.iter().find(|missing| missing.effect.name == effect);
    let is_like = |missing: &&Missing| missing.effect.is_step() && score::class(missing).contains(&effect);
    let own = named.or_else(|| diagnosis.missing.iter().find(is_like))?;
    Some((parameter(own, "after") - after).abs())
}

/// Counts effects of the catalogue that are events.
fn count(effect: &str, lambda: f64, seeds: impl Iterator<Item = u64>) -> Found {
    let mut found = Found::default();
    let cases = seeds.filter_map(|seed| Some((TURNING.single(effect, lambda, seed)?, seed)));
    cases.for_each(|(case, seed)| {
        let after = case.truth.hidden[0].parameters[0].1;
        let diagnosis = score::diagnosis(&case).unwrap();
        found.count(&diagnosis, (effect, after), &format!("λ {lambda} {seed}"));
    });
    found
}

/// Diagnoses a model with measurements.
fn diagnosed(model: String, data: String) -> Diagnosis {
    let model = Model::parse(Source::new("events.toml", model)).unwrap();
    let data = Measurements::parse(Source::new("events.csv", data), &*model.process).unwrap();
    diagnose(&Data::of(&model, data).unwrap(), MOST_EFFECTS, &Progress::default()).unwrap()
}

/// Counts springs that changed between two parts.
fn count_changed(lambda: f64, seeds: impl Iterator<Item = u64>) -> Found {
    let mut found = Found::default();
    for (case, seed) in seeds.filter_map(|seed| Some((changed::case(lambda, seed)?, seed))) {
        let effect = format!("{}.changed", case.effect);
        let [before, behind] = case.stiffness;
        let name = format!("λ {lambda} {seed}, {before:.1} to {behind:.1} N/um");
        keep(&format!("changed {lambda} {seed}"), &case.model, &case.data);
        found.count(&diagnosed(case.model, case.data), (&effect, case.after as f64), &name);
    }
    found
}

/// At the rate that is asked for, nine of ten, fewer than three of five would be chance in one seed of a hundred.
#[test]
fn a_correction_is_named_between_the_right_parts() {
    let found = count(CORRECTED, 15.0, 0..5);
    assert!(found.cases == 5 && found.placed >= 3 && found.in_class >= 3, "{found:?}");
}

/// The same of a spring that changed.
#[test]
fn a_changed_stiffness_is_named_between_the_right_parts() {
    let found = count_changed(15.0, 0..5);
    assert!(found.cases == 5 && found.placed >= 3 && found.in_class >= 3, "{found:?}");
}

#[test]
#[ignore = "minutes long; prints the rates of README.md"]
fn the_whole_of_corrections() {
    for lambda in [8.0, 15.0, 40.0] {
        println!("λ = {lambda}: {:?}", count(CORRECTED, lambda, (1000..1060).step_by(crate::every())));
    }
}

#[test]
#[ignore = "minutes long; prints the rates of README.md"]
fn the_whole_of_changes() {
    for lambda in [8.0, 15.0, 40.0] {
        println!("λ = {lambda}: {:?}", count_changed(lambda, (1000..1060).step_by(crate::every())));
    }
}

/// A machine whose springs and guideways are known, whose edge wears, and in whose batch the offset was corrected: both
/// are named, the correction where it was and as large as it was, and nothing else of the machine.
#[test]
fn a_correction_does_not_hide_the_wear_of_a_whole_machine() {
    for seed in 0..3 {
        let (model, data) = corrected::files(seed);
        let diagnosis = diagnosed(model, data);
        let mut classes: Vec<Vec<&str>> = diagnosis.missing.iter().map(score::class).collect();
        classes.sort();
        assert_eq!(misplaced(&diagnosis, CORRECTED, CORRECTION.0 as f64), Some(0.0), "{seed}: {classes:?}");
        assert!(classes.len() == 2 && classes.iter().any(|class| class.contains(&"tool-wear")), "{seed}: {classes:?}");
        let own = diagnosis.missing.iter().find(|missing| missing.effect.name == CORRECTED).unwrap();
        let diameter = own.estimates.iter().find(|e| e.parameter.path.ends_with(".diameter")).unwrap();
        let (low, high) = (diameter.interval.low.unwrap(), diameter.interval.high.unwrap());
        // Three standard uncertainties: one seed of a hundred would leave them by chance.
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low) * 3.0 / 1.96);
        assert!((1e-6 * CORRECTION.1 - middle).abs() < half, "{seed}: {low:e} to {high:e}");
    }
}

/// Counts shafts that were measured with a step of the instrument and with nothing missing: all of them, and those in
/// which a step is named or stands in the class of what is.
fn count_steps(seeds: impl Iterator<Item = u64>) -> [usize; 2] {
    let cases = seeds.map(|seed| (TURNING.nothing_but(Some(Trouble::Step), seed), seed));
    let told = cases.filter(|(case, _)| case.truth.noise == NoiseKind::Column).map(|(case, seed)| {
        let diagnosis = score::diagnosis(&case).unwrap();
        let classes: Vec<Vec<&str>> = diagnosis.missing.iter().map(score::class).collect();
        let is_told = classes.iter().any(|class| class.contains(&"jump"));
        if !is_told {
            println!("step {seed}: {classes:?}");
            keep(&format!("step {seed}"), &case.model, &case.data);
        }
        usize::from(is_told)
    });
    told.fold([0, 0], |[all, some], told| [all + 1, some + told])
}

#[test]
#[ignore = "minutes long; prints the rate of README.md"]
fn the_whole_of_steps() {
    let [all, told] = count_steps((1000..1060).step_by(crate::every()));
    println!("a step of the instrument: told in {told} of {all}");
}

/// Keeps a case that went wrong, where `FEM_MISSES` says so.
fn keep(name: &str, model: &str, data: &str) {
    let Some(directory) = std::env::var_os("FEM_MISSES") else { return };
    let folder = std::path::Path::new(&directory).join(name);
    std::fs::create_dir_all(&folder).unwrap();
    std::fs::write(folder.join("model.toml"), model).unwrap();
    std::fs::write(folder.join("data.csv"), data).unwrap();
}
