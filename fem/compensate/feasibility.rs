//! Whether compensation can keep what is allowed.

/// Whether compensation brings the axis within its tolerances.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Feasibility {
    /// The axis is within them as it is.
    Within,
    /// One pitch table and one backlash value suffice.
    Compensation,
    /// Only a table for each direction suffices.
    BothDirections,
    /// Tables would suffice if the controller took finer entries.
    Resolution,
    /// No table suffices: the mechanics must be repaired first.
    Repair,
    /// Tables suffice at the targets, and the test does not tell whether they do between them.
    BetweenTargets,
    /// The test does not tell, for repeated approaches are missing.
    Unknown,
}

impl Feasibility {
    /// Word in JSON.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Within => "within-tolerance",
            Self::Compensation => "compensation-suffices",
            Self::BothDirections => "needs-both-directions",
            Self::Resolution => "needs-finer-resolution",
            Self::Repair => "repair-first",
            Self::BetweenTargets => "unknown-between-targets",
            Self::Unknown => "unknown",
        }
    }
}
