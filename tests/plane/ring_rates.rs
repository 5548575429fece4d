//! Lamé's ring: rates of the displacement (L2) and of the energy for every element.

use fem::element::plane::{ALL, Elasticity, PlaneElement, PlaneState, Sampled};
use fem::mesh::{Grading, OUTSIDE, RingMesh};
use fem::solve::elastic::{ElasticSystem, Loads};

use crate::order;

const OUTER: f64 = 0.05;
const INNER: f64 = 0.03;
const PRESSURE: f64 = 50e6;

/// u_r(r) under outer pressure: −p Ro²/(E (Ro² − Ri²)) ((1 − ν) r + (1 + ν) Ri²/r).
fn exact(r: f64) -> f64 {
    -PRESSURE * OUTER * OUTER / (210e9 * (OUTER * OUTER - INNER * INNER)) * (0.7 * r + 1.3 * INNER * INNER / r)
}

/// L2 norm of the error of the displacement over that of the displacement.
fn error(element: &'static dyn PlaneElement, cells: usize) -> f64 {
    let grading = Grading::uniform();
    let ring = RingMesh {
        outer_radius: OUTER,
        inner_radius: INNER,
        circumferential: 12 * cells,
        radial: cells,
        element,
        grading,
    };
    let mesh = ring.build().unwrap();
    let law = Elasticity::new(PlaneState::Stress, 210e9, 0.3, 0.0, 0.02).unwrap();
    let mut loads = Loads::none(&mesh);
    loads.add_pressure(&mesh, &law, OUTSIDE, PRESSURE).unwrap();
    let mut motion = ElasticSystem::free(&mesh, law).unwrap().solve(&loads).unwrap().nodes;
    // triangles share one diagonal, so that the mesh turns a little: take the rigid motion out
    let count = motion.len() as f64;
    let shift = [0, 1].map(|axis| motion.iter().map(|own| own[axis]).sum::<f64>() / count);
    let polar: f64 = mesh.nodes().iter().map(|[x, y]| x * x + y * y).sum();
    let turn = mesh.nodes().iter().zip(&motion).map(|([x, y], [ux, uy])| x * uy - y * ux).sum::<f64>() / polar;
    for ([x, y], own) in mesh.nodes().iter().zip(&mut motion) {
        *own = [own[0] - shift[0] + turn * y, own[1] - shift[1] - turn * x];
    }
    let sampled = Sampled::new(element);
    let (mut wrong, mut whole) = (0.0, 0.0);
    for own in mesh.elements() {
        let coordinates = mesh.coordinates(own);
        sampled.integrate(&coordinates[..own.nodes.len()], |da, shapes, _, _| {
            let (mut at, mut moved) = ([0.0; 2], [0.0; 2]);
            for ((&node, shape), place) in own.nodes.iter().zip(shapes).zip(coordinates) {
                for axis in 0..2 {
                    at[axis] += shape * place[axis];
                    moved[axis] += shape * motion[node as usize][axis];
                }
            }
            let radius = at[0].hypot(at[1]);
            for axis in 0..2 {
                let expected = exact(radius) * at[axis] / radius;
                wrong += da * (moved[axis] - expected).powi(2);
                whole += da * expected.powi(2);
            }
        });
    }
    (wrong / whole).sqrt()
}

#[test]
fn displacement_converges_at_the_order_of_the_element() {
    for element in ALL {
        let expected = if element.edges()[0].len() == 3 { 3.0 } else { 2.0 };
        let errors = [4, 8, 16].map(|cells| error(*element, cells));
        let rates = [order(errors[0], errors[1]), order(errors[1], errors[2])];
        println!("{element:?}: errors {errors:?}, rates {rates:.2?}");
        assert!((rates[1] - expected).abs() < 0.2, "{element:?}: {rates:.2?}, expected {expected}");
        assert!((rates[1] - expected - 1.0).abs() > 0.2);
    }
}
