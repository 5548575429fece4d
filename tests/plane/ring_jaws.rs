//! Rings pressed by jaws: finite elements against the Fourier series, which shares nothing with them.

use std::f64::consts::TAU;

use fem::element::plane::{Elasticity, PlaneElement, PlaneState, Quad8, Quad9, Tri6};
use fem::mesh::{Grading, RingMesh};
use fem::series::{Push, SeriesRing};
use fem::solve::elastic::{ElasticSystem, Loads};
use fem::solve::ring::{Bore, ContactArc, add_jaws};

/// A ring of the handbook's example: 100 × 84 × 20 mm, steel.
const RING: SeriesRing =
    SeriesRing { outer_radius: 0.05, inner_radius: 0.042, width: 0.02, youngs_modulus: 210e9, poisson_ratio: 0.3 };

fn mesh(ring: SeriesRing, cells: [usize; 2], element: &'static dyn PlaneElement, grading: Grading) -> RingMesh {
    let SeriesRing { outer_radius, inner_radius, .. } = ring;
    RingMesh { outer_radius, inner_radius, circumferential: cells[0], radial: cells[1], element, grading }
}

/// Largest error of the bore over 720 angles, relative to peak to valley; and the displacements at the
/// given angles.
fn error(ring: SeriesRing, mesh: &RingMesh, jaws: &[ContactArc]) -> f64 {
    let mesh = mesh.build().unwrap();
    let law = Elasticity::new(PlaneState::Stress, ring.youngs_modulus, ring.poisson_ratio, 0.0, ring.width).unwrap();
    let mut loads = Loads::none(&mesh);
    add_jaws(&mut loads, &mesh, jaws).unwrap();
    let solution = ElasticSystem::free(&mesh, law).unwrap().solve(&loads).unwrap();
    let bore = Bore::new(&mesh).unwrap();
    let shape = bore.shape(&solution.nodes);
    let series = ring.bore();
    let pushes: Vec<Push> =
        jaws.iter().map(|jaw| Push { angle: jaw.angle, arc: jaw.width, force: jaw.force }).collect();
    let (mut low, mut high, mut worst) = (f64::INFINITY, f64::NEG_INFINITY, 0.0_f64);
    for place in 0..720 {
        let angle = f64::from(place) * TAU / 720.0 + 1e-4;
        let exact = series.radial(&pushes, angle);
        (low, high) = (low.min(exact), high.max(exact));
        worst = worst.max((shape.radial(angle) - exact).abs());
    }
    worst / (high - low)
}

fn jaws(n: usize, first: f64, width: f64) -> Vec<ContactArc> {
    (0..n).map(|jaw| ContactArc { angle: first + jaw as f64 * TAU / n as f64, width, force: 3000.0 }).collect()
}

#[test]
fn the_default_mesh_is_within_a_ten_thousandth_of_the_series() {
    for n in [2, 3, 4, 6] {
        // at nodes, off nodes, across any part of an element, narrower than an element, a line
        for (first, width) in [(0.0, 10.0), (0.0, 0.0), (0.123, 7.3), (0.37, 0.2), (0.2, 0.0), (0.5, 0.0)] {
            let jaws = jaws(n, f64::to_radians(first), f64::to_radians(width));
            let error = error(RING, &mesh(RING, [360, 6], &Quad8, Grading::uniform()), &jaws);
            println!("n = {n}, first {first}°, arc {width}°: {error:.2e} of peak to valley");
            assert!(error < 1e-4, "n = {n}, first {first}, arc {width}: {error:.2e}");
        }
    }
}

#[test]
fn a_wrong_arc_is_told_apart() {
    let [right, wrong] = [10.0, 12.0].map(|arc| jaws(3, 0.0, f64::to_radians(arc)));
    let series = RING.bore();
    let pushes: Vec<Push> =
        right.iter().map(|jaw| Push { angle: jaw.angle, arc: jaw.width, force: jaw.force }).collect();
    let ring = mesh(RING, [360, 6], &Quad8, Grading::uniform()).build().unwrap();
    let law = Elasticity::new(PlaneState::Stress, RING.youngs_modulus, RING.poisson_ratio, 0.0, RING.width).unwrap();
    let mut loads = Loads::none(&ring);
    add_jaws(&mut loads, &ring, &wrong).unwrap();
    let solution = ElasticSystem::free(&ring, law).unwrap().solve(&loads).unwrap();
    let bore = Bore::new(&ring).unwrap();
    let gap = bore.shape(&solution.nodes).radial(0.0) / series.radial(&pushes, 0.0) - 1.0;
    assert!(gap.abs() > 2e-3, "{gap:.2e}");
}

