//! Bodies of revolution: the patch test in r and z, and rates of temperature and displacement against the cooling of a
//! solid cylinder and a hollow sphere under pressure, both on their axes.

use std::f64::consts::{FRAC_PI_2, PI};

use fem::element::plane::{ALL, Capacity, Conduction, Elasticity, PlaneElement, Sampled, Thickness};
use fem::mesh::{Lattice, Mesh, RectangleMesh};
use fem::solve::conduction::{Condition, History, Run, Scheme, ThermalSystem};
use fem::solve::elastic::{ElasticError, ElasticSystem, Loads, Prescribed, nodal_stresses};

use crate::{held_border, order};

/// Of an element of second order, or of first.
fn is_quadratic(element: &dyn PlaneElement) -> bool {
    element.edges()[0].len() == 3
}

/// 3 × 4 cells from a radius on, whose inner corners are shaken out of place; sides stay straight.
fn shaken(element: &'static dyn PlaneElement, radius: f64) -> Mesh {
    let corner = |i: usize, j: usize| {
        let inside = i > 0 && i < 6 && j > 0 && j < 8;
        let [a, b] = [(i * 7 + j * 3) as f64, (i * 5 + j * 11) as f64].map(f64::sin);
        let shake = f64::from(u8::from(inside)) * 0.04;
        [i as f64 / 6.0 * 1.2 + shake * a, radius + j as f64 / 8.0 + shake * b]
    };
    // Middles lie half way between the corners at the ends of the side or, in the middle of a cell, of its diagonal.
    let place = |i: usize, j: usize| {
        let [from, to] = [corner(i / 2 * 2, j.div_ceil(2) * 2), corner(i.div_ceil(2) * 2, j / 2 * 2)];
        [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])]
    };
    let lattice = Lattice { columns: 3, rows: 4, closed: false, element };
    lattice.mesh(["bottom", "right", "top", "left"], place).unwrap()
}

/// u = a r, w = b z: strains b along the axis, a along the radius and around.
#[test]
fn even_strain_is_exact_on_distorted_meshes() {
    let (widened, stretched) = (-1e-4, 2e-4);
    let motion = |[x, y]: [f64; 2]| [stretched * x, widened * y];
    for (element, radius) in ALL.iter().flat_map(|element| [(element, 0.0), (element, 0.3)]) {
        let mesh = shaken(*element, radius);
        let law = Elasticity::revolved(210e9, 0.3, 0.0).unwrap();
        let held = held_border(&mesh, motion);
        let solution = ElasticSystem::held(&mesh, law, &held).unwrap().solve(&Loads::none(&mesh)).unwrap();
        for (node, moved) in mesh.nodes().iter().zip(&solution.nodes) {
            let exact = motion(*node);
            assert!((moved[0] - exact[0]).abs().max((moved[1] - exact[1]).abs()) < 1e-16, "{element:?} {radius}");
        }
        let expected = law.stress([stretched, widened, 0.0, widened], 0.0);
        for stress in nodal_stresses(&mesh, &law, &solution.nodes, &[]) {
            let is_exact = stress.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9 * expected[0].abs());
            assert!(is_exact, "{element:?} {radius}: {stress:?} {expected:?}");
        }
    }
}

/// A free body that is warmed evenly grows without stress, on its axis too.
#[test]
fn a_warm_free_body_has_no_stress() {
    for (element, radius) in ALL.iter().flat_map(|element| [(element, 0.0), (element, 0.3)]) {
        let mesh = shaken(*element, radius);
        let law = Elasticity::revolved(210e9, 0.3, 11.5e-6).unwrap();
        let rises = vec![40.0; mesh.nodes().len()];
        let mut loads = Loads::none(&mesh);
        loads.add_temperature(&mesh, &law, &rises);
        let solution = ElasticSystem::free(&mesh, law).unwrap().solve(&loads).unwrap();
        let scale = 210e9 * 11.5e-6 * 40.0;
        let stresses = nodal_stresses(&mesh, &law, &solution.nodes, &rises);
        assert!(stresses.iter().flatten().all(|stress| stress.abs() < 1e-9 * scale), "{element:?} {radius}");
        for (node, moved) in mesh.nodes().iter().zip(&solution.nodes) {
            assert!((moved[1] - 11.5e-6 * 40.0 * node[1]).abs() < 1e-15, "{element:?} {radius}");
        }
    }
}

#[test]
fn a_body_of_revolution_is_held_along_its_axis_alone() {
    let mesh = shaken(ALL[3], 0.3);
    let law = Elasticity::revolved(210e9, 0.3, 11.5e-6).unwrap();
    let radial = [Prescribed { node: 3, axis: 1, displacement: 0.0 }];
    let error = ElasticSystem::held(&mesh, law, &radial).unwrap_err();
    assert!(matches!(error, ElasticError::Loose { .. }), "{error}");
    assert!(error.to_string().contains("slide along"), "{error}");
    let axial = [Prescribed { node: 3, axis: 0, displacement: 0.0 }];
    let mut loads = Loads::none(&mesh);
    loads.add_pressure(&mesh, &law, "bottom", 1e6).unwrap();
    assert!(ElasticSystem::held(&mesh, law, &axial).unwrap().solve(&loads).is_ok());
    // What presses all around is in equilibrium; what presses on one end is not.
    assert!(ElasticSystem::free(&mesh, law).unwrap().solve(&loads).is_ok());
    loads.add_pressure(&mesh, &law, "left", 1e6).unwrap();
    let error = ElasticSystem::free(&mesh, law).unwrap().solve(&loads).unwrap_err();
    assert!(matches!(error, ElasticError::Unbalanced { .. }), "{error}");
}

