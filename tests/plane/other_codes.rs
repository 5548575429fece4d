//! The section that scikit-fem, NGSolve and CalculiX agree on: 0.10 × 0.05 m, k 45, ρ 7850, c 470, 50 kW/m²
//! on x = 0, h = 100 W/m²K to 20 °C elsewhere, 200 steps of 1 s, quad4, 200 × 100 cells.

use fem::element::plane::{Capacity, Conduction, Quad4, Thickness};
use fem::mesh::RectangleMesh;
use fem::solve::conduction::{Condition, History, Power, Run, Scheme, ThermalSystem};

#[test]
fn temperatures_are_those_of_other_codes() {
    let mesh = RectangleMesh::uniform([0.10, 0.05], [200, 100], &Quad4).build().unwrap();
    let mut conditions = vec![Condition::Flux { sides: "left".to_owned(), flux: Power::switched(5e4, &[]) }];
    for side in ["bottom", "right", "top"] {
        let ambient = History::Constant(20.0);
        conditions.push(Condition::Convection { sides: side.to_owned(), coefficient: 100.0, ambient });
    }
    let law = Conduction { conductivity: 45.0, heat_capacity: 7850.0 * 470.0, thickness: Thickness::Uniform(1.0) };
    let system = ThermalSystem::new(&mesh, law, Capacity::Consistent, &conditions).unwrap();
    let places = [[0.0, 0.025], [0.05, 0.025], [0.10, 0.025], [0.0, 0.0]].map(|place| mesh.nearest_node(place));
    for (scheme, expected) in [
        (Scheme::BackwardEuler, [78.341_392, 39.993_426, 28.686_355, 76.960_134, 44.265_258]),
        (Scheme::CrankNicolson, [78.360_466, 40.006_953, 28.675_852, 76.978_144, 44.278_921]),
    ] {
        let mut last = Vec::new();
        let run = Run { scheme, step: 1.0, end: 200.0 };
        system.run(&vec![20.0; mesh.nodes().len()], &run, |now| last = now.temperatures()).unwrap();
        let found = [last[places[0]], last[places[1]], last[places[2]], last[places[3]], system.mean(&last)];
        for (found, expected) in found.iter().zip(expected) {
            // printed to 1e-6
            assert!((found - expected).abs() < 1e-6, "{scheme:?}: {found} {expected}");
        }
    }
}
