//! What is usual of a parameter of a candidate effect.

/// Size of a candidate effect, in terms of the largest usual one, beyond which no machine has it.
const BELIEVED: f64 = 100.0;

/// Soft knowledge of a parameter of a candidate effect, in the search variable s: what is unusual costs, and a size far beyond
/// it is not believed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Usual {
    /// A size of either sign: ln |s| is spread about a centre.
    Size {
        /// Centre of ln |s|.
        centre: f64,
        /// Standard deviation of ln |s|.
        spread: f64,
    },
    /// Anything that may vanish or has no size: s is spread about a centre.
    Place {
        /// Centre of s.
        centre: f64,
        /// Standard deviation of s.
        spread: f64,
    },
    /// Something that somebody has adjusted: s has a normal distribution about zero, without the tails of the others.
    Adjusted {
        /// Standard deviation of s.
        spread: f64,
    },
    /// One of so many places, each as likely as any other.
    OneOf(usize),
}

impl Usual {
    /// Standard deviation of a normal distribution whose middle nine tenths are a range of length one.
    pub(super) const NINE_TENTHS: f64 = 0.5 / 1.645;
    /// Standard deviation of what is equally likely within a range of length one.
    const EVEN: f64 = 0.288_675;
    /// Ratio of the largest to the smallest usual size where the catalogue says no smallest.
    pub(super) const DECADES: f64 = 200.0;

    /// The size that is usually not surpassed.
    pub fn largest(&self) -> f64 {
        const BEYOND: f64 = 2.0;
        match self {
            Self::Size { centre, spread } => (centre + BEYOND * spread).exp(),
            Self::Place { centre, spread } => centre.abs() + BEYOND * spread,
            Self::Adjusted { spread } => BEYOND * spread,
            Self::OneOf(_) => f64::INFINITY,
        }
    }

    /// A size whose middle nine tenths are a range.
    pub(super) fn size(smallest: f64, largest: f64) -> Self {
        let (low, high) = (smallest.ln(), largest.ln());
        Self::Size { centre: 0.5 * (low + high), spread: (high - low) * Self::NINE_TENTHS }
    }

    /// Anything that is as likely everywhere within a range.
    pub(super) fn place(low: f64, high: f64) -> Self {
        Self::Place { centre: 0.5 * (low + high), spread: (high - low) * Self::EVEN }
    }

    /// Whether it is a size that no machine has: two effects that cancel each other grow so far.
    pub fn is_beyond_belief(&self, s: f64) -> bool {
        matches!(self, Self::Size { .. }) && s.abs() > BELIEVED * self.largest()
    }
}
