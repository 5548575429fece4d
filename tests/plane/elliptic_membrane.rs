//! NAFEMS LE1, elliptic membrane in plane stress (*The Standard NAFEMS Benchmarks*, 1990): σyy at D is 92.7
//! MPa.
//!
//! ```text
//!  B +-._   outer (x/3.25)² + (y/2.75)² = 1, 10 MPa outwards      E 210 GPa, ν 0.3, t 0.1 m
//!    |    `-.
//!  A +-.     `.   inner (x/2)² + y² = 1                             AB: u_x = 0, CD: u_y = 0
//!       `-.    \
//!        D +---+ C
//! ```

use fem::element::plane::{ALL, Elasticity, PlaneElement, PlaneState};
use fem::mesh::Lattice;
use fem::solve::elastic::{ElasticSystem, Loads, Prescribed, nodal_stresses};

/// σyy at D, MPa.
const EXPECTED: f64 = 92.7;

/// σyy at D on `columns` × `rows` cells, and the sum of the reactions over the loads (0 in equilibrium).
fn stress_at_d(element: &'static dyn PlaneElement, columns: usize, rows: usize) -> (f64, f64) {
    let lattice = Lattice { columns, rows, closed: false, element };
    let mesh = lattice
        .mesh(["outside", "left", "inside", "bottom"], |i, j| {
            let angle = std::f64::consts::FRAC_PI_2 * i as f64 / (2 * columns) as f64;
            let depth = j as f64 / (2 * rows) as f64;
            let (wide, high) = (3.25 + (2.0 - 3.25) * depth, 2.75 + (1.0 - 2.75) * depth);
            [wide * angle.cos(), high * angle.sin()]
        })
        .unwrap();
    let law = Elasticity::new(PlaneState::Stress, 210e9, 0.3, 0.0, 0.1).unwrap();
    let mut held = Prescribed::fixed_side(&mesh, "left", 0).unwrap();
    held.extend(Prescribed::fixed_side(&mesh, "bottom", 1).unwrap());
    let mut loads = Loads::none(&mesh);
    loads.add_pressure(&mesh, &law, "outside", -10e6).unwrap();
    let solution = ElasticSystem::held(&mesh, law, &held).unwrap().solve(&loads).unwrap();
    let stresses = nodal_stresses(&mesh, &law, &solution.nodes, &[]);
    let (force, _, size) = loads.resultant(&mesh, [0.0, 0.0]);
    let carried: f64 =
        solution.reactions.iter().filter(|(freedom, _)| freedom % 2 == 0).map(|reaction| reaction.1).sum();
    (stresses[mesh.nearest_node([2.0, 0.0])][1] * 1e-6, (carried + force[0]).abs() / size)
}

#[test]
fn stress_at_the_inner_edge() {
    for (element, columns, rows, tolerance) in
        [(0, 192, 96, 0.03), (1, 96, 48, 0.003), (2, 192, 96, 0.015), (3, 48, 24, 0.003), (4, 48, 24, 0.003)]
    {
        let (stress, unbalanced) = stress_at_d(ALL[element], columns, rows);
        println!("{:?} {columns} x {rows}: {stress:.4} MPa", ALL[element]);
        assert!((stress / EXPECTED - 1.0).abs() < tolerance, "{:?}: {stress}", ALL[element]);
        assert!(unbalanced < 1e-12, "{:?}: {unbalanced}", ALL[element]);
        // the twin with a wrong value must fail
        assert!((stress / (1.05 * EXPECTED) - 1.0).abs() > tolerance);
    }
}

#[test]
fn a_coarse_mesh_of_quad8_is_within_two_percent() {
    let (stress, _) = stress_at_d(ALL[3], 12, 6);
    assert!((stress / EXPECTED - 1.0).abs() < 0.02, "{stress}");
}
