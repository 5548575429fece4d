//! Further rows that somebody wants measured on the same machine.

/// One of them: what is to be seen, and where, when and how. Numbers are in SI; what is left out is as the model has it.
#[derive(Debug, Clone, PartialEq)]
pub struct Asked {
    /// Name of the observable.
    pub observable: String,
    /// Numbers by the names of their columns.
    pub numbers: Vec<(String, f64)>,
    /// Words by the names of their columns.
    pub words: Vec<(String, String)>,
}

impl Asked {
    /// The number of a column, `size` times as large.
    pub fn number(&self, column: &str, size: f64) -> Option<f64> {
        self.numbers.iter().find(|(name, _)| name == column).map(|(_, value)| value * size)
    }

    /// Whether a column has this word.
    pub fn is(&self, column: &str, word: &str) -> bool {
        self.words.iter().any(|(name, own)| name == column && own == word)
    }
}
