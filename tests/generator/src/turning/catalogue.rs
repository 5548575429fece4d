//! The 17 effects of turning: their parameters, plausible sizes, and which workholding admits them.

use crate::job::Holding;
use crate::random::{Random, figures};

/// One effect with its parameters in canonical units.
#[derive(Debug, Clone, PartialEq)]
pub struct Cause {
    /// Name in the catalogue.
    pub effect: &'static str,
    /// (parameter, value in the canonical unit).
    pub parameters: Vec<(&'static str, f64)>,
}

/// How a parameter's size makes the effect's size; needed to bring an effect to a wanted visibility.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Role {
    /// The effect is proportional to it.
    Amplitude,
    /// Proportional, of either sign.
    Signed,
    /// The effect is proportional to its square.
    Root,
    /// The effect is inversely proportional to it.
    Stiffness,
    /// An exponent, time constant or place: changes the shape.
    Shape,
}

/// One parameter: its name, unit, and the plausible range from which true values are drawn.
struct Parameter(&'static str, &'static str, f64, f64, Role);

const STIFFNESS: &[Parameter] = &[Parameter("stiffness", "N/um", 15.0, 150.0, Role::Stiffness)];
const CONTACT: &[Parameter] =
    &[Parameter("c", "um/N^n", 0.15, 0.4, Role::Amplitude), Parameter("n", "", 0.35, 0.7, Role::Shape)];
const TILT: &[Parameter] = &[Parameter("stiffness", "kN*m/rad", 200.0, 900.0, Role::Stiffness)];
const FEEDBACK: &[Parameter] = &[Parameter("exponent", "", 0.6, 1.0, Role::Amplitude)];
const WEAR: &[Parameter] = &[
    Parameter("run_in", "um", 1.0, 4.0, Role::Amplitude),
    Parameter("run_in_path", "m", 300.0, 900.0, Role::Shape),
    Parameter("rate", "um/km", 3.0, 15.0, Role::Amplitude),
];
const GROWTH: &[Parameter] = &[
    Parameter("elongation", "um", 5.0, 15.0, Role::Amplitude),
    Parameter("time_constant", "min", 10.0, 40.0, Role::Shape),
];
const HEATING: &[Parameter] = &[
    Parameter("power", "W", 30.0, 150.0, Role::Amplitude),
    Parameter("convection", "W/m^2/K", 5.0, 30.0, Role::Shape),
];
const DRIFT: &[Parameter] =
    &[Parameter("drift", "um", 4.0, 15.0, Role::Amplitude), Parameter("time_constant", "min", 30.0, 90.0, Role::Shape)];
const TAPER: &[Parameter] = &[Parameter("slope", "um/m", 10.0, 60.0, Role::Signed)];
const HEIGHT: &[Parameter] = &[Parameter("slope", "mm/m", 1.0, 4.0, Role::Root)];
/// The centre's range is a share of the shaft's length here; it becomes mm when drawn.
const HOLLOW: &[Parameter] = &[
    Parameter("depth", "um", 3.0, 20.0, Role::Amplitude),
    Parameter("centre", "mm", 0.15, 0.85, Role::Shape),
    Parameter("width", "mm", 25.0, 90.0, Role::Shape),
];
const TAILSTOCK: &[Parameter] = &[Parameter("offset", "um", 4.0, 40.0, Role::Signed)];
const SETTING: &[Parameter] = &[Parameter("offset", "um", 5.0, 30.0, Role::Signed)];

const LAWS: &[(&str, &[Parameter])] = &[
    ("headstock-compliance", STIFFNESS),
    ("tailstock-compliance", STIFFNESS),
    ("carriage-compliance", STIFFNESS),
    ("headstock-contact", CONTACT),
    ("tailstock-contact", CONTACT),
    ("carriage-contact", CONTACT),
    ("chuck-tilt", TILT),
    ("force-feedback", FEEDBACK),
    ("tool-wear", WEAR),
    ("tool-thermal-growth", GROWTH),
    ("workpiece-heating", HEATING),
    ("spindle-thermal-drift", DRIFT),
    ("guideway-taper", TAPER),
    ("guideway-height", HEIGHT),
    ("guideway-wear", HOLLOW),
    ("tailstock-offset", TAILSTOCK),
    ("setting-error", SETTING),
];

