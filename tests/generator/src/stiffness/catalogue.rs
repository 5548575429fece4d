//! The effects of a joint under test: their parameters and plausible sizes.

use crate::law::{Law, Parameter, Role};

/// All of them.
pub const LAWS: &[Law] = &[
    ("gap", &[Parameter("gap", "um", 1.0, 20.0, Role::Amplitude)]),
    (
        "contact-joint",
        &[Parameter("c", "um/N^n", 0.05, 0.6, Role::Amplitude), Parameter("n", "", 0.35, 0.75, Role::Shape)],
    ),
    ("dry-friction", &[Parameter("force", "N", 8.0, 120.0, Role::Amplitude)]),
    ("preload", &[Parameter("force", "N", 40.0, 300.0, Role::Amplitude)]),
    ("settling", &[Parameter("depth", "um", 0.8, 15.0, Role::Amplitude)]),
    ("datum-offset", &[Parameter("offset", "um", 1.0, 20.0, Role::Signed)]),
];
