//! The answer of `fem fit`: what a model leaves open, estimated.

use serde_json::{Value as Json, json};

use super::answer::Answer;
use super::block::{Block, Cell, Column, Table};
use super::comparison::{NO_STRUCTURE, not_judged};
use super::json::finite;
use super::measurement::{self, files};
use super::number;
use crate::fit::{Estimate, Fit};
use crate::model::Data;
use crate::noise::NoiseSource;
use crate::progress::Progress;
use crate::units::Knowledge;

/// The fit of a model to data: estimates, goodness, correlations.
pub struct FitAnswer<'a>(pub &'a Data<'a>, pub &'a Fit);

impl Answer for FitAnswer<'_> {
    fn blocks(&self) -> Vec<Block> {
        let Self(data, fit) = *self;
        let (name, kind) = (&data.model.source.name, data.kind());
        let noise = super::comparison::noise_text(&fit.noise.level(data), data);
        let at_work = measurement::at_work(name, &fit.noise.terms, &*data.model.process, Some(data));
        let mut blocks = vec![Block::Lines(format!(
            "{name} fitted to {}: {} observations, {noise}\n{at_work}",
            data.name,
            data.len()
        ))];
        blocks.extend(cautions(data, fit).cloned().map(Block::Caution));
        let sizes = fit.sizes.iter().flat_map(|s| rows(&s.estimate, true));
        let columns = [Column::wide("parameter"), Column::new("value", 24), Column::remark("95 % interval", 0)];
        let rows = fit.estimates.iter().flat_map(|e| rows(e, false)).chain(sizes);
        blocks.push(Block::Table(Table::new(columns, rows)));
        for (i, j, combination) in &fit.told_together {
            let (a, b) = (&fit.estimates[*i].parameter.path, &fit.estimates[*j].parameter.path);
            let word = combination.word();
            blocks.push(Block::Lines(format!(
                "\n  all rows depend on the {word} of {a} and {b} alone: give one of the two a value\n"
            )));
        }
        let is_told = |pair: (usize, usize)| fit.told_together.iter().any(|(i, j, _)| (*i, *j) == pair);
        for (i, j, c) in fit.correlated.iter().filter(|(i, j, _)| !is_told((*i, *j))) {
            let (a, b) = (&fit.estimates[*i].parameter.path, &fit.estimates[*j].parameter.path);
            blocks.push(Block::Lines(format!("\n  {a} and {b} can hardly be told apart (correlation {c:+.3})\n")));
        }
        let verdict = match (fit.adequacy, fit.p_value) {
            _ if !fit.reduced_chi2.is_finite() && fit.noise.source == NoiseSource::Repeats => {
                "as many parameters as conditions leave nothing to judge the model by"
            }
            (None, _) => not_judged(data),
            (Some(true), Some(_)) => "the noise explains what is left",
            (Some(true), None) => NO_STRUCTURE,
            (Some(false), _) => {
                "more is left than the noise explains: something is missing, or what is written is wrong"
            }
        };
        let chi2 = Some(fit.reduced_chi2).filter(|chi2| chi2.is_finite());
        let chi2 = chi2.map_or(String::new(), |chi2| format!(", chi2/dof {}", number::fixed(chi2, 3)));
        let rms = kind.from_si(fit.rms);
        blocks.push(Block::Lines(format!("\n  rms {rms:.3} {}{chi2}: {verdict}\n", kind.unit)));
        if fit.failures > 0 {
            let failed = format!("{} of {} trial values", fit.failures, fit.evaluations);
            blocks.push(Block::Sentence(format!("the model could not be computed at {failed}")));
        }
        blocks
    }

    /// `fem fit --json`: `fem-fit/1`.
    fn json(&self) -> Json {
        let Self(data, fit) = *self;
        let kind = data.kind();
        let name = |i: usize| &*fit.estimates[i].parameter.path;
        json!({
            "schema": "fem-fit/1",
            "model": &*data.model.source.name,
            "data": data.name,
            "files": files(data),
            "observations": data.len(),
            "noise": super::comparison::noise(&fit.noise.level(data), kind),
            "measurement": measurement::json(&fit.noise.terms, &*data.model.process, Some(data)),
            "rms": kind.from_si(fit.rms),
            "unit": kind.unit,
            "chi2_per_dof": finite(fit.reduced_chi2),
            "p_value": fit.p_value,
            "adequate": fit.adequacy,
            "parameters": fit.estimates.iter().map(estimate).collect::<Vec<_>>(),
            "sizes": fit.sizes.iter().map(|s| estimate(&s.estimate)).collect::<Vec<_>>(),
            "correlated": fit.correlated.iter().map(|(i, j, c)| json!([name(*i), name(*j), c])).collect::<Vec<_>>(),
            "told_together": fit.told_together.iter().map(|(i, j, c)| json!([name(*i), name(*j), c.word()])).collect::<Vec<_>>(),
            "failed_trials": fit.failures,
            "evaluations": fit.evaluations,
            "cautions": cautions(data, fit).collect::<Vec<_>>(),
        })
    }

    fn progress(&self) -> Option<&Progress> {
        Some(&self.0.progress)
    }
}

