//! Published benchmarks of plane conduction, and the hollow cylinder.

use std::f64::consts::PI;
use std::sync::Arc;

use super::rig::*;
use crate::element::plane::{Capacity, Conduction, Quad8, Thickness};
use crate::mesh::{BORE, Grading, OUTSIDE, RectangleMesh, RingMesh};
use crate::solve::conduction::{Condition, History, Run, Scheme, ThermalSystem};
use crate::validation::{Case, Tolerance};

pub fn cases() -> Vec<Case> {
    // NAFEMS prints two decimals.
    let printed = |name: &str, place, expected: f64, computed: f64, source| {
        row(name, place, (expected, computed, "degC"), Tolerance::Absolute(0.01), source)
    };
    vec![
        printed(
            "NAFEMS T3, 40 8-node elements",
            "temperature at 0.08 m after 32 s",
            36.60,
            t3().unwrap_or(f64::NAN),
            "NAFEMS T3 (1990)",
        ),
        printed("NAFEMS T4, 24 x 40 8-node elements", "temperature at (0.6, 0.2) m", 18.25, t4(), "NAFEMS T4 (1990)"),
        row(
            "hollow cylinder, 100 inside, 0 outside",
            "temperature half way",
            (100.0 * (100.0f64 / 70.0).ln() / (100.0f64 / 40.0).ln(), hollow().unwrap_or(f64::NAN), "degC"),
            // Quadratic elements of a tenth of the wall: errors of the fourth power at their nodes.
            Tolerance::Relative(1e-4),
            "ln(r_o/r)/ln(r_o/r_i)",
        ),
    ]
}

fn held(sides: &str, temperature: History) -> Condition {
    Condition::Temperature { sides: sides.into(), temperature }
}

/// A rod of 0.1 m from 0, T(L) = 100 sin(πt/40).
fn t3() -> Option<f64> {
    let mesh = RectangleMesh::uniform([0.1, 0.001], [40, 1], &Quad8).build().ok()?;
    let law = Conduction { conductivity: 35.0, heat_capacity: 7200.0 * 440.5, thickness: Thickness::Uniform(0.001) };
    let end = History::Function(Arc::new(|t: f64| 100.0 * (PI * t / 40.0).sin()));
    let conditions = [held("left", History::Constant(0.0)), held("right", end)];
    let system = ThermalSystem::new(&mesh, law, Capacity::Consistent, &conditions).ok()?;
    let node = mesh.nearest_node([0.08, 0.0]);
    let mut last = f64::NAN;
    let run = Run { scheme: Scheme::Sdirk2, step: 0.25, end: 32.0 };
    system.run(&vec![0.0; mesh.nodes().len()], &run, |now| last = now.at(node)).ok()?;
    Some(last)
}

/// 0.6 × 1 m, k = 52: below at 100, right and above losing 750 W/(m² K) to 0; steady.
fn t4() -> f64 {
    let plate = body(
        r#"
        body = { material = { base = "steel", conductivity = "52 W/m/K" }, rectangle = { length = "0.6 m", height = "1 m", width = "1 m" } }
        boundary = [{ edge = "bottom", temperature = "100 degC" }, { edge = "right", convection = "750 W/m^2/K" }, { edge = "top", convection = "750 W/m^2/K" }]
        environment = { temperature = "0 degC" }
        time = { end = "1e6 min", step = "1e5 min", scheme = "backward-euler" }
        mesh = { element_size = "25 mm" }
        "#,
        "",
    );
    temperature_at(&plate, [0.6, 0.2], 6e7)
}

/// Radii 40 and 100 mm.
fn hollow() -> Option<f64> {
    let grading = Grading::uniform();
    let (outer_radius, inner_radius) = (0.1, 0.04);
    let ring = RingMesh { outer_radius, inner_radius, circumferential: 64, radial: 10, element: &Quad8, grading };
    let mesh = ring.build().ok()?;
    let law = Conduction { conductivity: 50.0, heat_capacity: 3.7e6, thickness: Thickness::Uniform(0.01) };
    let conditions = [held(BORE, History::Constant(100.0)), held(OUTSIDE, History::Constant(0.0))];
    let temperatures = ThermalSystem::new(&mesh, law, Capacity::Consistent, &conditions).ok()?.steady(0.0).ok()?;
    let place = mesh.locate([0.07, 0.0])?;
    Some(place.shares.iter().map(|(node, share)| share * temperatures[*node]).sum())
}
