//! The effects of a feed axis: their parameters and plausible sizes.

use crate::law::{Law, Parameter, Role};

/// All of them.
pub const LAWS: &[Law] = &[
    ("scale-error", &[Parameter("slope", "um/m", 8.0, 60.0, Role::Signed)]),
    (
        "periodic-error",
        &[
            Parameter("amplitude", "um", 0.8, 8.0, Role::Amplitude),
            Parameter("phase", "deg", -179.0, 179.0, Role::Shape),
        ],
    ),
    ("backlash", &[Parameter("gap", "um", 2.0, 30.0, Role::Signed)]),
    ("uneven-backlash", &[Parameter("change", "um", 3.0, 40.0, Role::Signed)]),
    ("worn-screw", &[Parameter("depth", "um", 3.0, 40.0, Role::Amplitude)]),
    (
        "elastic-lost-motion",
        &[
            Parameter("friction", "N", 100.0, 3000.0, Role::Amplitude),
            Parameter("stiffness", "N/um", 60.0, 600.0, Role::Shape),
        ],
    ),
    (
        "thermal-growth",
        &[
            Parameter("slope", "um/m", 15.0, 100.0, Role::Signed),
            Parameter("time_constant", "min", 8.0, 45.0, Role::Shape),
        ],
    ),
    ("abbe-error", &[Parameter("height", "um", 2.0, 30.0, Role::Signed)]),
    ("reference-shift", &[Parameter("offset", "um", 2.0, 30.0, Role::Signed)]),
];