/// First zero of J₀.
const ZERO: f64 = 2.404_825_557_695_773;

/// J₀ by its integral, exact to rounding.
fn bessel(x: f64) -> f64 {
    (0..100).map(|i| (x * (PI * (f64::from(i) + 0.5) / 100.0).sin()).cos()).sum::<f64>() / 100.0
}

/// L2 norm of the error of T = e^(−z² t) J₀(z r) in a cylinder whose outside is held at zero, z the first zero of J₀.
fn cooled(element: &'static dyn PlaneElement, cells: usize) -> f64 {
    const END: f64 = 0.1;
    let mesh = RectangleMesh::uniform([0.3, 1.0], [cells.div_ceil(4), cells], element).build().unwrap();
    let law = Conduction { conductivity: 1.0, heat_capacity: 1.0, thickness: Thickness::Revolved };
    let held = Condition::Temperature { sides: "top".into(), temperature: History::Constant(0.0) };
    let system = ThermalSystem::new(&mesh, law, Capacity::Consistent, &[held]).unwrap();
    let initial: Vec<f64> = mesh.nodes().iter().map(|[_, r]| bessel(ZERO * r)).collect();
    let mut last = Vec::new();
    let run = Run { scheme: Scheme::Sdirk2, step: END / 400.0, end: END };
    system.run(&initial, &run, |now| last = now.temperatures()).unwrap();
    let sampled = Sampled::new(element);
    let mut wrong = 0.0;
    for own in mesh.elements() {
        let coordinates = mesh.coordinates(own);
        let coordinates = &coordinates[..own.nodes.len()];
        sampled.integrate_weighted(Thickness::Revolved, coordinates, |part, r, shapes, _, _| {
            let found: f64 = own.nodes.iter().zip(shapes).map(|(&node, shape)| shape * last[node as usize]).sum();
            wrong += part * (found - (-ZERO * ZERO * END).exp() * bessel(ZERO * r)).powi(2);
        });
    }
    wrong.sqrt()
}

#[test]
fn temperature_converges_at_the_order_of_the_element() {
    for element in ALL {
        let expected = if is_quadratic(*element) { 3.0 } else { 2.0 };
        let errors = [4, 8, 16].map(|cells| cooled(*element, cells));
        let rate = order(errors[1], errors[2]);
        println!("{element:?}: errors {errors:?}, rate {rate:.2}");
        assert!((rate - expected).abs() < 0.2, "{element:?}: {rate:.2}, expected {expected}");
    }
}

/// Error (root mean square over the nodes) of the displacement of a hollow sphere of radii 1 and 2 under a pressure of E/100 within, relative to that
/// of the bore; one half of it, whose equator does not move along the axis.
///
/// u(R) = p a³/(E (b³ − a³)) ((1 − 2ν) R + (1 + ν) b³/(2 R²)) (Lamé).
fn sphere(element: &'static dyn PlaneElement, cells: usize) -> f64 {
    const NU: f64 = 0.3;
    let lattice = Lattice { columns: 2 * cells, rows: cells, closed: false, element };
    // From the axis to the equator, and inwards: the sense in which x and y turn.
    let place = |i: usize, j: usize| {
        let angle = FRAC_PI_2 * i as f64 / (4 * cells) as f64;
        let radius = 2.0 - j as f64 / (2 * cells) as f64;
        [radius * angle.cos(), radius * angle.sin()]
    };
    let mesh = lattice.mesh(["outside", "equator", "bore", "axis"], place).unwrap();
    let law = Elasticity::revolved(1.0, NU, 0.0).unwrap();
    let mut loads = Loads::none(&mesh);
    loads.add_pressure(&mesh, &law, "bore", 0.01).unwrap();
    let held = Prescribed::fixed_side(&mesh, "equator", 0).unwrap();
    let solution = ElasticSystem::held(&mesh, law, &held).unwrap().solve(&loads).unwrap();
    let exact = |radius: f64| 0.01 / 7.0 * ((1.0 - 2.0 * NU) * radius + (1.0 + NU) * 4.0 / (radius * radius));
    let wrong = |(node, moved): (&[f64; 2], &[f64; 2])| {
        let radius = node[0].hypot(node[1]);
        let share = exact(radius) / radius;
        (moved[0] - share * node[0]).powi(2) + (moved[1] - share * node[1]).powi(2)
    };
    let sum: f64 = mesh.nodes().iter().zip(&solution.nodes).map(wrong).sum();
    (sum / mesh.nodes().len() as f64).sqrt() / exact(1.0)
}

#[test]
fn a_sphere_under_pressure_converges_at_the_order_of_the_element() {
    for element in ALL {
        // At the nodes elements of second order are better than their order promises.
        let least = if is_quadratic(*element) { 2.8 } else { 1.7 };
        let errors = [4, 8, 16].map(|cells| sphere(*element, cells));
        let rate = order(errors[1], errors[2]);
        println!("{element:?}: errors {errors:?}, rate {rate:.2}");
        assert!(rate > least, "{element:?}: {rate:.2}, expected {least}");
        assert!(errors[2] < if is_quadratic(*element) { 1e-4 } else { 2e-2 }, "{element:?}");
    }
}
