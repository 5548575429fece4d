//! In which terms of a value it is spread about what is known best.

use crate::input::{Bounds, Parameter};

/// What of a value is normal about its best, where it is not known exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spread {
    /// The value.
    Plain,
    /// Its logarithm: of something whose size is known by a factor, as beside an exponent.
    Logarithm,
    /// Its reciprocal: of a stiffness that may as well be infinite.
    Reciprocal,
}

impl Spread {
    /// All of them.
    const ALL: [Self; 3] = [Self::Plain, Self::Logarithm, Self::Reciprocal];
    /// How many times its best a value is where its reciprocal is none.
    const INFINITE: f64 = 1e6;

    /// The usual one of a parameter: what is positive is known by a factor.
    pub fn usual(parameter: &Parameter) -> Self {
        if parameter.bounds == Bounds::Positive { Self::Logarithm } else { Self::Plain }
    }

    /// Its word.
    pub fn word(self) -> &'static str {
        match self {
            Self::Plain => "plain",
            Self::Logarithm => "logarithm",
            Self::Reciprocal => "reciprocal",
        }
    }

    /// That of a word.
    pub fn of(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|own| own.word() == word)
    }

    /// The value that lies so far (in units of the value) from the best.
    pub fn away(self, best: f64, by: f64) -> f64 {
        let share = by / best;
        match self {
            // Without the round-off of a logarithm and back; nothing has neither.
            _ if by == 0.0 || best == 0.0 => best + by,
            Self::Plain => best + by,
            Self::Logarithm => best * share.exp(),
            Self::Reciprocal => best / (1.0 - share).max(1.0 / Self::INFINITE),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Spread;

    #[test]
    fn a_small_step_is_the_same_in_all_terms() {
        for spread in Spread::ALL {
            assert_eq!(spread.away(-3.0, 0.0), -3.0);
            assert!((spread.away(-3.0, 1e-6) + 3.0 - 1e-6).abs() < 1e-12, "{spread:?}");
            assert_eq!(Spread::of(spread.word()), Some(spread));
        }
        assert_eq!(Spread::Reciprocal.away(50.0, 25.0), 100.0);
        assert_eq!(Spread::Reciprocal.away(50.0, 60.0), 5e7);
    }
}
