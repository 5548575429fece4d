//! Laws that are like those of the catalogue and not equal to them: a contact with another exponent, wear that
//! bends, play that is not the same along the screw. What such a cause leaves must not be given to a second one.
//!
//! The law of an effect is let off by a share of itself that varies smoothly along a coordinate, or with its own
//! size. The shares have a normal distribution, and are weighed against a further effect by the marginal
//! likelihood of the rows (Bayes factor), whose determinant is the price of their freedom.

use nalgebra::{Cholesky, DMatrix, DVector};

use super::candidate_model::CandidateModel;
use super::confounding::EQUAL_FIT;
use super::lead::bare;
use super::residual_projection::ProjectedResidual;
use super::search::SearchResult;
use crate::input::Name;
use crate::units::ANGLE;

/// Standard deviation of the share of itself by which a law is off.
const SHARE: f64 = 0.2;
/// Largest share at which a law is still like the catalogue's.
const LARGEST: f64 = 0.6;

/// How the law of an effect bends.
#[derive(Clone, Debug, PartialEq)]
pub struct Bend {
    /// Name of the effect.
    pub effect: Name,
    /// Coordinate along which it bends; `None` where it does with its own size.
    pub along: Option<Name>,
    /// Largest share of itself by which it is off.
    pub share: f64,
    /// Fall of −2 ln L, the price of the bend paid.
    pub evidence: f64,
}

/// The bend of a member's law that explains most of what a set leaves; `None` where none explains more than
/// what confounds effects.
pub fn bend(found: &SearchResult, set: &CandidateModel) -> Option<Bend> {
    let projected = ProjectedResidual::new(&mut set.objective.clone(), &set.solution)?;
    let of_member = |member: &usize| {
        let signature = signature(found, set, *member)?;
        let shapes = shapes(set, &signature);
        let bends = shapes.into_iter().filter_map(|(along, shape)| {
            let (evidence, share) = evidence(set, &projected, &signature, &shape)?;
            if share > LARGEST {
                return None;
            }
            Some(Bend { effect: found.candidates[*member].effect.name.clone(), along, share, evidence })
        });
        bends.max_by(|a, b| a.evidence.total_cmp(&b.evidence))
    };
    let bends = set.members.iter().filter_map(of_member);
    bends.max_by(|a, b| a.evidence.total_cmp(&b.evidence)).filter(|bend| bend.evidence > EQUAL_FIT)
}

/// Contribution of a member to the prediction of every row, SI.
fn signature(found: &SearchResult, set: &CandidateModel, member: usize) -> Option<Vec<f64>> {
    let rest = bare(&found.base, &found.candidates, set, member)?;
    Some(set.change_from(&rest).collect())
}

/// Shapes that the share may have over the rows, a column each, with the coordinate along which they run.
fn shapes(set: &CandidateModel, signature: &[f64]) -> Vec<(Option<Name>, DMatrix<f64>)> {
    let data = set.objective.data;
    let coordinates = data.model.process.coordinates();
    let along = data.given.iter().flat_map(|i| {
        let (coordinate, column) = (&coordinates[*i], &data.rows.columns[*i].to_vec());
        let waves = (coordinate.holds.kind() == Some(ANGLE)).then(|| waves(column));
        curve(column).into_iter().chain(waves).map(|shape| (Some(coordinate.name.clone()), shape))
    });
    let largest = signature.iter().fold(0.0_f64, |most, s| most.max(s.abs()));
    // Another exponent: to first order a law is off by the logarithm of its size.
    let exponent = signature.iter().map(|s| if *s == 0.0 { 0.0 } else { (s.abs() / largest).ln() });
    let exponent = DMatrix::from_iterator(signature.len(), 1, exponent);
    along.chain(curve(signature).into_iter().chain([exponent]).map(|shape| (None, shape))).collect()
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

/// Fall of −2 ln L when the shares along these shapes are marginalised, and the largest share at their most
/// likely values.
fn evidence(
    set: &CandidateModel,
    projected: &ProjectedResidual,
    signature: &[f64],
    shape: &DMatrix<f64>,
) -> Option<(f64, f64)> {
    let objective = &set.objective;
    let columns: Vec<DVector<f64>> = shape
        .column_iter()
        .map(|column| {
            let bent = column.iter().zip(signature).map(|(share, s)| SHARE * share * s);
            projected.project(objective.whiten(bent))
        })
        .collect();
    let columns = DMatrix::from_columns(&columns);
    let along = columns.transpose() * &projected.residual;
    let normal = columns.transpose() * &columns + DMatrix::identity(columns.ncols(), columns.ncols());
    let factor = Cholesky::new(normal)?;
    let amplitudes = factor.solve(&along);
    let log_determinant = 2.0 * factor.l_dirty().diagonal().iter().map(|d| d.ln()).sum::<f64>();
    let largest = signature.iter().fold(0.0_f64, |most, s| most.max(s.abs()));
    let off = (shape * &amplitudes * SHARE)
        .iter()
        .zip(signature)
        .fold(0.0_f64, |most, (share, s)| most.max((share * s).abs()));
    let share = off / largest;
    Some((along.dot(&amplitudes) - log_determinant, share))
}
