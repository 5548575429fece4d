//! Rules of the handbook for adding errors up [seed 002 (27)–(51)], with a misprint corrected: (47) without the stray
//! Q_maxⁿ.

use super::Law;

/// (40): systematic errors add with their signs.
pub fn systematic(errors: &[f64]) -> f64 {
    errors.iter().sum()
}

/// (42): Δ = t·√Σ λᵢΔᵢ² of random errors with half-fields Δᵢ.
pub fn random(t: f64, errors: &[(Law, f64)]) -> f64 {
    // The empty sum is −0.0.
    t * errors.iter().map(|(law, half)| law.lambda() * half * half).sum::<f64>().abs().sqrt()
}

/// (33), (34): uncertainty σ/√n of the mean of `parts` trial parts, where the process scatters over a field
/// T: σ = T/6.
pub fn calculation(field: f64, parts: usize) -> f64 {
    field / 6.0 / (parts as f64).sqrt()
}

/// (44): setting by trial parts, from measuring, adjusting and calculating, each of them uniform or of
/// unknown law.
pub fn setting(t: f64, components: &[f64]) -> f64 {
    random(t, &components.iter().map(|half| (Law::Uniform, *half)).collect::<Vec<_>>())
}

/// (47): y₁ = c_min·(Q_maxⁿ − Q_minⁿ) and y₂ = c_max·(Q_maxⁿ − Q_minⁿ); ε_з is the root of their squares.
pub fn clamping_ends(c: (f64, f64), force: (f64, f64), exponent: f64) -> [f64; 2] {
    let rise = force.1.powf(exponent) - force.0.powf(exponent);
    [c.0 * rise, c.1 * rise]
}

/// (30): ε_з = y_max − y_min of a size whose base moves with the contact.
pub fn clamping_scatter(c: (f64, f64), force: (f64, f64), exponent: f64) -> f64 {
    c.1 * force.1.powf(exponent) - c.0 * force.0.powf(exponent)
}

/// (50), (51): a batch in one fixture on one machine at one setting,
/// Δ = √(Δ_γ² + ε² + 3Δ_и² + 3Δ_т²) + Δ_н + ΣΔ_ф. As printed, ε stands under the root with the systematic part
/// that (52) gives it, against the rule that the two add arithmetically.
pub fn batch(inherited: f64, setup: f64, wear: f64, thermal: f64, setting: f64, form: f64) -> f64 {
    let scattering = [(Law::Normal, inherited), (Law::Normal, setup), (Law::Uniform, wear), (Law::Uniform, thermal)];
    random(3.0, &scattering) + setting + form
}

/// (27): Δ_γ = c·Δ_заг/(j + c), what a cut of force per depth c in a system of stiffness j copies of a blank's
/// error.
pub fn inherited(blank: f64, force_per_depth: f64, stiffness: f64) -> f64 {
    force_per_depth * blank / (stiffness + force_per_depth)
}

/// (32): Δ_и = u·L.
pub fn wear(rate: f64, path: f64) -> f64 {
    rate * path
}

/// (36): Δ_т = α·L·t.
pub fn heating(expansion: f64, length: f64, rise: f64) -> f64 {
    expansion * length * rise
}
