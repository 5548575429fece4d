//! What a body whose properties change with its temperature conducts and loses beside what it would in proportion to its
//! enthalpy.

use super::{Properties, ThermalError};
use crate::solve::sparse::Matrix;

/// How far beyond the table of a property a temperature may be by the rounding of units, K.
const SLACK: f64 = 1e-6;

/// Properties that change with the temperature.
pub(super) struct Varying {
    properties: Properties,
    /// Conduction alone, with the properties of the start, W/K.
    conduction: Matrix,
}

/// What a kelvin of each node's Kirchhoff temperature changes.
#[derive(Debug)]
pub(super) struct Slopes {
    /// Loss by surfaces, W/K.
    pub surfaces: Vec<f64>,
    /// Where properties change.
    pub varying: Option<Relative>,
}

/// What a kelvin of each node's Kirchhoff temperature makes of the others.
#[derive(Debug)]
pub(super) struct Relative {
    /// Of its temperature.
    pub warm: Vec<f64>,
    /// Of its enthalpy.
    pub enthalpies: Vec<f64>,
}

impl Slopes {
    /// Changes of Kirchhoff temperatures as changes of enthalpies.
    pub fn to_enthalpies(&self, changes: &mut [f64]) {
        if let Some(Relative { enthalpies, .. }) = &self.varying {
            changes.iter_mut().zip(enthalpies).for_each(|(change, slope)| *change *= slope);
        }
    }
}

impl Varying {
    /// # Errors
    /// A property that is zero or below somewhere.
    pub fn new(properties: Properties, conduction: Matrix) -> Result<Self, ThermalError> {
        properties.check()?;
        Ok(Self { properties, conduction })
    }

    /// Temperature of what has an enthalpy, K of the capacity at the start.
    pub fn temperature(&self, enthalpy: f64) -> f64 {
        self.properties.heat_capacity.inverse(enthalpy).0
    }

    /// Enthalpy (K) of what has a temperature.
    pub fn enthalpy(&self, temperature: f64) -> f64 {
        self.properties.heat_capacity.at(temperature).0
    }

    /// # Errors
    /// The body is warmer or colder at `time` than its properties are known.
    pub fn check(&self, time: f64, enthalpies: &[f64]) -> Result<(), ThermalError> {
        let known = self.properties.known;
        let reached = enthalpies
            .iter()
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], own| [f64::min(low, *own), f64::max(high, *own)]);
        let reached = reached.map(|own| self.temperature(own));
        match reached[0] >= known[0] - SLACK && reached[1] <= known[1] + SLACK {
            true => Ok(()),
            false => Err(ThermalError::Unknown { time, reached, known }),
        }
    }

    /// Takes off the heat (W) what nodes with these enthalpies conduct and lose beside what they would in proportion to them,
    /// of which `conductance` has the conduction and all films. Their temperatures, and what a kelvin makes of them.
    pub fn lose(&self, enthalpies: &[f64], conductance: &Matrix, heat: &mut [f64]) -> (Vec<f64>, Relative) {
        let (mut warm, mut by_film, mut conducted) = (Vec::new(), Vec::new(), Vec::new());
        let mut relative = Relative { warm: Vec::new(), enthalpies: Vec::new() };
        for enthalpy in enthalpies {
            let (own, of_enthalpy) = self.properties.heat_capacity.inverse(*enthalpy);
            let (transformed, steep) = self.properties.conductivity.at(own);
            warm.push(own);
            by_film.push(own - enthalpy);
            conducted.push(transformed - own);
            relative.warm.push(steep.recip());
            relative.enthalpies.push((steep * of_enthalpy).recip());
        }
        conductance.multiply_add(-1.0, &by_film, heat);
        self.conduction.multiply_add(-1.0, &conducted, heat);
        (warm, relative)
    }

    /// What a kelvin of Kirchhoff's temperature conducts and loses by the films of `conductance`, W/K.
    pub fn tangent(&self, relative: &Relative, conductance: &Matrix) -> Matrix {
        let films = conductance.combined(1.0, &self.conduction, -1.0);
        self.conduction.combined(1.0, &films.averaged(&relative.warm), 1.0)
    }
}
