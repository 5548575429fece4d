//! The solution put back into a stiffness that another library assembles.

use fem::element::BeamPiece;
use fem::solve::frame::Frame;
use sprs::{CsMat, TriMat};

/// K of a shaft with a spring at either end, by `sprs`.
fn stiffness(pieces: &[BeamPiece], springs: [f64; 2]) -> CsMat<f64> {
    let size = 2 * (pieces.len() + 1);
    let mut triplets = TriMat::new((size, size));
    for (i, piece) in pieces.iter().enumerate() {
        let k = piece.stiffness();
        for row in 0..4 {
            for column in 0..4 {
                triplets.add_triplet(2 * i + row, 2 * i + column, k[(row, column)]);
            }
        }
    }
    triplets.add_triplet(0, 0, springs[0]);
    triplets.add_triplet(size - 2, size - 2, springs[1]);
    triplets.to_csr()
}

#[test]
fn the_solution_balances_the_load_in_another_assembly() {
    let piece = |i: usize| BeamPiece {
        length: 0.02 + 0.01 * (i % 3) as f64,
        flexural_rigidity: 2e4 * (1.0 + (i % 4) as f64),
        shear_rigidity: 8e7,
    };
    let pieces: Vec<BeamPiece> = (0..20).map(piece).collect();
    let springs = [6e7, 4e7];
    let frame = Frame::new(&pieces).unwrap().translational_spring(0, springs[0]).unwrap();
    let solution = frame.translational_spring(20, springs[1]).unwrap().solve(&[(7, 500.0)]).unwrap();
    let motion: Vec<f64> = solution.displacement.iter().zip(&solution.rotation).flat_map(|(w, t)| [*w, *t]).collect();
    let mut forces = vec![0.0; motion.len()];
    sprs::prod::mul_acc_mat_vec_csr(stiffness(&pieces, springs).view(), &motion, &mut forces);
    // Rounding of the displacements times the largest stiffness: 12·8e4/0.02³ N/m · 5e-5 m · 2e-16.
    let rounding = 1.2e11 * 5e-5 * 2.2e-16 * 4.0;
    for (i, force) in forces.iter().enumerate() {
        let load = if i == 14 { 500.0 } else { 0.0 };
        assert!((force - load).abs() <= rounding, "{i}: {force} for {load}");
    }
}
