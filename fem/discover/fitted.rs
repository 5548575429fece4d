//! Laws that are written into the model and fitted together with it.

use super::apart::Apart;
use super::law::{self, Written};
use super::left_out::LeftOut;
use super::search::{Bench, Found, amplitudes};
use crate::fit::{self, Estimate, Fit};
use crate::model::{Data, Edit, Entry, Model, Setting, add_effect};

/// Name of the effect, and where its parameters stand.
pub const NAME: &str = "law";
const OWN: &str = "effects.law.";

/// A law that was found.
pub struct Law {
    /// The observable to which it is added, by its position in the process's list.
    pub observable: usize,
    /// The formula with its parameters.
    pub written: Written,
    /// Names of its variables.
    pub variables: Vec<String>,
    /// −2 ln of its weight: χ² and its price.
    pub criterion: f64,
    /// What it was made of.
    pub found: Found,
    /// The model with it, its values open.
    pub open: Model,
    /// The model with it, fitted.
    pub model: Option<Model>,
    /// Its parameters.
    pub estimates: Vec<Estimate>,
    /// χ² over the degrees of freedom with it.
    pub reduced_chi2: f64,
    /// Probability of chance of as much.
    pub p_value: Option<f64>,
    /// What it says of rows that were left out.
    pub left_out: Option<LeftOut>,
    /// The row that tells it from the best, where it is a rival.
    pub apart: Option<Apart>,
    /// The settings with which `fem add` writes it, the formula first.
    pub settings: Vec<Setting>,
}

impl Law {
    /// Names and values of its parameters that are not fitted: scales.
    pub fn known(&self) -> impl Iterator<Item = &(String, String)> {
        self.written.settings.iter().filter(|(_, value)| !value.starts_with('?'))
    }
}

/// Writes a law into the model, and fits it to all rows.
pub fn fitted(data: &Data, bench: &Bench, found: &Found) -> Option<Law> {
    let observable = found.terms.first()?.observable;
    let kind = data.model.process.observables()[observable].error_kind();
    let mut sizes = amplitudes(&bench.seen(&found.terms), bench.residual)?.into_iter();
    let mut terms = Vec::new();
    for term in &found.terms {
        let count = term.factors.iter().map(|factor| factor.shape.functions()).product();
        terms.push((term, sizes.by_ref().take(count).collect()));
    }
    let mut variables: Vec<String> =
        found.variables().into_iter().map(|own| bench.variables[own].name.to_string()).collect();
    variables.sort();
    variables.dedup();
    let written = law::written(&terms, bench.variables, kind);
    let settings: Vec<Setting> = std::iter::once(("formula".to_string(), written.formula.clone()))
        .chain(written.settings.iter().cloned())
        .map(|(key, value)| Setting { key, value: Entry::Text(value) })
        .collect();
    let model = add_effect(data.model, NAME, &settings).ok()?;
    let own = Data::of(&model, data.clone().into_measurements()).ok()?;
    let fit = fit::fit(&own).ok()?;
    let chi2 = bench.misfit(fit.reduced_chi2 * bench.freedom);
    Some(Law {
        observable,
        written,
        variables,
        criterion: chi2 + found.price,
        found: found.clone(),
        model: completed(&own, &fit),
        open: model.clone(),
        estimates: fit.estimates.iter().filter(|e| e.parameter.path.starts_with(OWN)).cloned().collect(),
        reduced_chi2: fit.reduced_chi2,
        p_value: fit.p_value,
        left_out: None,
        apart: None,
        settings: fitted_settings(&settings, &fit),
    })
}

/// The model with the values of a fit; those of the law stand even where an end of their interval is open, for it describes.
fn completed(data: &Data, fit: &Fit) -> Option<Model> {
    let mut edits = fit::edits(data, fit);
    for open in fit.estimates.iter().filter(|e| !e.is_closed() && e.parameter.path.starts_with(OWN)) {
        let kind = open.parameter.kind;
        let text = format!("{} {}", fit::five_digits(kind.from_si(open.value)), kind.unit);
        let entry = match kind.unit.is_empty() {
            true => Entry::Number(kind.from_si(open.value)),
            false => Entry::Text(text),
        };
        edits.push(Edit::Set { path: open.parameter.path.clone(), entry });
    }
    data.model.edited(&edits).ok()
}

/// The settings of a law with the values of a fit in the place of those from which it began.
fn fitted_settings(settings: &[Setting], fit: &Fit) -> Vec<Setting> {
    let fitted = |own: &Setting| {
        let path = format!("{OWN}{}", own.key);
        let Some(e) = fit.estimates.iter().find(|e| *e.parameter.path == *path) else { return own.clone() };
        let kind = e.parameter.kind;
        let value = match e.is_closed() {
            true => fit::uncertain(kind.from_si(e.value), fit.birge_ratio() * e.std / kind.canonical().factor),
            false => fit::five_digits(kind.from_si(e.value)),
        };
        Setting { key: own.key.clone(), value: Entry::Text(format!("{value} {}", kind.unit).trim_end().into()) }
    };
    settings.iter().map(fitted).collect()
}