/// Names of all effects of the process.
pub const EFFECTS: &[&str] = &[
    "headstock-compliance",
    "tailstock-compliance",
    "carriage-compliance",
    "headstock-contact",
    "tailstock-contact",
    "carriage-contact",
    "chuck-tilt",
    "force-feedback",
    "tool-wear",
    "tool-thermal-growth",
    "workpiece-heating",
    "spindle-thermal-drift",
    "guideway-taper",
    "guideway-height",
    "guideway-wear",
    "tailstock-offset",
    "setting-error",
];

/// The laws that meet in the force equilibrium; the others add.
const IN_EQUILIBRIUM: &[&str] = &[
    "headstock-compliance",
    "tailstock-compliance",
    "carriage-compliance",
    "headstock-contact",
    "tailstock-contact",
    "carriage-contact",
    "chuck-tilt",
    "force-feedback",
];

/// Whether the effect acts through the equilibrium (springs, contacts, tilt, feedback) and not by adding to the diameter.
pub fn in_equilibrium(effect: &str) -> bool {
    IN_EQUILIBRIUM.contains(&effect)
}

/// "tailstock-* and tailstock-offset not in `chuck`; chuck-tilt not in `centres`; the others all".
pub fn admits(holding: Holding, effect: &str) -> bool {
    match holding {
        Holding::Centres => effect != "chuck-tilt",
        Holding::Chuck => !effect.starts_with("tailstock-"),
        Holding::ChuckAndCentre => true,
    }
}

/// The value of one parameter of one effect, if that effect is among the causes.
pub fn value(causes: &[Cause], effect: &str, parameter: &str) -> Option<f64> {
    let cause = causes.iter().find(|c| c.effect == effect)?;
    cause.parameters.iter().find(|(name, _)| *name == parameter).map(|(_, v)| *v)
}

/// Canonical unit of a parameter.
pub fn unit(effect: &str, parameter: &str) -> &'static str {
    parameters(effect).iter().find(|p| p.0 == parameter).map_or("", |p| p.1)
}

fn parameters(effect: &str) -> &'static [Parameter] {
    LAWS.iter().find(|(name, _)| *name == effect).map_or(&[], |(_, parameters)| *parameters)
}

/// An effect with plausible true values for a shaft of this length (mm).
pub fn draw(effect: &'static str, length: f64, random: &mut Random) -> Cause {
    let mut drawn = Vec::new();
    for &Parameter(name, unit, low, high, role) in parameters(effect) {
        let size = match role {
            Role::Signed => random.sign() * random.uniform(low, high),
            Role::Shape if name == "centre" && unit == "mm" => length * random.uniform(low, high),
            _ => random.uniform(low, high),
        };
        drawn.push((name, figures(size, 5)));
    }
    Cause { effect, parameters: drawn }
}

/// The same effect, `factor` times as large and of the same shape.
pub fn scaled(cause: &Cause, factor: f64) -> Cause {
    let mut scaled = cause.clone();
    for ((_, value), law) in scaled.parameters.iter_mut().zip(parameters(cause.effect)) {
        *value = match law.4 {
            Role::Amplitude | Role::Signed => figures(*value * factor, 5),
            Role::Root => figures(*value * factor.sqrt(), 5),
            Role::Stiffness => figures(*value / factor, 5),
            Role::Shape => *value,
        };
    }
    scaled
}

/// How far a draw may be scaled down before it is a different kind of thing: an exponent of 0.1 is no cutting force.
pub fn least_factor(effect: &str) -> f64 {
    if effect == "force-feedback" { 0.25 } else { 0.04 }
}
