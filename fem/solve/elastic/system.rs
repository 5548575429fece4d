//! Assemble and factor once, solve any number of loads.

use std::ops::Deref;
use std::sync::Arc;

use super::{ElasticError, Loads, Prescribed, supports};
use crate::element::plane::Elasticity;
use crate::mesh::Mesh;
use crate::solve::sparse::{Accuracy, Analysis, Freedoms, Graph, Matrix, Order, Pattern, Solver, SparseError};

/// Largest resultant or constraint force of a free body, relative to the sum of the forces.
const BALANCED: f64 = 1e-9;
/// Standard deviations of what round-off adds up to: chance exceeds so many once in 16 000 solutions.
const DEVIATIONS: f64 = 4.0;

/// An elastic body, factored. Its mesh is borrowed (`&Mesh`) or shared (`Arc<Mesh>`).
#[derive(Clone, Debug)]
pub struct ElasticSystem<M> {
    mesh: M,
    law: Elasticity,
    freedoms: Freedoms,
    matrix: Matrix,
    solver: Solver,
    prescribed: Vec<Prescribed>,
    /// The prescribed freedoms that only take the rigid motion of a free body away.
    carriers: Vec<usize>,
    free: bool,
}

/// A solved load case.
#[derive(Clone, Debug, PartialEq)]
pub struct Displacements {
    /// Displacement of every node, m. (nodes, 2)
    pub nodes: Vec<[f64; 2]>,
    /// Force (N) of the support on the body at every prescribed freedom, in the order of the freedoms.
    pub reactions: Vec<(usize, f64)>,
    /// Accuracy with which the equations are satisfied.
    pub accuracy: Accuracy,
}

impl<M: Deref<Target = Mesh>> ElasticSystem<M> {
    /// A body held by prescribed displacements.
    ///
    /// # Errors
    /// A wrong or missing support; a stiffness that cannot be factored.
    pub fn held(mesh: M, law: Elasticity, prescribed: &[Prescribed]) -> Result<Self, ElasticError> {
        supports::check(&mesh, law.thickness(), prescribed)?;
        Self::new(mesh, law, prescribed.to_vec(), false)
    }

    /// A free body: three freedoms are fixed to take its rigid motion away, of a body of revolution one. They must carry
    /// no force, and every solution is checked for that.
    ///
    /// # Errors
    /// A mesh of several pieces; a stiffness that cannot be factored.
    pub fn free(mesh: M, law: Elasticity) -> Result<Self, ElasticError> {
        mesh.connected()?;
        let prescribed = if law.thickness().is_revolved() {
            vec![Prescribed { node: 0, axis: 0, displacement: 0.0 }]
        } else {
            Self::without_rigid_motion(&mesh)
        };
        Self::new(mesh, law, prescribed, true)
    }

    /// Three freedoms of a plane body at two nodes far apart.
    fn without_rigid_motion(mesh: &Mesh) -> Vec<Prescribed> {
        let nodes = mesh.nodes();
        let distance = |a: usize, b: usize| (nodes[a][0] - nodes[b][0]).hypot(nodes[a][1] - nodes[b][1]);
        let farthest = |from: usize| {
            (0..nodes.len()).max_by(|&a, &b| distance(from, a).total_cmp(&distance(from, b))).unwrap_or(0)
        };
        let start = farthest(0);
        let end = farthest(start);
        // held across the line from start to end, so that the body cannot turn about start
        let steep = (nodes[end][1] - nodes[start][1]).abs() > (nodes[end][0] - nodes[start][0]).abs();
        let fixed = |node, axis| Prescribed { node, axis, displacement: 0.0 };
        vec![fixed(start, 0), fixed(start, 1), fixed(end, usize::from(!steep))]
    }

    fn new(mesh: M, law: Elasticity, mut prescribed: Vec<Prescribed>, free: bool) -> Result<Self, ElasticError> {
        let carriers = if free { prescribed.iter().map(Prescribed::freedom).collect() } else { Vec::new() };
        if law.thickness().is_revolved() {
            supports::hold_axis(&mesh, &mut prescribed);
        }
        prescribed.sort_by_key(Prescribed::freedom);
        let held: Vec<usize> = prescribed.iter().map(Prescribed::freedom).collect();
        let graph = Graph::new(&mesh);
        let order = Order::default().find(&graph, mesh.nodes())?;
        let freedoms = Freedoms::new(2, &order, &held);
        let pattern = Arc::new(Pattern::new(&graph, &freedoms));
        drop(graph);
        let matrix = Matrix::assemble::<2>(&mesh, &pattern, &freedoms, |_, sampled, coordinates, square| {
            law.stiffness(sampled, coordinates, square);
        })?;
        let solver = Solver::new(&Analysis::of(&matrix)?, &matrix, &freedoms, mesh.nodes())?;
        Ok(Self { mesh, law, freedoms, matrix, solver, prescribed, carriers, free })
    }

