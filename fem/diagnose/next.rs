//! Next measurement: the candidate experiment that tells most about which of the sets that fit is true (Bayesian design
//! of experiments).
//!
//! Each set predicts the rows of an experiment with the uncertainty that the data leave of its parameters: a normal
//! distribution of mean m and covariance C = I + LLᵀ in standard uncertainties of the rows. What an experiment is
//! expected to tell is the mutual information of set and rows; of a mixture of normal distributions it is no less than
//!
//! −Σᵢ wᵢ ln Σⱼ wⱼ exp(−Bᵢⱼ), Bᵢⱼ = ⅛ δ² + ½ ln |C̄| − ¼ ln |Cᵢ||Cⱼ|, δ² = ΔᵀC̄⁻¹Δ, C̄ = ½(Cᵢ + Cⱼ)
//!
//! with Bhattacharyya's distances B (Kolchinsky and Tracey 2017, Entropy 19, 361). L has a column for each parameter, so
//! that all of it is computed from inner products of columns, for any number of repeats.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};
use rayon::prelude::*;

use super::candidate_model::{CandidateModel, Weighed};
use super::confounding::{Confounding, SEPARATE};
use super::laplace;
use super::look_alike::LookAlike;
use super::posterior::Posterior;
use super::search::SearchResult;
use crate::input::Name;
use crate::noise::Acts;
use crate::process::{CandidateExperiment, Description, Rows};

/// Numbers of repeats of an experiment that are considered.
pub const REPEATS: &[usize] = &[1, 2, 4, 8];
/// Weight, beside the best set, of what a diagnosis tells as indistinguishable: it should be told apart, however
/// improbable it is.
const TOLD: f64 = 0.05;
/// Information below which an experiment is not worth the making, nats: one set of ten is expected to be ruled out.
const LEAST: f64 = 0.1;
/// Part of the most that any experiment tells which is enough for a shorter one to be preferred.
const ENOUGH: f64 = 0.9;

/// Measurement to make next.
#[derive(Clone, Debug)]
pub struct Next {
    /// Experiment to make.
    pub experiment: CandidateExperiment,
    /// Number of repeats of each of its rows.
    pub repeats: usize,
    /// Pairs of effects that it tells apart, or, where it is not enough, brings farther apart; those that stand for
    /// each other in the most probable sets first.
    pub pairs: Vec<(Description, Description)>,
    /// Effects of which it tells whether they are there.
    pub whether: Vec<Description>,
    /// Separation of the worst of them, in standard uncertainties.
    pub separation: f64,
    /// Whether that separation is enough to tell them apart.
    pub enough: bool,
    /// As how many equally probable sets those that fit now count, and those that are expected to be left; of a plan,
    /// which has no sets, nothing.
    pub sets: Option<(f64, f64)>,
}

impl Next {
    /// Number of rows, repeats included.
    pub fn observations(&self) -> usize {
        self.repeats * self.experiment.rows.len()
    }
}

/// A set that may be true.
struct Contender<'r, 'a> {
    model: &'r CandidateModel<'a>,
    /// Effects that it has beyond the model, those of the measurement too.
    effects: Vec<Description>,
    /// Names of those about which there is a question, sorted.
    asked: Vec<String>,
    weight: f64,
    left: laplace::Left,
}

impl<'r, 'a> Contender<'r, 'a> {
    fn new(model: &'r CandidateModel<'a>, more: Option<&Description>, criterion: f64, best: f64) -> Option<Self> {
        let effects = model.objective.added.iter().chain(more).cloned().collect();
        let weight = (0.5 * (best - criterion)).exp();
        Some(Self { model, effects, asked: Vec::new(), weight, left: laplace::left(model)? })
    }

    /// What it predicts of some rows, in standard uncertainties of each measured once: columns of L, and last the most
    /// probable values. `None` where it cannot be computed.
    fn columns(&self, rows: &Rows) -> Option<Vec<DVector<f64>>> {
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
fn contenders<'r, 'a>(
    found: &'r SearchResult<'a>,
    confoundings: &'r [Confounding<'a>],
    look_alikes: &'r [LookAlike<'a>],
    posterior: &Posterior,
) -> Vec<Contender<'r, 'a>> {
    let best = found.tried.first().map_or(0.0, |set| set.criterion);
    let credible = found.credible().iter();
    let mut all: Vec<Contender> =
        credible.filter_map(|Weighed { model, criterion }| Contender::new(model, None, *criterion, best)).collect();
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
    // Nobody asks for what is told of no account: sets that differ in nothing else are one.
    let candidates = &found.candidates;
    let members = found.best().members.iter().map(|member| &candidates[*member].effect.name);
    let instead =
        confoundings.iter().flat_map(|own| &own.alternatives).map(|other| &candidates[other.candidate].effect.name);
    let across = look_alikes.iter().flat_map(|own| [&own.cause.name, &own.other.name]);
    let grouped = posterior.groups.iter().flat_map(|group| &group.effects);
    let told: BTreeSet<&Name> = members.chain(instead).chain(across).chain(grouped).collect();
    let whole: f64 = all.iter().map(|own| own.weight).sum();
    for own in &mut all {
        let is_asked = |effect: &&Description| told.contains(&effect.name) || posterior.is_notable(effect);
        own.asked = own.effects.iter().filter(is_asked).map(|effect| effect.name.to_string()).collect();
        own.asked.sort_unstable();
        own.weight /= whole;
    }
    all
}

