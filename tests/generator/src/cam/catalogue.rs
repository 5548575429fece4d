//! The effects of a cam grinder: their parameters and plausible sizes.

use crate::law::{Law, Parameter, Role};

/// All of them.
pub const LAWS: &[Law] = &[
    ("wheel-wear", &[Parameter("loss", "um", 2.0, 30.0, Role::Amplitude)]),
    ("servo-lag", &[Parameter("time", "ms", 0.2, 3.0, Role::Signed)]),
    ("infeed-backlash", &[Parameter("gap", "um", 3.0, 30.0, Role::Amplitude)]),
    ("centre-height", &[Parameter("height", "um", 20.0, 200.0, Role::Signed)]),
    ("grinding-deflection", &[Parameter("stiffness", "N/um", 5.0, 60.0, Role::Stiffness)]),
];