    /// The mesh.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// The elastic law.
    pub fn law(&self) -> &Elasticity {
        &self.law
    }

    /// Bytes held by the matrix and by its factor.
    pub fn bytes(&self) -> [usize; 2] {
        [self.matrix.bytes() + self.matrix.pattern().bytes(), self.solver.factor().bytes()]
    }

    /// Displacements under `loads`.
    ///
    /// # Errors
    /// A load that is not finite; loads of a free body that are not in equilibrium; a solution without
    /// accuracy.
    pub fn solve(&self, loads: &Loads) -> Result<Displacements, ElasticError> {
        if let Some(freedom) = loads.forces().iter().position(|force| !force.is_finite()) {
            return Err(SparseError::Load { node: freedom / 2, value: loads.forces()[freedom] }.into());
        }
        let size = self.balance(loads)?;
        let b = self.freedoms.gather(loads.forces());
        let mut x = vec![0.0; b.len()];
        for support in &self.prescribed {
            x[self.freedoms.number(support.freedom())] = support.displacement;
        }
        let accuracy = self.solver.solve(&self.matrix, &b, &mut x)?;
        let mut held = b;
        self.matrix.multiply_add(-1.0, &x, &mut held);
        let reactions: Vec<(usize, f64)> =
            self.freedoms.held().map(|freedom| (freedom, -held[self.freedoms.number(freedom)])).collect();
        let allowed = BALANCED * size + self.round_off(&x, accuracy);
        let is_wrong = |(freedom, force): &&(usize, f64)| {
            self.carriers.contains(freedom) && (force.is_nan() || force.abs() > allowed)
        };
        if let Some(&(freedom, force)) = reactions.iter().find(is_wrong) {
            return Err(ElasticError::Carries { node: freedom / 2, force });
        }
        let values = self.freedoms.scatter(&x);
        let nodes = values.chunks_exact(2).map(|own| [own[0], own[1]]).collect();
        Ok(Displacements { nodes, reactions, accuracy })
    }

    /// Force (N) that the round-off of a solution leaves on the constraints of a free body. They carry what all rows of the
    /// equations together are off by along a rigid motion, a random walk (Higham and Mary, A new approach to probabilistic
    /// rounding error analysis, SIAM J. Sci. Comput. 41, 2019): a step for every entry of the matrix, rounded where it was
    /// assembled and multiplied, and one for the residual of every row. No step is longer than that of the largest entry and
    /// displacement, which in a slender body are many times the load.
    fn round_off(&self, x: &[f64], accuracy: Accuracy) -> f64 {
        let moved = x.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let entries = 0.5 * f64::EPSILON * (self.matrix.pattern().entries() as f64).sqrt();
        let rows = accuracy.residual * (x.len() as f64).sqrt();
        DEVIATIONS * entries.hypot(rows) * self.matrix.largest() * moved
    }

    /// Sum of the sizes of the forces (N); refuses loads on a free body that are not in equilibrium.
    fn balance(&self, loads: &Loads) -> Result<f64, ElasticError> {
        let nodes = self.mesh.nodes();
        let centre = [0, 1].map(|axis| nodes.iter().map(|node| node[axis]).sum::<f64>() / nodes.len() as f64);
        let reach =
            nodes.iter().fold(0.0_f64, |reach, node| reach.max((node[0] - centre[0]).hypot(node[1] - centre[1])));
        let (mut force, mut moment, size) = loads.resultant(&self.mesh, centre);
        if self.law.thickness().is_revolved() {
            // What presses all around is in equilibrium with itself.
            (force[1], moment) = (0.0, 0.0);
        }
        let largest = force[0].abs().max(force[1].abs()).max(moment.abs() / reach);
        if self.free && largest > BALANCED * size {
            return Err(ElasticError::Unbalanced { force, moment });
        }
        Ok(size)
    }
}
