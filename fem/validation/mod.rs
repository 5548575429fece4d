//! The validation table: what handbooks, closed forms, standards and benchmarks say, and what the program
//! computes; each part with a bench of its own.

mod axis;
mod bench;
mod budget;
mod cam;
mod case;
mod contour;
mod fit;
mod fixture;
mod ring;
mod rotary;
mod stiffness;
mod study;
mod thermal;
mod turning;

pub use case::{Case, Tolerance};

/// A part of the table: its name and its cases, which are computed on demand.
pub type Part = (&'static str, fn() -> Vec<Case>);

/// Every part of the table.
pub const PARTS: &[Part] = &[
    ("turning", turning::cases),
    ("ring", ring::cases),
    ("thermal", thermal::cases),
    ("fixture", fixture::cases),
    ("stiffness", stiffness::cases),
    ("axis", axis::cases),
    ("rotary", rotary::cases),
    ("contour", contour::cases),
    ("cam", cam::cases),
    ("budget", budget::cases),
    ("fit", fit::cases),
    ("study", study::cases),
];
