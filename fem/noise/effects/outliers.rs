//! Single rows are wrong.

use super::super::Noise;
use super::super::contradiction::{FEW, contradicting, contradictions as contradictory};
use super::super::evidence::Evidence;
use super::super::key::{IN_FILE, OBSERVABLE, ROWS};
use super::super::term::{Acts, MeasurementEffect, Size, Term};

/// Factor by which the noise of an outlying row exceeds that of the others, where nothing else is said: its
/// weight is then a hundredth, and no likelihood of single rows could tell it.
pub const OUTLYING: f64 = 10.0;

/// Single rows are wrong, and weighed down.
pub static OUTLIERS: MeasurementEffect = MeasurementEffect {
    name: "outliers",
    about: "single rows are wrong: a chip under the stylus, a slip of the pen, a reading taken too soon",
    law: "standard deviation of an outlying row = factor * that of the others",
    source: "Hogg, Bovy & Lang, Data analysis recipes: fitting a model to data, 2010, sec. 3 (mixture)",
    separates: "measure these rows again",
    size: Size::Number("factor", "by which the noise of an outlying row exceeds that of the others"),
    keys: &[OBSERVABLE, ROWS, IN_FILE],
    example: "10",
    usual: OUTLYING,
    parameters: 0.0,
    // 2·ln(0.99/0.01)
    odds: 9.2,
    acts: Acts::Weighs,
    ..MeasurementEffect::USUAL
};

/// The term of these rows.
pub fn of(rows: Vec<usize>) -> Term {
    Term { rows, size: OUTLYING, ..Term::new(&OUTLIERS) }
}

/// The term of outlying rows with a factor as large as the farthest of them lies off (residuals in SI, and the noise of the
/// others): beside a smaller one a slip of the pen by a hundred standard deviations would leave ten, which laws are found for.
/// A term of another kind as it is.
pub fn outlying_by(term: &Term, residuals: &[f64], own: &Noise) -> Term {
    let mut term = term.clone();
    if *term.effect == OUTLIERS {
        let farthest = term.rows.iter().map(|row| residuals[*row].abs() / own.sigma[*row]).fold(OUTLYING, f64::max);
        term.size = farthest;
    }
    term
}

/// The terms with outlying rows that contradict the rows that they repeat; `None` where there are none, or
/// too many to be single mistakes.
pub fn contradictions(evidence: &Evidence) -> Option<Vec<Term>> {
    let noise = evidence.noise;
    let z: Vec<f64> = evidence.residuals.iter().zip(noise.sigma.iter()).map(|(r, s)| r / s).collect();
    let rows = contradictory(&evidence.repeats.groups_of_rows(), &z);
    let is_new = rows.iter().any(|row| !noise.is_weighed_down(*row));
    is_new.then(|| instead(evidence, rows))
}

/// Rows that lie far outside of what the others scatter; none where they are too many to be single mistakes.
pub fn sought(evidence: &Evidence) -> Vec<Vec<Term>> {
    let noise = evidence.noise;
    let present: Vec<usize> = (0..noise.sigma.len()).filter(|row| noise.is_weighed_down(*row)).collect();
    let left = noise.unshared(evidence.residuals);
    let z: Vec<f64> = left.iter().zip(noise.sigma.iter()).map(|(r, s)| r / s).collect();
    let mut sizes: Vec<f64> = z.iter().map(|z| z.abs()).collect();
    sizes.sort_unstable_by(f64::total_cmp);
    // The median of |z| is 0.6745 of a standard deviation.
    let usual = sizes[sizes.len() / 2] / 0.6745;
    let usual = if noise.source.is_known() { usual.max(1.0) } else { usual };
    let threshold = ((2.0 * (z.len() as f64).ln()).sqrt() + 1.0) * usual;
    let contradicts = contradicting(&evidence.repeats.groups_of_rows(), &z);
    let is_out = |row: &usize| z[*row].abs() > threshold || contradicts[*row];
    let new: Vec<usize> = (0..z.len()).filter(|row| is_out(row) && !present.contains(row)).collect();
    let mut rows = [present, new.clone()].concat();
    rows.sort_unstable();
    let are_few = !new.is_empty() && rows.len() as f64 <= FEW * z.len() as f64;
    if are_few { vec![instead(evidence, rows)] } else { Vec::new() }
}

/// The terms at work with these outlying rows in the place of any others.
fn instead(evidence: &Evidence, rows: Vec<usize>) -> Vec<Term> {
    evidence.noise.terms.iter().filter(|t| *t.effect != OUTLIERS).cloned().chain([of(rows)]).collect()
}

#[cfg(test)]
mod tests {
    use statrs::distribution::{ContinuousCDF, Normal};

    use super::OUTLYING;

    /// Ninety-eight rows at the quantiles of a normal distribution, and two at 8 and 12 standard deviations: how far
    /// the weighted mean is from that of the good rows, in its standard error.
    #[test]
    fn outlying_rows_pull_less_than_by_a_student_likelihood() {
        let normal = Normal::new(0.0, 1.0).unwrap();
        let good = (0..98).map(|i| normal.inverse_cdf((f64::from(i) + 0.5) / 98.0));
        let rows: Vec<f64> = good.chain([8.0, 12.0]).collect();
        let mean = |weight: &dyn Fn(f64) -> f64| {
            let sum: f64 = rows.iter().map(|z| z * weight(*z)).sum();
            sum / rows.iter().map(|z| weight(*z)).sum::<f64>()
        };
        let pull = |mean: f64| mean * 98f64.sqrt();
        let by_factor = pull(mean(&|z| if z > 5.0 { 1.0 / (OUTLYING * OUTLYING) } else { 1.0 }));
        // Weights (nu + 1)/(nu + z^2) about the mean, until they settle: the likeliest centre.
        let by_student =
            |nu: f64| pull((0..100).fold(0.0, |centre, _| mean(&|z: f64| (nu + 1.0) / (nu + (z - centre).powi(2)))));
        assert!((by_factor - 0.020).abs() < 1e-3, "{by_factor}");
        assert!((by_student(4.0) - 0.128).abs() < 1e-3, "{}", by_student(4.0));
        assert!((by_student(10.0) - 0.238).abs() < 1e-3, "{}", by_student(10.0));
        assert!((pull(mean(&|_| 1.0)) - 1.98).abs() < 1e-2);
    }
}