/// A parameter with its interval.
pub(super) fn estimate(e: &Estimate) -> Json {
    let k = e.parameter.kind;
    let factor = k.canonical().factor;
    let end = |si: Option<f64>| si.map(|v| k.from_si(v));
    let prior = match e.parameter.quantity.knowledge {
        Knowledge::Rough(std) => json!({ "value": k.from_si(e.parameter.quantity.value), "std": std / factor }),
        Knowledge::Free | Knowledge::Known => Json::Null,
    };
    json!({
        "parameter": &*e.parameter.path,
        "value": finite(k.from_si(e.value)),
        "unit": k.unit,
        "std": finite(e.std / factor),
        "interval95": [end(e.interval.low), end(e.interval.high)],
        "prior": prior,
        "warnings": e.warnings,
    })
}

/// Cautions to be read before the rest is believed: on the data, then on what the fitted model asks of the machine.
fn cautions<'a>(data: &'a Data, fit: &'a Fit) -> impl Iterator<Item = &'a String> {
    data.cautions.iter().chain(&fit.doubts)
}

/// The rows of an estimate and its warnings; the size of an effect of the measurement has an interval, and no `+-` in a
/// file.
pub(super) fn rows(e: &Estimate, is_size: bool) -> Vec<Vec<Cell>> {
    let k = e.parameter.kind;
    let end = |si: Option<f64>| si.map_or("open".into(), |v| format!("{:.5}", Short(k.from_si(v))));
    let (value, std) = (k.from_si(e.value), e.std / k.canonical().factor);
    let value = match (is_size, std.is_finite()) {
        (true, _) => format!("{:.5}", Short(value)),
        (false, true) => crate::fit::uncertain(value, std),
        (false, false) => format!("{:.4} +- ?", Short(value)),
    };
    let interval = format!("{} to {} {}", end(e.interval.low), end(e.interval.high), k.unit);
    let own = [e.parameter.path.to_string(), value, interval];
    let warnings = e.warnings.iter().map(|warning| [String::new(), String::new(), warning.clone()]);
    [own].into_iter().chain(warnings).map(|cells| cells.map(Cell::Text).into()).collect()
}

/// Number that is written with as many significant digits as its precision asks for.
pub(super) struct Short(pub f64);

impl std::fmt::Display for Short {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let digits = f.precision().unwrap_or(5) as i32;
        if self.0.abs() >= 1e12 || (self.0 != 0.0 && self.0.abs() < 1e-9) {
            return write!(f, "{:.*e}", digits as usize - 1, self.0);
        }
        let place = if self.0 == 0.0 { 0 } else { (digits - 1 - self.0.abs().log10().floor() as i32).clamp(0, 12) };
        write!(f, "{:.*}", place as usize, self.0)
    }
}
