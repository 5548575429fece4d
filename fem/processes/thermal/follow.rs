//! A body followed through time: the looks at it, and what was seen.

use crate::process::Failure;
use crate::solve::conduction::Energy;
use crate::solve::rod::Track;

/// Something to look at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Look {
    /// Growth of the body from its base to its free end, m.
    Elongation,
    /// Rise of the middle of a plane body over its ends, upwards, m.
    Bow,
    /// Change of the diameter of a circle of a body of revolution, m.
    Diameter {
        /// Distance of the circle from the left end, m.
        x: f64,
        /// Its radius, m; the outside where it is `None`.
        y: Option<f64>,
    },
    /// Rise of temperature at a place, K.
    Rise {
        /// Distance from the base, m.
        x: f64,
        /// Height in a plane body, m; half way up where it is `None`. Radius in a body of revolution, the outside where
        /// it is `None`. Rods have none.
        y: Option<f64>,
    },
}

impl Look {
    /// Whether it is at the shape of the body, and not at a temperature.
    pub fn is_shape(&self) -> bool {
        !matches!(self, Self::Rise { .. })
    }
}

/// Somebody who is told the time (s) at the start and at the end of every step, and may ask for the rises of
/// all nodes (K).
pub type Watch<'a> = &'a mut dyn FnMut(f64, &dyn Fn() -> Vec<f64>);

/// Values and heat balance of a body followed through time.
#[derive(Clone, Debug)]
pub struct Followed {
    /// Values of every look at the start and at the end of every step.
    pub track: Track,
    /// Where the heat went.
    pub energy: Energy,
}

/// A body that cannot be computed.
pub fn unsolvable(error: &dyn std::fmt::Display) -> Failure {
    Failure {
        message: format!("the body cannot be computed: {error}"),
        help: "check its dimensions, sources, joints and steps: a unit may be wrong".into(),
    }
}
