//! Plans a measurement: the effects that planned rows could show, those that would be confounded, and what
//! else to measure.

use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

use super::confounding::SEPARATE;
use super::detection_limit::{DetectionLimit, detection_limit};
use super::gain::gain;
use super::next::REPEATS;
use super::null_distribution::{MaxStatistic, Variance};
use super::residual_projection::ProjectedResidual;
use super::screening::Screening;
use super::search::SIGNIFICANCE;
use super::sensitivity::{self, CandidateEffect};
use super::{Next, absent, instrument, unsolvable};
use crate::fit::{Objective, Solution};
use crate::model::Data;
use crate::noise::{Acts, Noise, NoiseSource, Term};
use crate::process::{Description, Failure, Rows, Values};

/// Size at which effects are compared with each other, in standard uncertainties: each is plain to see.
const PLAIN: f64 = 15.0;

/// Assessment of planned rows. SI units.
#[non_exhaustive]
pub struct Plan {
    /// Number of planned rows.
    pub rows: usize,
    /// Expected noise of each of the design's observables, root mean square.
    pub sigma: Vec<f64>,
    /// Every effect that the model does not have, also of the instrument, with its detection limit; `None` where it changes nothing
    /// in these rows.
    #[doc(hidden)]
    pub effects: Vec<(Description, Option<DetectionLimit>)>,
    /// Pairs of effects that would be confounded.
    #[doc(hidden)]
    pub alike: Vec<Alike>,
    /// Further experiment that tells most of them apart.
    #[doc(hidden)]
    pub next: Option<Next>,
    /// Effects of the measurement that the noise of the rows has.
    #[doc(hidden)]
    pub terms: Vec<Term>,
    /// Those that are left aside, for their size is unknown.
    #[doc(hidden)]
    pub unknown: Vec<Term>,
}

/// Two effects that would be confounded.
#[derive(Clone, Debug)]
pub struct Alike {
    /// One effect.
    pub one: Description,
    /// The other effect.
    pub other: Description,
    /// Separation, in standard uncertainties, where one of them shows at fifteen.
    pub separation: f64,
}

/// Assesses planned rows; `sigma` is the expected noise of each of the process's observables, where the
/// design has no column `u`.
///
/// # Errors
/// The model cannot be computed.
pub fn plan(design: &Data, sigma: &[f64]) -> Result<Plan, Failure> {
    let model = design.model;
    let of_rows = |rows: &Rows| rows.observable.iter().map(|o| sigma[*o]).collect::<Values>();
    let known = design.uncertainty.clone().unwrap_or_else(|| of_rows(&design.rows));
    let (unknown, terms): (Vec<Term>, Vec<Term>) = design.terms.iter().cloned().partition(is_unknown);
    let expected = Noise::independent(known.clone(), NoiseSource::Column);
    let absent = [absent(model), instrument::absent_readings(design)].concat();
    let now = Assessment::of(&absent, design, known.clone())?;
    let alike = now.alike(&absent);
    let experiments = model.system.candidate_experiments(&design.rows);
    let rate = |experiment: crate::process::CandidateExperiment| {
        if !design.progress.permits(&format!("whether it helps to {}", experiment.words)) {
            return Vec::new();
        }
        let rows = design.rows.and(&experiment.rows);
        let more = Data::proposed(model, &design.name, rows).watched(design.progress.clone());
        let at = |repeats: &usize| {
            let usual = |o: &usize| expected.usual(design, *o) / (*repeats as f64).sqrt();
            let new = experiment.rows.observable.iter().map(usual);
            let sigma = known.iter().copied().chain(new).collect();
            let then = Assessment::of(&absent, &more, sigma).ok()?;
            let told: Vec<(usize, usize)> = now.pairs().filter(|p| then.separation(*p).powi(2) >= SEPARATE).collect();
            let separation = told.iter().map(|p| then.separation(*p)).fold(f64::INFINITY, f64::min);
            let pairs: Vec<_> = told.iter().map(|(i, j)| (absent[*i].clone(), absent[*j].clone())).collect();
            (!pairs.is_empty()).then(|| Next {
                experiment: experiment.clone(),
                steps: 1,
                repeats: *repeats,
                pairs,
                whether: Vec::new(),
                separation,
                enough: true,
                sets: None,
            })
        };
        REPEATS.iter().filter_map(at).collect::<Vec<_>>()
    };
    let rated: Vec<Next> = experiments.into_par_iter().flat_map_iter(rate).collect();
    let next = rated.into_iter().max_by_key(|n| (n.pairs.len(), std::cmp::Reverse(n.observations())));
    let typical = design.observables.iter().map(|s| expected.usual(design, s.position)).collect();
    let effects = absent.into_iter().zip(now.visible).collect();
    Ok(Plan { rows: design.len(), sigma: typical, effects, alike, next, terms, unknown })
}

/// Whether the size of a term is unknown, so that it can act in no plan.
fn is_unknown(term: &Term) -> bool {
    term.size.is_nan() && (term.effect.acts.is_estimated() || matches!(term.effect.acts, Acts::Rounds))
}

