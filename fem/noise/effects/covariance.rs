//! The covariance of the rows is known.

use super::super::key::UNIT;
use super::super::term::{Acts, MeasurementEffect, Size};

/// The covariance of the rows stands in a file.
pub static COVARIANCE: MeasurementEffect = MeasurementEffect {
    name: "covariance",
    about: "the covariance of the rows is known: it stands in a file, and takes the place of `u`",
    law: "covariance of two rows = the entry of the file",
    source: "Aitken, On least squares and linear combinations of observations, Proc. R. Soc. Edinb. 55, 1936",
    separates: "repeat the measurement: the scatter of all rows together is their covariance",
    size: Size::File("file", "CSV: a matrix of numbers, or a header `row,column,covariance` and the entries"),
    keys: &[UNIT],
    example: "covariance.csv",
    parameters: 0.0,
    acts: Acts::Given,
    ..MeasurementEffect::USUAL
};

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use nalgebra::DMatrix;

    use crate::noise::tests::{measured, whitened_square};
    use crate::noise::{GivenCovariance, Noise, NoiseSource, Term, effects};

    #[test]
    fn rows_have_the_covariance_that_is_given() {
        // [[4, 2, 0], [2, 5, 0], [0, 0, 9]] has the determinant 144, and (1, 1, 3) the square 5/16 + 1.
        let matrix = DMatrix::from_row_slice(3, 3, &[4.0, 2.0, 0.0, 2.0, 5.0, 0.0, 0.0, 0.0, 9.0]);
        let given = GivenCovariance::new(matrix).unwrap();
        let sigma = given.sigma();
        let term = Term { covariance: Some(Arc::new(given)), ..Term::new(&effects::COVARIANCE) };
        let rows = measured(&[1.0, 2.0, 3.0]);
        let noise = Noise::independent(sigma, NoiseSource::Covariance).with(vec![term], &rows);
        let square: f64 = noise.whiten([1.0, 1.0, 3.0]).iter().map(|z| z * z).sum();
        assert!((square - (5.0 / 16.0 + 1.0)).abs() < 1e-12, "{square}");
        assert!((noise.log_determinant() - 144f64.ln()).abs() < 1e-12);
        // Rows that share nothing are as they were.
        assert!((whitened_square(&rows, &[], &[1.0, 1.0, 3.0]).0 - 11.0).abs() < 1e-12);
    }
}
