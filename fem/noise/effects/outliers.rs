//! Single rows are wrong.

use super::super::term::{Acts, MeasurementEffect, Size};

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
    acts: Acts::Weighs,
};

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
