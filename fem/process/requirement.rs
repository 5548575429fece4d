//! What a drawing asks of what is made.

use crate::tolerance::Limits;
use crate::units::Kind;

/// One characteristic, and the limits that it has to keep.
#[derive(Clone, Debug, PartialEq)]
pub struct Requirement {
    /// Key for programs.
    pub key: &'static str,
    /// Name for people: "diameter of section 2, h6".
    pub label: String,
    /// Kind of its values.
    pub kind: Kind,
    /// Its limits, SI; those of a size are deviations from the nominal one.
    pub limits: Limits,
}

/// A characteristic of one part, as rows of it show it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Characteristic {
    /// Which of the requirements it is held against, by its position.
    pub requirement: usize,
    /// Number of the part, where parts have numbers.
    pub part: Option<usize>,
    /// The smallest and the largest value, SI; the same twice of a form.
    pub range: [f64; 2],
}
