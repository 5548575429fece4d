//! Conditions that heat and cool a body.

use super::{History, Power, ThermalError};
use crate::element::plane::{Thickness, WHOLE};
use crate::mesh::{Mesh, Side};

/// One condition on a body. Sides without any are insulated.
#[derive(Clone, Debug)]
pub enum Condition {
    /// Heat flows in through the sides `sides`.
    Flux {
        /// Name of the sides.
        sides: String,
        /// Heat flux, W/m², positive into the body.
        flux: Power,
    },
    /// A strip of flux that moves along straight sides, in the direction of growing x (or y where the sides
    /// are upright) for a positive speed.
    MovingFlux {
        /// Name of the sides.
        sides: String,
        /// Heat flux under the strip, W/m².
        flux: Power,
        /// Width of the strip, m.
        width: f64,
        /// Place of its middle at t = 0: x (or y), m.
        start: f64,
        /// Speed of the strip, m/s.
        speed: f64,
    },
    /// A source (W) on nodes.
    Source {
        /// Each node with its share of the power.
        shares: Vec<(usize, f64)>,
        /// Power, W.
        power: Power,
    },
    /// Loss h (T − T_a) through the sides.
    Convection {
        /// Name of the sides.
        sides: String,
        /// Heat transfer coefficient h, W/(m² K).
        coefficient: f64,
        /// T_a over time.
        ambient: History,
    },
    /// A loss through the sides that is not in proportion to their temperature, or whose film changes.
    Surface {
        /// Name of the sides.
        sides: String,
        /// The loss.
        loss: Loss,
        /// T_a over time.
        ambient: History,
    },
    /// Loss h (T − T_a) through both faces of the sheet, everywhere; a body of revolution has none.
    Faces {
        /// Heat transfer coefficient h, W/(m² K).
        coefficient: f64,
        /// T_a over time.
        ambient: History,
    },
    /// Prescribed temperature of the sides.
    Temperature {
        /// Name of the sides.
        sides: String,
        /// T over time.
        temperature: History,
    },
}

/// What a surface loses to surroundings, by its temperature and the time.
#[derive(Clone, Debug)]
pub enum Loss {
    /// h (T − T_a), h in W/(m² K) over time.
    Film(History),
    /// εσ (T⁴ − T_a⁴) of absolute temperatures.
    Radiation {
        /// Emissivity ε.
        emissivity: f64,
        /// Absolute temperature (K) at which all histories and temperatures of the body are zero.
        zero: f64,
    },
}

impl Condition {
    /// Times (s) at which the condition jumps.
    pub fn switches(&self) -> Vec<f64> {
        match self {
            Self::Flux { flux: power, .. } | Self::MovingFlux { flux: power, .. } | Self::Source { power, .. } => {
                power.switches().collect()
            }
            _ => Vec::new(),
        }
    }
}

/// Heat (W) into nodes per unit of an amplitude.
pub(super) struct Supply {
    /// Each node with its power per unit, W.
    pub shares: Vec<(usize, f64)>,
    pub amplitude: Amplitude,
}

pub(super) enum Amplitude {
    Switched(Power),
    Varying(History),
}

impl Amplitude {
    /// Value at `time` as the step between two times takes it.
    pub fn within(&self, time: f64, step: [f64; 2]) -> f64 {
        match self {
            Self::Switched(power) => power.within(time, step),
            Self::Varying(history) => history.within(time, step),
        }
    }
}

/// ∫ Nₐ t dl of all nodes on `sides`, times `factor`.
pub(super) fn side_shares(mesh: &Mesh, sides: &[Side], thickness: Thickness, factor: f64) -> Vec<(usize, f64)> {
    let factor = factor * thickness.scale();
    let own = |&side: &Side| {
        let shares = mesh.curve(side).shape_integrals(thickness, WHOLE);
        let nodes = mesh.side_nodes(side).as_slice().to_vec();
        nodes.into_iter().zip(shares).map(move |(node, share)| (node as usize, factor * share))
    };
    sides.iter().flat_map(own).collect()
}

/// Part of the way that a side covers, below which it stands across the way.
const ACROSS: f64 = 1e-12;

/// A strip of flux moving along straight sides.
pub(super) struct MovingStrip {
    /// Sides with their coordinate at s = −1 and at s = 1.
    sides: Vec<(Side, f64, f64)>,
    thickness: Thickness,
    flux: Power,
    width: f64,
    start: f64,
    speed: f64,
}

impl MovingStrip {
    pub fn new(
        mesh: &Mesh,
        sides: &[Side],
        thickness: Thickness,
        flux: Power,
        [width, start, speed]: [f64; 3],
    ) -> Result<Self, ThermalError> {
        ThermalError::check(width > 0.0 && width.is_finite(), "width of the strip (m)", "above zero", width)?;
        ThermalError::check(start.is_finite(), "start of the strip (m)", "finite", start)?;
        ThermalError::check(speed.is_finite(), "speed of the strip (m/s)", "finite", speed)?;
        let ends = |side: &Side| [-1.0, 1.0].map(|s| mesh.curve(*side).point(s));
        let extent = |axis: usize| {
            let places = sides.iter().flat_map(ends).map(|place| place[axis]);
            let (low, high) = places.fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x), high.max(x)));
            high - low
        };
        let axis = usize::from(extent(1) > extent(0));
        let own = |side: &Side| {
            let [from, to] = ends(side).map(|place| place[axis]);
            (*side, from, to)
        };
        // Shoulders of a stepped body stand across the way, and are passed in no time.
        let is_along = |(_, from, to): &(Side, f64, f64)| (to - from).abs() > ACROSS * extent(axis);
        let sides = sides.iter().map(own).filter(is_along).collect();
        Ok(Self { sides, thickness, flux, width, start, speed })
    }

    /// Adds the heat (W) at `time` of a step to `add(node, W)`, integrated exactly over the part of each side under the
    /// strip.
    pub fn heat(&self, mesh: &Mesh, (time, step): (f64, [f64; 2]), mut add: impl FnMut(usize, f64)) {
        let flux = self.flux.within(time, step);
        if flux == 0.0 {
            return;
        }
        let middle = self.start + self.speed * time;
        for &(side, from, to) in &self.sides {
            // s at the ends of the strip; the side may run either way
            let at = |place: f64| (2.0 * (place - from) / (to - from) - 1.0).clamp(-1.0, 1.0);
            let [a, b] = [at(middle - 0.5 * self.width), at(middle + 0.5 * self.width)];
            if a == b {
                continue;
            }
            let shares = mesh.curve(side).shape_integrals(self.thickness, [a.min(b), a.max(b)]);
            let factor = flux * self.thickness.scale();
            for (&node, share) in mesh.side_nodes(side).as_slice().iter().zip(shares) {
                add(node as usize, factor * share);
            }
        }
    }
}
