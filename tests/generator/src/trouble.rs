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
    /// Values are rounded to 2 standard deviations.
    Rounded,
    /// Zeros of 2 standard deviations, and one row of a hundred that is off by 8 to 15.
    Mixed,
    /// The hidden effect saturates: its law is 1.4 of itself where it is small and 0.7 where it is largest.
    Bent,
}

/// Coefficient of the autoregression, part of the uncertainty that is stated, sizes of zeros, of the step, of
/// what values are rounded to and of zeros among other troubles, and the largest share of a bend.
const COEFFICIENT: f64 = 0.6;
const STATED: f64 = 0.6;
const ZERO: f64 = 3.0;
const STEP: f64 = 4.0;
const ROUNDED: f64 = 2.0;
const SMALLER_ZERO: f64 = 2.0;
const BEND: f64 = 0.4;

impl Trouble {
    /// All of them.
    pub const ALL: &[Self] = &[
        Self::Shared,
        Self::Outliers,
        Self::Understated,
        Self::Zeros,
        Self::Step,
        Self::Rounded,
        Self::Mixed,
        Self::Bent,
    ];

    /// The measurement effects that name it; a step at the border of groups is also one of their zeros. None
    /// where there is nothing to name: a bent law is no effect of the measurement, and steps of the instrument
    /// within the noise do no harm.
    pub fn names(self) -> &'static [&'static str] {
        match self {
            Self::Shared => &["correlated-noise"],
            Self::Outliers => &["outliers"],
            Self::Understated => &["uncertainty-scale"],
            Self::Zeros => &["zero-shift"],
            Self::Step => &["jump", "drift", "zero-shift"],
            Self::Mixed => &["zero-shift", "outliers"],
            Self::Rounded | Self::Bent => &[],
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
            Self::Outliers => wrong = spoil(&mut noise, 50, random),
            Self::Understated | Self::Rounded | Self::Bent => {}
            Self::Zeros => shift(&mut noise, groups, ZERO, random),
            Self::Mixed => {
                shift(&mut noise, groups, SMALLER_ZERO, random);
                wrong = spoil(&mut noise, 100, random);
            }
            Self::Step => {
                let first = random.whole(noise.len() / 5, noise.len() * 4 / 5);
                noise[first..].iter_mut().for_each(|n| *n += STEP);
            }
        }
        (noise, wrong)
    }

    /// What an instrument shows of a value that its noise of `sigma` is already in.
    pub fn shown(self, value: f64, sigma: f64) -> f64 {
        let step = ROUNDED * sigma;
        if self == Self::Rounded { (value / step).round() * step } else { value }
    }

    /// What a law of this signature is off by.
    pub fn bend(self, signature: &[f64]) -> Vec<f64> {
        let largest = signature.iter().fold(0.0_f64, |most, s| most.max(s.abs()));
        let off = |s: &f64| if largest > 0.0 { BEND * s * (2.5 * s.abs() / largest).cos() } else { 0.0 };
        signature.iter().map(|s| if self == Self::Bent { off(s) } else { 0.0 }).collect()
    }
}

/// Makes one row of so many wrong; also says which.
fn spoil(noise: &mut [f64], one_of: usize, random: &mut Random) -> Vec<usize> {
    let mut wrong = Vec::new();
    while wrong.len() < noise.len().div_ceil(one_of) {
        let row = random.whole(0, noise.len() - 1);
        if !wrong.contains(&row) {
            noise[row] += random.sign() * random.uniform(8.0, 15.0);
            wrong.push(row);
        }
    }
    wrong.sort_unstable();
    wrong
}

/// Gives every group a zero of its own.
fn shift(noise: &mut [f64], groups: &[usize], size: f64, random: &mut Random) {
    let count = groups.iter().max().map_or(0, |g| g + 1);
    let zeros: Vec<f64> = (0..count).map(|_| size * random.normal()).collect();
    noise.iter_mut().zip(groups).for_each(|(n, group)| *n += zeros[*group]);
}
