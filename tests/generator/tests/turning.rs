//! One equilibrium of nose, work, supports and blank against closed forms and against elements.

use std::f64::consts::PI;

use generator::dense::solve;
use generator::job::NoiseKind;
use generator::law::Cause;
use generator::turning::design::STEEL;
use generator::turning::equilibrium::errors;
use generator::turning::held::{Held, Root, Support};
use generator::turning::job::{Holding, Job, Row, Survey};
use generator::turning::set_up::{Lobe, Pass, Rest, SetUp, Wave};
use generator::turning::shaft::{Material, Segment, Shaft};

const LENGTH: f64 = 600.0;
const DIAMETER: f64 = 40.0;
/// So stiff that nothing bends.
const RIGID: f64 = 1e14;

fn job(holding: Holding, modulus: f64, force: f64, places: &[f64]) -> Job {
    let segments = vec![Segment { length: LENGTH, diameter: DIAMETER, ..Segment::default() }];
    Job {
        shaft: Shaft { material: Material { modulus, ..STEEL }, segments, shear: false },
        holding,
        depth: 0.5,
        feed: 0.2,
        speed: 600.0,
        force,
        forward: false,
        parts: 1,
        cycle: 6.0,
        pauses: vec![],
        rows: places.iter().map(|x| Row { part: 1, x: *x, force, ..Row::default() }).collect(),
        force_column: true,
        noise: NoiseKind::Neither,
        shown: vec![],
        survey: Some(Survey { clearance: 8.0, land: vec![(0.0, 0.0), (1e4, 0.2)], spacing: 300.0, height: 240.0 }),
        set_up: SetUp::default(),
    }
}

fn cause(effect: &'static str, parameters: &[(&'static str, f64)]) -> Cause {
    Cause { effect, parameters: parameters.to_vec() }
}

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() < tolerance, "{found} against {expected}");
}

/// δ(3ξ² − ξ³)/2 of a clamped shaft whose other end is moved; 18.75 and 60 um of diameter for 30 um.
#[test]
fn a_centre_out_of_line_bends_the_shaft() {
    let offset = [cause("tailstock-offset", &[("offset", 30.0)])];
    let places = [0.0, 150.0, 300.0, 480.0, 600.0];
    let found = errors(&job(Holding::ChuckAndCentre, 210.0, 0.0, &places), &offset);
    for (found, x) in found.iter().zip(places) {
        let part: f64 = x / LENGTH;
        close(*found, 30.0 * (3.0 * part.powi(2) - part.powi(3)), 1e-8);
    }
    close(found[2], 18.75, 1e-8);
    let straight = errors(&job(Holding::Centres, 210.0, 0.0, &places), &offset);
    straight.iter().zip(places).for_each(|(found, x)| close(*found, 60.0 * x / LENGTH, 1e-8));
}

/// d(1 − (3ξ² − ξ³)/2) of a headstock that does not tilt; all of it on a chuck alone.
#[test]
fn a_headstock_that_warms() {
    let drift = [cause("spindle-thermal-drift", &[("drift", 20.0), ("time_constant", 1e-9)])];
    let places = [120.0, 300.0, 450.0];
    let at = |holding| errors(&job(holding, 210.0, 0.0, &places), &drift);
    for (i, x) in places.iter().enumerate() {
        let part: f64 = x / LENGTH;
        close(at(Holding::ChuckAndCentre)[i], 40.0 * (1.0 - 1.5 * part.powi(2) + 0.5 * part.powi(3)), 1e-8);
        close(at(Holding::Centres)[i], 40.0 * (1.0 - part), 1e-8);
        close(at(Holding::Chuck)[i], 40.0, 1e-8);
    }
}

/// Between centres a spring k at `a` bears R = (P·f(a,x) − u)/(f(a,a) + 1/k), f(a,x) = x·b(L²−x²−b²)/(6EIL).
#[test]
fn a_rest_that_stands_out_of_line() {
    let inertia = PI * DIAMETER.powi(4) / 64.0;
    let bends = |x: f64, at: f64| {
        let (x, at) = if x < at { (x, at) } else { (at, x) };
        let b = LENGTH - at;
        1e3 * x * b * (LENGTH * LENGTH - x * x - b * b) / (6.0 * 210e3 * inertia * LENGTH)
    };
    for offset in [0.0, 12.0, -25.0] {
        let places = [90.0, 260.0, 410.0];
        let mut job = job(Holding::Centres, 210.0, 450.0, &places);
        job.set_up.rests.push(Rest { at: 260.0, stiffness: 40.0, offset });
        for (found, x) in errors(&job, &[]).iter().zip(places) {
            let bears = (450.0 * bends(260.0, x) - offset) / (bends(260.0, 260.0) + 1.0 / 40.0);
            close(0.5 * found, 450.0 * bends(x, x) - bears * bends(x, 260.0), 1e-9);
        }
    }
}

