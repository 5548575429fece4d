//! Plane bodies, on which rings and heated sections stand: Betti's reciprocity, Clapeyron's balance of work, and the
//! balance of forces and moments with the supports.

use fem::element::plane::{Elasticity, PlaneElement, PlaneState, Quad4, Quad8, Tri6};
use fem::mesh::{Grading, Mesh, RectangleMesh};
use fem::solve::elastic::{Displacements, ElasticSystem, Loads, Prescribed};
use proptest::prelude::*;

use super::alike;

/// A rectangle with forces at some of its nodes, twice.
#[derive(Clone, Debug)]
struct Trial {
    size: [f64; 2],
    cells: [usize; 2],
    element: usize,
    poisson: f64,
    loads: [Vec<(usize, [f64; 2])>; 2],
}

fn trial() -> impl Strategy<Value = Trial> {
    let force = (0usize..10_000, [-500.0..500.0, -500.0..500.0]);
    let loads = || prop::collection::vec(force.clone(), 1..6);
    ([0.05..0.4, 0.02..0.2], [2usize..7, 2usize..6], 0usize..3, 0.0..0.45, [loads(), loads()])
        .prop_map(|(size, cells, element, poisson, loads)| Trial { size, cells, element, poisson, loads })
}

impl Trial {
    fn mesh(&self) -> Mesh {
        let element: &'static dyn PlaneElement = [&Quad4 as &'static dyn PlaneElement, &Quad8, &Tri6][self.element];
        let uniform = Grading::uniform;
        let ([length, height], [columns, rows]) = (self.size, self.cells);
        RectangleMesh { length, height, columns, rows, element, along: uniform(), across: uniform() }.build().unwrap()
    }

    fn law(&self) -> Elasticity {
        Elasticity::new(PlaneState::Stress, 210e9, self.poisson, 0.0, 0.02).unwrap()
    }

    fn loads(&self, mesh: &Mesh, number: usize) -> Loads {
        let mut loads = Loads::none(mesh);
        self.loads[number].iter().for_each(|(node, force)| loads.add_force(node % mesh.nodes().len(), *force));
        loads
    }
}

/// Work of forces along displacements, J.
fn work(loads: &Loads, moved: &Displacements) -> f64 {
    loads.forces().iter().zip(moved.nodes.iter().flatten()).map(|(force, way)| force * way).sum()
}

proptest! {
    #![proptest_config(super::random(160))]

    #[test]
    fn works_are_mutual_and_supports_balance_the_loads(trial in trial()) {
        let mesh = trial.mesh();
        let held: Vec<Prescribed> = [0, 1].iter().flat_map(|axis| Prescribed::fixed_side(&mesh, "left", *axis).unwrap()).collect();
        let system = ElasticSystem::held(&mesh, trial.law(), &held).unwrap();
        let loads = [0, 1].map(|number| trial.loads(&mesh, number));
        let moved = [0, 1].map(|number| system.solve(&loads[number]).unwrap());
        // Betti; the larger of the own works is what round-off is relative to.
        let own = [0, 1].map(|number| work(&loads[number], &moved[number]));
        let scale = own[0].max(own[1]);
        prop_assert!((work(&loads[0], &moved[1]) - work(&loads[1], &moved[0])).abs() <= 1e-9 * scale);
        prop_assert!(own.iter().all(|work| *work >= 0.0), "a load that gains work: {own:?}");
        for (loads, moved) in loads.iter().zip(&moved) {
            // Loads and reactions, forces and the moment about the origin.
            let mut all = loads.forces().to_vec();
            moved.reactions.iter().for_each(|(freedom, force)| all[*freedom] += force);
            let moment = |forces: &[f64]| -> f64 {
                mesh.nodes().iter().zip(forces.chunks(2)).map(|(at, f)| at[0] * f[1] - at[1] * f[0]).sum()
            };
            let along = |axis: usize| all.iter().skip(axis).step_by(2).sum::<f64>();
            let size: f64 = loads.forces().iter().map(|force| force.abs()).sum();
            prop_assert!(along(0).abs().max(along(1).abs()) <= 1e-9 * size, "forces {} and {}", along(0), along(1));
            prop_assert!(moment(&all).abs() <= 1e-9 * size * trial.size[0], "moment {}", moment(&all));
        }
        // Superposition.
        let mut both = trial.loads(&mesh, 0);
        trial.loads[1].iter().for_each(|(node, force)| both.add_force(node % mesh.nodes().len(), *force));
        let flat = |moved: &Displacements| moved.nodes.iter().flatten().copied().collect::<Vec<f64>>();
        alike(&super::sum(&flat(&moved[0]), &flat(&moved[1])), &flat(&system.solve(&both).unwrap()), 1e-9)?;
    }
}
