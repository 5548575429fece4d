//! Complex numbers of several points of a contour, worked on side by side.

use std::iter::Sum;
use std::ops::Mul;

use nalgebra::Complex;

/// Numbers side by side.
pub const LANES: usize = 8;

/// Real parts and imaginary parts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lanes(pub [[f64; LANES]; 2]);

impl Lanes {
    pub const ONE: Self = Self([[1.0; LANES], [0.0; LANES]]);

    pub fn new(all: [Complex<f64>; LANES]) -> Self {
        Self([all.map(|z| z.re), all.map(|z| z.im)])
    }

    #[inline]
    pub fn add(&mut self, more: &Self, factor: f64) {
        for (to, more) in self.0.iter_mut().zip(&more.0) {
            for i in 0..LANES {
                to[i] += factor * more[i];
            }
        }
    }

    #[must_use]
    #[inline]
    pub fn times(&self, other: &Self) -> Self {
        let ([ar, ai], [br, bi]) = (&self.0, &other.0);
        let mut all = Self::default();
        for i in 0..LANES {
            all.0[0][i] = ar[i] * br[i] - ai[i] * bi[i];
            all.0[1][i] = ar[i] * bi[i] + ai[i] * br[i];
        }
        all
    }

    /// The same number times all.
    #[must_use]
    #[inline]
    pub fn scaled(&self, factor: Complex<f64>) -> Self {
        self.times(&Self::new([factor; LANES]))
    }

    /// All plus the same real number.
    #[must_use]
    #[inline]
    pub fn plus(&self, more: f64) -> Self {
        Self([self.0[0].map(|re| re + more), self.0[1]])
    }

    #[must_use]
    #[inline]
    pub fn inverse(&self) -> Self {
        let [re, im] = &self.0;
        let mut all = Self::default();
        for i in 0..LANES {
            let scale = 1.0 / (re[i] * re[i] + im[i] * im[i]);
            all.0[0][i] = scale * re[i];
            all.0[1][i] = -scale * im[i];
        }
        all
    }

    /// Imaginary part of the sum of all products.
    #[inline]
    pub fn product_sum(&self, other: &Self) -> f64 {
        let ([ar, ai], [br, bi]) = (&self.0, &other.0);
        let mut sums = [0.0; LANES];
        for i in 0..LANES {
            sums[i] = ar[i] * bi[i] + ai[i] * br[i];
        }
        sums.iter().sum()
    }

    /// The sum of all.
    pub fn sum(&self) -> Complex<f64> {
        let [re, im] = self.0.map(|part| part.iter().sum());
        Complex::new(re, im)
    }

    #[must_use]
    pub fn power(&self, exponent: usize) -> Self {
        let (mut all, mut square, mut left) = (Self::ONE, *self, exponent);
        while left > 0 {
            if left % 2 == 1 {
                all = all.times(&square);
            }
            square = square.times(&square);
            left /= 2;
        }
        all
    }
}

impl Mul<f64> for Lanes {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self(self.0.map(|part| part.map(|value| factor * value)))
    }
}

impl Sum for Lanes {
    fn sum<I: Iterator<Item = Self>>(all: I) -> Self {
        all.fold(Self::default(), |mut sum, own| {
            sum.add(&own, 1.0);
            sum
        })
    }
}
