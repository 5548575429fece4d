//! Effects that cannot be told apart by these data: naming one of them alone would be a wrong answer.

use nalgebra::DVector;
use rayon::prelude::*;

use super::gain::{Gain, gain};
use super::ground::{Ground, length_outside};
use super::search::{Found, bare, fit_with, promising, starts, without};
use super::signature::{Candidate, Variant};
use super::trial::Trial;

/// Sets of one size are equally good when χ² differs by no more than this.
pub const EQUAL: f64 = 6.0;
/// Squared separation, in standard uncertainties, below which the noise mixes two sets up in more than one case of twenty:
/// (1.645 + 1.645)².
pub const SEPARATE: f64 = 11.0;
/// To first order an alternative may look worse than it is: beyond this much plus a part of the gain it is not fitted.
const HOPELESS: (f64, f64) = (40.0, 0.25);

/// Another effect in the place of one of a set.
#[derive(Clone)]
pub struct Rival<'a> {
    /// The set with the other effect in place.
    pub trial: Trial<'a>,
    /// The candidate that stands in.
    pub candidate: usize,
    /// χ² of the rival set less that of the set.
    pub worse_by: f64,
    /// Squared distance between the two predictions that no parameter of the rival can bridge, in standard uncertainties.
    pub separation: f64,
}

impl Rival<'_> {
    fn is_equal(&self) -> bool {
        self.worse_by <= EQUAL || self.separation < SEPARATE
    }
}

/// For each member of the best set those that could stand in its place, the best first; and χ² without the member.
pub struct Place<'a> {
    /// The member.
    pub candidate: usize,
    /// χ² of the set without it.
    pub without: f64,
    /// Who fits as well.
    pub rivals: Vec<Rival<'a>>,
}

/// The places of the best set.
pub fn places<'a>(found: &Found<'a>) -> Vec<Place<'a>> {
    let best = found.best();
    let mut places: Vec<Place<'a>> = best.members.par_iter().filter_map(|member| place(found, best, *member)).collect();
    let Some(ground) = Ground::new(&mut found.base.objective.clone(), &found.base.solution) else { return places };
    // Sets that differ in more than one effect: each of their effects stands for the one that it resembles most.
    for other in found.tried.iter().filter(|t| t.members.len() == best.members.len()) {
        let new: Vec<usize> = other.members.iter().copied().filter(|m| !best.members.contains(m)).collect();
        if new.len() < 2 {
            continue;
        }
        let Some(rival) = rival(best, other.clone(), new[0]) else { continue };
        if !rival.is_equal() {
            continue;
        }
        let mut open: Vec<usize> = best.members.iter().copied().filter(|m| !other.members.contains(m)).collect();
        for candidate in new {
            let likest = |m: &usize| likeness(&ground, &found.candidates[candidate], &found.candidates[*m]);
            let Some(i) = (0..open.len()).max_by(|a, b| likest(&open[*a]).total_cmp(&likest(&open[*b]))) else { break };
            let member = open.remove(i);
            let place = places.iter_mut().find(|p| p.candidate == member);
            if let Some(place) = place.filter(|p| p.rivals.iter().all(|r| r.candidate != candidate)) {
                place.rivals.push(Rival { candidate, ..rival.clone() });
            }
        }
    }
    places
}

fn place<'a>(found: &Found<'a>, best: &Trial<'a>, member: usize) -> Option<Place<'a>> {
    let without = without(&found.base, &found.candidates, best, member)?;
    let bare = bare(&found.base, &found.candidates, best, member)?;
    let ground = Ground::new(&mut bare.objective.clone(), &bare.solution)?;
    let gained = ground.residual.norm_squared() - best.solution.chi2;
    let stand_in = |candidate: usize| {
        let stranger = &found.candidates[candidate];
        let mut starts = starts(&ground, stranger);
        let fall = starts.first().map_or(0.0, |s| s.1.fall);
        if gained - fall > HOPELESS.0 + HOPELESS.1 * gained {
            return None;
        }
        // From where the member has left, all else as it was: to what the data ask for, and to what resembles the member most.
        starts.extend(imitations(best, &bare, stranger));
        let trial = fit_with(&bare, candidate, stranger, &starts)?;
        rival(best, trial, candidate).filter(Rival::is_equal)
    };
    let others = (0..found.candidates.len()).filter(|i| !best.members.contains(i));
    let mut rivals: Vec<Rival<'a>> = others.filter_map(stand_in).collect();
    rivals.sort_by(|a, b| a.trial.score().total_cmp(&b.trial.score()));
    Some(Place { candidate: member, without: without.solution.chi2, rivals })
}

/// The shapes of a stranger that come closest to what the member made of the rows.
fn imitations(best: &Trial, bare: &Trial, stranger: &Candidate) -> Vec<(usize, Gain)> {
    let rows = best.solution.predicted.iter().zip(&bare.solution.predicted).zip(&best.objective.noise.sigma);
    let priors = std::iter::repeat_n(0.0, best.objective.priors());
    let made = DVector::from_vec(rows.map(|((p, q), s)| (p - q) / s).chain(priors).collect());
    let imitation =
        |v: &Variant| gain(&(v.columns.transpose() * &v.columns), &(v.columns.transpose() * &made), &v.signed);
    promising(stranger.variants.iter().map(imitation).collect())
}

/// Compares a set with the best: by its fit, and by what would be left if the best were the truth and nothing noisy.
fn rival<'a>(best: &Trial<'a>, mut trial: Trial<'a>, candidate: usize) -> Option<Rival<'a>> {
    let jacobian = trial.objective.jacobian(&trial.solution.position)?;
    let rows = best.solution.predicted.iter().zip(&trial.solution.predicted).zip(&trial.objective.noise.sigma);
    let apart = rows.map(|((p, q), s)| (p - q) / s).chain(priors_apart(best, &trial));
    let separation = length_outside(&jacobian, DVector::from_vec(apart.collect())).powi(2);
    let worse_by = trial.solution.chi2 - best.solution.chi2;
    Some(Rival { trial, candidate, worse_by, separation })
}

/// How far two sets are apart in what the model knows roughly, in its standard uncertainties.
pub fn priors_apart(best: &Trial, rival: &Trial) -> Vec<f64> {
    let moved = |i: usize| {
        let axis = &rival.objective.axes[i];
        let [a, b] = [best, rival].map(|t| axis.value(t.solution.position[i]));
        axis.prior.map(|(_, std)| (a - b) / std)
    };
    (0..best.objective.model.parameters.len()).filter_map(moved).collect()
}

/// How much of the signature of one candidate the other can make, at best, 0 to 1.
fn likeness(ground: &Ground, a: &Candidate, b: &Candidate) -> f64 {
    let columns = |c: &Candidate| c.variants.iter().map(|v| ground.project_columns(&v.columns)).collect::<Vec<_>>();
    let (of_a, of_b) = (columns(a), columns(b));
    let cosine = |x: &nalgebra::DMatrix<f64>, y: &nalgebra::DMatrix<f64>| {
        let (x, y) = (x.column(0), y.column(0));
        (x.dot(&y) / (x.norm() * y.norm()).max(f64::MIN_POSITIVE)).abs()
    };
    of_a.iter().flat_map(|x| of_b.iter().map(move |y| cosine(x, y))).fold(0.0, f64::max)
}
