//! Troubles of real measurements: noise that is not white, or not of the size that is stated.

use crate::random::Random;

/// One trouble.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Trouble {
    /// Every row shares 0.6 of what the row before is off by (first-order autoregression).
    Shared,
    /// One row of fifty is off by 8 to 15 standard deviations.
    Outliers,
    /// The stated uncertainty is 0.6 of the true one.
    Understated,
    /// Every part or set-up was measured from a zero of its own, of 3 standard deviations.
    Zeros,
    /// From one row on everything is 4 standard deviations higher.
    Step,
}

/// Coefficient of the autoregression, part of the uncertainty that is stated, and sizes of zeros and of the
/// step.
const COEFFICIENT: f64 = 0.6;
const STATED: f64 = 0.6;
const ZERO: f64 = 3.0;
const STEP: f64 = 4.0;

impl Trouble {
    /// All of them.
    pub const ALL: &[Self] = &[Self::Shared, Self::Outliers, Self::Understated, Self::Zeros, Self::Step];

    /// The measurement effects that name it; a step at the border of groups is also one of their zeros.
    pub fn names(self) -> &'static [&'static str] {
        match self {
            Self::Shared => &["correlated-noise"],
            Self::Outliers => &["outliers"],
            Self::Understated => &["uncertainty-scale"],
            Self::Zeros => &["zero-shift"],
            Self::Step => &["jump", "drift", "zero-shift"],
        }
    }

    /// Part of the true uncertainty that is stated.
    pub fn stated(self) -> f64 {
        if self == Self::Understated { STATED } else { 1.0 }
    }

    /// What the rows are off by, in standard deviations, and which rows are wrong. `groups` says which rows
    /// were measured together.
    pub fn noise(self, groups: &[usize], random: &mut Random) -> (Vec<f64>, Vec<usize>) {
        let mut noise: Vec<f64> = groups.iter().map(|_| random.normal()).collect();
        let mut wrong = Vec::new();
        match self {
            Self::Shared => {
                for row in 1..noise.len() {
                    let own = (1.0 - COEFFICIENT * COEFFICIENT).sqrt();
                    noise[row] = COEFFICIENT * noise[row - 1] + own * noise[row];
                }
            }
            Self::Outliers => {
                while wrong.len() < noise.len().div_ceil(50) {
                    let row = random.whole(0, noise.len() - 1);
                    if !wrong.contains(&row) {
                        noise[row] += random.sign() * random.uniform(8.0, 15.0);
                        wrong.push(row);
                    }
                }
                wrong.sort_unstable();
            }
            Self::Understated => {}
            Self::Zeros => {
                let count = groups.iter().max().map_or(0, |g| g + 1);
                let zeros: Vec<f64> = (0..count).map(|_| ZERO * random.normal()).collect();
                noise.iter_mut().zip(groups).for_each(|(n, group)| *n += zeros[*group]);
            }
            Self::Step => {
                let first = random.whole(noise.len() / 5, noise.len() * 4 / 5);
                noise[first..].iter_mut().for_each(|n| *n += STEP);
            }
        }
        (noise, wrong)
    }
}
