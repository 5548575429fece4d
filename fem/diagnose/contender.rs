//! The sets of effects between which the next measurement is to decide.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::DVector;

use super::candidate_model::{CandidateModel, Weighed};
use super::confounding::Confounding;
use super::laplace;
use super::look_alike::LookAlike;
use super::posterior::{CERTAIN, Posterior, RULED_OUT};
use super::search::SearchResult;
use crate::input::Name;
use crate::noise::Acts;
use crate::process::{Description, Rows};

/// Weight, beside the best set, of what a diagnosis tells as indistinguishable: it should be told apart, however
/// improbable it is.
const TOLD: f64 = 0.05;

/// Probability from which an effect is asked for that is hardly more likely than before the data: one of five.
const WORTH_ASKING: f64 = 0.2;

/// A set that may be true.
pub struct Contender<'r, 'a> {
    model: &'r CandidateModel<'a>,
    /// Effects that it has beyond the model, those of the measurement too.
    pub effects: Vec<Description>,
    /// Names of those about which there is a question, sorted.
    pub asked: Vec<String>,
    /// Its probability among all of them.
    pub weight: f64,
    left: laplace::Left,
}

impl<'r, 'a> Contender<'r, 'a> {
    fn new(model: &'r CandidateModel<'a>, more: Option<&Description>, criterion: f64, best: f64) -> Option<Self> {
        let effects = model.objective.added.iter().chain(more).cloned().collect();
        let weight = laplace::weight(criterion, best);
        Some(Self { model, effects, asked: Vec::new(), weight, left: laplace::left(model)? })
    }

    /// What it predicts of some rows, in standard uncertainties of each measured once: columns of L, and last the most
    /// probable values. `None` where it cannot be computed.
    pub fn columns(&self, rows: &Rows) -> Option<Vec<DVector<f64>>> {
        let objective = &self.model.objective;
        let sigma = rows.observable.iter().map(|o| objective.noise.usual(objective.data, *o));
        let sigma = DVector::from_iterator(rows.len(), sigma);
        let position = &self.model.solution.position;
        let slopes = objective.sensitivities(position, rows)?;
        let predicted = DVector::from_vec(objective.predict_rows(position, rows)?) + &slopes * &self.left.step;
        let spread = slopes * &self.left.root;
        // What rows share by the way of measuring, new rows share anew.
        let shared = objective.noise.terms.iter().filter(|term| matches!(term.effect.acts, Acts::Shared(_)));
        let shared: f64 = shared.map(|term| term.size.powi(2)).filter(|size| size.is_finite()).sum();
        let spread = spread.column_iter().map(|column| column.component_div(&sigma));
        let all: Vec<DVector<f64>> =
            spread.chain([sigma.map(|s| shared.sqrt() / s), predicted.component_div(&sigma)]).collect();
        all.iter().all(|column| column.iter().all(|value| value.is_finite())).then_some(all)
    }

    fn names(&self) -> Vec<&str> {
        let mut names: Vec<&str> = self.effects.iter().map(|effect| &*effect.name).collect();
        names.sort_unstable();
        names
    }
}

/// The sets that may be true: those that hold nearly all of the probability, and all that a diagnosis tells as
/// indistinguishable.
pub fn contenders<'r, 'a>(
    found: &'r SearchResult<'a>,
    confoundings: &'r [Confounding<'a>],
    look_alikes: &'r [LookAlike<'a>],
    posterior: &Posterior,
) -> Vec<Contender<'r, 'a>> {
    let best = found.tried.first().map_or(0.0, |set| set.criterion);
    let credible = found.credible().iter();
    let mut all: Vec<Contender> =
        credible.filter_map(|Weighed { model, criterion, .. }| Contender::new(model, None, *criterion, best)).collect();
    let of_effects = confoundings.iter().flat_map(|own| &own.alternatives).map(|other| (&other.model, None));
    // An effect of the machine in the place of a term is among the model's own; a term is not.
    let of_terms = look_alikes.iter().map(|own| {
        let is_term = !own.model.objective.added.contains(&own.other);
        (&own.model, is_term.then_some(&own.other))
    });
    for (model, more) in of_effects.chain(of_terms) {
        let Some(criterion) = laplace::criterion(model) else { continue };
        let Some(mut other) = Contender::new(model, more, criterion, best) else { continue };
        if all.iter().all(|own| own.names() != other.names()) {
            other.weight = other.weight.clamp(TOLD, 1.0);
            all.push(other);
        }
    }
    // Asked is what the answer leaves open: sets that differ in nothing else are one.
    let candidates = &found.candidates;
    let members = found.best().members.iter().map(|member| &candidates[*member].effect.name);
    let instead =
        confoundings.iter().flat_map(|own| &own.alternatives).map(|other| &candidates[other.candidate].effect.name);
    let across = look_alikes.iter().flat_map(|own| [&own.cause.name, &own.other.name]);
    let grouped = posterior.groups.iter().flat_map(|group| &group.effects);
    let told: BTreeSet<&Name> = members.chain(instead).chain(across).chain(grouped).collect();
    let whole: f64 = all.iter().map(|own| own.weight).sum();
    for own in &mut all {
        let is_open = |effect: &Description| {
            let least = if posterior.is_notable(effect) { RULED_OUT } else { WORTH_ASKING };
            (least..CERTAIN).contains(&posterior.of(&effect.name))
        };
        let is_asked = |effect: &&Description| told.contains(&effect.name) || is_open(effect);
        own.asked = own.effects.iter().filter(is_asked).map(|effect| effect.name.to_string()).collect();
        own.asked.sort_unstable();
        own.weight /= whole;
    }
    all
}

/// Entropy of what is asked, nats.
pub fn entropy(contenders: &[Contender]) -> f64 {
    let mut weights: BTreeMap<&[String], f64> = BTreeMap::new();
    for own in contenders {
        *weights.entry(&own.asked).or_default() += own.weight;
    }
    -weights.values().map(|w| w * w.ln()).sum::<f64>()
}
