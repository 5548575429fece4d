//! The balance of heat: where it went.

/// Heat over a run, J.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// More heat in the body, and in the heaters on it, than at the start.
    pub stored: f64,
    /// Put in by fluxes and sources.
    pub supplied: f64,
    /// Lost by convection (to ambient and from it, the difference).
    pub convected: f64,
    /// Come in where the temperature is prescribed.
    pub prescribed: f64,
    /// Sum of the sizes of all of these, step by step: what rounding is measured by.
    pub turnover: f64,
}

impl Energy {
    /// Adds up a step's shares.
    pub(in crate::solve) fn add(&mut self, stored: f64, supplied: f64, convected: f64, prescribed: f64) {
        self.stored += stored;
        self.supplied += supplied;
        self.convected += convected;
        self.prescribed += prescribed;
        self.turnover += stored.abs() + supplied.abs() + convected.abs() + prescribed.abs();
    }

    /// (supplied + prescribed − convected − stored) / turnover: rounding in a correct computation.
    pub fn imbalance(&self) -> f64 {
        let gap = self.supplied + self.prescribed - self.convected - self.stored;
        if gap == 0.0 { 0.0 } else { gap / self.turnover }
    }
}
