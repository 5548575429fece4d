//! Where the temperatures come to rest under what holds.

use super::surface::Surface;
use super::system::{MAX_ITERATIONS, is_at_rest};
use super::{ThermalError, ThermalSystem};
use crate::solve::sparse::Solver;

impl ThermalSystem<'_> {
    /// Temperatures of all nodes in the steady state under what holds at `time` (s).
    ///
    /// # Errors
    /// [`ThermalError::Insulated`] where nothing holds the temperature.
    pub fn steady(&self, time: f64) -> Result<Vec<f64>, ThermalError> {
        self.check_held()?;
        let mut heat = vec![0.0; self.freedoms.len()];
        self.supply(time, [time; 2], &mut heat);
        self.add_ambient(time, [time; 2], &mut heat);
        let mut enthalpies = vec![0.0; self.freedoms.len()];
        self.set_held(time, &mut enthalpies);
        for _ in 0..MAX_ITERATIONS {
            let mut missing = heat.clone();
            let (_, slopes) = self.lose((time, [time; 2]), &enthalpies, &mut missing);
            self.conductance.multiply_add(-1.0, &enthalpies, &mut missing);
            let matrix = self.tangent(&slopes);
            let solver = Solver::new(&self.analysis, &matrix, &self.freedoms, self.mesh.nodes())?;
            let mut change = vec![0.0; enthalpies.len()];
            solver.solve(&matrix, &missing, &mut change)?;
            slopes.to_enthalpies(&mut change);
            enthalpies.iter_mut().zip(&change).for_each(|(own, change)| *own += change);
            let moved = change.iter().map(|own| own.abs()).fold(0.0, f64::max);
            if self.is_linear() || is_at_rest(moved) {
                self.check_known(time, &enthalpies)?;
                return Ok(self.scattered(&enthalpies));
            }
        }
        Err(ThermalError::NoBalance { time })
    }

    /// Every piece of the mesh must lose heat somewhere, or have a prescribed temperature.
    fn check_held(&self) -> Result<(), ThermalError> {
        let pieces = self.mesh.pieces();
        let mut is_held = vec![false; pieces.len()];
        for (node, &piece) in pieces.iter().enumerate() {
            is_held[piece as usize] |= self.freedoms.is_held(node) || self.losses[self.freedoms.number(node)] > 0.0;
        }
        for node in self.surfaces.iter().flat_map(Surface::holds) {
            is_held[pieces[node] as usize] = true;
        }
        match self.mesh.elements().find(|element| !is_held[pieces[element.nodes[0] as usize] as usize]) {
            Some(element) => Err(ThermalError::Insulated { element: element.index }),
            None => Ok(()),
        }
    }
}
