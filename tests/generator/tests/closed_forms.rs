//! Closed forms of statics and of the laws, and the heated rod against its Green's function.

use generator::job::NoiseKind;
use generator::law::Cause;
use generator::turning::design::STEEL;
use generator::turning::equilibrium::errors;
use generator::turning::heat::tool_temperature;
use generator::turning::job::{Holding, Job, Row};
use generator::turning::set_up::SetUp;
use generator::turning::shaft::{Material, Segment, Shaft};
use std::f64::consts::PI;

fn job(holding: Holding, modulus: f64, shear: bool, x: f64) -> Job {
    let segments = vec![
        Segment { length: 200.0, diameter: 40.0, ..Segment::default() },
        Segment { length: 400.0, diameter: 40.0, ..Segment::default() },
    ];
    Job {
        shaft: Shaft { material: Material { modulus, ..STEEL }, segments, shear },
        holding,
        depth: 0.5,
        feed: 0.2,
        speed: 600.0,
        force: 450.0,
        forward: false,
        parts: 1,
        cycle: 6.0,
        pauses: vec![],
        rows: vec![Row { part: 1, x, force: 450.0, ..Row::default() }],
        force_column: true,
        noise: NoiseKind::Neither,
        shown: vec![],
        survey: None,
        set_up: SetUp::default(),
    }
}

fn close(a: f64, b: f64, tolerance: f64) {
    assert!((a / b - 1.0).abs() < tolerance, "{a} against {b}");
}

#[test]
fn beams() {
    let (p, l, e) = (450.0, 600.0_f64, 210e3);
    let i = PI * 40_f64.powi(4) / 64.0;
    for x in [60.0, 200.0, 300.0, 517.0] {
        let b = l - x;
        let y = |h| 0.5e-3 * errors(&job(h, 210.0, false, x), &[])[0];
        close(y(Holding::Centres), p * x * x * b * b / (3.0 * e * i * l), 1e-12);
        close(y(Holding::Chuck), p * x.powi(3) / (3.0 * e * i), 1e-12);
        let propped = p * x.powi(3) * b * b * (4.0 * l - x) / (12.0 * e * i * l.powi(3));
        close(y(Holding::ChuckAndCentre), propped, 1e-11);
    }
    close(0.5e-3 * errors(&job(Holding::Centres, 210.0, false, 300.0), &[])[0], p * l.powi(3) / (48.0 * e * i), 1e-12);
    let worst = (2.0 - 2_f64.sqrt()) * l;
    let y = 0.5e-3 * errors(&job(Holding::ChuckAndCentre, 210.0, false, worst), &[])[0];
    close(p * l.powi(3) / (e * i * y), 101.91, 1e-4);
}

#[test]
fn shear_of_a_cantilever() {
    let g = 210e3 / 2.6;
    let area = PI * 400.0;
    let kappa = 6.0 * 1.3 / 8.8;
    let y = |shear| 0.5e-3 * errors(&job(Holding::Chuck, 210.0, shear, 300.0), &[])[0];
    close(y(true) - y(false), 450.0 * 300.0 / (kappa * g * area), 1e-10);
}

#[test]
fn rigid_shaft_on_springs() {
    let cause = |effect, k| Cause { effect, parameters: vec![("stiffness", k)] };
    let causes =
        [cause("headstock-compliance", 40.0), cause("tailstock-compliance", 25.0), cause("carriage-compliance", 60.0)];
    for x in [24.0, 300.0, 570.0] {
        let share: f64 = x / 600.0;
        let y = 450.0 * ((1.0 - share).powi(2) / 40.0 + share * share / 25.0 + 1.0 / 60.0);
        close(0.5 * errors(&job(Holding::Centres, 1e17, false, x), &causes)[0], y, 1e-9);
    }
    // A clamp that tilts freely is a pin: chuck-and-centre becomes centres.
    let soft = [causes.as_slice(), &[cause("chuck-tilt", 1e-5)]].concat();
    let a = errors(&job(Holding::ChuckAndCentre, 210.0, true, 444.0), &soft)[0];
    close(a, errors(&job(Holding::Centres, 210.0, true, 444.0), &causes)[0], 1e-5);
}

