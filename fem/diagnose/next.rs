//! The next measurement: of everything that could be measured, what tells best apart what these data cannot.

use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

use super::classes::{Place, Rival, SEPARATE, priors_apart};
use super::ground::length_outside;
use super::search::Found;
use super::trial::Trial;
use crate::process::{Description, Further, Rows};

/// How often the further rows are measured.
pub const REPEATS: &[usize] = &[1, 2, 4, 8];

/// The measurement to make next.
#[derive(Clone, Debug)]
pub struct Next {
    /// What to measure.
    pub further: Further,
    /// How often each of its rows.
    pub repeats: usize,
    /// Which effects it tells apart, or, where it is not enough, brings farther apart.
    pub pairs: Vec<(&'static Description, &'static Description)>,
    /// By how many standard uncertainties, the worst pair.
    pub separation: f64,
    /// Whether that is enough to tell them apart.
    pub enough: bool,
}

impl Next {
    /// Number of rows in all.
    pub fn observations(&self) -> usize {
        self.repeats * self.further.rows.len()
    }
}

/// The best of the menu: what tells most pairs apart, with the fewest rows. `None` where there is nothing to tell apart, or nothing on the
/// menu that would help.
pub fn next(found: &Found, best: &Trial, places: &[Place]) -> Option<Next> {
    let menu = best.objective.model.system.menu(&best.objective.measurements.rows);
    let rivals: Vec<_> = places.iter().flat_map(|p| p.rivals.iter().map(move |r| (p.candidate, r))).collect();
    let rated: Vec<Next> = menu.into_par_iter().flat_map_iter(|further| rate(found, best, &rivals, &further)).collect();
    let value = |n: &Next| (if n.enough { n.pairs.len() } else { 0 }, n.separation);
    rated.into_iter().max_by(|a, b| {
        let told = value(a).0.cmp(&value(b).0);
        let rows = if a.enough { b.observations().cmp(&a.observations()) } else { std::cmp::Ordering::Equal };
        told.then(rows).then(value(a).1.total_cmp(&value(b).1))
    })
}

/// What a further measurement tells, for each number of repeats.
fn rate(found: &Found, best: &Trial, rivals: &[(usize, &Rival)], further: &Further) -> Vec<Next> {
    let contrasts: Vec<_> = rivals
        .iter()
        .filter_map(|(member, rival)| {
            let pair = (found.candidates[*member].effect, found.candidates[rival.candidate].effect);
            Some((pair, rival.separation, Contrast::new(best, &rival.trial, &further.rows)?))
        })
        .collect();
    let at = |repeats: usize| {
        let seen: Vec<_> = contrasts.iter().map(|(pair, before, c)| (*pair, *before, c.distance(repeats))).collect();
        let told = |s: &&(_, f64, f64)| s.2 * s.2 >= SEPARATE;
        let enough = seen.iter().any(|s| told(&s));
        let helped: Vec<_> = seen.iter().filter(|s| if enough { told(s) } else { s.2 * s.2 > s.1 + 1.0 }).collect();
        let separation = helped.iter().map(|s| s.2).fold(f64::INFINITY, f64::min);
        let pairs: Vec<_> = helped.iter().map(|s| s.0).collect();
        (!pairs.is_empty()).then(|| Next { further: further.clone(), repeats, pairs, separation, enough })
    };
    REPEATS.iter().filter_map(|r| at(*r)).collect()
}

/// Two sets over the measured rows and further ones.
struct Contrast {
    measured: DVector<f64>,
    jacobian: DMatrix<f64>,
    /// One further row each, in its standard uncertainty.
    further: DVector<f64>,
    further_jacobian: DMatrix<f64>,
}

impl Contrast {
    fn new(best: &Trial, rival: &Trial, further: &Rows) -> Option<Self> {
        let (mut one, mut other) = (best.objective.clone(), rival.objective.clone());
        let sigma = further.observable.iter().map(|o| one.noise.usual(one.measurements, *o));
        let sigma = DVector::from_iterator(further.len(), sigma);
        let jacobian = other.jacobian(&rival.solution.position)?;
        // Residuals are measured less predicted: their derivatives have the opposite sign.
        let mut further_jacobian = -other.sensitivities(&rival.solution.position, further)?;
        further_jacobian.column_iter_mut().for_each(|mut c| c.component_div_assign(&sigma));
        let ahead = one.predict_rows(&best.solution.position, further)?;
        let behind = other.predict_rows(&rival.solution.position, further)?;
        let measured = best.solution.predicted.iter().zip(&rival.solution.predicted).zip(&one.noise.sigma);
        let measured = measured.map(|((p, q), s)| (p - q) / s).chain(priors_apart(best, rival)).collect();
        let further = (DVector::from_vec(ahead) - DVector::from_vec(behind)).component_div(&sigma);
        Some(Self { measured: DVector::from_vec(measured), jacobian, further, further_jacobian })
    }

    /// Distance between the two, in standard uncertainties, that no parameter of the rival can bridge.
    fn distance(&self, repeats: usize) -> f64 {
        let weight = (repeats as f64).sqrt();
        let (n, m) = (self.measured.len(), self.further.len());
        let apart =
            DVector::from_iterator(n + m, self.measured.iter().copied().chain(self.further.iter().map(|v| v * weight)));
        let mut both = DMatrix::zeros(n + m, self.jacobian.ncols());
        both.rows_mut(0, n).copy_from(&self.jacobian);
        both.rows_mut(n, m).copy_from(&(&self.further_jacobian * weight));
        length_outside(&both, apart)
    }
}
