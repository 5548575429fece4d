//! Forces on nodes equivalent to pressure, traction and temperature.

use super::ElasticError;
use crate::element::plane::{Elasticity, MAX_NODES, Sampled, WHOLE};
use crate::mesh::Mesh;

/// Forces (N) on all freedoms.
#[derive(Clone, Debug, PartialEq)]
pub struct Loads {
    forces: Vec<f64>,
}

impl Loads {
    /// No load on the nodes of `mesh`.
    pub fn none(mesh: &Mesh) -> Self {
        Self { forces: vec![0.0; 2 * mesh.nodes().len()] }
    }

    /// Forces over the freedoms 2 · node + axis, N.
    pub fn forces(&self) -> &[f64] {
        &self.forces
    }

    /// A force (N) on a node; of a body of revolution that on all of its circle.
    pub fn add_force(&mut self, node: usize, force: [f64; 2]) {
        self.forces[2 * node] += force[0];
        self.forces[2 * node + 1] += force[1];
    }

    /// A pressure (Pa, pressing on the body) on the sides called `name`: fₐ = −∫ p Nₐ n t dl, 2πy in the place of t of a
    /// body of revolution.
    ///
    /// # Errors
    /// The mesh has no such sides.
    pub fn add_pressure(
        &mut self,
        mesh: &Mesh,
        law: &Elasticity,
        name: &str,
        pressure: f64,
    ) -> Result<(), ElasticError> {
        for &side in mesh.sides(name)? {
            let forces = mesh.curve(side).pressure_forces(law.thickness());
            for (&node, [x, y]) in mesh.side_nodes(side).as_slice().iter().zip(forces) {
                let factor = pressure * law.thickness().scale();
                self.add_force(node as usize, [factor * x, factor * y]);
            }
        }
        Ok(())
    }

    /// A traction (Pa) on the sides called `name`: fₐ = ∫ τ Nₐ t dl.
    ///
    /// # Errors
    /// The mesh has no such sides.
    pub fn add_traction(
        &mut self,
        mesh: &Mesh,
        law: &Elasticity,
        name: &str,
        [x, y]: [f64; 2],
    ) -> Result<(), ElasticError> {
        for &side in mesh.sides(name)? {
            let shares = mesh.curve(side).shape_integrals(law.thickness(), WHOLE);
            for (&node, share) in mesh.side_nodes(side).as_slice().iter().zip(shares) {
                let factor = share * law.thickness().scale();
                self.add_force(node as usize, [factor * x, factor * y]);
            }
        }
        Ok(())
    }

    /// The forces equivalent to a rise of temperature (K, at every node).
    pub fn add_temperature(&mut self, mesh: &Mesh, law: &Elasticity, rises: &[f64]) {
        let sampled: Vec<Sampled> = mesh.blocks().iter().map(|block| Sampled::new(block.element())).collect();
        for element in mesh.elements() {
            let mut own = [0.0; MAX_NODES];
            for (own, &node) in own.iter_mut().zip(element.nodes) {
                *own = rises[node as usize];
            }
            let coordinates = mesh.coordinates(element);
            let forces = law.thermal_forces(&sampled[element.block], &coordinates[..element.nodes.len()], &own);
            for (&node, force) in element.nodes.iter().zip(forces) {
                self.add_force(node as usize, force);
            }
        }
    }

    /// Work (N m/K) that these loads do on the thermal expansion of a free body, for a rise of 1 K at each
    /// node; `displacements` (m) are those under the loads. By reciprocity that is the loads' work on the
    /// displacement by the rise, so that a load of one, in equilibrium with itself, weighs the rises of all
    /// nodes to a displacement.
    pub fn thermal_work(mesh: &Mesh, law: &Elasticity, displacements: &[[f64; 2]]) -> Vec<f64> {
        let sampled: Vec<Sampled> = mesh.blocks().iter().map(|block| Sampled::new(block.element())).collect();
        let mut work = vec![0.0; mesh.nodes().len()];
        for element in mesh.elements() {
            let mut motion = [[0.0; 2]; MAX_NODES];
            for (own, &node) in motion.iter_mut().zip(element.nodes) {
                *own = displacements[node as usize];
            }
            let coordinates = mesh.coordinates(element);
            let own = law.thermal_work(&sampled[element.block], &coordinates[..element.nodes.len()], &motion);
            for (&node, own) in element.nodes.iter().zip(own) {
                work[node as usize] += own;
            }
        }
        work
    }

    /// Sum of the forces (N), sum of the moments about `centre` (N m), and sum of the sizes of the forces
    /// (N).
    pub fn resultant(&self, mesh: &Mesh, centre: [f64; 2]) -> ([f64; 2], f64, f64) {
        let (mut force, mut moment, mut size) = ([0.0; 2], 0.0, 0.0);
        for (node, own) in mesh.nodes().iter().zip(self.forces.chunks_exact(2)) {
            force = [force[0] + own[0], force[1] + own[1]];
            moment += (node[0] - centre[0]) * own[1] - (node[1] - centre[1]) * own[0];
            size += own[0].hypot(own[1]);
        }
        (force, moment, size)
    }
}
