//! Laws that are written into the model and fitted together with it.

use nalgebra::DVector;

use super::law::{self, Written};
use super::search::{Bench, Found, Term, amplitudes};
use crate::diagnose::Apart;
use crate::fit::{self, Estimate, Fit, Objective, SearchVariable, Solution, StoppingCriterion, minimise};
use crate::input::{Parameter, numbered};
use crate::model::{Data, Edit, Entry, Model, Setting, add_effect};

/// Stopping criterion that is enough to rank laws.
const SOME_STEPS: StoppingCriterion = StoppingCriterion::rough(12, 1e-4);

/// Name of the effect; further ones are numbered.
const NAME: &str = "law";

/// A name that begins so, and that no effect of the model has.
pub fn free_name(model: &Model, name: &str) -> String {
    let is_free = |name: &String| model.effects.iter().all(|effect| effect.description.name != *name);
    numbered(name).find(is_free).unwrap_or_default()
}

/// Whether a parameter is one of a law of this name.
pub fn is_parameter_of(name: &str, parameter: &Parameter) -> bool {
    let key = parameter.path.strip_prefix("effects.").and_then(|own| own.strip_prefix(name));
    key.is_some_and(|rest| rest.starts_with('.'))
}

/// Whether an estimate is one of a law of this name.
pub fn is_of(name: &str, estimate: &Estimate) -> bool {
    is_parameter_of(name, &estimate.parameter)
}

/// A law that is written into the model, and what it leaves there.
pub struct Ranked {
    /// Name of the effect.
    pub name: String,
    /// The observable to which it is added, by its position in the process's list.
    pub observable: usize,
    /// The formula with its parameters.
    pub written: Written,
    /// Names of its variables.
    pub variables: Vec<String>,
    /// Whether somebody has it in mind.
    pub is_candidate: bool,
    /// −2 ln of its weight: χ² and its price.
    pub criterion: f64,
    /// What it was made of.
    pub found: Found,
    /// The model with it, its values open.
    pub open: Model,
    /// The row that tells it from the best, where it is a rival.
    pub apart: Option<Apart>,
    /// Where a search for its values has come to.
    pub position: DVector<f64>,
}

impl Ranked {
    /// −2 ln of the likelihood.
    pub fn misfit(&self) -> f64 {
        self.criterion - self.found.price
    }

    /// Names and values of its parameters that are not fitted: scales.
    pub fn known(&self) -> impl Iterator<Item = &(String, String)> {
        self.written.settings.iter().filter(|(_, value)| !value.starts_with('?'))
    }
}

/// Writes a law into the model of a fit, and takes a few steps from there.
pub fn drafted((objective, solution): (&Objective, &Solution), bench: &Bench, found: &Found) -> Option<Ranked> {
    let data = objective.data;
    let observable = found.terms.first()?.observable;
    let kind = data.model.process.observables()[observable].error_kind();
    let mut sizes = amplitudes(&bench.seen(&found.terms), bench.residual)?.into_iter();
    let mut terms = Vec::new();
    for term in &found.terms {
        let count = term.factors.iter().map(|factor| factor.shape.functions()).product();
        terms.push((term, sizes.by_ref().take(count).collect()));
    }
    let written = law::written(&terms, bench.variables, (objective.data.model, kind));
    let name = free_name(data.model, NAME);
    let open = add_effect(data.model, &name, &written.open()).ok()?;
    let (position, chi2) = begun((objective, solution), &open)?;
    let mut variables: Vec<String> =
        bench.variables_of(found).into_iter().map(|own| bench.variables[own].name.to_string()).collect();
    variables.sort();
    variables.dedup();
    let (found, criterion) = (found.clone(), bench.misfit(chi2) + found.price);
    Some(Ranked {
        name,
        observable,
        written,
        variables,
        is_candidate: false,
        criterion,
        found,
        open,
        apart: None,
        position,
    })
}

/// A few steps from where a model with a law begins, beside the values of the model without it.
pub fn begun((objective, solution): (&Objective, &Solution), open: &Model) -> Option<(DVector<f64>, f64)> {
    let start = |with: &Objective| {
        let one = |(variable, parameter): (&SearchVariable, &Parameter)| {
            let known = objective.parameters.iter().position(|other| other.path == parameter.path);
            known.map_or_else(|| variable.position(variable.starts[0]), |i| solution.position[i])
        };
        DVector::from_iterator(with.variables.len(), with.variables.iter().zip(&with.parameters).map(one))
    };
    descended(objective, open, start, SOME_STEPS)
}