/// Entropy of what is asked, nats.
fn entropy(contenders: &[Contender]) -> f64 {
    let mut weights: BTreeMap<&[String], f64> = BTreeMap::new();
    for own in contenders {
        *weights.entry(&own.asked).or_default() += own.weight;
    }
    -weights.values().map(|w| w * w.ln()).sum::<f64>()
}

/// Chooses the experiment that tells most, or the shortest of those that tell nearly as much. `None` where one set is
/// certain, or no experiment would help.
pub fn next(
    found: &SearchResult,
    confoundings: &[Confounding],
    look_alikes: &[LookAlike],
    posterior: &Posterior,
) -> Option<Next> {
    let data = found.base.objective.data;
    let contenders = contenders(found, confoundings, look_alikes, posterior);
    let entropy = entropy(&contenders);
    if entropy < LEAST {
        return None;
    }
    let experiments = data.model.system.candidate_experiments(&data.rows);
    let rate = |experiment: CandidateExperiment| {
        let prospect = Prospect::new(&contenders, &experiment.rows)?;
        let at = |repeats: &usize| (*repeats, prospect.information(&contenders, *repeats));
        let rated: Vec<(usize, f64)> = REPEATS.iter().map(at).collect();
        Some((experiment, prospect, rated))
    };
    let rated: Vec<_> = experiments.into_par_iter().filter_map(rate).collect();
    let all = || {
        rated.iter().flat_map(|(experiment, prospect, rated)| {
            rated.iter().map(move |(repeats, tells)| (experiment, prospect, *repeats, *tells))
        })
    };
    let most = all().map(|own| own.3).fold(0.0, f64::max);
    let rows = |own: &(&CandidateExperiment, &Prospect, usize, f64)| own.2 * own.0.rows.len();
    let (experiment, prospect, repeats, tells) = all()
        .filter(|own| own.3 >= ENOUGH * most && own.3 >= LEAST)
        .min_by(|a, b| rows(a).cmp(&rows(b)).then(b.3.total_cmp(&a.3)))?;
    let told = prospect.told(&contenders, repeats);
    Some(Next {
        experiment: experiment.clone(),
        repeats,
        pairs: told.pairs,
        whether: told.whether,
        separation: told.separation,
        enough: told.enough,
        sets: Some((entropy.exp(), (entropy - tells).max(0.0).exp())),
    })
}

/// What the sets predict of the rows of an experiment: inner products of the columns of their uncertainties and of
/// their predictions, in standard uncertainties of rows that are measured once.
struct Prospect {
    /// Numbers of the sets, and their weights.
    members: Vec<usize>,
    weights: Vec<f64>,
    /// Columns of each set's L, and last its prediction less that of the first set.
    columns: Vec<std::ops::Range<usize>>,
    products: DMatrix<f64>,
}

impl Prospect {
    /// Of sets that cannot be computed at these rows nothing is expected.
    fn new(contenders: &[Contender], rows: &Rows) -> Option<Self> {
        let (mut members, mut columns, mut all) = (Vec::new(), Vec::new(), Vec::new());
        for (number, own) in contenders.iter().enumerate() {
            let Some(more) = own.columns(rows) else { continue };
            members.push(number);
            columns.push(all.len()..all.len() + more.len());
            all.extend(more);
        }
        let first: DVector<f64> = all[columns.first()?.end - 1].clone();
        for own in &columns {
            all[own.end - 1] -= &first;
        }
        let all = DMatrix::from_columns(&all);
        let whole: f64 = members.iter().map(|i| contenders[*i].weight).sum();
        let weights = members.iter().map(|i| contenders[*i].weight / whole).collect();
        Some(Self { weights, members, columns, products: all.tr_mul(&all) })
    }

    /// I + r·MᵀM of some columns, factored, of rows that are repeated r times.
    fn factored(&self, own: &[usize], scale: f64) -> Option<Cholesky<f64, Dyn>> {
        let entry = |r: usize, c: usize| scale * self.products[(own[r], own[c])] + f64::from(u8::from(r == c));
        Cholesky::new(DMatrix::from_fn(own.len(), own.len(), entry))
    }

    fn log_determinant(factor: &Cholesky<f64, Dyn>) -> f64 {
        2.0 * factor.l_dirty().diagonal().iter().map(|d| d.ln()).sum::<f64>()
    }

