//! The effects of two axes on a circle: their parameters and plausible sizes.

use crate::law::{Law, Parameter, Role};

const GAP: &[Parameter] = &[Parameter("gap", "um", 2.0, 15.0, Role::Amplitude)];
const WAVE: &[Parameter] =
    &[Parameter("amplitude", "um", 0.8, 6.0, Role::Amplitude), Parameter("phase", "deg", -179.0, 179.0, Role::Shape)];
const WINDING: &[Parameter] = &[
    Parameter("friction", "N", 100.0, 1500.0, Role::Amplitude),
    Parameter("stiffness", "N/um", 60.0, 600.0, Role::Shape),
];
const CHANGE: &[Parameter] = &[Parameter("change", "", 0.02, 0.15, Role::Signed)];
const SPIKE: &[Parameter] = &[
    Parameter("height", "um", 2.0, 20.0, Role::Amplitude),
    Parameter("time_constant", "ms", 60.0, 400.0, Role::Shape),
];

/// All of them.
pub const LAWS: &[Law] = &[
    ("servo-mismatch", &[Parameter("mismatch", "", 0.01, 0.08, Role::Signed)]),
    ("gain-with-feed-x", CHANGE),
    ("gain-with-feed-y", CHANGE),
    ("backlash-x", GAP),
    ("backlash-y", GAP),
    ("elastic-lost-motion-x", WINDING),
    ("elastic-lost-motion-y", WINDING),
    ("cyclic-error-x", WAVE),
    ("cyclic-error-y", WAVE),
    ("stick-slip-x", WAVE),
    ("stick-slip-y", WAVE),
    ("scale-mismatch", &[Parameter("mismatch", "um/m", 10.0, 80.0, Role::Signed)]),
    ("squareness", &[Parameter("angle", "um/m", 10.0, 80.0, Role::Signed)]),
    (
        "cutting-deflection",
        &[
            Parameter("stiffness_x", "N/um", 10.0, 60.0, Role::Stiffness),
            Parameter("stiffness_y", "N/um", 10.0, 60.0, Role::Stiffness),
        ],
    ),
    ("reversal-spike-x", SPIKE),
    ("reversal-spike-y", SPIKE),
    ("centre-offset", &[Parameter("x", "um", 2.0, 15.0, Role::Signed), Parameter("y", "um", 2.0, 15.0, Role::Signed)]),
];
