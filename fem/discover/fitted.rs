//! Laws that are written into the model and fitted together with it.

use super::apart::Apart;
use super::law::{self, Written};
use super::left_out::LeftOut;
use super::search::{Bench, Found, amplitudes};
use crate::fit::{self, Estimate, Fit, Objective, SearchVariable, Solution, StoppingCriterion, minimise};
use crate::input::Parameter;
use crate::model::{Data, Edit, Entry, Model, Setting, add_effect};

/// Stopping criterion that is enough to rank laws.
const SOME_STEPS: StoppingCriterion = StoppingCriterion::rough(12, 1e-4);

/// Name of the effect; further ones are numbered.
const NAME: &str = "law";

/// A name for a law that no effect of the model has.
pub fn free_name(model: &Model) -> String {
    let is_free = |name: &String| model.effects.iter().all(|effect| effect.description.name != *name);
    std::iter::once(NAME.to_string())
        .chain((2..).map(|number| format!("{NAME}-{number}")))
        .find(is_free)
        .unwrap_or_default()
}

/// Whether a parameter is one of a law of this name.
pub fn is_of(name: &str, estimate: &Estimate) -> bool {
    let key = estimate.parameter.path.strip_prefix("effects.").and_then(|own| own.strip_prefix(name));
    key.is_some_and(|rest| rest.starts_with('.'))
}

/// A law that was found.
pub struct Law {
    /// Name of the effect.
    pub name: String,
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

/// A law that is written into the model, and what it leaves after a few steps from where the search has left it.
pub struct Draft<'f> {
    found: &'f Found,
    observable: usize,
    written: Written,
    name: String,
    model: Model,
    /// −2 ln of its weight: χ² and its price.
    pub criterion: f64,
}

impl Draft<'_> {
    /// −2 ln of the likelihood.
    pub fn misfit(&self) -> f64 {
        self.criterion - self.found.price
    }
}

/// Writes a law into the model of a fit, and takes a few steps from there.
pub fn drafted<'f>(
    (objective, solution): (&Objective, &Solution),
    bench: &Bench,
    found: &'f Found,
) -> Option<Draft<'f>> {
    let data = objective.data;
    let observable = found.terms.first()?.observable;
    let kind = data.model.process.observables()[observable].error_kind();
    let mut sizes = amplitudes(&bench.seen(&found.terms), bench.residual)?.into_iter();
    let mut terms = Vec::new();
    for term in &found.terms {
        let count = term.factors.iter().map(|factor| factor.shape.functions()).product();
        terms.push((term, sizes.by_ref().take(count).collect()));
    }
    let written = law::written(&terms, bench.variables, kind);
    let name = free_name(data.model);
    let model = add_effect(data.model, &name, &written.open()).ok()?;
    let criterion = {
        let own = Data::of(&model, data.clone().into_measurements()).ok()?;
        let mut with = Objective::new(&own).ok()?;
        with.noise = objective.noise.clone();
        let start = |(variable, parameter): (&SearchVariable, &Parameter)| {
            let known = objective.parameters.iter().position(|other| other.path == parameter.path);
            known.map_or_else(|| variable.position(variable.starts[0]), |i| solution.position[i])
        };
        let start = with.variables.iter().zip(&with.parameters).map(start).collect::<Vec<_>>();
        bench.misfit(minimise(&mut with, &start.into(), &[], SOME_STEPS)?.chi2) + found.price
    };
    Some(Draft { found, observable, written, name, model, criterion })
}

/// Fits a law to all rows.
pub fn fitted(data: &Data, bench: &Bench, draft: Draft) -> Option<Law> {
    let Draft { found, observable, written, name, model, .. } = draft;
    let own = Data::of(&model, data.clone().into_measurements()).ok()?;
    let fit = fit::fit(&own).ok()?;
    let chi2 = bench.misfit(fit.reduced_chi2 * bench.freedom);
    let mut variables: Vec<String> =
        found.variables().into_iter().map(|own| bench.variables[own].name.to_string()).collect();
    variables.sort();
    variables.dedup();
    Some(Law {
        observable,
        variables,
        criterion: chi2 + found.price,
        found: found.clone(),
        model: completed(&own, &fit, &name),
        estimates: fit.estimates.iter().filter(|e| is_of(&name, e)).cloned().collect(),
        reduced_chi2: fit.reduced_chi2,
        p_value: fit.p_value,
        left_out: None,
        apart: None,
        settings: fitted_settings(&written.open(), &fit, &name),
        open: model,
        written,
        name,
    })
}

/// The model with the values of a fit; those of the law stand even where an end of their interval is open, for it describes.
fn completed(data: &Data, fit: &Fit, name: &str) -> Option<Model> {
    let mut edits = fit::edits(data, fit);
    for open in fit.estimates.iter().filter(|e| !e.is_closed() && is_of(name, e)) {
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
pub fn fitted_settings(settings: &[Setting], fit: &Fit, name: &str) -> Vec<Setting> {
    let fitted = |own: &Setting| {
        let Some(e) = fit.estimates.iter().find(|e| is_of(name, e) && e.parameter.path.key() == own.key) else {
            return own.clone();
        };
        let kind = e.parameter.kind;
        let value = match e.is_closed() {
            true => fit::uncertain(kind.from_si(e.value), fit.birge_ratio() * e.std / kind.canonical().factor),
            false => fit::five_digits(kind.from_si(e.value)),
        };
        Setting { key: own.key.clone(), value: Entry::Text(format!("{value} {}", kind.unit).trim_end().into()) }
    };
    settings.iter().map(fitted).collect()
}
