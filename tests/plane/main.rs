//! Plane finite elements against closed forms, the Fourier series of the ring and published benchmarks, and
//! the rates at which their errors fall with the size of elements and steps.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod elliptic_membrane;
mod heat_rates;
mod other_codes;
mod patch;
mod revolved;
mod ring_free;
mod ring_jaws;
mod ring_rates;
mod thermal;
mod thermal_bow;

/// Observed order between errors at sizes h and h/2.
fn order(coarse: f64, fine: f64) -> f64 {
    (coarse / fine).log2()
}
