//! Effects and the laws of their parameters: what can be drawn, and how an effect is brought to a wanted
//! visibility.

use crate::random::{Random, figures};

/// One effect with its parameters in canonical units.
#[derive(Debug, Clone, PartialEq)]
pub struct Cause {
    /// Name in the catalogue.
    pub effect: &'static str,
    /// (parameter, value in the canonical unit).
    pub parameters: Vec<(&'static str, f64)>,
}

/// How a parameter's size makes the effect's size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Role {
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
#[derive(Debug, Clone, Copy)]
pub struct Parameter(pub &'static str, pub &'static str, pub f64, pub f64, pub Role);

/// An effect's name and parameters.
pub type Law = (&'static str, &'static [Parameter]);

/// The value of one parameter of one effect, if that effect is among the causes; of an effect that is shown
/// each parameter is a cause.
pub fn value(causes: &[Cause], effect: &str, parameter: &str) -> Option<f64> {
    let mut own = causes.iter().filter(|c| c.effect == effect).flat_map(|c| &c.parameters);
    own.find(|(name, _)| *name == parameter).map(|(_, v)| *v)
}

/// Canonical unit of a parameter.
pub fn unit(laws: &[Law], effect: &str, parameter: &str) -> &'static str {
    parameters(laws, effect).iter().find(|p| p.0 == parameter).map_or("", |p| p.1)
}

fn parameters(laws: &[Law], effect: &str) -> &'static [Parameter] {
    laws.iter().find(|(name, _)| *name == effect).map_or(&[], |(_, parameters)| *parameters)
}

/// An effect with plausible true values; a place in mm is drawn as a share of `length` (mm).
pub fn draw(laws: &[Law], effect: &'static str, length: f64, random: &mut Random) -> Cause {
    let mut drawn = Vec::new();
    for &Parameter(name, unit, low, high, role) in parameters(laws, effect) {
        let size = match role {
            Role::Signed => random.sign() * random.uniform(low, high),
            Role::Shape if ["centre", "at"].contains(&name) && unit == "mm" => length * random.uniform(low, high),
            _ => random.uniform(low, high),
        };
        drawn.push((name, figures(size, 5)));
    }
    Cause { effect, parameters: drawn }
}

/// The same effect, `factor` times as large and of the same shape.
pub fn scaled(laws: &[Law], cause: &Cause, factor: f64) -> Cause {
    let mut scaled = cause.clone();
    for ((_, value), law) in scaled.parameters.iter_mut().zip(parameters(laws, cause.effect)) {
        *value = match law.4 {
            Role::Amplitude | Role::Signed => figures(*value * factor, 5),
            Role::Root => figures(*value * factor.sqrt(), 5),
            Role::Stiffness => figures(*value / factor, 5),
            Role::Shape => *value,
        };
    }
    scaled
}
