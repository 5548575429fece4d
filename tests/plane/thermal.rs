//! Temperatures against benchmarks and closed forms.

use std::f64::consts::PI;
use std::sync::Arc;

use fem::element::plane::{Capacity, Conduction, PlaneElement, Quad4, Quad8, Quad9, Thickness, Tri3, Tri6};
use fem::mesh::{Grading, Mesh, RectangleMesh};
use fem::solve::conduction::{Condition, Energy, History, Power, Run, Scheme, ThermalError, ThermalSystem};

fn temperature(sides: &str, history: History) -> Condition {
    Condition::Temperature { sides: sides.to_owned(), temperature: history }
}

fn convection(sides: &str, coefficient: f64, ambient: f64) -> Condition {
    Condition::Convection { sides: sides.to_owned(), coefficient, ambient: History::Constant(ambient) }
}

fn flux(sides: &str, flux: f64, on: Vec<[f64; 2]>) -> Condition {
    Condition::Flux { sides: sides.to_owned(), flux: Power::switched(flux, &on) }
}

fn rectangle(size: [f64; 2], cells: [usize; 2], element: &'static dyn PlaneElement) -> Mesh {
    RectangleMesh::uniform(size, cells, element).build().unwrap()
}

fn system<'m>(mesh: &'m Mesh, [k, rho_c]: [f64; 2], conditions: &[Condition]) -> ThermalSystem<'m> {
    let law = Conduction { conductivity: k, heat_capacity: rho_c, thickness: Thickness::Uniform(0.02) };
    ThermalSystem::new(mesh, law, Capacity::Consistent, conditions).unwrap()
}

/// Temperature at (x, y) at the end of a run from 0.
fn final_temperature(system: &ThermalSystem<'_>, mesh: &Mesh, at: &[[f64; 2]], run: Run) -> (Vec<f64>, Energy) {
    let nodes: Vec<usize> = at.iter().map(|&place| mesh.nearest_node(place)).collect();
    let mut last = Vec::new();
    let energy = system
        .run(&vec![0.0; mesh.nodes().len()], &run, |now| last = nodes.iter().map(|&node| now.at(node)).collect())
        .unwrap();
    (last, energy)
}

