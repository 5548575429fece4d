//! Yield: the part of all jobs whose result lies within its tolerance.

use statrs::function::beta::inv_beta_reg;

/// Probability that the interval of a yield misses it.
const MISSED: f64 = 0.05;

/// Jobs by their outcome.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Acceptance {
    /// Jobs within the tolerance.
    pub good: u64,
    /// Jobs outside of it.
    pub bad: u64,
    /// Jobs that gave no number.
    pub failed: u64,
}

impl Acceptance {
    /// Number of jobs.
    pub fn jobs(&self) -> u64 {
        self.good + self.bad + self.failed
    }

    /// Part of all jobs that is known to be good, 0 to 1: who failed is not.
    pub fn share(&self) -> f64 {
        self.good as f64 / self.jobs().max(1) as f64
    }

    /// Interval of 95 % (Clopper and Pearson 1934) of the yield, if the jobs are independent draws: at its lower end
    /// failed jobs count as bad, at its upper end as good.
    pub fn interval(&self) -> (f64, f64) {
        let (jobs, least, most) = (self.jobs(), self.good, self.good + self.failed);
        let beta = |successes: f64, failures: f64, p: f64| inv_beta_reg(successes, failures, p);
        let low = match least {
            0 => 0.0,
            least => beta(least as f64, (jobs - least) as f64 + 1.0, 0.5 * MISSED),
        };
        let high = match jobs - most {
            0 => 1.0,
            bad => beta(most as f64 + 1.0, bad as f64, 1.0 - 0.5 * MISSED),
        };
        (low, high)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// P(X <= k) of a binomial distribution, summed by logarithms of its terms.
    fn up_to(k: u64, n: u64, p: f64) -> f64 {
        let mut term = n as f64 * (-p).ln_1p();
        let mut sum = term.exp();
        for i in 0..k {
            term += ((n - i) as f64 / (i + 1) as f64 * p / (1.0 - p)).ln();
            sum += term.exp();
        }
        sum
    }

    #[test]
    fn the_ends_are_where_what_was_seen_is_just_possible() {
        for (good, bad) in [(95, 5), (1, 99), (499, 1), (60, 40)] {
            let (low, high) = Acceptance { good, bad, failed: 0 }.interval();
            let n = good + bad;
            assert!((1.0 - up_to(good - 1, n, low) - 0.025).abs() < 1e-6, "{good} of {n}: {low}");
            assert!((up_to(good, n, high) - 0.025).abs() < 1e-6, "{good} of {n}: {high}");
        }
        // None of n: the rule of three, 1 - 0.025^(1/n).
        let all = Acceptance { good: 100, bad: 0, failed: 0 };
        assert!((all.interval().0 - 0.025f64.powf(0.01)).abs() < 1e-9 && all.interval().1 == 1.0);
    }

    #[test]
    fn failed_jobs_are_neither_good_nor_left_out() {
        let some = Acceptance { good: 90, bad: 5, failed: 5 };
        assert_eq!(some.share(), 0.9);
        let (low, high) = some.interval();
        assert_eq!(low, Acceptance { good: 90, bad: 10, failed: 0 }.interval().0);
        assert_eq!(high, Acceptance { good: 95, bad: 5, failed: 0 }.interval().1);
    }
}
