//! Rings under even loads: Lamé's solution, free expansion, and what a free body refuses.

use std::f64::consts::TAU;

use fem::element::plane::{Elasticity, PlaneState, Quad8};
use fem::mesh::{Grading, Mesh, OUTSIDE, RingMesh};
use fem::solve::elastic::{ElasticError, ElasticSystem, Loads, Prescribed, nodal_stresses};
use fem::solve::ring::{Bore, ContactArc, add_jaws};

fn ring() -> Mesh {
    let grading = Grading::uniform();
    RingMesh { outer_radius: 0.05, inner_radius: 0.03, circumferential: 96, radial: 6, element: &Quad8, grading }
        .build()
        .unwrap()
}

fn steel(state: PlaneState) -> Elasticity {
    Elasticity::new(state, 210e9, 0.3, 11.5e-6, 0.02).unwrap()
}

/// Lamé: outer pressure p gives u_r(Ri) = −2 p Ro² Ri (1 − ν²)/E' … with E, ν of plane stress, and σθθ(Ri) =
/// −2 p Ro²/(Ro² − Ri²) in both states.
#[test]
fn lame() {
    let mesh = ring();
    let (pressure, square) = (50e6, |x: f64| x * x);
    for (state, factor) in [(PlaneState::Stress, 1.0), (PlaneState::Strain, 1.0 - 0.3 * 0.3)] {
        let law = steel(state);
        let mut by_pressure = Loads::none(&mesh);
        by_pressure.add_pressure(&mesh, &law, OUTSIDE, pressure).unwrap();
        let mut by_jaw = Loads::none(&mesh);
        let force = pressure * TAU * 0.05 * 0.02;
        add_jaws(&mut by_jaw, &mesh, &[ContactArc { angle: 0.3, width: TAU, force }]).unwrap();
        let expected = -2.0 * pressure * square(0.05) * 0.03 * factor / (210e9 * (square(0.05) - square(0.03)));
        for loads in [by_pressure, by_jaw] {
            let solution = ElasticSystem::free(&mesh, law).unwrap().solve(&loads).unwrap();
            let bore = Bore::new(&mesh).unwrap();
            let shape = bore.shape(&solution.nodes);
            for angle in [0.0, 0.7, 3.0, 6.2] {
                let error = shape.radial(angle) / expected - 1.0;
                assert!(error.abs() < 5e-6, "{state:?} at {angle}: {error:.2e}");
            }
            assert!((shape.mean() / expected - 1.0).abs() < 5e-6);
            let stress = nodal_stresses(&mesh, &law, &solution.nodes, &[])[mesh.nearest_node([0.03, 0.0])][1];
            let hoop = -2.0 * pressure * square(0.05) / (square(0.05) - square(0.03));
            assert!((stress / hoop - 1.0).abs() < 5e-3, "{state:?}: {stress} {hoop}");
        }
    }
}

#[test]
fn a_warm_ring_grows_without_stress() {
    let mesh = ring();
    let law = steel(PlaneState::Stress);
    let rises = vec![40.0; mesh.nodes().len()];
    let mut loads = Loads::none(&mesh);
    loads.add_temperature(&mesh, &law, &rises);
    let solution = ElasticSystem::free(&mesh, law).unwrap().solve(&loads).unwrap();
    let bore = Bore::new(&mesh).unwrap();
    let expected = 11.5e-6 * 40.0 * 0.03;
    for node in mesh.nodes_on("bore").unwrap() {
        let [x, y] = mesh.nodes()[node as usize];
        let radial = bore.shape(&solution.nodes).radial(y.atan2(x));
        assert!((radial / expected - 1.0).abs() < 1e-11, "{}", radial / expected - 1.0);
    }
    let stresses = nodal_stresses(&mesh, &law, &solution.nodes, &rises);
    assert!(stresses.iter().flatten().all(|stress| stress.abs() < 1e-10 * 210e9 * 11.5e-6 * 40.0 * 100.0));
}

#[test]
fn one_jaw_alone_is_refused() {
    let mesh = ring();
    let mut loads = Loads::none(&mesh);
    add_jaws(&mut loads, &mesh, &[ContactArc { angle: 0.0, width: 0.1, force: 1000.0 }]).unwrap();
    let error = ElasticSystem::free(&mesh, steel(PlaneState::Stress)).unwrap().solve(&loads).unwrap_err();
    assert!(matches!(error, ElasticError::Unbalanced { .. }), "{error}");
}

#[test]
fn loose_supports_are_named() {
    let mesh = ring();
    let [right, left] = [mesh.nearest_node([0.05, 0.0]), mesh.nearest_node([-0.05, 0.0])];
    let fixed = |node, axis| Prescribed { node, axis, displacement: 0.0 };
    for (supports, expected) in [
        (vec![], "the body of element 0 is loose: it can "),
        (
            vec![fixed(right, 0), fixed(left, 1)],
            "the body of element 0 is loose: it can turn about (-0.050000, 0.000000) m",
        ),
        (
            vec![fixed(right, 0), fixed(right, 1)],
            "the body of element 0 is loose: it can turn about (0.050000, 0.000000) m",
        ),
        (vec![fixed(right, 1), fixed(left, 1)], "the body of element 0 is loose: it can slide along ("),
    ] {
        let error = ElasticSystem::held(&mesh, steel(PlaneState::Stress), &supports).unwrap_err().to_string();
        assert!(error.replace("-0.000000", "0.000000").starts_with(expected), "{error}");
    }
}
