//! Judges the fitted models of a search, each against the model without candidate effects.

use super::candidate_model::CandidateModel;
use super::cross_validation::Folds;
use super::null_distribution::{Variance, variance};
use super::verdict::{GoodnessOfFit, Verdict, as_written, features, is_noise};
use crate::compare::{Feature, Judges};
use crate::measure::Repeats;
use crate::noise::{NoiseSource, Term};

/// Least part of the unexplained χ² that effects must explain to be named as the cause.
const HALF: f64 = 0.5;

/// Fewest rows that tell one cause from another, however well each is known: any effect explains what a row or two are off by.
const FEWEST_ROWS: usize = 3;

/// What every fitted model of a search is held against.
pub struct Judge<'s, 'a> {
    base: &'s CandidateModel<'a>,
    /// Repeats within the groups that the noise sets apart.
    pub repeats: &'s Repeats,
    /// Parts of the rows that are held out in cross-validation, if any can be.
    pub folds: Option<Folds>,
    /// What is known of the variance of the rows.
    pub variance: Variance,
    /// Goodness of fit of the model without candidate effects.
    pub before: GoodnessOfFit,
    /// Structure that it leaves.
    pub features: Vec<Feature>,
    /// What the rows can tell.
    pub judges: Judges,
    is_imitation: bool,
}

/// Judgement on a fitted model.
pub struct Judgement {
    /// How well it fits.
    pub goodness: GoodnessOfFit,
    /// Structure that it leaves.
    pub features: Vec<Feature>,
    /// What that says.
    pub verdict: Verdict,
    /// Effects of the measurement that the residuals still ask for, where they have no other structure.
    pub suspects: Vec<Term>,
}

impl<'s, 'a> Judge<'s, 'a> {
    /// By a model without candidate effects; what only imitates the rows explains nothing.
    pub fn of(base: &'s CandidateModel<'a>, repeats: &'s Repeats, is_imitation: bool) -> Self {
        let CandidateModel { objective, .. } = base;
        let folds = Folds::of(base);
        let judges = match objective.data.len() < FEWEST_ROWS {
            true => Judges::Nothing,
            false => Judges::of(objective.data, &base.residuals(), &objective.noise, repeats),
        };
        Self {
            base,
            repeats,
            variance: variance(&objective.noise, repeats),
            before: GoodnessOfFit::of(base, repeats, folds.as_ref()),
            features: features(base),
            folds,
            judges,
            is_imitation,
        }
    }

    /// Whether the rows can tell a verdict.
    pub fn can_judge(&self) -> bool {
        self.judges != Judges::Nothing
    }

    /// Goodness of fit of a model.
    pub fn goodness(&self, model: &CandidateModel) -> GoodnessOfFit {
        GoodnessOfFit::of(model, self.repeats, self.folds.as_ref())
    }

    /// Judges a fitted model.
    pub fn judge(&self, model: &CandidateModel) -> Judgement {
        let goodness = self.goodness(model);
        let features = if model.members.is_empty() { self.features.clone() } else { features(model) };
        let own = self.verdict(model, &goodness, &features);
        let is_none = self.is_imitation && !matches!(own, Verdict::Adequate | Verdict::NotJudged);
        Judgement {
            goodness,
            features,
            verdict: if is_none { Verdict::Unexplained } else { own },
            suspects: Vec::new(),
        }
    }

    /// The judgement on the model without candidate effects where nothing that was found explains the rows.
    pub fn of_base(&self, verdict: Verdict) -> Judgement {
        Judgement { goodness: self.before.clone(), features: self.features.clone(), verdict, suspects: Vec::new() }
    }

    fn verdict(&self, model: &CandidateModel, goodness: &GoodnessOfFit, left: &[Feature]) -> Verdict {
        if !self.can_judge() {
            return Verdict::NotJudged;
        }
        match (model.members.is_empty(), is_noise(goodness, left)) {
            (true, true) => Verdict::Adequate,
            (true, false) => Verdict::Unexplained,
            (false, true) => Verdict::MissingEffect,
            (false, false) => {
                let (was, is) = (excess(self.base, &self.features), excess(model, left));
                if 1.0 - is / was < HALF { Verdict::Unexplained } else { Verdict::PartlyExplained }
            }
        }
    }
}

impl Judgement {
    /// What is said of the model must hold for the one that is written with it.
    pub fn hold_against_what_is_written(&mut self, model: &CandidateModel, is_nothing_missing: bool) {
        if !matches!(self.verdict, Verdict::Adequate | Verdict::MissingEffect) {
            return;
        }
        let written = as_written(model);
        match written.adequacy() {
            Some(true) => {}
            Some(false) => {
                self.verdict = if is_nothing_missing { Verdict::Unexplained } else { Verdict::PartlyExplained };
                (self.features, self.suspects) = (written.features, written.suspects);
            }
            None if is_nothing_missing => self.verdict = Verdict::NotJudged,
            None => {}
        }
    }
}

/// Part of χ² that the noise does not explain; where the noise is only estimated, the part that has
/// structure.
fn excess(trial: &CandidateModel, features: &[Feature]) -> f64 {
    let chi2 = trial.solution.chi2;
    match trial.objective.noise.source {
        NoiseSource::Column | NoiseSource::Covariance | NoiseSource::Repeats => {
            (chi2 - trial.objective.freedom()).max(0.0)
        }
        NoiseSource::Estimated => chi2 * features.iter().map(|f| f.share).fold(0.0, f64::max),
    }
}