#[test]
fn other_elements_and_graded_meshes_agree() {
    let arc = 10_f64.to_radians();
    let loads = jaws(3, 0.05, arc);
    let toward = loads.iter().flat_map(|jaw| [jaw.angle - 0.5 * arc, jaw.angle + 0.5 * arc]).collect();
    let graded = Grading { toward, ratio: 4.0, reach: 0.3 };
    for (element, cells, grading, tolerance) in [
        (&Quad8 as &'static dyn PlaneElement, [120, 4], graded, 2e-4),
        (&Quad9, [180, 4], Grading::uniform(), 2e-4),
        (&Tri6, [180, 4], Grading::uniform(), 2e-4),
    ] {
        let error = error(RING, &mesh(RING, cells, element, grading), &loads);
        println!("{element:?} {cells:?}: {error:.2e}");
        assert!(error < tolerance, "{element:?}: {error:.2e}");
    }
}

/// Jaws 2 and 3 out of place, forces in equilibrium, their mean kept: F_i ∝ sine of the angle between the
/// other two.
#[test]
fn jaws_out_of_place_in_equilibrium() {
    let angles = [0.0, 123.0, 237.5].map(f64::to_radians);
    let shares = [0, 1, 2].map(|jaw| (angles[(jaw + 2) % 3] - angles[(jaw + 1) % 3]).sin());
    let sum: f64 = shares.iter().sum();
    let jaws: Vec<ContactArc> = (0..3)
        .map(|jaw| ContactArc { angle: angles[jaw], width: 0.1, force: 3.0 * 3000.0 * shares[jaw] / sum })
        .collect();
    let error = error(RING, &mesh(RING, [360, 6], &Quad8, Grading::uniform()), &jaws);
    assert!(error < 1e-4, "{error:.2e}");
}

/// Exact (Michell): u_r at 0°, 30°, 60°, which are nodes of this mesh, and the mean, um.
#[test]
fn a_ring_to_the_digits_of_the_series() {
    let ring = SeriesRing { inner_radius: 0.04, ..RING };
    let jaws: Vec<ContactArc> =
        (0..3).map(|jaw| ContactArc { angle: f64::from(jaw) * TAU / 3.0, width: TAU / 36.0, force: 2000.0 }).collect();
    let fine = mesh(ring, [288, 11], &Quad8, Grading::uniform());
    let error = error(ring, &fine, &jaws);
    println!("ring of 50 and 40 mm, 288 x 11: {error:.2e}");
    assert!(error < 1e-5, "{error:.2e}");
    let fine = fine.build().unwrap();
    let law = Elasticity::new(PlaneState::Stress, ring.youngs_modulus, ring.poisson_ratio, 0.0, ring.width).unwrap();
    let mut loads = Loads::none(&fine);
    add_jaws(&mut loads, &fine, &jaws).unwrap();
    let solution = ElasticSystem::free(&fine, law).unwrap().solve(&loads).unwrap();
    assert!(solution.reactions.iter().all(|(_, force)| force.abs() < 1e-9 * 6000.0), "{:?}", solution.reactions);
    let bore = Bore::new(&fine).unwrap();
    let shape = bore.shape(&solution.nodes);
    for (degrees, expected) in [(0.0, -10.025_369), (30.0, -0.532_458), (60.0, 6.892_577), (120.0, -10.025_369)] {
        let found = 1e6 * shape.radial(f64::to_radians(degrees));
        assert!((found - expected).abs() < 5e-5, "{degrees}: {found} {expected}");
    }
    assert!((1e6 * shape.mean() + 1.010_508).abs() < 5e-6, "{}", shape.mean());
}