/// Hermite's elements of a stepped shaft on a tilting clamp, two rests and a centre, all moved.
#[test]
fn as_elements_have_it() {
    let (nodes, x) = ([0.0_f64, 100.0, 170.0, 250.0, 330.0, 420.0], 250.0);
    let diameters = [30.0_f64, 30.0, 44.0, 44.0, 36.0];
    let segments = vec![(170.0, 30.0), (160.0, 44.0), (90.0, 36.0)];
    let segments =
        segments.into_iter().map(|(length, diameter)| Segment { length, diameter, ..Segment::default() }).collect();
    let shaft = Shaft { material: STEEL, segments, shear: false };
    let support = |at, stiffness: f64| Support { at, compliance: 1.0 / stiffness, contact: None };
    let supports = [support(0.0, 60.0), support(420.0, 35.0), support(100.0, 25.0), support(330.0, 50.0)];
    let (imposed, force, tilt) = ([4.0, -11.0, 7.0, 15.0], 380.0, 250.0);
    let count = 2 * nodes.len();
    let mut matrix = vec![vec![0.0; count]; count];
    for (element, pair) in nodes.windows(2).enumerate() {
        let l = pair[1] - pair[0];
        // N/um of displacements in um; slopes in um/mm.
        let s = 210.0 * PI * diameters[element].powi(4) / 64.0 / l.powi(3);
        let local = [
            [12.0, 6.0 * l, -12.0, 6.0 * l],
            [6.0 * l, 4.0 * l * l, -6.0 * l, 2.0 * l * l],
            [-12.0, -6.0 * l, 12.0, -6.0 * l],
            [6.0 * l, 2.0 * l * l, -6.0 * l, 4.0 * l * l],
        ];
        for (i, row) in local.iter().enumerate() {
            for (j, value) in row.iter().enumerate() {
                matrix[2 * element + i][2 * element + j] += s * value;
            }
        }
    }
    let mut right = vec![0.0; count];
    for (support, moved) in supports.iter().zip(imposed) {
        let node = nodes.iter().position(|at| *at == support.at).expect("a node");
        matrix[2 * node][2 * node] += 1.0 / support.compliance;
        right[2 * node] += moved / support.compliance;
    }
    // kN·m/rad to N·mm per um/mm.
    matrix[1][1] += tilt * 1e3;
    right[2 * nodes.iter().position(|at| *at == x).expect("a node")] += force;
    let bent = solve(matrix, right);
    let held = Held::new(&shaft, Root::Clamp(1e-3 / tilt), &supports, x);
    close(held.goes(force, &imposed), bent[6], 1e-9);
    let reactions = held.reactions(force, &imposed);
    for ((support, moved), reaction) in supports.iter().zip(imposed).zip(reactions) {
        let node = nodes.iter().position(|at| *at == support.at).expect("a node");
        close(reaction, (bent[2 * node] - moved) / support.compliance, 1e-7);
    }
}

/// Between centres two contacts bear P·(1 − ξ) and P·ξ; with a rest and a clamp every contact has sunk c·qⁿ.
#[test]
fn contacts_sink_under_what_they_bear() {
    let contacts =
        [cause("headstock-contact", &[("c", 0.3), ("n", 0.5)]), cause("tailstock-contact", &[("c", 0.2), ("n", 0.6)])];
    let found = errors(&job(Holding::Centres, RIGID, 450.0, &[150.0]), &contacts)[0];
    let sinks = 0.75 * 0.3 * 337.5_f64.sqrt() + 0.25 * 0.2 * 112.5_f64.powf(0.6);
    close(found, 2.0 * sinks, 1e-8);
    let shaft = job(Holding::Centres, 210.0, 0.0, &[]).shaft;
    let support = |at, contact| Support { at, compliance: 0.02, contact };
    let supports = [support(0.0, Some((0.3, 0.5))), support(600.0, Some((0.2, 0.6))), support(250.0, None)];
    for imposed in [[0.0; 3], [9.0, -14.0, 20.0], [0.0, 40.0, 0.0]] {
        let held = Held::new(&shaft, Root::Clamp(1e-6), &supports, 400.0);
        let reactions = held.reactions(450.0, &imposed);
        let sunk: Vec<f64> = supports
            .iter()
            .zip(&reactions)
            .map(|(s, q)| s.contact.map_or(0.0, |(c, n)| if *q > 0.0 { c * q.powf(n) } else { 0.0 }))
            .collect();
        let bare = supports.map(|s| Support { contact: None, ..s });
        let moved: Vec<f64> = imposed.iter().zip(&sunk).map(|(u, d)| u + d).collect();
        let known = Held::new(&shaft, Root::Clamp(1e-6), &bare, 400.0);
        close(held.goes(450.0, &imposed), known.goes(450.0, &moved), 1e-9);
        for (found, expected) in reactions.iter().zip(known.reactions(450.0, &moved)) {
            close(*found, expected, 1e-7);
        }
    }
}

