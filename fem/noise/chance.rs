//! Probabilities of chance: upper tails of χ² and F for any statistic that a computation may come upon.

use statrs::distribution::{ChiSquared, ContinuousCDF, FisherSnedecor};

/// Probability that χ² of so many degrees of freedom is beyond a value. `None` where either is no number, and
/// without freedom: then there is no test.
pub fn beyond_chi2(freedom: f64, value: f64) -> Option<f64> {
    let distribution = ChiSquared::new(freedom).ok()?;
    of(value, |value| distribution.sf(value))
}

/// Probability that a ratio of variances of `between` and `within` degrees of freedom is beyond a value (F
/// test). `None` where one is no number, and without freedom: then there is no test.
pub fn beyond_f(between: f64, within: f64, value: f64) -> Option<f64> {
    let distribution = FisherSnedecor::new(between, within).ok()?;
    of(value, |value| match (between * value).is_finite() {
        true => distribution.sf(value),
        // The share of the variance between is 1 to every digit.
        false => 0.0,
    })
}

fn of(value: f64, beyond: impl Fn(f64) -> f64) -> Option<f64> {
    match value {
        value if value.is_nan() => None,
        value if value <= 0.0 => Some(1.0),
        f64::INFINITY => Some(0.0),
        value => Some(beyond(value)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tails_are_those_of_the_tables() {
        // χ² of 3 and F of (2, 9): 95 % points of the usual tables, to their digits.
        assert!((beyond_chi2(3.0, 7.815).unwrap() - 0.05).abs() < 1e-5);
        assert!((beyond_f(2.0, 9.0, 4.2565).unwrap() - 0.05).abs() < 1e-5);
    }

    #[test]
    fn what_is_no_number_is_no_test() {
        assert_eq!((beyond_chi2(3.0, f64::NAN), beyond_f(2.0, 9.0, f64::NAN)), (None, None));
        assert_eq!((beyond_chi2(0.0, 1.0), beyond_f(-1.0, 9.0, 1.0), beyond_f(1.0, f64::NAN, 1.0)), (None, None, None));
        for huge in [1e200, 1e308, f64::INFINITY] {
            assert_eq!((beyond_chi2(3.0, huge), beyond_f(4.0, 9.0, huge)), (Some(0.0), Some(0.0)), "{huge}");
        }
        assert_eq!((beyond_chi2(3.0, -1.0), beyond_f(2.0, 9.0, 0.0)), (Some(1.0), Some(1.0)));
    }
}
