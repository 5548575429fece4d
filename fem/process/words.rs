//! The words that a column may hold.

use std::sync::Arc;

use crate::input::Name;

/// Words of a column, each kept as its position among them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Words {
    /// Those that a process knows.
    Known(&'static [&'static str]),
    /// Those that a file has, in the order in which they first appear.
    Recorded(Arc<[Name]>),
}

impl Words {
    /// None at all.
    pub const NONE: Self = Self::Known(&[]);

    /// The word at a position.
    pub fn get(&self, position: usize) -> Option<&str> {
        match self {
            Self::Known(all) => all.get(position).copied(),
            Self::Recorded(all) => all.get(position).map(Name::as_str),
        }
    }

    /// The word for which a value of a column stands.
    pub fn of_value(&self, value: f64) -> Option<&str> {
        if value.is_nan() { None } else { self.get(value as usize) }
    }

    /// Position of a word.
    pub fn position(&self, word: &str) -> Option<usize> {
        self.iter().position(|own| own == word)
    }

    /// All words.
    pub fn iter(&self) -> impl Iterator<Item = &str> {
        (0..self.len()).filter_map(|position| self.get(position))
    }

    /// Number of words.
    pub fn len(&self) -> usize {
        match self {
            Self::Known(all) => all.len(),
            Self::Recorded(all) => all.len(),
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}
