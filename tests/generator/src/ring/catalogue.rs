//! The effects of the ring: their parameters and plausible sizes.

use crate::law::{Law, Parameter, Role};

/// All of them.
pub const LAWS: &[Law] = &[
    ("jaw-contact-arc", &[Parameter("arc", "deg", 8.0, 45.0, Role::Root)]),
    (
        "jaw-position",
        &[Parameter("error_2", "deg", 0.2, 3.0, Role::Signed), Parameter("error_3", "deg", 0.2, 3.0, Role::Signed)],
    ),
    ("jaw-imbalance", &[Parameter("difference", "%", 2.0, 40.0, Role::Signed)]),
    ("centrifugal-unloading", &[Parameter("jaw_moment", "kg*mm", 10.0, 80.0, Role::Amplitude)]),
    (
        "residual-stress",
        &[Parameter("amplitude", "um", 1.0, 8.0, Role::Amplitude), Parameter("phase", "deg", -89.0, 89.0, Role::Shape)],
    ),
    (
        "spindle-error",
        &[Parameter("amplitude", "um", 1.0, 8.0, Role::Amplitude), Parameter("phase", "deg", -89.0, 89.0, Role::Shape)],
    ),
    (
        "chuck-runout",
        &[Parameter("runout", "um", 4.0, 40.0, Role::Amplitude), Parameter("phase", "deg", -179.0, 179.0, Role::Shape)],
    ),
    ("cutting-heat", &[Parameter("temperature_rise", "K", 2.0, 20.0, Role::Amplitude)]),
    ("copying", &[Parameter("stiffness", "N/um", 3.0, 40.0, Role::Stiffness)]),
];
