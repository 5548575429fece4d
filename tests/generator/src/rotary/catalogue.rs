//! The effects of a rotary axis: their parameters and plausible sizes.

use crate::law::{Law, Parameter, Role};

const PHASE: Parameter = Parameter("phase", "deg", -179.0, 179.0, Role::Shape);

/// All of them.
pub const LAWS: &[Law] = &[
    ("worm-error", &[Parameter("amplitude", "arcsec", 1.0, 20.0, Role::Amplitude), PHASE]),
    ("worm-second-harmonic", &[Parameter("amplitude", "arcsec", 0.8, 10.0, Role::Amplitude), PHASE]),
    ("wheel-eccentricity", &[Parameter("eccentricity", "um", 3.0, 40.0, Role::Amplitude), PHASE]),
    ("tooth-error", &[Parameter("amplitude", "arcsec", 1.0, 20.0, Role::Amplitude), PHASE]),
    ("gear-eccentricity", &[Parameter("amplitude", "arcsec", 1.0, 30.0, Role::Amplitude), PHASE]),
    ("motor-gear-eccentricity", &[Parameter("amplitude", "arcsec", 1.0, 20.0, Role::Amplitude), PHASE]),
    ("ratio-error", &[Parameter("slope", "arcsec/deg", 0.05, 0.6, Role::Signed)]),
    ("backlash", &[Parameter("gap", "arcsec", 4.0, 60.0, Role::Signed)]),
    ("uneven-backlash", &[Parameter("change", "arcsec", 3.0, 30.0, Role::Amplitude), PHASE]),
    (
        "elastic-wind-up",
        &[
            Parameter("friction", "N*m", 2.0, 40.0, Role::Amplitude),
            Parameter("stiffness", "N*m/arcsec", 0.8, 8.0, Role::Shape),
        ],
    ),
    ("compliance", &[Parameter("stiffness", "N*m/arcsec", 0.8, 8.0, Role::Stiffness)]),
    ("unbalance", &[Parameter("moment", "N*m", 3.0, 60.0, Role::Amplitude), PHASE]),
    ("scale-eccentricity", &[Parameter("eccentricity", "um", 1.0, 15.0, Role::Amplitude), PHASE]),
    ("scale-second-harmonic", &[Parameter("amplitude", "arcsec", 0.8, 10.0, Role::Amplitude), PHASE]),
    ("interpolation-error", &[Parameter("amplitude", "arcsec", 0.5, 5.0, Role::Amplitude), PHASE]),
    (
        "thermal-drift",
        &[
            Parameter("size", "arcsec", 4.0, 40.0, Role::Signed),
            Parameter("time_constant", "min", 8.0, 45.0, Role::Shape),
        ],
    ),
    ("reference-shift", &[Parameter("offset", "arcsec", 4.0, 60.0, Role::Signed)]),
];