/// Lets the values of a law settle beside those of the model, under the noise of a fit. Without a term on which no row
/// depends any more, for its constants have gone beyond the rows, it is another law.
pub fn settled((objective, solution): (&Objective, &Solution), bench: &Bench, law: Ranked) -> Option<Ranked> {
    let own = objective.data.beside(&law.open).ok()?;
    let with = &mut beside(objective, &own)?;
    let there = minimise(with, &law.position, &[], StoppingCriterion::FULL)?;
    // On the edge of where the model can be computed nothing can be said of its values.
    (there.is_at_rest || with.jacobian(&there).is_some()).then_some(())?;
    let left = law.terms_at(with, &there);
    if left.len() == law.found.terms.len() {
        let criterion = bench.misfit(there.chi2) + law.found.price;
        return Some(Ranked { position: there.position, criterion, ..law });
    }
    let draft = drafted((objective, solution), bench, &bench.judged(left))?;
    settled((objective, solution), bench, draft)
}

impl Ranked {
    /// The terms on which some row depends at a solution.
    fn terms_at(&self, with: &Objective, there: &Solution) -> Vec<Term> {
        let terms = self.found.terms.iter().zip(&self.written.amplitudes);
        let seen = terms.filter(|(_, amplitude)| is_seen(&self.name, amplitude, with, there));
        seen.map(|(term, _)| term.clone()).collect()
    }
}

/// Whether some row depends on a parameter of a law of this name at a solution.
fn is_seen(name: &str, key: &str, with: &Objective, there: &Solution) -> bool {
    let is_own = |p: &Parameter| is_parameter_of(name, p) && p.path.key() == key;
    with.parameters.iter().position(is_own).is_none_or(|i| !fit::is_idle(with, there, i))
}

/// A model with a law, under the noise of a fit.
fn beside<'d>(objective: &Objective, own: &'d Data) -> Option<Objective<'d>> {
    let mut with = Objective::new(own).ok()?;
    with.noise = objective.noise.clone();
    Some(with)
}

/// Where a search for the values of a model with a law comes to under the noise of a fit, and χ² there.
pub fn descended(
    objective: &Objective,
    open: &Model,
    start: impl FnOnce(&Objective) -> DVector<f64>,
    stop: StoppingCriterion,
) -> Option<(DVector<f64>, f64)> {
    let own = objective.data.beside(open).ok()?;
    let mut with = beside(objective, &own)?;
    let start = start(&with);
    let Solution { position, chi2, .. } = minimise(&mut with, &start, &[], stop)?;
    Some((position, chi2))
}

/// A law that is fitted.
pub struct Law {
    /// The law.
    pub ranked: Ranked,
    /// The model with it, fitted.
    pub model: Option<Model>,
    /// Its parameters.
    pub estimates: Vec<Estimate>,
    /// χ² over the degrees of freedom with it.
    pub reduced_chi2: f64,
    /// Probability of chance of as much.
    pub p_value: Option<f64>,
    /// The settings with which `fem add` writes it, the formula first.
    pub settings: Vec<Setting>,
}

/// Fits a law to all rows.
pub fn fitted(data: &Data, ranked: Ranked) -> Option<Law> {
    let own = data.beside(&ranked.open).ok()?;
    let fit = fit::fit(&own).ok()?;
    Some(Law {
        model: completed(&own, &fit, &ranked.name),
        estimates: fit.estimates.iter().filter(|e| is_of(&ranked.name, e)).cloned().collect(),
        reduced_chi2: fit.reduced_chi2,
        p_value: fit.p_value,
        settings: fitted_settings(&ranked.written.open(), &fit, &ranked.name),
        ranked,
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::Source;
    use crate::measure::Measurements;

    /// A term that has gone beyond the rows is none any more.
    #[test]
    fn no_row_depends_on_a_tent_beside_the_rows() {
        let text = "process = \"axis\"\naxis = { travel = \"1 m\" }\n\
                    screw = { material = \"steel\", diameter = \"40 mm\", lead = \"10 mm\" }\n\
                    [effects.law]\nformula = \"a*max(0, 1 - abs(position - p_c)/p_w) + a2*position/p_0\"\n\
                    a = \"? near 3 um\"\np_c = \"? near C mm\"\np_w = \"? near 20 mm\"\n\
                    a2 = \"? near 1 um\"\np_0 = \"1 m\"\n";
        for (centre, seen) in [("150", [true, true]), ("900", [false, true])] {
            let model = Model::parse(Source::new("model.toml", text.replace('C', centre))).unwrap();
            let rows = "position [mm],direction,deviation [um],u [um]\n\
                        100,+,1,1\n140,+,4,1\n160,+,5,1\n200,+,2,1\n240,+,3,1\n300,+,3,1\n";
            let rows = Measurements::parse(Source::new("rows.csv", rows), &*model.process).unwrap();
            let data = Data::of(&model, rows).unwrap();
            let objective = Objective::new(&data).unwrap();
            let start = objective.variables.iter().map(|own| own.position(own.starts[0]));
            let there = objective.evaluate(DVector::from_iterator(objective.variables.len(), start)).unwrap();
            assert_eq!(["a", "a2"].map(|key| is_seen("law", key, &objective, &there)), seen, "{centre}");
        }
    }
}
