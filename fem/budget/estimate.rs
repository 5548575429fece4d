//! Adds a budget up by the handbook's rules and by Monte Carlo.

use super::monte_carlo::{self, Drawn};
use super::part::Swing;
use super::purchase::{Purchase, purchases};
use super::{Budget, Contribution, Kind, Law, ModelPart, rules};
use crate::process::Failure;
use crate::progress::Progress;

/// Result of the handbook's rules. m.
#[derive(Clone, Debug, PartialEq)]
pub struct Handbook {
    /// Sum of the systematic errors with their signs, (40).
    pub systematic: f64,
    /// Half-field of the random errors, (42).
    pub random: f64,
    /// |systematic| + random.
    pub total: f64,
    /// Total with the errors of every group taken one by one, where that differs.
    pub one_by_one: Option<f64>,
    /// Groups that enter as one error, with their own totals.
    pub groups: Vec<(String, f64)>,
}

/// Share of one error in the result.
#[derive(Clone, Debug, PartialEq)]
pub struct Share {
    /// Name of the error.
    pub name: String,
    /// Way in which it adds.
    pub kind: Kind,
    /// Law in the handbook's rule.
    pub law: Law,
    /// Changes of the result at the two ends of its field, all else in the middle, m; those of a systematic
    /// error have one end at zero.
    pub swing: (f64, f64),
    /// Part of the variance; 0 for a systematic error.
    pub variance_share: f64,
}

/// Result of a budget.
#[non_exhaustive]
pub struct Estimate {
    /// Result of the handbook's rules.
    #[doc(hidden)]
    pub handbook: Handbook,
    /// Result of Monte Carlo.
    #[doc(hidden)]
    pub monte_carlo: Drawn,
    /// Shares of the errors, the largest swing first.
    #[doc(hidden)]
    pub shares: Vec<Share>,
    /// What less of each term does, the one that does most first.
    #[doc(hidden)]
    pub purchases: Vec<Purchase>,
}

impl Budget {
    /// Adds the budget up by the rules and by Monte Carlo; `None` where it has no errors but a drill alone.
    ///
    /// # Errors
    /// A model cannot be computed somewhere in its inputs' fields.
    pub fn estimate(&self, progress: &Progress) -> Result<Option<Estimate>, Failure> {
        let models = &self.models;
        if self.errors.is_empty() && models.parts.is_empty() {
            return Ok(None);
        }
        let figures = models.results(&models.centre())?;
        let (errors, signs) = with_signs(self, &figures);
        let swings = models.swings(&figures, &signs)?;
        let figure = |((part, figure), sign): ((&ModelPart, &f64), &f64)| match part.kind {
            Kind::Systematic => sign * figure,
            Kind::Random => figure.abs(),
        };
        let figures: Vec<f64> = models.parts.iter().zip(&figures).zip(&signs).map(figure).collect();
        let handbook = by_rules(self, &errors, &figures, &swings);
        let shares = shares(self, &errors, &figures, &swings);
        let purchases = bought(self, &errors, &figures, &swings);
        let monte_carlo = monte_carlo::draw(self, &errors, &signs, progress)?;
        Ok(Some(Estimate { handbook, monte_carlo, shares, purchases }))
    }
}

fn half(swing: (f64, f64)) -> f64 {
    0.5 * (swing.1 - swing.0).abs()
}

/// Errors with signs, and the signs of the models' figures: a systematic one of which only the size is known
/// takes the worse side, that of the sum whose sign is known.
fn with_signs(budget: &Budget, figures: &[f64]) -> (Vec<Contribution>, Vec<f64>) {
    let known = budget.errors.iter().filter(|e| e.kind == Kind::Systematic && e.has_sign());
    let parts = || budget.models.parts.iter();
    let of_models = parts().zip(figures).filter(|(part, _)| part.kind == Kind::Systematic && part.has_sign());
    let is_below = known.map(|e| e.value).sum::<f64>() + of_models.map(|(_, figure)| figure).sum::<f64>() < 0.0;
    let worse = |e: &Contribution| {
        let turned = is_below && e.kind == Kind::Systematic && !e.has_sign();
        Contribution { value: if turned { -e.value } else { e.value }, ..e.clone() }
    };
    let sign = |part: &ModelPart| if is_below && !part.has_sign() { -1.0 } else { 1.0 };
    (budget.errors.iter().map(worse).collect(), parts().map(sign).collect())
}

