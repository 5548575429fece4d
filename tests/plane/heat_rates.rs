//! Rates of the temperature in space and time: the decay of a cosine, T = exp(−π² t) cos πx on 0 < x < 1.

use std::f64::consts::PI;

use fem::element::plane::{ALL, Capacity, Conduction, PlaneElement, Quad9, Sampled, Thickness};
use fem::mesh::{Mesh, RectangleMesh};
use fem::solve::conduction::{Run, Scheme, ThermalSystem};

use crate::order;

const END: f64 = 0.05;

fn final_temperatures(mesh: &Mesh, scheme: Scheme, step: f64) -> Vec<f64> {
    let law = Conduction { conductivity: 1.0, heat_capacity: 1.0, thickness: Thickness::Uniform(1.0) };
    let system = ThermalSystem::new(mesh, law, Capacity::Consistent, &[]).unwrap();
    let initial: Vec<f64> = mesh.nodes().iter().map(|[x, _]| (PI * x).cos()).collect();
    let mut last = Vec::new();
    system.run(&initial, &Run { scheme, step, end: END }, |now| last = now.temperatures()).unwrap();
    last
}

/// L2 norm of the error.
fn error(element: &'static dyn PlaneElement, cells: usize) -> f64 {
    let mesh = RectangleMesh::uniform([1.0, 0.3], [cells, cells / 4], element).build().unwrap();
    let last = final_temperatures(&mesh, Scheme::Sdirk2, END / 400.0);
    let sampled = Sampled::new(element);
    let mut wrong = 0.0;
    for own in mesh.elements() {
        let coordinates = mesh.coordinates(own);
        sampled.integrate(&coordinates[..own.nodes.len()], |da, shapes, _, _| {
            let x: f64 = shapes.iter().zip(coordinates).map(|(shape, place)| shape * place[0]).sum();
            let found: f64 = own.nodes.iter().zip(shapes).map(|(&node, shape)| shape * last[node as usize]).sum();
            wrong += da * (found - (-PI * PI * END).exp() * (PI * x).cos()).powi(2);
        });
    }
    wrong.sqrt()
}

#[test]
fn temperature_converges_in_space_at_the_order_of_the_element() {
    for element in ALL {
        let expected = if element.edges()[0].len() == 3 { 3.0 } else { 2.0 };
        let errors = [4, 8, 16].map(|cells| error(*element, cells));
        let rate = order(errors[1], errors[2]);
        println!("{element:?}: errors {errors:?}, rate {rate:.2}");
        assert!((rate - expected).abs() < 0.2, "{element:?}: {rate:.2}, expected {expected}");
    }
}

#[test]
fn temperature_converges_in_time_at_the_order_of_the_scheme() {
    let mesh = RectangleMesh::uniform([1.0, 0.3], [16, 1], &Quad9).build().unwrap();
    let exact = final_temperatures(&mesh, Scheme::Sdirk2, END / 4000.0);
    for (scheme, expected) in [(Scheme::BackwardEuler, 1.0), (Scheme::CrankNicolson, 2.0), (Scheme::Sdirk2, 2.0)] {
        let errors = [10.0, 20.0, 40.0].map(|steps| {
            let found = final_temperatures(&mesh, scheme, END / steps);
            found.iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        });
        let rate = order(errors[1], errors[2]);
        println!("{scheme:?}: errors {errors:?}, rate {rate:.2}");
        assert!((rate - expected).abs() < 0.1, "{scheme:?}: {rate:.2}, expected {expected}");
    }
}
