//! The straight uniform member of a plane structure: a bar and a beam in one, in any direction.
//!
//! ```text
//!        y ^            2
//!          |         o       forces and displacements (u, v, θ) at each end along x and y, θ counter-clockwise;
//!          |      .          w = −u sin a + v cos a across the member, u cos a + v sin a along it
//!          |   .  ) a
//!          1 o------------> x
//! ```

use nalgebra::{Matrix3, SMatrix};

use super::{BarPiece, BeamPiece};

/// Stiffness between the freedoms (u1, v1, θ1, u2, v2, θ2) of the ends.
pub type EndStiffness = SMatrix<f64, 6, 6>;

/// A uniform member between two places of the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Member {
    /// From the first end to the second, along x and y (m).
    pub span: [f64; 2],
    /// Axial rigidity EA (N).
    pub axial_rigidity: f64,
    /// Flexural rigidity EI (N m²).
    pub flexural_rigidity: f64,
    /// Shear rigidity κGA (N); `f64::INFINITY` makes it an Euler–Bernoulli beam.
    pub shear_rigidity: f64,
}

/// A place inside a member: how it follows the ends, and how it yields where these are held.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inside {
    /// (u, v, θ) there for each of (u1, v1, θ1, u2, v2, θ2) alone.
    pub follows: SMatrix<f64, 3, 6>,
    /// (u, v, θ) there for unit forces and a unit moment there, ends held; m/N, rad/N, rad/(N m).
    pub yields: Matrix3<f64>,
}

impl Member {
    /// Length (m).
    pub fn length(&self) -> f64 {
        self.span[0].hypot(self.span[1])
    }

    /// A part of its length.
    #[must_use]
    pub fn piece(&self, part: f64) -> Self {
        Self { span: self.span.map(|own| own * part), ..*self }
    }

    /// Exact stiffness K (6 × 6, symmetric), N/m, N, N m.
    pub fn stiffness(&self) -> EndStiffness {
        let (local, turn) = (self.along_and_across(), self.turn());
        let mut turned = EndStiffness::zeros();
        for (row, column) in [(0, 0), (0, 3), (3, 0), (3, 3)] {
            let block = turn.transpose() * local.fixed_view::<3, 3>(row, column) * turn;
            turned.fixed_view_mut::<3, 3>(row, column).copy_from(&block);
        }
        turned
    }

    /// The same between freedoms along and across the member.
    fn along_and_across(&self) -> EndStiffness {
        let (bar, beam) = (self.bar().stiffness(), self.beam().stiffness());
        let mut local = EndStiffness::zeros();
        // (u1, w1, θ1, u2, w2, θ2) along and across.
        let (along, across) = ([0, 3], [1, 2, 4, 5]);
        for (i, row) in along.into_iter().enumerate() {
            along.into_iter().enumerate().for_each(|(j, column)| local[(row, column)] = bar[(i, j)]);
        }
        for (i, row) in across.into_iter().enumerate() {
            across.into_iter().enumerate().for_each(|(j, column)| local[(row, column)] = beam[(i, j)]);
        }
        local
    }

    /// The place at a part of the length from the first end, exact: statics of the two pieces on either side, as long as
    /// neither is without length.
    pub fn inside(&self, part: f64) -> Inside {
        let mut follows = SMatrix::<f64, 3, 6>::zeros();
        if part <= 0.0 || part >= 1.0 {
            (0..3).for_each(|i| follows[(i, i + if part <= 0.0 { 0 } else { 3 })] = 1.0);
            return Inside { follows, yields: Matrix3::zeros() };
        }
        let [before, after] = [part, 1.0 - part].map(|part| self.piece(part).along_and_across());
        let own = before.fixed_view::<3, 3>(3, 3) + after.fixed_view::<3, 3>(0, 0);
        let turn = self.turn();
        let yields = own.try_inverse().unwrap_or_else(Matrix3::zeros);
        for (column, held) in [(0, before.fixed_view::<3, 3>(3, 0)), (3, after.fixed_view::<3, 3>(0, 3))] {
            let block = -(turn.transpose() * yields * held * turn);
            follows.fixed_view_mut::<3, 3>(0, column).copy_from(&block);
        }
        Inside { follows, yields: turn.transpose() * yields * turn }
    }

    fn bar(&self) -> BarPiece {
        BarPiece { length: self.length(), axial_rigidity: self.axial_rigidity }
    }

    fn beam(&self) -> BeamPiece {
        let Self { flexural_rigidity, shear_rigidity, .. } = *self;
        BeamPiece { length: self.length(), flexural_rigidity, shear_rigidity }
    }

    /// From the freedoms of an end along x and y to those along and across the member.
    fn turn(&self) -> Matrix3<f64> {
        let [c, s] = self.span.map(|own| own / self.length());
        Matrix3::new(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MEMBER: Member =
        Member { span: [0.3, 0.4], axial_rigidity: 2e8, flexural_rigidity: 3e4, shear_rigidity: 6e7 };

    /// Moved or turned as a whole it resists nothing, and neither do places inside stay behind.
    #[test]
    fn rigid_motions_cost_nothing() {
        let [x, y] = MEMBER.span;
        let rigid = SMatrix::<f64, 6, 3>::from_columns(&[
            [1.0, 0.0, 0.0, 1.0, 0.0, 0.0].into(),
            [0.0, 1.0, 0.0, 0.0, 1.0, 0.0].into(),
            [0.0, 0.0, 1.0, -y, x, 1.0].into(),
        ]);
        let size = MEMBER.stiffness().norm();
        assert!((MEMBER.stiffness() * rigid).norm() < 1e-14 * size);
        let moved = MEMBER.inside(0.3).follows * rigid;
        let expected = Matrix3::new(1.0, 0.0, -0.3 * y, 0.0, 1.0, 0.3 * x, 0.0, 0.0, 1.0);
        assert!((moved - expected).norm() < 1e-12, "{moved}");
    }

    /// Held at both ends, under a force across: y = P a³ b³/(3 EI l³) + P a b/(κGA l) where shear does not couple
    /// (Roark's Formulas for Stress and Strain, 7th ed., table 8.1, case 1d), here in the middle: P l³/(192 EI) + P l/(4 κGA).
    #[test]
    fn a_place_inside_yields_as_in_handbooks() {
        let l = MEMBER.length();
        let across = nalgebra::Vector3::new(-0.8, 0.6, 0.0);
        let found = across.dot(&(MEMBER.inside(0.5).yields * across));
        let expected = l.powi(3) / (192.0 * 3e4) + l / (4.0 * 6e7);
        assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
        let along = nalgebra::Vector3::new(0.6, 0.8, 0.0);
        let found = along.dot(&(MEMBER.inside(0.25).yields * along));
        assert!((found / (0.25 * 0.75 * l / 2e8) - 1.0).abs() < 1e-12);
    }
}
