//! The effects of heated rods: their parameters and plausible sizes.

use crate::law::{Law, Parameter, Role};

/// All of them. Places are shares of the rod's length here and become mm when drawn.
pub const LAWS: &[Law] = &[
    ("convection", &[Parameter("coefficient", "W/m^2/K", 6.0, 30.0, Role::Amplitude)]),
    ("base-conductance", &[Parameter("conductance", "W/K", 0.03, 0.6, Role::Amplitude)]),
    (
        "ambient-drift",
        &[
            Parameter("amplitude", "K", 0.5, 4.0, Role::Amplitude),
            Parameter("period", "h", 1.2, 7.0, Role::Shape),
            Parameter("phase", "deg", -179.0, 179.0, Role::Shape),
        ],
    ),
    (
        "extra-source",
        &[Parameter("at", "mm", 0.12, 0.88, Role::Shape), Parameter("power", "W", 0.2, 2.0, Role::Amplitude)],
    ),
    (
        "heater-capacity",
        &[
            Parameter("heat_capacity", "J/K", 5.0, 200.0, Role::Amplitude),
            Parameter("contact", "W/K", 0.2, 3.0, Role::Shape),
        ],
    ),
    (
        "contact-resistance",
        &[
            Parameter("at", "mm", 0.15, 0.85, Role::Shape),
            Parameter("conductance", "W/m^2/K", 500.0, 6000.0, Role::Stiffness),
        ],
    ),
    ("sensor-lag", &[Parameter("time_constant", "s", 20.0, 300.0, Role::Amplitude)]),
];