/// Adds up errors, figures of models (with their signs, or halves of their fields) and changes by their inputs.
fn by_rules(budget: &Budget, errors: &[Contribution], figures: &[f64], swings: &[Swing]) -> Handbook {
    let sum_of = |errors: &[&Contribution]| {
        let of = |kind: Kind| errors.iter().filter(move |e| e.kind == kind);
        let systematic: Vec<f64> = of(Kind::Systematic).map(|e| e.value).collect();
        let random: Vec<(Law, f64)> = of(Kind::Random).map(|e| (e.law, e.value)).collect();
        (rules::systematic(&systematic), random)
    };
    let of = |kind: Kind| budget.models.parts.iter().zip(figures).filter(move |(part, _)| part.kind == kind);
    let nominal: f64 = of(Kind::Systematic).map(|(_, figure)| figure).sum();
    let fields = of(Kind::Random).map(|(part, figure)| (part.law, *figure));
    let of_models = swings.iter().map(|(_, law, swing)| (*law, half(*swing))).chain(fields);
    let is_grouped = |e: &&Contribution| budget.groups.iter().any(|g| Some(&g.name) == e.group.as_ref());
    let loose: Vec<&Contribution> = errors.iter().filter(|e| !is_grouped(e)).collect();
    let (mut systematic, mut scattering) = sum_of(&loose);
    systematic += nominal;
    scattering.extend(of_models.clone());
    let mut groups = Vec::new();
    for group in &budget.groups {
        let members: Vec<&Contribution> = errors.iter().filter(|e| e.group.as_ref() == Some(&group.name)).collect();
        let (own, random) = sum_of(&members);
        // Total of the group, at the risk for which its law has its field.
        let total = own.abs() + rules::random(1.0 / group.law.lambda().sqrt(), &random);
        scattering.push((group.law, total));
        groups.push((group.name.clone(), total));
    }
    let random = rules::random(budget.t, &scattering);
    let total = systematic.abs() + random;
    let all: Vec<&Contribution> = errors.iter().collect();
    let (every, mut each) = sum_of(&all);
    each.extend(of_models);
    let one_by_one = (every + nominal).abs() + rules::random(budget.t, &each);
    let differs = !budget.groups.is_empty() && (one_by_one - total).abs() > 1e-9 * total;
    Handbook { systematic, random, total, one_by_one: differs.then_some(one_by_one), groups }
}

/// What less of each term does: of errors, then of figures of models, then of what varies in them.
fn bought(budget: &Budget, errors: &[Contribution], figures: &[f64], swings: &[Swing]) -> Vec<Purchase> {
    let names = errors.iter().map(|own| &own.name).chain(budget.models.parts.iter().map(|own| &own.name));
    let names = names.chain(swings.iter().map(|(name, ..)| name)).cloned();
    purchases(names, budget.tolerance, |term, part| {
        let of = |own: usize| if own == term { part } else { 1.0 };
        let error = |(i, own): (usize, &Contribution)| Contribution { value: of(i) * own.value, ..own.clone() };
        let errors: Vec<Contribution> = errors.iter().enumerate().map(error).collect();
        let figure = |(i, own): (usize, &f64)| of(errors.len() + i) * own;
        let figures: Vec<f64> = figures.iter().enumerate().map(figure).collect();
        let swing = |(i, (name, law, (a, b))): (usize, &Swing)| {
            let part = of(errors.len() + figures.len() + i);
            (name.clone(), *law, (part * a, part * b))
        };
        let swings: Vec<Swing> = swings.iter().enumerate().map(swing).collect();
        let found = by_rules(budget, &errors, &figures, &swings);
        (found.systematic, found.random)
    })
}

fn shares(budget: &Budget, errors: &[Contribution], figures: &[f64], swings: &[Swing]) -> Vec<Share> {
    let share = |name: String, kind: Kind, law: Law, value: f64| Share {
        name,
        kind,
        law,
        swing: if kind == Kind::Random { (-value, value) } else { (value.min(0.0), value.max(0.0)) },
        variance_share: if kind == Kind::Random { law.lambda() * value * value } else { 0.0 },
    };
    let mut shares: Vec<Share> = errors.iter().map(|e| share(e.name.clone(), e.kind, e.law, e.value)).collect();
    shares.extend(budget.models.parts.iter().zip(figures).map(|(part, figure)| {
        let fixed = if part.kind == Kind::Systematic { ", as it stands" } else { "" };
        share(format!("{}{fixed}", part.name), part.kind, part.law, *figure)
    }));
    shares.extend(swings.iter().map(|(name, law, swing)| Share {
        name: name.clone(),
        kind: Kind::Random,
        law: *law,
        swing: *swing,
        variance_share: law.lambda() * half(*swing).powi(2),
    }));
    let variance: f64 = shares.iter().map(|s| s.variance_share).sum();
    if variance > 0.0 {
        shares.iter_mut().for_each(|s| s.variance_share /= variance);
    }
    shares.sort_by(|a, b| (b.swing.1 - b.swing.0).abs().total_cmp(&(a.swing.1 - a.swing.0).abs()));
    shares
}
