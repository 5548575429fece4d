//! The processes that the program knows.

use super::{Case, Process, axis, cam, contour, fixture, ring, stiffness, thermal, turning};

/// A process and its handbook and benchmark cases, computed on demand.
type Entry = (&'static dyn Process, fn() -> Vec<Case>);

/// One line per process, in the order in which people meet them.
const ENTRIES: [Entry; 8] = [
    (&turning::Turning, turning::cases),
    (&ring::Ring, ring::cases),
    (&thermal::Thermal, thermal::cases),
    (&fixture::Fixture, fixture::cases),
    (&stiffness::Stiffness, stiffness::cases),
    (&axis::Axis, axis::cases),
    (&contour::Contour, contour::cases),
    (&cam::CamGrinding, cam::cases),
];

/// Every process.
pub const ALL: &[&dyn Process] = &{
    let mut all = [ENTRIES[0].0; ENTRIES.len()];
    let mut i = 0;
    while i < all.len() {
        all[i] = ENTRIES[i].0;
        i += 1;
    }
    all
};

/// The handbook and benchmark cases of every process, computed, by its name.
pub fn validation() -> impl Iterator<Item = (&'static str, Vec<Case>)> {
    ENTRIES.iter().map(|(process, cases)| (process.name(), cases()))
}
