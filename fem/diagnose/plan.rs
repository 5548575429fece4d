//! Before measuring: which effects planned rows could show, which would look alike, and what else to measure.

use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

use super::classes::SEPARATE;
use super::gain::gain;
use super::ground::Ground;
use super::next::REPEATS;
use super::price::{Price, Yardstick};
use super::search::SIGNIFICANCE;
use super::signature::{self, Candidate};
use super::visibility::{Visibility, visibility};
use super::{Next, absent, unsolvable};
use crate::compare::{Noise, NoiseSource};
use crate::fit::{Objective, Solution};
use crate::measure::Measurements;
use crate::model::Model;
use crate::process::{Description, Failure, Rows};

/// Effects are held against each other at a size at which each is plain to see, in standard uncertainties.
const PLAIN: f64 = 15.0;

/// What planned rows could show. SI units.
pub struct Plan {
    /// Number of planned rows.
    pub rows: usize,
    /// The noise that is expected, of each of the design's observables; root mean square.
    pub sigma: Vec<f64>,
    /// Every effect that the model does not have, with what could be seen of it; `None` where it changes nothing in these rows.
    pub effects: Vec<(&'static Description, Option<Visibility>)>,
    /// Pairs that would look alike.
    pub alike: Vec<Alike>,
    /// What else to measure, to tell most of them apart.
    pub next: Option<Next>,
}

/// Two effects that would look alike.
#[derive(Clone, Debug)]
pub struct Alike {
    /// One.
    pub one: &'static Description,
    /// The other.
    pub other: &'static Description,
    /// How far apart they are where one of them shows at fifteen standard uncertainties.
    pub separation: f64,
}

/// Assesses planned rows; `sigma` is the expected noise of each of the process's observables, where the design has no column `u`.
///
/// # Errors
/// The model cannot be computed.
pub fn plan(model: &Model, design: &Measurements, sigma: &[f64]) -> Result<Plan, Failure> {
    let of_rows = |rows: &Rows| rows.observable.iter().map(|o| sigma[*o]).collect::<Vec<f64>>();
    let known = design.uncertainty.clone().unwrap_or_else(|| of_rows(&design.rows));
    let expected = Noise { sigma: known.clone(), source: NoiseSource::Column };
    let absent = absent(model);
    let now = Assessment::of(model, &absent, design, known.clone())?;
    let alike = now.alike(&absent);
    let menu = model.system.menu(&design.rows);
    let rate = |further: crate::process::Further| {
        let rows = design.rows.and(&further.rows);
        let more = Measurements::planned(model.process, &design.name, rows);
        let at = |repeats: &usize| {
            let usual = |o: &usize| expected.usual(design, *o) / (*repeats as f64).sqrt();
            let new = further.rows.observable.iter().map(usual);
            let sigma = known.iter().copied().chain(new).collect();
            let then = Assessment::of(model, &absent, &more, sigma).ok()?;
            let told: Vec<(usize, usize)> = now.pairs().filter(|p| then.separation(*p).powi(2) >= SEPARATE).collect();
            let separation = told.iter().map(|p| then.separation(*p)).fold(f64::INFINITY, f64::min);
            let pairs: Vec<_> = told.iter().map(|(i, j)| (absent[*i], absent[*j])).collect();
            (!pairs.is_empty()).then(|| Next {
                further: further.clone(),
                repeats: *repeats,
                pairs,
                separation,
                enough: true,
            })
        };
        REPEATS.iter().filter_map(at).collect::<Vec<_>>()
    };
    let rated: Vec<Next> = menu.into_par_iter().flat_map_iter(rate).collect();
    let next = rated.into_iter().max_by_key(|n| (n.pairs.len(), std::cmp::Reverse(n.observations())));
    let typical = design.seen.iter().map(|s| expected.usual(design, s.position)).collect();
    Ok(Plan { rows: design.len(), sigma: typical, effects: absent.into_iter().zip(now.visible).collect(), alike, next })
}

/// What rows tell of all effects.
struct Assessment {
    visible: Vec<Option<Visibility>>,
    /// Between effects, in standard uncertainties.
    separations: DMatrix<f64>,
}

impl Assessment {
    fn of(
        model: &Model,
        absent: &[&'static Description],
        design: &Measurements,
        sigma: Vec<f64>,
    ) -> Result<Self, Failure> {
        let design = &*design.seen_by(&*model.system);
        let mut objective = Objective::new(model, design)?;
        objective.noise = Noise { sigma, source: NoiseSource::Column };
        let first = objective.axes.iter().map(|a| a.position(a.starts.first().copied().unwrap_or(0.0)));
        let position = DVector::from_iterator(objective.axes.len(), first);
        let predicted = objective.predict(&position).ok_or_else(unsolvable)?;
        let solution = Solution { position, predicted, chi2: 0.0 };
        let candidates = signature::candidates(&objective, &solution, absent);
        let ground = Ground::new(&mut objective, &solution).ok_or_else(unsolvable)?;
        let price = Price::simulate(&ground, &candidates.iter().collect::<Vec<_>>(), Yardstick::Known);
        let threshold = price.quantile(SIGNIFICANCE);
        Ok(Self {
            visible: candidates.iter().map(|c| visibility(&ground, c, threshold)).collect(),
            separations: separations(&ground, &candidates),
        })
    }

    /// How far two effects are apart, whichever can imitate the other better.
    fn separation(&self, (i, j): (usize, usize)) -> f64 {
        self.separations[(i, j)].min(self.separations[(j, i)])
    }

    /// The pairs of visible effects that look alike.
    fn pairs(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        let n = self.visible.len();
        let seen = |i: usize| self.visible[i].as_ref().is_some_and(|v| v.visible);
        let all = (0..n).flat_map(move |j| (0..j).map(move |i| (i, j)));
        all.filter(move |(i, j)| seen(*i) && seen(*j) && self.separation((*i, *j)).powi(2) < SEPARATE)
    }

    fn alike(&self, absent: &[&'static Description]) -> Vec<Alike> {
        let alike = |p: (usize, usize)| Alike { one: absent[p.0], other: absent[p.1], separation: self.separation(p) };
        let mut all: Vec<Alike> = self.pairs().map(alike).collect();
        all.sort_by(|a, b| a.separation.total_cmp(&b.separation));
        all
    }
}

/// (i, j): what is left of effect i, plain to see at its median shape, when j imitates it as well as it can.
fn separations(ground: &Ground, candidates: &[Candidate]) -> DMatrix<f64> {
    let n = candidates.len();
    let projected: Vec<Vec<(DMatrix<f64>, &[bool])>> = candidates
        .iter()
        .map(|c| c.variants.iter().map(|v| (ground.project_columns(&v.columns), &v.signed[..])).collect())
        .collect();
    let left = |column: DVector<f64>, other: &[(DMatrix<f64>, &[bool])]| {
        let size = column.norm();
        if size == 0.0 {
            return PLAIN;
        }
        let plain = column * (PLAIN / size);
        let falls = other.iter().map(|(c, signed)| {
            let (gram, along) = (c.transpose() * c, c.transpose() * &plain);
            // Of a signed effect either sign may be the true one.
            gain(&gram, &along, signed).fall.max(gain(&gram, &-along, signed).fall)
        });
        (PLAIN * PLAIN - falls.fold(0.0, f64::max)).max(0.0).sqrt()
    };
    let median = |(i, j): (usize, usize)| {
        let column = |c: &DMatrix<f64>| {
            let largest = c.column_iter().max_by(|a, b| a.norm().total_cmp(&b.norm()));
            largest.map_or_else(|| DVector::zeros(c.nrows()), |c| c.into_owned())
        };
        let mut all: Vec<f64> = projected[i].iter().map(|(c, _)| left(column(c), &projected[j])).collect();
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

/// The rows of a model's own programme, thinned to what a person would measure.
pub fn programme(model: &Model) -> Measurements {
    /// Rows that are planned for where nobody says which.
    const MOST: usize = 240;
    let all = model.system.programme();
    let step = all.len().div_ceil(MOST).max(1);
    // A step that has no common factor with the length of a pass visits every place.
    let step = (step..).find(|s| !all.len().is_multiple_of(*s) || *s == 1).unwrap_or(step);
    let take = |column: &Vec<f64>| column.iter().copied().step_by(step).collect();
    let rows = Rows {
        columns: all.columns.iter().map(take).collect(),
        observable: all.observable.iter().copied().step_by(step).collect(),
    };
    Measurements::planned(model.process, "the model's own programme", rows)
}
