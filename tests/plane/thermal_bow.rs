//! A plate heated from above: elongation and bow from the temperature field, without stress where it is
//! linear.

use fem::element::plane::{ALL, Capacity, Conduction, Elasticity, PlaneState, Thickness};
use fem::mesh::RectangleMesh;
use fem::solve::conduction::{Condition, History, ThermalSystem};
use fem::solve::elastic::{ElasticSystem, Loads, nodal_stresses};

/// T from 0 below to ΔT above: elongation α ΔT L/2 at mid-height, bow α ΔT L²/(8 h).
#[test]
fn a_gradient_bows_a_plate() {
    let (length, height, rise, expansion) = (0.4, 0.05, 12.0, 11.5e-6);
    for element in ALL {
        let mesh = RectangleMesh::uniform([length, height], [40, 4], *element).build().unwrap();
        let held = |sides: &str, temperature| Condition::Temperature {
            sides: sides.to_owned(),
            temperature: History::Constant(temperature),
        };
        let conduction = Conduction { conductivity: 50.0, heat_capacity: 3.7e6, thickness: Thickness::Uniform(0.06) };
        let conditions = [held("bottom", 0.0), held("top", rise)];
        let thermal = ThermalSystem::new(&mesh, conduction, Capacity::Consistent, &conditions).unwrap();
        let temperatures = thermal.steady(0.0).unwrap();
        let law = Elasticity::new(PlaneState::Stress, 210e9, 0.3, expansion, 0.06).unwrap();
        let mut loads = Loads::none(&mesh);
        loads.add_temperature(&mesh, &law, &temperatures);
        let solution = ElasticSystem::free(&mesh, law).unwrap().solve(&loads).unwrap();
        let at = |x: f64| solution.nodes[mesh.nearest_node([x, 0.5 * height])];
        let (left, middle, right) = (at(0.0), at(0.5 * length), at(length));
        // linear elements cannot bend freely: they only come near
        let tolerance: f64 = if element.edges()[0].len() == 3 { 1e-9 } else { 0.35 };
        let elongation = (right[0] - left[0]) / (expansion * rise * length / 2.0);
        assert!((elongation - 1.0).abs() < tolerance.min(0.02), "{element:?}: {elongation}");
        let bow = (middle[1] - 0.5 * (left[1] + right[1])) / (expansion * rise * length * length / (8.0 * height));
        assert!((bow - 1.0).abs() < tolerance, "{element:?}: {bow}");
        if element.edges()[0].len() == 3 {
            let stresses = nodal_stresses(&mesh, &law, &solution.nodes, &temperatures);
            assert!(stresses.iter().flatten().all(|stress| stress.abs() < 1.0), "{element:?}");
        }
    }
}
