//! One job of a study.

use std::path::{Path, PathBuf};

use super::plan::{Offered, StudyPlan, Task};
use super::summary::{Cell, Row};
use crate::diagnose::MOST_EFFECTS;
use crate::discover::diagnose;
use crate::fit::{Fit, fit};
use crate::input::InputError;
use crate::measure::{Measurements, Reading};
use crate::model::{Data, Model};
use crate::process::{Datum, Failure, Figure, RunReport};
use crate::progress::Progress;

/// Names of results of fits and diagnoses beside the estimates.
const OF_FIT: &[&str] = &["chi2_per_dof", "p_value"];
const OF_DIAGNOSIS: &[(&str, bool)] =
    &[("verdict", true), ("missing", true), ("chi2_per_dof_before", false), ("chi2_per_dof_after", false)];

impl StudyPlan {
    /// Does job number `number`, counted from 0. Whatever goes wrong in it stands in its row.
    #[doc(hidden)]
    pub fn job(&self, number: u64) -> Row {
        let (inputs, file) = self.point(number);
        let data = file.map(|file| file.strip_prefix(self.file.folder()).unwrap_or(file).display().to_string());
        let computed = self.compute(&inputs, file);
        let (results, error) = match computed {
            Ok(results) => (results, String::new()),
            Err(message) => (vec![Cell::Empty; self.results.len()], message),
        };
        Row { job: number + 1, inputs, data, results, error }
    }

    fn compute(&self, inputs: &[f64], file: Option<&PathBuf>) -> Result<Vec<Cell>, String> {
        let mut values = Vec::with_capacity(inputs.len());
        for (input, told) in self.inputs.iter().zip(inputs) {
            let si = input.kind.to_si(*told);
            if !input.bounds.admits(si) {
                return Err(format!("{} cannot be {}", input.path, input.kind.format(si)));
            }
            values.push((&*input.path, si));
        }
        let failed = |failure: Failure| failure.message;
        let model = self.model.with_values(&values).map_err(failed)?;
        match (self.task, file) {
            (Task::Run, _) => {
                let report = model.report(&Progress::default()).map_err(failed)?;
                Ok(self.results.iter().map(|result| cell(&report, &result.offered.name)).collect())
            }
            (task, Some(file)) => self.measured(task, &model, file),
            (_, None) => Err("there are no measurements".into()),
        }
    }

    fn measured(&self, task: Task, model: &Model, file: &Path) -> Result<Vec<Cell>, String> {
        let wrong = |error: InputError| error.problems.first().map_or_else(String::new, |p| p.message.clone());
        let failed = |failure: Failure| failure.message;
        let read = Measurements::load_all(&[file.to_path_buf()], &*model.process, &Reading::default(), false);
        let data = Data::of(model, read.map_err(wrong)?).map_err(wrong)?;
        let names = self.results.iter().map(|result| result.offered.name.as_str());
        if task == Task::Fit {
            let fit = fit(&data).map_err(failed)?;
            return Ok(names.map(|name| of_fit(&fit, name)).collect());
        }
        let found = diagnose(&data, MOST_EFFECTS, &Progress::default()).map_err(failed)?;
        let missing: Vec<&str> = found.missing.iter().map(|m| &*m.effect.name).collect();
        let missing = if missing.is_empty() { "nothing".into() } else { missing.join(" + ") };
        let cell = |name: &str| match name {
            "verdict" => Cell::Word(found.verdict.word().into()),
            "missing" => Cell::Word(missing.clone()),
            "chi2_per_dof_before" => number(found.before.reduced_chi2),
            "chi2_per_dof_after" => number(found.after.reduced_chi2),
            name => of_fit(&found.fit, name),
        };
        Ok(names.map(cell).collect())
    }
}

/// Lists the results that reports of a model offer.
pub fn of_report(report: &RunReport) -> Vec<Offered> {
    let entries = report.figures.iter().flat_map(|figure| figure.entries.iter().map(move |(key, d)| (figure, key, d)));
    let offered = entries.filter_map(|(figure, key, datum)| {
        let name = format!("{}.{key}", figure.key);
        match datum {
            Datum::Quantity(kind, _) => Some(Offered { name, kind: Some(*kind), is_word: false }),
            Datum::Number(_) | Datum::Count(_) => Some(Offered { name, kind: None, is_word: false }),
            Datum::Word(_) | Datum::Flag(_) => Some(Offered { name, kind: None, is_word: true }),
            Datum::Quantities(..) | Datum::Missing | Datum::Record(_) | Datum::List(_) => None,
        }
    });
    offered.collect()
}

/// A value within a list or a record of a report, by its full name.
pub fn deeper(report: &RunReport, name: &str) -> Option<Offered> {
    let (kind, is_word) = match datum(report, name)? {
        Datum::Quantity(kind, _) => (Some(kind), false),
        Datum::Number(_) | Datum::Count(_) => (None, false),
        Datum::Word(_) | Datum::Flag(_) => (None, true),
        _ => return None,
    };
    Some(Offered { name: name.into(), kind, is_word })
}

/// Lists the results that fits or diagnoses of a model offer.
pub fn of_measured(task: Task, model: &Model) -> Vec<Offered> {
    let word = |(name, is_word): &(&str, bool)| Offered { name: name.to_string(), kind: None, is_word: *is_word };
    let mut all: Vec<Offered> = match task {
        Task::Diagnose => OF_DIAGNOSIS.iter().map(word).collect(),
        _ => OF_FIT.iter().map(|name| word(&(name, false))).collect(),
    };
    for parameter in &model.parameters {
        let name = parameter.path.to_string();
        all.push(Offered { name: format!("{name}.std"), kind: Some(parameter.kind.difference()), is_word: false });
        all.push(Offered { name, kind: Some(parameter.kind), is_word: false });
    }
    all
}

fn datum(report: &RunReport, name: &str) -> Option<Datum> {
    let (key, rest) = name.split_once('.')?;
    let figure: &Figure = report.figures.iter().find(|figure| figure.key == key)?;
    figure.datum(&rest.replace('.', "/"))
}

fn cell(report: &RunReport, name: &str) -> Cell {
    match datum(report, name) {
        Some(Datum::Quantity(kind, si)) => number(kind.from_si(si)),
        Some(Datum::Number(value)) => number(value),
        Some(Datum::Count(count)) => Cell::Number(count as f64),
        Some(Datum::Word(word)) => Cell::Word(word.into_owned()),
        Some(Datum::Flag(flag)) => Cell::Word(if flag { "yes" } else { "no" }.into()),
        _ => Cell::Empty,
    }
}

fn of_fit(fit: &Fit, name: &str) -> Cell {
    match name {
        "chi2_per_dof" => return number(fit.reduced_chi2),
        "p_value" => return fit.p_value.map_or(Cell::Empty, number),
        _ => {}
    }
    let found = |path: &str| fit.estimates.iter().find(|e| e.parameter.path == path);
    match (found(name), name.strip_suffix(".std").and_then(found)) {
        (Some(estimate), _) => number(estimate.parameter.kind.from_si(estimate.value)),
        (None, Some(estimate)) => number(estimate.std / estimate.parameter.kind.canonical().factor),
        (None, None) => Cell::Empty,
    }
}

fn number(value: f64) -> Cell {
    if value.is_finite() { Cell::Number(value) } else { Cell::Empty }
}