/// NAFEMS T3: a rod of 0.1 m, T(0) = 0, T(L) = 100 sin(πt/40) °C; 36.60 °C at 0.08 m after 32 s.
#[test]
fn nafems_t3() {
    for (element, cells) in [(&Quad8 as &'static dyn PlaneElement, 40), (&Tri6, 40), (&Quad4, 160), (&Tri3, 160)] {
        for scheme in [Scheme::Sdirk2, Scheme::CrankNicolson] {
            let mesh = rectangle([0.1, 0.001], [cells, 1], element);
            let end = History::Function(Arc::new(|t: f64| 100.0 * (PI * t / 40.0).sin()));
            let conditions = [temperature("left", History::Constant(0.0)), temperature("right", end)];
            let system = system(&mesh, [35.0, 7200.0 * 440.5], &conditions);
            let (found, energy) =
                final_temperature(&system, &mesh, &[[0.08, 0.0]], Run { scheme, step: 0.25, end: 32.0 });
            println!("T3 {element:?} {scheme:?}: {:.4}", found[0]);
            assert!((found[0] - 36.60).abs() < 0.01, "{element:?} {scheme:?}: {}", found[0]);
            assert!(energy.imbalance().abs() < 1e-13, "{energy:?}");
        }
    }
}

/// NAFEMS T4: 0.6 × 1.0 m, k 52, bottom 100 °C, right and top 750 W/m²K to 0 °C; 18.25 °C at (0.6, 0.2).
#[test]
fn nafems_t4() {
    for (element, cells, tolerance) in [
        (&Quad8 as &'static dyn PlaneElement, [24, 40], 0.01),
        (&Quad9, [24, 40], 0.01),
        (&Tri6, [24, 40], 0.01),
        (&Quad4, [96, 160], 0.01),
        (&Tri3, [96, 160], 0.01),
    ] {
        let mesh = rectangle([0.6, 1.0], cells, element);
        let conditions = [
            temperature("bottom", History::Constant(100.0)),
            convection("right", 750.0, 0.0),
            convection("top", 750.0, 0.0),
        ];
        let found = system(&mesh, [52.0, 1.0], &conditions).steady(0.0).unwrap()[mesh.nearest_node([0.6, 0.2])];
        println!("T4 {element:?}: {found:.4}");
        assert!((found - 18.25).abs() < tolerance, "{element:?}: {found}");
    }
}

/// A slab of 2 m, k = ρc = 1, from 0 to faces at 100: 65.478 and 8.093 at x = 0.2 and 0.8, t = 0.1.
#[test]
fn slab_with_hot_faces() {
    for element in [&Quad8 as &'static dyn PlaneElement, &Quad9, &Tri6, &Quad4] {
        let mesh = rectangle([2.0, 0.05], [80, 1], element);
        let conditions = ["left", "right"].map(|side| temperature(side, History::Constant(100.0)));
        let system = system(&mesh, [1.0, 1.0], &conditions);
        let run = Run { scheme: Scheme::Sdirk2, step: 0.0005, end: 0.1 };
        let (found, energy) = final_temperature(&system, &mesh, &[[0.2, 0.0], [0.8, 0.0]], run);
        println!("slab {element:?}: {found:.4?}");
        let tolerance = if element.nodes() == 4 { 0.02 } else { 1.5e-3 };
        assert!((found[0] - 65.478).abs() < tolerance && (found[1] - 8.093).abs() < tolerance, "{found:?}");
        assert!(energy.imbalance().abs() < 1e-13, "{energy:?}");
    }
}

#[test]
fn sdirk2_forgets_a_jump_and_crank_nicolson_rings() {
    let mesh = rectangle([2.0, 0.05], [40, 1], &Quad4);
    let conditions = ["left", "right"].map(|side| temperature(side, History::Constant(100.0)));
    let system = system(&mesh, [1.0, 1.0], &conditions);
    let node = mesh.nearest_node([0.05, 0.0]);
    let swing = |scheme| {
        let mut path = Vec::new();
        system
            .run(&vec![0.0; mesh.nodes().len()], &Run { scheme, step: 0.05, end: 1.0 }, |now| path.push(now.at(node)))
            .unwrap();
        // SDIRK2 overshoots once, by some 8 of 100 K, and forgets it
        path[4..].windows(2).map(|pair| pair[0] - pair[1]).fold(0.0_f64, f64::max)
    };
    assert!(swing(Scheme::CrankNicolson) > 5.0, "{}", swing(Scheme::CrankNicolson));
    assert!(swing(Scheme::Sdirk2) < 0.2, "{}", swing(Scheme::Sdirk2));
}

#[test]
fn sources_switch_exactly_at_their_times() {
    let mesh = rectangle([0.1, 0.05], [8, 4], &Quad8);
    let source = {
        let shares = vec![(mesh.nearest_node([0.03, 0.02]), 1.0)];
        Condition::Source { shares, power: Power::switched(7.0, &[[3.3, 20.0]]) }
    };
    let conditions = [flux("left", 5e4, vec![[1.1, 8.4], [12.0, 12.7]]), source];
    let system = system(&mesh, [45.0, 3.6e6], &conditions);
    for scheme in [Scheme::Sdirk2, Scheme::CrankNicolson, Scheme::BackwardEuler] {
        let initial = vec![20.0; mesh.nodes().len()];
        let mut times = Vec::new();
        let mut last = Vec::new();
        let energy = system
            .run(&initial, &Run { scheme, step: 5.0, end: 16.0 }, |now| {
                times.push(now.time);
                last = now.temperatures();
            })
            .unwrap();
        let expected = 5e4 * 0.05 * 0.02 * (7.3 + 0.7) + 7.0 * 12.7;
        assert!((energy.supplied / expected - 1.0).abs() < 1e-13, "{scheme:?}: {energy:?}");
        let stored = 3.6e6 * 0.1 * 0.05 * 0.02 * (system.mean(&last) - 20.0);
        assert!((stored / expected - 1.0).abs() < 1e-12, "{scheme:?}: {stored} {expected}");
        for switch in [1.1, 3.3, 8.4, 12.0, 12.7, 16.0] {
            assert!(times.contains(&switch), "{switch} {times:?}");
        }
    }
}

#[test]
fn heat_is_balanced_to_rounding() {
    for element in fem::element::plane::ALL {
        let mesh = rectangle([0.1, 0.05], [8, 5], *element);
        let ambient = History::Function(Arc::new(|t: f64| 20.0 + 3.0 * (0.1 * t).sin()));
        let conditions = [
            temperature("left", History::Function(Arc::new(|t: f64| 20.0 + 0.5 * t))),
            Condition::Convection { sides: "bottom".to_owned(), coefficient: 300.0, ambient },
            flux("right", 5e4, vec![[3.0, 11.0]]),
            Condition::MovingFlux {
                sides: "top".to_owned(),
                flux: Power::switched(1e6, &[]),
                width: 0.013,
                start: -0.01,
                speed: 0.003,
            },
        ];
        let law = Conduction { conductivity: 45.0, heat_capacity: 3.6e6, thickness: Thickness::Uniform(0.02) };
        for capacity in [Capacity::Consistent, Capacity::Lumped] {
            let system = ThermalSystem::new(&mesh, law, capacity, &conditions).unwrap();
            for scheme in [Scheme::Sdirk2, Scheme::CrankNicolson, Scheme::BackwardEuler] {
                let run = Run { scheme, step: 0.7, end: 60.0 };
                let energy = system.run(&vec![20.0; mesh.nodes().len()], &run, |_| ()).unwrap();
                assert!(energy.imbalance().abs() < 1e-14, "{element:?} {capacity:?} {scheme:?}: {energy:?}");
                assert!(energy.supplied > 5e4 * 0.05 * 0.02 * 8.0 && energy.convected > 0.0 && energy.stored > 0.0);
            }
        }
    }
}

/// A strip that passes wholly gives flux × width × thickness × length / speed, whatever the mesh.
#[test]
fn a_moving_strip_gives_its_heat() {
    for (sides, length) in [("top", 0.1), ("left", 0.05)] {
        let mesh = rectangle([0.1, 0.05], [7, 5], &Quad8);
        let strip = Condition::MovingFlux {
            sides: sides.to_owned(),
            flux: Power::switched(1e6, &[]),
            width: 0.01,
            start: -0.01,
            speed: 0.002,
        };
        let system = system(&mesh, [45.0, 3.6e6], &[strip]);
        let run = Run { scheme: Scheme::Sdirk2, step: 0.05, end: 80.0 };
        let energy = system.run(&vec![0.0; mesh.nodes().len()], &run, |_| ()).unwrap();
        let expected = 1e6 * 0.01 * 0.02 * length / 0.002;
        assert!((energy.supplied / expected - 1.0).abs() < 1e-4, "{sides}: {} {expected}", energy.supplied);
    }
}

#[test]
fn what_has_no_steady_state_says_so() {
    let mesh = rectangle([0.1, 0.05], [4, 4], &Quad4);
    let insulated = system(&mesh, [45.0, 3.6e6], &[flux("left", 5e4, vec![])]);
    assert_eq!(insulated.steady(0.0), Err(ThermalError::Insulated { element: 0 }));
    let law = Conduction { conductivity: -1.0, heat_capacity: 1.0, thickness: Thickness::Uniform(1.0) };
    let error = ThermalSystem::new(&mesh, law, Capacity::Lumped, &[]).unwrap_err();
    assert_eq!(error.to_string(), "conductivity (W/(m K)) must be above zero, not -1");
    let error = ThermalSystem::new(
        &mesh,
        Conduction { conductivity: 1.0, ..law },
        Capacity::Lumped,
        &[flux("lefft", 1.0, vec![])],
    );
    assert_eq!(error.unwrap_err().to_string(), "the mesh has no sides called `lefft`; it has bottom, left, right, top");
}

#[test]
fn graded_meshes_hold_a_boundary_layer() {
    let grading = Grading { toward: vec![0.0], ratio: 20.0, reach: 0.5 };
    let mesh = RectangleMesh { along: grading, ..RectangleMesh::uniform([1.0, 0.05], [20, 1], &Quad8) };
    let mesh = mesh.build().unwrap();
    // semi-infinite body under flux: T(0, t) = 2 q √(t/π k ρc)
    let system = system(&mesh, [1.0, 1.0], &[flux("left", 1.0, vec![])]);
    let run = Run { scheme: Scheme::Sdirk2, step: 1e-4, end: 0.01 };
    let (found, _) = final_temperature(&system, &mesh, &[[0.0, 0.0]], run);
    let exact = 2.0 * (0.01 / PI).sqrt();
    assert!((found[0] / exact - 1.0).abs() < 2e-3, "{} {exact}", found[0]);
}
