//! Plane finite elements against closed forms, the Fourier series of the ring and published benchmarks, and
//! the rates at which their errors fall with the size of elements and steps.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod elliptic_membrane;
mod heat_rates;
mod other_codes;
mod patch;
mod revolved;
mod ring_free;
mod ring_jaws;
mod ring_rates;
mod thermal;
mod thermal_bow;

use fem::mesh::Mesh;
use fem::solve::elastic::Prescribed;

/// Holds the whole border of a mesh where `motion` takes it (m).
fn held_border(mesh: &Mesh, motion: impl Fn([f64; 2]) -> [f64; 2]) -> Vec<Prescribed> {
    let mut border: Vec<u32> = mesh.names().flat_map(|name| mesh.nodes_on(name).unwrap()).collect();
    border.sort_unstable();
    border.dedup();
    assert!(border.len() < mesh.nodes().len());
    let held = |node: u32| {
        let displacement = motion(mesh.nodes()[node as usize]);
        [0, 1].map(|axis| Prescribed { node: node as usize, axis, displacement: displacement[axis] })
    };
    border.into_iter().flat_map(held).collect()
}

/// Observed order between errors at sizes h and h/2.
fn order(coarse: f64, fine: f64) -> f64 {
    (coarse / fine).log2()
}
