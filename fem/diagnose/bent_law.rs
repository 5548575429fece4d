//! Laws that are like those of the catalogue and not equal to them: a contact with another exponent, wear that
//! bends, play that is not the same along the screw. What such a cause leaves must not be given to a second one.
//!
//! The law of an effect is let off by a share of itself that varies smoothly along a coordinate, or with its own
//! size. The shares have a normal distribution, and are weighed against a further effect by the marginal
//! likelihood of the rows (Bayes factor), whose determinant is the price of their freedom.

use nalgebra::{Cholesky, DMatrix, DVector};
use rayon::prelude::*;

use super::candidate_model::{CandidateModel, Weighed};
use super::confounding::EQUAL_FIT;
use super::laplace;
use super::lead::bare;
use super::residual_projection::ProjectedResidual;
use super::search::SearchResult;
use crate::input::Name;
use crate::process::Neutral;
use crate::units::ANGLE;

/// Standard deviation of the share of itself by which a law is off.
const SHARE: f64 = 0.2;
/// Largest share at which a law is still like the catalogue's.
const LARGEST: f64 = 0.6;
/// Odds that the law of a cause that is there bends, and is seen to.
const ODDS: f64 = 0.1;
/// Rise of the criterion up to which a law that is exact is told before one that bends: odds of four hundred to one.
const EXACT: f64 = 12.0;
/// Rise of the criterion from the best set up to which a set may come down to it by a bend, and how many are looked at.
const HOPEFUL: f64 = 6.0;
const MOST_SETS: usize = 16;

/// What a law bends along.
#[derive(Clone, Debug, PartialEq)]
pub enum Along {
    /// A coordinate.
    Coordinate(Name),
    /// The size of the effect itself.
    Size,
    /// The turns of a wave: it has harmonics.
    Turns,
}

/// How the law of an effect bends.
#[derive(Clone, Debug, PartialEq)]
pub struct Bend {
    /// Name of the effect.
    pub effect: Name,
    /// What it bends along.
    pub along: Along,
    /// Largest share of itself by which it is off.
    pub share: f64,
    /// Fall of −2 ln L, the price of the bend paid.
    pub evidence: f64,
    /// Fall of χ², that price not paid.
    fall: f64,
    /// Number of bends of which it is the best.
    among: usize,
}

impl Bend {
    /// −2 ln of the posterior weight of a set whose criterion this is without the bend.
    fn criterion(&self, set: &Weighed) -> f64 {
        let chi2 = set.model.solution.chi2;
        let fall = laplace::misfit(&set.model, chi2) - laplace::misfit(&set.model, (chi2 - self.fall).max(0.0));
        set.criterion - fall + (self.fall - self.evidence) + 2.0 * (self.among as f64).ln() - 2.0 * ODDS.ln()
    }
}

/// The sets, by their numbers among those that were tried, that are likelier where one of their laws bends, with their
/// criteria then.
pub fn bent_sets(found: &SearchResult) -> Vec<(usize, f64)> {
    let least = found.tried.first().map_or(0.0, |best| best.criterion);
    // No bend takes away more than what exceeds the noise.
    let down_to = |set: &Weighed| {
        let (chi2, freedom) = (set.model.solution.chi2, set.model.objective.freedom());
        let misfit = |chi2: f64| laplace::misfit(&set.model, chi2);
        set.criterion - (misfit(chi2) - misfit(chi2.min(freedom)))
    };
    let is_hopeful = |(_, set): &(usize, &Weighed)| {
        !set.model.members.is_empty() && down_to(set) - 2.0 * ODDS.ln() < least + HOPEFUL
    };
    let mut hopeful: Vec<(usize, &Weighed)> = found.tried.iter().enumerate().filter(is_hopeful).collect();
    hopeful.sort_by(|a, b| down_to(a.1).total_cmp(&down_to(b.1)));
    hopeful.truncate(MOST_SETS);
    let bent = |(number, set): (usize, &Weighed)| {
        let criterion = best_bend(found, &set.model)?.criterion(set);
        (criterion < set.criterion).then_some((number, criterion))
    };
    hopeful.into_par_iter().filter_map(bent).collect()
}

/// The least −2 ln of the weight, where nothing is held to be usual, of sets that are likelier where one of their laws bends;
/// infinite without any. By it they are held against laws that write the same and need no bend: these are told before it.
pub fn criterion_of_values(found: &SearchResult, bent: &[(usize, f64)]) -> f64 {
    let of = |(number, bent): &(usize, f64)| {
        let set = &found.tried[*number];
        laplace::criterion_of_values(&set.model) + bent - set.criterion + EXACT
    };
    bent.iter().map(of).fold(f64::INFINITY, f64::min)
}

/// The bend of a member's law that explains most of what a set leaves; `None` where none explains more than
/// what confounds effects.
pub fn bend(found: &SearchResult, set: &CandidateModel) -> Option<Bend> {
    best_bend(found, set).filter(|bend| bend.evidence > EQUAL_FIT)
}

fn best_bend(found: &SearchResult, set: &CandidateModel) -> Option<Bend> {
    let projected = ProjectedResidual::new(&mut set.objective.clone(), &set.solution)?;
    let of_member = |member: &usize| {
        let Some(signature) = signature(found, set, *member) else { return Vec::new() };
        let harmonics = harmonics(found, set, *member, &signature).map(|shape| (Along::Turns, shape));
        let bends = shapes(set, &signature).into_iter().chain(harmonics).filter_map(|(along, shape)| {
            let (evidence, fall, share) = evidence(set, &projected, &signature, &shape)?;
            let effect = found.candidates[*member].effect.name.clone();
            Some(Bend { effect, along, share, evidence, fall, among: 0 })
        });
        bends.collect()
    };
    let bends: Vec<Bend> = set.members.iter().flat_map(of_member).collect();
    let among = bends.len();
    let like = bends.into_iter().filter(|bend| bend.share <= LARGEST);
    like.max_by(|a, b| a.evidence.total_cmp(&b.evidence)).map(|bend| Bend { among, ..bend })
}

