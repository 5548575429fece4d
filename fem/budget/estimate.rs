//! Adds a budget up by the handbook's rules and by Monte Carlo.

use super::monte_carlo::{self, Drawn};
use super::{Budget, Contribution, Kind, Law, rules};
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
pub struct Estimate {
    /// Result of the handbook's rules.
    pub handbook: Handbook,
    /// Result of Monte Carlo.
    pub monte_carlo: Drawn,
    /// Shares of the errors, the largest swing first.
    pub shares: Vec<Share>,
}

/// Adds a budget up; `None` where it has no errors but a drill alone.
///
/// # Errors
/// The model cannot be computed somewhere in its inputs' fields.
pub fn estimate(budget: &Budget, progress: &Progress) -> Result<Option<Estimate>, Failure> {
    if budget.errors.is_empty() && budget.model.is_none() {
        return Ok(None);
    }
    let (nominal, inputs) = match &budget.model {
        Some(model) => model.linearised()?,
        None => (0.0, Vec::new()),
    };
    let errors = with_signs(budget, nominal);
    let handbook = by_rules(budget, &errors, nominal, &inputs);
    let shares = shares(budget, &errors, nominal, &inputs);
    let monte_carlo = monte_carlo::draw(budget, &errors, progress)?;
    Ok(Some(Estimate { handbook, monte_carlo, shares }))
}

/// Changes of the result by an input of a model at the two ends of its field.
pub(super) type Swing = (String, Law, (f64, f64));

fn half(swing: (f64, f64)) -> f64 {
    0.5 * (swing.1 - swing.0).abs()
}

/// Errors with signs: a systematic error of which only the size is known takes the worse side, that of the
/// sum whose sign is known.
fn with_signs(budget: &Budget, nominal: f64) -> Vec<Contribution> {
    let known = budget.errors.iter().filter(|e| e.kind == Kind::Systematic && e.has_sign());
    let is_below = known.map(|e| e.value).sum::<f64>() + nominal < 0.0;
    let worse = |e: &Contribution| {
        let turned = is_below && e.kind == Kind::Systematic && !e.has_sign();
        Contribution { value: if turned { -e.value } else { e.value }, ..e.clone() }
    };
    budget.errors.iter().map(worse).collect()
}

fn by_rules(budget: &Budget, errors: &[Contribution], nominal: f64, inputs: &[Swing]) -> Handbook {
    let sum_of = |errors: &[&Contribution]| {
        let of = |kind: Kind| errors.iter().filter(move |e| e.kind == kind);
        let systematic: Vec<f64> = of(Kind::Systematic).map(|e| e.value).collect();
        let random: Vec<(Law, f64)> = of(Kind::Random).map(|e| (e.law, e.value)).collect();
        (rules::systematic(&systematic), random)
    };
    let of_model = inputs.iter().map(|(_, law, swing)| (*law, half(*swing)));
    let is_grouped = |e: &&Contribution| budget.groups.iter().any(|g| Some(&g.name) == e.group.as_ref());
    let loose: Vec<&Contribution> = errors.iter().filter(|e| !is_grouped(e)).collect();
    let (mut systematic, mut scattering) = sum_of(&loose);
    systematic += nominal;
    scattering.extend(of_model.clone());
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
    each.extend(of_model);
    let one_by_one = (every + nominal).abs() + rules::random(budget.t, &each);
    let differs = !budget.groups.is_empty() && (one_by_one - total).abs() > 1e-9 * total;
    Handbook { systematic, random, total, one_by_one: differs.then_some(one_by_one), groups }
}

fn shares(budget: &Budget, errors: &[Contribution], nominal: f64, inputs: &[Swing]) -> Vec<Share> {
    let mut shares: Vec<Share> = errors
        .iter()
        .map(|e| Share {
            name: e.name.clone(),
            kind: e.kind,
            law: e.law,
            swing: if e.kind == Kind::Random { (-e.value, e.value) } else { (e.value.min(0.0), e.value.max(0.0)) },
            variance_share: if e.kind == Kind::Random { e.law.lambda() * e.value * e.value } else { 0.0 },
        })
        .collect();
    if let Some(model) = &budget.model {
        shares.push(Share {
            name: format!("{}, as it stands", model.model.source.name),
            kind: Kind::Systematic,
            law: Law::Normal,
            swing: (nominal.min(0.0), nominal.max(0.0)),
            variance_share: 0.0,
        });
    }
    shares.extend(inputs.iter().map(|(name, law, swing)| Share {
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
