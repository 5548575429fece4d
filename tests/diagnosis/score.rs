//! One case: what was said, held against the truth.

use std::time::Instant;

use fem::diagnose::{Cause, Diagnosis, MOST_EFFECTS, Verdict};
use fem::input::Source;
use fem::measure::{Measurements, Reading};
use fem::model::{Data, Model};
use fem::noise::NoiseSource;
use fem::process::Failure;
use fem::progress::Progress;
use generator::{Case, Kind};

/// What a diagnosis got right.
#[derive(Clone, Debug, Default)]
pub struct Score {
    /// The verdict is right, and all hidden effects are named, each in its class, and none besides.
    pub right: bool,
    /// Whether effects of the catalogue are hidden in it.
    pub hides_effects: bool,
    /// No effect of the machine is named.
    pub no_cause: bool,
    /// The first effect that is named, or one of its class, is hidden.
    pub first: bool,
    /// Every hidden effect is named or stands in a class.
    pub all_named: bool,
    /// Sizes of the classes, the named effect included.
    pub classes: Vec<usize>,
    /// Intervals that hold the true value, and intervals.
    pub covered: (usize, usize),
    /// χ²/n of the final prediction against new measurements of the same job, by the true noise.
    pub fresh: f64,
    /// Wall time, s.
    pub seconds: f64,
    /// For people.
    pub said: String,
}

/// The diagnosis of some data: with `FEM_LAWS=1` as users get it, with laws that are in no catalogue, whose search takes longer than
/// a sample may.
pub fn diagnose(data: &Data, most: usize, progress: &Progress) -> Result<Diagnosis, Failure> {
    match std::env::var_os("FEM_LAWS") {
        Some(_) => fem::discover::diagnose(data, most, progress),
        None => fem::diagnose::diagnose(data, most, progress),
    }
}

/// The diagnosis of a case alone, or why there is none: readings may lie so far off that they are refused.
pub fn diagnosis(case: &Case) -> Result<Diagnosis, String> {
    let model = Model::parse(Source::new("case.toml", case.model.clone())).expect("the model is right");
    let source = Source::new("case.csv", case.data.clone());
    let data = Measurements::parse(source, &*model.process).expect("so are the data");
    let data = Data::of(&model, data).map_err(|refused| refused.to_string())?;
    diagnose(&data, MOST_EFFECTS, &Progress::default()).map_err(|failure| failure.to_string())
}

/// Diagnoses a case.
pub fn score(case: &Case) -> Score {
    let model = Model::parse(Source::new("case.toml", case.model.clone())).expect("the model is right");
    let read = |text: &str| {
        Measurements::parse(Source::new("case.csv", text.to_string()), &*model.process).expect("so are the data")
    };
    let (data, fresh) = (read(&case.data), read(&case.fresh));
    let data = Data::of(&model, data).expect("every row lies in the model");
    let start = Instant::now();
    let diagnosis = diagnose(&data, MOST_EFFECTS, &Progress::default());
    let seconds = start.elapsed().as_secs_f64();
    let diagnosis = match diagnosis {
        Ok(diagnosis) => diagnosis,
        Err(failure) => return Score { seconds, said: failure.to_string(), ..Score::default() },
    };
    let hidden: Vec<&str> = case.truth.hidden.iter().map(|h| h.effect).collect();
    let classes: Vec<Vec<&str>> = diagnosis.missing.iter().map(class).collect();
    let all_named = hidden.iter().all(|h| classes.iter().any(|c| c.contains(h)));
    let right = match case.truth.kind {
        Kind::Nothing => diagnosis.verdict == Verdict::Adequate,
        // What no effect of the machine can make may be one of the measurement: a zero of every part.
        Kind::Outside => {
            let remains = matches!(diagnosis.verdict, Verdict::Unexplained | Verdict::PartlyExplained);
            let of_measurement = diagnosis.missing.iter().all(|m| m.cause != Cause::Physical);
            remains || diagnosis.verdict == Verdict::MissingEffect && of_measurement
        }
        Kind::Effects => all_named && classes.len() == hidden.len() && diagnosis.verdict == Verdict::MissingEffect,
    };
    let mut differences: Vec<f64> = fresh.observed.iter().zip(&diagnosis.after.predicted).map(|(y, p)| y - p).collect();
    let blind = model.system.datum_directions(&model.system.resolved(&fresh.rows));
    blind.iter().for_each(|direction| direction.take_out(&mut differences));
    let squares = differences.iter().zip(&case.truth.noise_of_rows).map(|(d, sigma)| (d / sigma).powi(2));
    Score {
        right,
        no_cause: diagnosis.missing.iter().all(|m| m.cause != Cause::Physical),
        hides_effects: case.truth.kind == Kind::Effects,
        first: classes.first().is_some_and(|c| hidden.iter().any(|h| c.contains(h))),
        all_named,
        covered: coverage(case, &diagnosis),
        classes: classes.iter().map(Vec::len).collect(),
        fresh: squares.sum::<f64>() / (fresh.len() - blind.len()) as f64,
        seconds,
        said: said(case, &diagnosis, &hidden, &classes),
    }
}

