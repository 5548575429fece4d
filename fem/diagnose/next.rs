//! Next measurement: the candidate experiment that best tells confounded effects apart (design of
//! experiments).

use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

use super::candidate_model::CandidateModel;
use super::confounding::{Confounding, SEPARATE, priors_apart};
use super::look_alike::LookAlike;
use super::residual_projection::length_outside;
use super::search::SearchResult;
use crate::process::{CandidateExperiment, Description, Rows};

/// Numbers of repeats of an experiment that are considered.
pub const REPEATS: &[usize] = &[1, 2, 4, 8];

/// Measurement to make next.
#[derive(Clone, Debug)]
pub struct Next {
    /// Experiment to make.
    pub experiment: CandidateExperiment,
    /// Number of repeats of each of its rows.
    pub repeats: usize,
    /// Pairs of effects that it tells apart, or, where it is not enough, brings farther apart.
    pub pairs: Vec<(Description, Description)>,
    /// Separation of the worst pair, in standard uncertainties.
    pub separation: f64,
    /// Whether that separation is enough to tell them apart.
    pub enough: bool,
}

impl Next {
    /// Number of rows, repeats included.
    pub fn observations(&self) -> usize {
        self.repeats * self.experiment.rows.len()
    }
}

/// Two models that the rows cannot tell apart: the best, and one with another cause in the place of one of its
/// own.
struct Rival<'r, 'a> {
    /// The cause, and the other.
    pair: (&'r Description, &'r Description),
    model: &'r CandidateModel<'a>,
    /// Squared separation in the rows that were measured.
    separation: f64,
    /// Whether one of the causes is the instrument's: new rows then have a zero that nobody knows.
    has_free_zero: bool,
}

/// Selects the candidate experiment that tells most pairs apart, with the fewest rows. `None` where nothing
/// is confounded, or no experiment would help.
pub fn next(
    found: &SearchResult,
    best: &CandidateModel,
    confoundings: &[Confounding],
    look_alikes: &[LookAlike],
) -> Option<Next> {
    let experiments = best.objective.data.model.system.candidate_experiments(&best.objective.data.rows);
    let effect = |number: usize| &found.candidates[number].effect;
    let of_effects = confoundings.iter().flat_map(|own| {
        own.alternatives.iter().map(move |other| Rival {
            pair: (effect(own.candidate), effect(other.candidate)),
            model: &other.model,
            separation: other.separation,
            has_free_zero: false,
        })
    });
    let of_terms = look_alikes.iter().filter_map(|own| {
        let (model, separation) = own.model.as_ref()?;
        Some(Rival { pair: (&own.cause, &own.other), model, separation: *separation, has_free_zero: true })
    });
    let rivals: Vec<Rival> = of_effects.chain(of_terms).collect();
    let rated: Vec<Next> =
        experiments.into_par_iter().flat_map_iter(|experiment| rate(best, &rivals, &experiment)).collect();
    let value = |n: &Next| (if n.enough { n.pairs.len() } else { 0 }, n.separation);
    rated.into_iter().max_by(|a, b| {
        let told = value(a).0.cmp(&value(b).0);
        let rows = if a.enough { b.observations().cmp(&a.observations()) } else { std::cmp::Ordering::Equal };
        told.then(rows).then(value(a).1.total_cmp(&value(b).1))
    })
}

/// Rates an experiment for each number of repeats.
fn rate(best: &CandidateModel, rivals: &[Rival], experiment: &CandidateExperiment) -> Vec<Next> {
    let contrast = |rival: &Rival| {
        let pair = (rival.pair.0.clone(), rival.pair.1.clone());
        Some((pair, rival.separation, Contrast::new(best, rival, &experiment.rows)?))
    };
    let contrasts: Vec<_> = rivals.iter().filter_map(contrast).collect();
    let at = |repeats: usize| {
        let seen: Vec<_> =
            contrasts.iter().map(|(pair, before, c)| (pair.clone(), *before, c.distance(repeats))).collect();
        let told = |s: &&(_, f64, f64)| s.2 * s.2 >= SEPARATE;
        let enough = seen.iter().any(|s| told(&s));
        let helped: Vec<_> = seen.iter().filter(|s| if enough { told(s) } else { s.2 * s.2 > s.1 + 1.0 }).collect();
        let separation = helped.iter().map(|s| s.2).fold(f64::INFINITY, f64::min);
        let pairs: Vec<_> = helped.iter().map(|s| s.0.clone()).collect();
        (!pairs.is_empty()).then(|| Next { experiment: experiment.clone(), repeats, pairs, separation, enough })
    };
    REPEATS.iter().filter_map(|r| at(*r)).collect()
}

/// Difference between two models over the measured rows and those of an experiment.
struct Contrast {
    measured: DVector<f64>,
    jacobian: DMatrix<f64>,
    /// Difference in each row of the experiment, measured once, in its standard uncertainty.
    experiment: DVector<f64>,
    experiment_jacobian: DMatrix<f64>,
}

impl Contrast {
    fn new(best: &CandidateModel, rival: &Rival, experiment: &Rows) -> Option<Self> {
        let alternative = rival.model;
        let (one, other) = (best.objective.clone(), alternative.objective.clone());
        let sigma = experiment.observable.iter().map(|o| one.noise.usual(one.data, *o));
        let sigma = DVector::from_iterator(experiment.len(), sigma);
        let mut jacobian = other.jacobian(&alternative.solution)?;
        // Residuals are measured less predicted, so that their derivatives have the opposite sign.
        let mut experiment_jacobian = -other.sensitivities(&alternative.solution.position, experiment)?;
        experiment_jacobian.column_iter_mut().for_each(|mut c| c.component_div_assign(&sigma));
        let ahead = one.predict_rows(&best.solution.position, experiment)?;
        let behind = other.predict_rows(&alternative.solution.position, experiment)?;
        let measured = best.solution.predicted.iter().zip(&alternative.solution.predicted).map(|(p, q)| p - q);
        if rival.has_free_zero {
            let columns = jacobian.ncols();
            jacobian = jacobian.insert_column(columns, 0.0);
            experiment_jacobian = experiment_jacobian.insert_column(columns, 0.0);
            experiment_jacobian.set_column(columns, &sigma.map(|s| 1.0 / s));
        }
        let measured = other.noise.whiten(measured).into_iter().chain(priors_apart(best, alternative)).collect();
        let experiment = (DVector::from_vec(ahead) - DVector::from_vec(behind)).component_div(&sigma);
        Some(Self { measured: DVector::from_vec(measured), jacobian, experiment, experiment_jacobian })
    }

    /// Distance between the two, in standard uncertainties, that no parameter of the alternative can bridge.
    fn distance(&self, repeats: usize) -> f64 {
        let weight = (repeats as f64).sqrt();
        let (n, m) = (self.measured.len(), self.experiment.len());
        let apart = DVector::from_iterator(
            n + m,
            self.measured.iter().copied().chain(self.experiment.iter().map(|v| v * weight)),
        );
        let mut both = DMatrix::zeros(n + m, self.jacobian.ncols());
        both.rows_mut(0, n).copy_from(&self.jacobian);
        both.rows_mut(n, m).copy_from(&(&self.experiment_jacobian * weight));
        length_outside(&both, apart)
    }
}