    fn spread(&self, i: usize) -> std::ops::Range<usize> {
        self.columns[i].start..self.columns[i].end - 1
    }

    /// Squared distance δ² of what two sets predict, and Bhattacharyya's distance.
    fn apart(&self, i: usize, j: usize, repeats: f64) -> Option<(f64, f64)> {
        let both: Vec<usize> = self.spread(i).chain(self.spread(j)).collect();
        let (p, q) = (self.columns[i].end - 1, self.columns[j].end - 1);
        let along = |c: usize| self.products[(p, c)] - self.products[(q, c)];
        let square = along(p) - along(q);
        let factor = self.factored(&both, 0.5 * repeats)?;
        let shadow = DVector::from_iterator(both.len(), both.iter().map(|c| along(*c)));
        // (I + r·½MMᵀ)⁻¹ = I − r·½ M (I + r·½ MᵀM)⁻¹ Mᵀ
        let taken = 0.5 * repeats * shadow.dot(&factor.solve(&shadow));
        let distance = (repeats * (square - taken)).max(0.0);
        let own = |i: usize| Some(Self::log_determinant(&self.factored(&self.spread(i).collect::<Vec<_>>(), repeats)?));
        let volume = 0.5 * Self::log_determinant(&factor) - 0.25 * (own(i)? + own(j)?);
        Some((distance, 0.125 * distance + volume.max(0.0)))
    }

    /// What the experiment tells about what is asked, nats.
    fn information(&self, contenders: &[Contender], repeats: usize) -> f64 {
        let n = self.weights.len();
        let mut overlap = DMatrix::identity(n, n);
        for i in 0..n {
            for j in 0..i {
                let [one, other] = [i, j].map(|i| &contenders[self.members[i]].asked);
                let apart = if one == other { None } else { self.apart(i, j, repeats as f64) };
                let both = apart.map_or(1.0, |(_, b)| (-b).exp());
                (overlap[(i, j)], overlap[(j, i)]) = (both, both);
            }
        }
        let seen = overlap * DVector::from_column_slice(&self.weights);
        -self.weights.iter().zip(seen.iter()).map(|(w, seen)| w * seen.ln()).sum::<f64>()
    }

    /// What it tells apart: effects in which two sets differ by one, those of the most probable sets first.
    fn told(&self, contenders: &[Contender], repeats: usize) -> Told {
        let mut differences: Vec<(f64, f64, Difference)> = Vec::new();
        for (i, one) in self.members.iter().enumerate() {
            for (j, other) in self.members.iter().enumerate() {
                let [one, other] = [one, other].map(|number| &contenders[*number]);
                let asked = Difference::between(&one.effects, &other.effects).filter(|_| one.asked != other.asked);
                let Some(difference) = asked else { continue };
                let Some((distance, _)) = self.apart(i, j, repeats as f64) else { continue };
                differences.push((self.weights[i] * self.weights[j], distance, difference));
            }
        }
        differences.sort_by(|a, b| b.0.total_cmp(&a.0));
        let is_told = |own: &&(f64, f64, Difference)| own.1 >= SEPARATE;
        let enough = differences.iter().any(|own| is_told(&own));
        let mut told = Told { pairs: Vec::new(), whether: Vec::new(), separation: f64::INFINITY, enough };
        for (_, distance, difference) in
            differences.iter().filter(|own| if enough { is_told(own) } else { own.1 > 1.0 })
        {
            let is_new = match difference {
                Difference::Instead(a, b) => {
                    let is_known =
                        |p: &(Description, Description)| (&p.0, &p.1) == (*a, *b) || (&p.0, &p.1) == (*b, *a);
                    let is_new = !told.pairs.iter().any(is_known);
                    is_new.then(|| told.pairs.push(((*a).clone(), (*b).clone())));
                    is_new
                }
                Difference::Beside(a) => {
                    let is_new = !told.whether.contains(a);
                    is_new.then(|| told.whether.push((*a).clone()));
                    is_new
                }
            };
            if is_new {
                told.separation = told.separation.min(distance.sqrt());
            }
        }
        told
    }
}

/// What an experiment tells.
struct Told {
    pairs: Vec<(Description, Description)>,
    whether: Vec<Description>,
    separation: f64,
    enough: bool,
}

/// In which one effect two sets differ.
enum Difference<'e> {
    /// One in the place of the other.
    Instead(&'e Description, &'e Description),
    /// One more.
    Beside(&'e Description),
}

impl<'e> Difference<'e> {
    fn between(one: &'e [Description], other: &'e [Description]) -> Option<Self> {
        let only = |a: &'e [Description], b: &[Description]| a.iter().filter(|e| !b.contains(e)).collect::<Vec<_>>();
        match (&only(one, other)[..], &only(other, one)[..]) {
            ([a], [b]) => Some(Self::Instead(a, b)),
            ([a], []) => Some(Self::Beside(a)),
            _ => None,
        }
    }
}