/// The effect and those that cannot be told from it.
pub fn class(missing: &fem::diagnose::Missing) -> Vec<&str> {
    std::iter::once(&missing.effect).chain(&missing.indistinguishable_from).map(|e| &*e.name).collect()
}

/// Over the parameters of hidden effects that were named themselves.
fn coverage(case: &Case, diagnosis: &Diagnosis) -> (usize, usize) {
    let mut covered = (0, 0);
    for hidden in &case.truth.hidden {
        let Some(missing) = diagnosis.missing.iter().find(|m| m.effect.name == hidden.effect) else { continue };
        for (name, value) in &hidden.parameters {
            let Some(e) = missing.estimates.iter().find(|e| e.parameter.path.ends_with(&format!(".{name}"))) else {
                continue;
            };
            let holds = |value: f64| e.interval.contains(e.parameter.kind.to_si(value));
            // A phase comes round.
            let period = missing.effect.parameters.iter().find(|p| p.name == *name).and_then(|p| p.period);
            covered.0 += usize::from([-1.0, 0.0, 1.0].iter().any(|turns| holds(value + turns * period.unwrap_or(0.0))));
            covered.1 += 1;
        }
    }
    covered
}

fn said(case: &Case, diagnosis: &Diagnosis, hidden: &[&str], classes: &[Vec<&str>]) -> String {
    let source = match diagnosis.noise.source {
        NoiseSource::Column | NoiseSource::Covariance => "u",
        NoiseSource::Repeats => "repeats",
        NoiseSource::Estimated => "neither",
    };
    let lambda: Vec<String> = case.truth.lambda.iter().map(|l| format!("{l:.0}")).collect();
    let apart: Vec<String> = case.truth.apart.iter().map(|l| format!("{l:.0}")).collect();
    format!(
        "{hidden:?}{} at {} (apart {}), noise {source}: {:?} {classes:?}, chi2/dof {:.2} -> {:.2}",
        case.truth.shape,
        lambda.join(" "),
        apart.join(" "),
        diagnosis.verdict,
        diagnosis.before.reduced_chi2,
        diagnosis.after.reduced_chi2,
    )
}

/// Length of the difference between the prediction of the revealed model and what the case was made from,
/// in standard uncertainties.
pub fn apart(case: &Case) -> f64 {
    between(&case.revealed, &case.exact, &case.truth.noise_of_rows)
}

/// Length of the difference between what a model predicts and what was made without noise, in standard
/// uncertainties of the rows.
pub fn between(model: &str, exact: &str, noise_of_rows: &[f64]) -> f64 {
    let model = Model::parse(Source::new("revealed.toml", model.to_string())).expect("the model is right");
    let exact = Source::new("exact.csv", exact.to_string());
    // Repeats that have no noise would be copies.
    let mut said = Reading::default();
    said.as_typed = true;
    let exact = Measurements::parse_as(exact, &*model.process, &said).expect("so are the data");
    let rows = model.system.resolved(&exact.rows);
    let predicted = model.forward().observe(&rows).expect("the model can be computed");
    let mut differences: Vec<f64> = predicted.iter().zip(&exact.observed).map(|(p, e)| p - e).collect();
    model.system.datum_directions(&rows).iter().for_each(|direction| direction.take_out(&mut differences));
    let squares = differences.iter().zip(noise_of_rows).map(|(d, sigma)| (d / sigma).powi(2));
    squares.sum::<f64>().sqrt()
}
