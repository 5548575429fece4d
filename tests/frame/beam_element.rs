//! The beam element: symmetry, rigid motions, inverse of the flexibility.

use fem::element::BeamPiece;
use nalgebra::{Matrix2, Vector4};

/// Slender, stubby, shear-only, very short and very long pieces.
fn pieces() -> Vec<BeamPiece> {
    let piece = |length, flexural_rigidity, shear_rigidity| BeamPiece { length, flexural_rigidity, shear_rigidity };
    vec![
        piece(0.7, 2100.0, f64::INFINITY),
        piece(0.7, 2100.0, 3.1e5),
        piece(0.03, 64e3, 1.4e8),
        piece(0.0006, 64e3, 1.4e8),
        piece(20.0, 26.4e3, 9e7),
        piece(1.0, 1.0, 1e-6),
    ]
}

#[test]
fn stiffness_is_symmetric() {
    for piece in pieces() {
        let k = piece.stiffness();
        assert_eq!(k, k.transpose(), "{piece:?}");
    }
}

#[test]
fn rigid_motions_give_no_force() {
    for piece in pieces() {
        let k = piece.stiffness();
        for (name, motion) in
            [("translation", Vector4::new(1.0, 0.0, 1.0, 0.0)), ("rotation", Vector4::new(0.0, 1.0, piece.length, 1.0))]
        {
            let force = k * motion;
            let size = k.abs() * motion.abs();
            for row in 0..4 {
                assert!(force[row].abs() <= 4.0 * f64::EPSILON * size[row], "{name} of {piece:?}: {force}");
            }
        }
    }
}

/// A cantilever held at end 1: (w2, θ2) = [l³/3EI + l/κGA, l²/2EI; l²/2EI, l/EI] (F2, M2).
#[test]
fn stiffness_is_the_inverse_of_the_flexibility() {
    for piece in pieces() {
        let (l, ei) = (piece.length, piece.flexural_rigidity);
        let bent = l * l / (2.0 * ei);
        let flexibility = Matrix2::new(l.powi(3) / (3.0 * ei) + l / piece.shear_rigidity, bent, bent, l / ei);
        let stiffness = piece.stiffness().fixed_view::<2, 2>(2, 2).into_owned();
        let size = stiffness.abs() * flexibility.abs();
        let error = stiffness * flexibility - Matrix2::identity();
        for (error, size) in error.iter().zip(size.iter()) {
            assert!(error.abs() <= 8.0 * f64::EPSILON * size, "{piece:?}: {error:e}");
        }
    }
}

#[test]
fn divided_pieces_add_up() {
    for piece in pieces() {
        let parts: Vec<_> = piece.divided(7).collect();
        assert_eq!(parts.len(), 7);
        let length: f64 = parts.iter().map(|part| part.length).sum();
        assert!((length / piece.length - 1.0).abs() < 1e-14);
    }
}
