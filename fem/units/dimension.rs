//! Dimensions: exponents over the base units.

use std::fmt;

/// The base units, in the order of the exponents of a [`Dimension`].
const BASE: [&str; 5] = ["m", "kg", "s", "K", "rad"];

/// Exponents of a unit over metre, kilogram, second, kelvin and radian.
///
/// A contact law y = c·Qⁿ gives its coefficient the unit `um/N^n`, whose exponents are known only with n; the
/// part that is multiplied by n is kept beside the fixed part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Dimension {
    fixed: [i8; 5],
    times_n: [i8; 5],
}

impl Dimension {
    /// Dimension of a pure number.
    pub const NONE: Self = Self { fixed: [0; 5], times_n: [0; 5] };

    pub(super) const fn base(exponents: [i8; 5]) -> Self {
        Self { fixed: exponents, times_n: [0; 5] }
    }

    /// The same with angles taken for pure numbers.
    #[must_use]
    pub fn without_angle(mut self) -> Self {
        let angle = BASE.len() - 1;
        (self.fixed[angle], self.times_n[angle]) = (0, 0);
        self
    }

    /// The product of two; `None` beyond any physical power.
    pub fn times(self, other: Self) -> Option<Self> {
        self.combine(other, 1)
    }

    /// The quotient of two.
    pub fn over(self, other: Self) -> Option<Self> {
        self.combine(other, -1)
    }

    /// A whole power.
    pub fn to_the(self, exponent: i8) -> Option<Self> {
        self.power(exponent)
    }

    /// The square root, where every exponent is even.
    pub fn root(self) -> Option<Self> {
        let mut root = self;
        for e in root.fixed.iter_mut().chain(&mut root.times_n) {
            if *e % 2 != 0 {
                return None;
            }
            *e /= 2;
        }
        Some(root)
    }

    pub(super) fn combine(self, other: Self, sign: i8) -> Option<Self> {
        let mut sum = self;
        for i in 0..BASE.len() {
            sum.fixed[i] = sum.fixed[i].checked_add(other.fixed[i].checked_mul(sign)?)?;
            sum.times_n[i] = sum.times_n[i].checked_add(other.times_n[i].checked_mul(sign)?)?;
        }
        Some(sum)
    }

    pub(super) fn power(self, exponent: i8) -> Option<Self> {
        let mut power = self;
        for e in power.fixed.iter_mut().chain(&mut power.times_n) {
            *e = e.checked_mul(exponent)?;
        }
        Some(power)
    }

    /// The dimension raised to the symbol n; only a fixed dimension can be.
    pub(super) fn power_n(self) -> Option<Self> {
        (self.times_n == [0; 5]).then_some(Self { fixed: [0; 5], times_n: self.fixed })
    }
}

impl fmt::Display for Dimension {
    /// Writes the dimension as a product of SI base units, `m^2·kg·s^-3`; a pure number is `1`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut first = true;
        for (i, name) in BASE.iter().enumerate() {
            for (power, symbol) in [(self.fixed[i], ""), (self.times_n[i], "n")] {
                if power == 0 {
                    continue;
                }
                if !first {
                    write!(f, "·")?;
                }
                first = false;
                match (power, symbol) {
                    (1, "") => write!(f, "{name}")?,
                    (_, "") => write!(f, "{name}^{power}")?,
                    _ => write!(f, "{name}^({power}n)")?,
                }
            }
        }
        if first { write!(f, "1") } else { Ok(()) }
    }
}