/// Detection limits and separations of all effects in a design.
struct Assessment {
    visible: Vec<Option<DetectionLimit>>,
    /// Separation between effects, in standard uncertainties.
    separations: DMatrix<f64>,
}

impl Assessment {
    fn of(absent: &[Description], design: &Data, sigma: Values) -> Result<Self, Failure> {
        let mut objective = Objective::new(design)?;
        let terms = design.terms.iter().filter(|term| !is_unknown(term)).cloned().collect();
        objective.noise = Noise::independent(sigma, NoiseSource::Column).with(terms, design);
        let first = objective.variables.iter().map(|a| a.position(a.starts.first().copied().unwrap_or(0.0)));
        let position = DVector::from_iterator(objective.variables.len(), first);
        let predicted = objective.predict(&position).ok_or_else(unsolvable)?;
        let solution = Solution { position, predicted, chi2: 0.0, slopes: None, is_at_rest: false };
        let candidates = sensitivity::candidates(&objective, &solution, absent);
        let projected = ProjectedResidual::new(&mut objective, &solution).ok_or_else(unsolvable)?;
        let screening = Screening::new(&projected, &candidates.iter().collect::<Vec<_>>());
        let null_distribution = MaxStatistic::simulate(&screening, projected.freedom, Variance::Known);
        let threshold = null_distribution.quantile(SIGNIFICANCE);
        Ok(Self {
            visible: candidates.iter().map(|c| detection_limit(&projected, c, threshold)).collect(),
            separations: separations(&projected, &candidates),
        })
    }

    /// Separation of two effects, whichever can imitate the other better.
    fn separation(&self, (i, j): (usize, usize)) -> f64 {
        self.separations[(i, j)].min(self.separations[(j, i)])
    }

    /// Pairs of detectable effects that are confounded.
    fn pairs(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let n = self.visible.len();
        let seen = |i: usize| self.visible[i].as_ref().is_some_and(|v| v.detectable);
        let all = (0..n).flat_map(move |j| (0..j).map(move |i| (i, j)));
        all.filter(move |(i, j)| seen(*i) && seen(*j) && self.separation((*i, *j)).powi(2) < SEPARATE)
    }

    fn alike(&self, absent: &[Description]) -> Vec<Alike> {
        let alike = |p: (usize, usize)| Alike {
            one: absent[p.0].clone(),
            other: absent[p.1].clone(),
            separation: self.separation(p),
        };
        let mut all: Vec<Alike> = self.pairs().map(alike).collect();
        // Separations that differ by round-off stand in the order of the catalogue.
        let shown = |a: &Alike| (1e3 * a.separation).round();
        all.sort_by(|a, b| shown(a).total_cmp(&shown(b)));
        all
    }
}

/// Entry (i, j): length left of effect i, plain to see at its median variant, when effect j imitates it as
/// well as it can.
fn separations(projected: &ProjectedResidual, candidates: &[CandidateEffect]) -> DMatrix<f64> {
    let n = candidates.len();
    let columns: Vec<Vec<(DMatrix<f64>, &[bool])>> = candidates
        .iter()
        .map(|c| c.variants.iter().map(|v| (projected.project_columns(&v.columns), &v.signed[..])).collect())
        .collect();
    let left = |column: DVector<f64>, other: &[(DMatrix<f64>, &[bool])]| {
        let size = column.norm();
        if size == 0.0 {
            return PLAIN;
        }
        let plain = column * (PLAIN / size);
        let falls = other.iter().map(|(c, signed)| {
            let (gram, along) = (c.transpose() * c, c.transpose() * &plain);
            // Either sign may be the true one of a signed effect.
            gain(&gram, &along, signed).delta_chi2.max(gain(&gram, &-along, signed).delta_chi2)
        });
        (PLAIN * PLAIN - falls.fold(0.0, f64::max)).max(0.0).sqrt()
    };
    let median = |(i, j): (usize, usize)| {
        let column = |c: &DMatrix<f64>| {
            let largest = c.column_iter().max_by(|a, b| a.norm().total_cmp(&b.norm()));
            largest.map_or_else(|| DVector::zeros(c.nrows()), |c| c.into_owned())
        };
        let mut all: Vec<f64> = columns[i].iter().map(|(c, _)| left(column(c), &columns[j])).collect();
        all.sort_unstable_by(f64::total_cmp);
        all.get(all.len() / 2).copied().unwrap_or(PLAIN)
    };
    let places: Vec<(usize, usize)> =
        (0..n).flat_map(|j| (0..n).map(move |i| (i, j))).filter(|(i, j)| i != j).collect();
    let values: Vec<f64> = places.par_iter().map(|p| median(*p)).collect();
    let mut matrix = DMatrix::from_element(n, n, 0.0);
    places.iter().zip(values).for_each(|(p, v)| matrix[*p] = v);
    matrix
}