/// A straight force law on a spring leaves C/(C + j) of the blank's excess and 1 − C/(C + j) of what moves the nose:
/// of 48 um of wear 10 um of diameter are taken off.
#[test]
fn the_depth_is_what_lies_between_nose_and_blank() {
    let copies = 0.107;
    let stiffness = 450.0 / 500.0 * (1.0 - copies) / copies;
    let machine =
        [cause("carriage-compliance", &[("stiffness", stiffness)]), cause("force-feedback", &[("exponent", 1.0)])];
    let job = job(Holding::Centres, RIGID, 450.0, &[300.0]);
    let with = |more: &[Cause]| errors(&job, &[&machine, more].concat())[0] - errors(&job, &machine)[0];
    let nose = 2.0 * 48.0 * (1.0 - copies);
    close(with(&[cause("setting-error", &[("offset", 48.0)])]), nose, 1e-7);
    close(with(&[cause("guideway-taper", &[("slope", 160.0)])]), nose, 1e-7);
    // A centre that goes away takes the work from the nose as well.
    close(with(&[cause("tailstock-offset", &[("offset", 96.0)])]), nose, 1e-7);
    close(nose - 96.0, -10.272, 1e-3);
    // Beyond the blank the nose does not touch, and the work keeps its size.
    close(errors(&job, &[&machine[..], &[cause("setting-error", &[("offset", 700.0)])]].concat())[0], 1000.0, 1e-9);
}

/// R² = (D/2 + across)² + z² of wear, a yielding carriage and both a height and a sag.
#[test]
fn across_and_up_under_one_root() {
    let job = job(Holding::Centres, RIGID, 450.0, &[150.0]);
    let causes = [
        cause("guideway-height", &[("slope", 3.0)]),
        cause("bed-sag", &[("front", 60.0), ("rear", 20.0)]),
        cause("setting-error", &[("offset", 80.0)]),
        cause("carriage-compliance", &[("stiffness", 9.0)]),
    ];
    let across = 80.0 + 50.0 + 40.0 * 240.0 / 300.0 * 0.75;
    let up = 3.0 * 150.0 - 40.0 * 0.75;
    let radius = f64::hypot(20e3 + across, up);
    close(errors(&job, &causes)[0], 2.0 * (radius - 20e3), 1e-7);
}

/// Each pass of a straight force law leaves k·(t + e/2) of the radius.
#[test]
fn passes_copy_what_is_left() {
    let mut job = job(Holding::Centres, RIGID, 450.0, &[0.0, 150.0, 240.0]);
    job.set_up.passes = vec![Pass { depth: 2.0, force: 1200.0 }, Pass { depth: 1.0, force: 700.0 }];
    job.set_up.waves = vec![Wave { waves: 2.0, amplitude: 0.4, phase: 30.0 }];
    let machine = [cause("carriage-compliance", &[("stiffness", 20.0)]), cause("force-feedback", &[("exponent", 1.0)])];
    for (found, row) in errors(&job, &machine).iter().zip(&job.rows) {
        let mut left = 1e3 * 0.2 * (2.0 * PI * 2.0 * row.x / LENGTH - PI / 6.0).cos();
        for (depth, force) in [(2000.0, 1200.0), (1000.0, 700.0), (500.0, 450.0)] {
            let rate = force / depth;
            left = rate / (rate + 20.0) * (depth + left);
        }
        close(*found, 2.0 * left, 1e-7);
    }
}

/// Of a straight force law an odd lobe leaves nothing across a diameter, an oval k of itself.
#[test]
fn lobes_across_a_diameter() {
    let mut job = job(Holding::Centres, RIGID, 450.0, &[200.0, 200.0]);
    job.rows[1].angle = 50.0;
    job.set_up.lobes =
        vec![Lobe { lobes: 2, amplitude: 0.1, phase: 20.0 }, Lobe { lobes: 3, amplitude: 0.05, phase: 0.0 }];
    let machine = [cause("carriage-compliance", &[("stiffness", 20.0)]), cause("force-feedback", &[("exponent", 1.0)])];
    let copies = 0.9 / 20.9;
    for (found, angle) in errors(&job, &machine).iter().zip([0.0_f64, 50.0]) {
        let oval = 100.0 * (2.0 * (angle - 20.0).to_radians()).cos();
        close(*found, 2.0 * copies * (500.0 + oval), 1e-7);
    }
}

/// P·x³/(3EI) + P·x/(κGA) of a hollow cantilever.
#[test]
fn a_hollow_shaft() {
    let mut job = job(Holding::Chuck, 210.0, 450.0, &[300.0]);
    job.shaft.segments[0].bore = 24.0;
    job.shaft.shear = true;
    let (m2, shear_modulus) = (0.36_f64, 210e3 / 2.6);
    let kappa = 6.0 * 1.3 * 1.36_f64.powi(2) / (8.8 * 1.36_f64.powi(2) + 23.6 * m2);
    let inertia = PI * (DIAMETER.powi(4) - 24_f64.powi(4)) / 64.0;
    let area = PI * (1600.0 - 576.0) / 4.0;
    let bends = 300_f64.powi(3) / (3.0 * 210e3 * inertia) + 300.0 / (kappa * shear_modulus * area);
    close(errors(&job, &[])[0], 2e3 * 450.0 * bends, 1e-8);
}