/// Contribution of a member to the prediction of every row, SI.
fn signature(found: &SearchResult, set: &CandidateModel, member: usize) -> Option<Vec<f64>> {
    let rest = bare(&found.base, &found.candidates, set, member)?;
    Some(set.change_from(&rest).collect())
}

/// What a member adds to the rows for each shape that its share may have, a column each, SI per unit of the share.
fn shapes(set: &CandidateModel, signature: &[f64]) -> Vec<(Along, DMatrix<f64>)> {
    let data = set.objective.data;
    let coordinates = data.model.process.coordinates();
    let along = data.given.iter().flat_map(|i| {
        let (coordinate, column) = (&coordinates[*i], &data.rows.columns[*i].to_vec());
        let waves = (coordinate.holds.kind() == Some(ANGLE)).then(|| waves(column));
        curve(column).into_iter().chain(waves).map(|shape| (Along::Coordinate(coordinate.name.clone()), shape))
    });
    let largest = signature.iter().fold(0.0_f64, |most, s| most.max(s.abs()));
    // Another exponent: to first order a law is off by the logarithm of its size.
    let exponent = signature.iter().map(|s| if *s == 0.0 { 0.0 } else { (s.abs() / largest).ln() });
    let exponent = DMatrix::from_iterator(signature.len(), 1, exponent);
    let of_size = curve(signature).into_iter().chain([exponent]).map(|shape| (Along::Size, shape));
    let of_itself = |(along, mut shape): (Along, DMatrix<f64>)| {
        shape.row_iter_mut().zip(signature).for_each(|(mut row, s)| row *= *s);
        (along, shape)
    };
    along.chain(of_size).map(of_itself).collect()
}

/// The second and the third harmonic of a member that is a wave: what it adds to the rows a quarter of a period on is the
/// cosine to its sine.
fn harmonics(found: &SearchResult, set: &CandidateModel, member: usize, signature: &[f64]) -> Option<DMatrix<f64>> {
    let effect = &found.candidates[member].effect;
    let phase = effect.parameters.iter().position(|p| p.period.is_some() && p.neutral == Neutral::Shape)?;
    let quarter = 0.25 * effect.parameters[phase].kind.to_si(effect.parameters[phase].period?);
    let before = set.members.iter().take_while(|m| **m != member).map(|m| found.candidates[*m].parameters);
    let mut position = set.solution.position.clone();
    position[found.base.objective.variables.len() + before.sum::<usize>() + phase] += quarter;
    let moved = set.objective.predict(&position)?;
    // What the others add is the same: the wave moved less the wave where it is, and the wave itself.
    let cosine: Vec<f64> =
        moved.iter().zip(&set.solution.predicted).zip(signature).map(|((m, p), s)| m - p + s).collect();
    let turn = |row: usize| (signature[row].hypot(cosine[row]), signature[row].atan2(cosine[row]));
    Some(DMatrix::from_fn(signature.len(), 4, |row, j| {
        let ((size, at), times) = (turn(row), f64::from(2 + j as u32 / 2));
        size * if j % 2 == 0 { (times * at).cos() } else { (times * at).sin() }
    }))
}

/// A line and a parabola along a coordinate (Legendre polynomials over its span); `None` where it does not vary.
fn curve(column: &[f64]) -> Option<DMatrix<f64>> {
    let low = column.iter().copied().fold(f64::INFINITY, f64::min);
    let high = column.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if low >= high {
        return None;
    }
    let is_between = column.iter().any(|v| *v > low && *v < high);
    Some(DMatrix::from_fn(column.len(), if is_between { 2 } else { 1 }, |row, j| {
        let t = 2.0 * (column[row] - low) / (high - low) - 1.0;
        if j == 0 { t } else { 1.5 * t * t - 0.5 }
    }))
}

/// One and two waves around an angle.
fn waves(column: &[f64]) -> DMatrix<f64> {
    DMatrix::from_fn(column.len(), 4, |row, j| {
        let angle = f64::from(1 + j as u32 / 2) * column[row];
        if j % 2 == 0 { angle.cos() } else { angle.sin() }
    })
}

/// Fall of −2 ln L when the shares along these shapes are marginalised, that of χ², and the largest share at their most
/// likely values.
fn evidence(
    set: &CandidateModel,
    projected: &ProjectedResidual,
    signature: &[f64],
    shape: &DMatrix<f64>,
) -> Option<(f64, f64, f64)> {
    let objective = &set.objective;
    let columns: Vec<DVector<f64>> = shape
        .column_iter()
        .map(|column| projected.project(objective.whiten(column.iter().map(|v| SHARE * v))))
        .collect();
    let columns = DMatrix::from_columns(&columns);
    let along = columns.transpose() * &projected.residual;
    let normal = columns.transpose() * &columns + DMatrix::identity(columns.ncols(), columns.ncols());
    let factor = Cholesky::new(normal)?;
    let amplitudes = factor.solve(&along);
    let log_determinant = 2.0 * factor.l_dirty().diagonal().iter().map(|d| d.ln()).sum::<f64>();
    let largest = signature.iter().fold(0.0_f64, |most, s| most.max(s.abs()));
    let share = SHARE * (shape * &amplitudes).amax() / largest;
    let fall = along.dot(&amplitudes);
    Some((fall - log_determinant, fall, share))
}
