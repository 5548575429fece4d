//! Places of the tool.

/// A place of the tool on the part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// Along the part, m.
    pub x: f64,
    /// Radius, m.
    pub r: f64,
}
