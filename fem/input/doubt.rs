//! Doubt about values that stand in a file as if they were known.

/// How a prediction grows with a quantity, so that a search goes along a variable in which it is nearly linear.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grows {
    /// As the quantity does: an amplitude, a force.
    Linearly,
    /// As its reciprocal: a stiffness.
    Inversely,
    /// In some other way: a shape, an exponent.
    Otherwise,
    /// As the quantity does, which is off by an amount and not by a factor, for its zero is a convention: a temperature.
    Evenly,
}

/// How often and how far what people write for a quantity is wrong where they write it as known. Quantities that a
/// drawing, a programme or a setting states have none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Doubt {
    /// Odds against one that it is wrong by so much that it shows.
    pub odds: f64,
    /// Factor, either way, by which it is then usually off at most; where it grows evenly the amount, SI.
    pub off: f64,
    /// How the prediction grows with it.
    pub grows: Grows,
    /// Why.
    pub because: &'static str,
}

impl Doubt {
    /// Doubt about a quantity that is off by a factor.
    pub const fn by_factor(odds: f64, factor: f64, grows: Grows, because: &'static str) -> Self {
        Self { odds, off: factor, grows, because }
    }

    /// Doubt about a quantity that is off by an amount, SI.
    pub const fn by_amount(odds: f64, amount: f64, because: &'static str) -> Self {
        Self { odds, off: amount, grows: Grows::Evenly, because }
    }
}
