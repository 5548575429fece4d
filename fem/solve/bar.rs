//! A straight bar that is held at points and pulled along itself at another: a ball screw between its
//! bearings and its nut.

use crate::element::BarPiece;

/// Nodes nearer to each other than this (m) count as one.
const SAME: f64 = 1e-12;

/// A uniform bar on the x axis, held rigidly at points.
#[derive(Clone, Debug, PartialEq)]
pub struct Bar {
    /// Axial rigidity EA, N.
    pub axial_rigidity: f64,
    /// Places where it is held, m; at least one.
    pub held: Vec<f64>,
}

impl Bar {
    /// Displacement per force (m/N) of a force that acts at x (m) along the bar. Between the force and the
    /// next hold on either side lies one bar element, which is exact; the two elements act side by side, and
    /// what lies beyond the holds carries nothing.
    pub fn compliance(&self, x: f64) -> f64 {
        let nearest = |side: fn(f64, f64) -> bool| {
            let distances = self.held.iter().filter(|at| side(**at, x)).map(|at| (at - x).abs());
            distances.fold(f64::INFINITY, f64::min)
        };
        let stiffness = |length| BarPiece { length, axial_rigidity: self.axial_rigidity }.axial_stiffness();
        let (below, above) = (nearest(|at, x| at <= x), nearest(|at, x| at > x));
        1.0 / (stiffness(below) + stiffness(above))
    }

    /// Displacements (m) of `nodes` (rising, m) under a force (N) at one of them: the chain of elements
    /// between the nodes, those that are held fixed, solved by elimination along the chain. Every hold must
    /// be among the nodes.
    pub fn displacements(&self, nodes: &[f64], loaded: usize, force: f64) -> Vec<f64> {
        let count = nodes.len();
        let is_held = |i: usize| self.held.iter().any(|at| (at - nodes[i]).abs() <= SAME);
        // K u = f: the diagonal, and the coupling of node i with i + 1.
        let (mut diagonal, mut coupling, mut u) = (vec![0.0; count], vec![0.0; count], vec![0.0; count]);
        for i in 1..count {
            let piece = BarPiece { length: nodes[i] - nodes[i - 1], axial_rigidity: self.axial_rigidity };
            let k = piece.stiffness();
            diagonal[i - 1] += k[(0, 0)];
            diagonal[i] += k[(1, 1)];
            coupling[i - 1] = k[(0, 1)];
        }
        u[loaded] = force;
        for i in (0..count).filter(|i| is_held(*i)) {
            (diagonal[i], u[i], coupling[i]) = (1.0, 0.0, 0.0);
            if i > 0 {
                coupling[i - 1] = 0.0;
            }
        }
        for i in 1..count {
            let factor = coupling[i - 1] / diagonal[i - 1];
            diagonal[i] -= factor * coupling[i - 1];
            u[i] -= factor * u[i - 1];
        }
        for i in (0..count).rev() {
            let next = if i + 1 < count { coupling[i] * u[i + 1] } else { 0.0 };
            u[i] = (u[i] - next) / diagonal[i];
        }
        u
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_force_stretches_what_lies_between_it_and_the_hold() {
        let bar = Bar { axial_rigidity: 2e8, held: vec![0.1] };
        assert!((bar.compliance(0.5) - 0.4 / 2e8).abs() < 1e-22);
        assert!((bar.compliance(-0.2) - 0.3 / 2e8).abs() < 1e-22);
        assert_eq!(bar.compliance(0.1), 0.0);
    }

    #[test]
    fn between_two_holds_both_sides_carry() {
        let bar = Bar { axial_rigidity: 2e8, held: vec![0.0, 1.0] };
        assert!((bar.compliance(0.25) - 0.25 * 0.75 / 2e8).abs() < 1e-22);
        assert!((bar.compliance(1.5) - 0.5 / 2e8).abs() < 1e-22);
    }

    #[test]
    fn the_chain_of_elements_gives_the_same() {
        for held in [vec![0.0], vec![0.6], vec![0.0, 0.9]] {
            let bar = Bar { axial_rigidity: 1.5e8, held };
            let nodes: Vec<f64> = (0..=30).map(|i| 0.03 * f64::from(i)).collect();
            for loaded in 0..nodes.len() {
                let u = bar.displacements(&nodes, loaded, 700.0);
                let expected = 700.0 * bar.compliance(nodes[loaded]);
                assert!((u[loaded] - expected).abs() < 1e-12 * 700.0 / 1.5e8, "{} {expected}", u[loaded]);
            }
        }
    }
}
