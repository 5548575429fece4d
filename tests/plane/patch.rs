//! The patch test: a distorted mesh whose border follows a constant strain has that strain everywhere.

use fem::element::plane::{ALL, Elasticity, PlaneElement, PlaneState};
use fem::mesh::{Lattice, Mesh};
use fem::solve::elastic::{ElasticSystem, Loads, nodal_stresses};

use crate::held_border;

/// 3 × 4 cells whose inner nodes are shaken out of place.
fn shaken(element: &'static dyn PlaneElement) -> Mesh {
    let lattice = Lattice { columns: 3, rows: 4, closed: false, element };
    let shaken = |i: usize, j: usize| {
        let inside = i > 0 && i < 6 && j > 0 && j < 8;
        let [a, b] = [(i * 7 + j * 3) as f64, (i * 5 + j * 11) as f64].map(f64::sin);
        let corner = i.is_multiple_of(2) && j.is_multiple_of(2);
        let shake = f64::from(u8::from(inside)) * if corner { 0.045 } else { 0.012 };
        [i as f64 / 6.0 * 1.2 + shake * a, j as f64 / 8.0 + shake * b]
    };
    lattice.mesh(["bottom", "right", "top", "left"], shaken).unwrap()
}

#[test]
fn constant_strain_is_exact_on_distorted_meshes() {
    let strain = [2e-4, -1e-4, 3e-4, 0.0];
    let motion = |[x, y]: [f64; 2]| [strain[0] * x + 0.4 * strain[2] * y, strain[1] * y + 0.6 * strain[2] * x];
    for element in ALL {
        for state in [PlaneState::Stress, PlaneState::Strain] {
            let mesh = shaken(*element);
            let law = Elasticity::new(state, 210e9, 0.3, 0.0, 0.02).unwrap();
            let held = held_border(&mesh, motion);
            let solution = ElasticSystem::held(&mesh, law, &held).unwrap().solve(&Loads::none(&mesh)).unwrap();
            for (node, moved) in mesh.nodes().iter().zip(&solution.nodes) {
                let exact = motion(*node);
                assert!((moved[0] - exact[0]).abs().max((moved[1] - exact[1]).abs()) < 1e-17, "{element:?}");
            }
            let expected = law.stress(strain, 0.0);
            for stress in nodal_stresses(&mesh, &law, &solution.nodes, &[]) {
                assert!(
                    stress.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-10 * expected[0].abs()),
                    "{element:?}"
                );
            }
            // what the border carries is in equilibrium
            for axis in 0..2 {
                let sum: f64 = solution.reactions.iter().filter(|(f, _)| f % 2 == axis).map(|(_, force)| force).sum();
                assert!(sum.abs() < 1e-6, "{element:?}: {sum}");
            }
        }
    }
}