#[test]
fn contact_and_feedback() {
    let contact = Cause { effect: "carriage-contact", parameters: vec![("c", 0.3), ("n", 0.5)] };
    close(errors(&job(Holding::Centres, 1e17, false, 300.0), &[contact])[0], 0.6 * 450_f64.sqrt(), 1e-9);
    // Linear feedback on a spring: y = P0 (t - y)/(t0 k) = a t/(1 + a) with a = P0/(t0 k).
    let spring = Cause { effect: "carriage-compliance", parameters: vec![("stiffness", 20.0)] };
    let feedback = Cause { effect: "force-feedback", parameters: vec![("exponent", 1.0)] };
    let mut job = job(Holding::Centres, 1e17, false, 300.0);
    job.rows[0].blank = Some(41.4);
    let a = 450.0 / (500.0 * 20.0);
    close(errors(&job, &[spring, feedback])[0], 2.0 * a * 700.0 / (1.0 + a), 1e-9);
}

/// Rod of length L with insulated ends, images at 2mL +- x': integral of the kernel along the tool's way,
/// tau = u^2.
fn green(d: f64, length: f64, convection: f64, v: f64, x: f64) -> f64 {
    let (alpha, rc) = (50.0 / (7850.0 * 470.0), 7850.0 * 470.0);
    let beta = 4.0 * convection / (rc * d);
    let end = (length - x) / v;
    let steps = 40_000;
    let h = end.sqrt() / steps as f64;
    let mut sum = 0.0;
    for k in 0..=steps {
        let u = k as f64 * h;
        let (tau, source) = (u * u, x + v * u * u);
        let mut kernel = 0.0;
        for m in -3..=3 {
            for at in [source, -source] {
                let r = x - at - 2.0 * f64::from(m) * length;
                kernel += if tau > 0.0 { (-r * r / (4.0 * alpha * tau)).exp() } else { f64::from(r == 0.0) };
            }
        }
        let weight = if k == 0 || k == steps {
            1.0
        } else if k % 2 == 1 {
            4.0
        } else {
            2.0
        };
        sum += weight * kernel * 2.0 / (4.0 * PI * alpha).sqrt() * (-beta * tau).exp();
    }
    sum * h / 3.0 / (rc * PI * d * d / 4.0)
}

#[test]
fn heat_against_green() {
    for (d, length, feed_speed, h) in [(40.0, 600.0, 120.0, 20.0), (25.0, 300.0, 60.0, 30.0), (60.0, 780.0, 250.0, 5.0)]
    {
        let segments = vec![
            Segment { length: 0.3 * length, diameter: d, ..Segment::default() },
            Segment { length: 0.7 * length, diameter: d, ..Segment::default() },
        ];
        let shaft = Shaft { material: STEEL, segments, shear: true };
        let places: Vec<f64> = (0..9).map(|i| (0.04 + 0.115 * f64::from(i)) * length).collect();
        let mine = tool_temperature(&shaft, h, feed_speed, false, 0.4, &places);
        for (x, t) in places.iter().zip(&mine) {
            let exact = green(d * 1e-3, length * 1e-3, h, feed_speed / 6e4, x * 1e-3);
            println!("{d} {length} {feed_speed} x {x:.1} {t:.6} {exact:.6} {:.1e}", t / exact - 1.0);
            close(*t, exact, 4e-4);
        }
        let mirrored: Vec<f64> = places.iter().map(|x| length - x).collect();
        let forward = tool_temperature(&shaft, h, feed_speed, true, 0.4, &mirrored);
        mine.iter().zip(&forward).for_each(|(a, b)| close(*a, *b, 4e-4));
    }
}

#[test]
fn heat_of_a_stepped_shaft_converges() {
    let segments = vec![
        Segment { length: 150.0, diameter: 40.0, ..Segment::default() },
        Segment { length: 200.0, diameter: 60.0, ..Segment::default() },
        Segment { length: 101.3, diameter: 30.0, ..Segment::default() },
    ];
    let shaft = Shaft { material: STEEL, segments, shear: true };
    let places: Vec<f64> = (0..12).map(|i| 18.0 + 38.0 * f64::from(i)).collect();
    let coarse = tool_temperature(&shaft, 15.0, 150.0, false, 0.4, &places);
    let fine = tool_temperature(&shaft, 15.0, 150.0, false, 0.1, &places);
    for (a, b) in coarse.iter().zip(&fine) {
        println!("{a:.6} {b:.6} {:.1e}", a / b - 1.0);
        close(*a, *b, 4e-4);
    }
}
