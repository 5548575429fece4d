//! Validation cases: what a handbook, a closed form or a benchmark says, and what the program computes.

/// How near the computed value must come, and never a figure fitted to the program: it follows from the
/// precision of the source or from the discretisation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tolerance {
    /// Part of the expected value.
    Relative(f64),
    /// In the case's unit.
    Absolute(f64),
}

/// One row of the validation table.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// Name of the problem.
    pub name: String,
    /// Quantity that is compared.
    pub quantity: &'static str,
    /// Value by the source.
    pub expected: f64,
    /// Value by the program.
    pub computed: f64,
    /// Unit of both.
    pub unit: &'static str,
    /// How near they must be.
    pub tolerance: Tolerance,
    /// Where the expected value comes from.
    pub source: &'static str,
}

impl Case {
    /// Relative error, or the absolute one where the tolerance is absolute.
    pub fn error(&self) -> f64 {
        match self.tolerance {
            Tolerance::Relative(_) => (self.computed - self.expected) / self.expected,
            Tolerance::Absolute(_) => self.computed - self.expected,
        }
    }

    /// The largest |error| that passes.
    pub fn allowed(&self) -> f64 {
        match self.tolerance {
            Tolerance::Relative(allowed) | Tolerance::Absolute(allowed) => allowed,
        }
    }

    /// Whether the error is a number within the tolerance.
    pub fn passed(&self) -> bool {
        self.error().abs() <= self.allowed()
    }

    /// Whether the source says `text`, in whatever case; `seed-002` is `seed 002`.
    pub fn cites(&self, text: &str) -> bool {
        let plain = |words: &str| words.to_lowercase().replace(['-', '_'], " ");
        plain(self.source).contains(&plain(text))
    }

    /// The work or the way of deriving that the source begins with, without where in it: `seed 002`.
    pub fn work(&self) -> &'static str {
        self.source.split([',', ';', ':', '(']).next().unwrap_or_default().trim()
    }
}
