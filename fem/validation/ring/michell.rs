//! Rings of any thickness against the Fourier series, which shares nothing with the finite elements.

use super::rig::*;
use crate::processes::ring::circle::evenly;
use crate::processes::ring::jaws::Jaw;
use crate::processes::ring::rows::STATE;
use crate::series::{BoreSeries, Push, SeriesRing};
use crate::validation::{Case, Tolerance};

const SOURCE: &str = "Michell (1899) series, Lame mean; tolerance from the change from 180 x 3 to 360 x 6 elements";

/// A row whose tolerance follows from the discretisation: between elements of twice the size and these the
/// error of order p changes by 2^p − 1 times what is left of it. A seventh of the change covers orders from
/// 3 on; those of 8-node elements are near 4.
fn refined(name: String, quantity: &'static str, exact: f64, [coarse, fine]: [f64; 2]) -> Case {
    let allowed = ((fine - coarse) / 7.0).abs().max(1e-9 * exact.abs());
    row(name, quantity, (1e6 * exact, 1e6 * fine, "um"), Tolerance::Absolute(1e6 * allowed), SOURCE)
}

/// The same ring on the usual mesh and on one of elements of twice the size, the latter first.
fn rings(text: &str, effects: &str) -> [Option<Chuck>; 2] {
    let coarse = text.replace("circumferential = 360, radial = 6", "circumferential = 180, radial = 3");
    [chuck(&coarse, effects), chuck(text, effects)]
}

pub fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for (bore, jaws, arc) in [
        (84.0, 3, 0.0),
        (84.0, 3, 10.0),
        (84.0, 2, 25.0),
        (70.0, 3, 40.0),
        (70.0, 4, 7.3),
        (94.0, 6, 5.0),
        (50.0, 3, 30.0),
    ] {
        cases.extend(ring_of(bore, jaws, arc));
    }
    cases.extend(out_of_place());
    cases.extend([4, 6].into_iter().flat_map(tightened));
    cases
}

/// The exact ring.
fn series(bore: f64) -> BoreSeries {
    let ring = SeriesRing {
        outer_radius: 0.05,
        inner_radius: 5e-4 * bore,
        width: 0.02,
        youngs_modulus: 210e9,
        poisson_ratio: 0.3,
    };
    ring.bore()
}

fn ring_of(bore: f64, jaws: usize, arc: f64) -> Vec<Case> {
    let computed = rings(&ring(bore, jaws), &format!("[jaw-contact-arc]\narc = \"{arc} deg\""));
    let series = series(bore);
    let spacing = std::f64::consts::TAU / jaws as f64;
    let push = |jaw: usize| Push { angle: spacing * jaw as f64, arc: arc.to_radians(), force: 3000.0 };
    let pushes: Vec<Push> = (0..jaws).map(push).collect();
    let angles = evenly(720);
    let exact: Vec<f64> = angles.iter().map(|angle| series.radial(&pushes, *angle)).collect();
    let shapes = computed.map(|chuck| deviations(&chuck, &angles, &[(STATE, 1.0)]));
    let name = format!("{jaws} jaws over {arc} deg, bore {bore} mm of 100");
    let of = |quantity, figure: &dyn Fn(&[f64]) -> f64| {
        refined(name.clone(), quantity, figure(&exact), [0, 1].map(|mesh| figure(&shapes[mesh])))
    };
    let midway = angles.len() / (2 * jaws);
    let wave = |shape: &[f64], m: usize| {
        let parts = angles.iter().zip(shape).map(|(angle, u)| u * (m as f64 * angle).cos());
        parts.sum::<f64>() / angles.len() as f64
    };
    vec![
        of("inward at a jaw", &|u| -u[0]),
        of("outward midway", &|u| u[midway]),
        of("peak to valley", &|u| u[midway] - u[0]),
        of("mean", &|u| wave(u, 0)),
        of("first harmonic of the jaws", &|u| -2.0 * wave(u, jaws)),
        of("second harmonic of the jaws", &|u| -2.0 * wave(u, 2 * jaws)),
    ]
}

/// Jaws at 0°, 123° and 237.5°, the forces as the sines of the angles between the other two.
fn out_of_place() -> Vec<Case> {
    let effects = "[jaw-contact-arc]\narc = \"10 deg\"\n[jaw-position]\nerror_2 = \"3 deg\"\nerror_3 = \"-2.5 deg\"";
    let computed = rings(&ring(84.0, 3), effects);
    let angles = [0.0, 123.0, 237.5f64].map(f64::to_radians);
    let sines = [0, 1, 2].map(|jaw: usize| (angles[(jaw + 2) % 3] - angles[(jaw + 1) % 3]).sin());
    let sum: f64 = sines.iter().sum();
    let push = |jaw: usize| Push { angle: angles[jaw], arc: 10f64.to_radians(), force: 9000.0 * sines[jaw] / sum };
    let pushes = [0, 1, 2].map(push);
    let exact = series(84.0);
    let jaws: Vec<Jaw> = computed[1].as_ref().and_then(|c| c.machine().jaws().ok()).unwrap_or_default();
    let share = jaws.get(1).map_or(f64::NAN, |jaw| jaw.share);
    let mut cases = vec![row(
        "jaws at 0, 123 and 237.5 deg",
        "share of jaw 2",
        (3.0 * sines[1] / sum, share, "-"),
        ROUND_OFF,
        "Lamy's theorem",
    )];
    for degrees in [0.0, 62.0, 123.0, 180.0, 300.0] {
        let angle = f64::to_radians(degrees);
        let name = format!("jaws at 0, 123 and 237.5 deg, at {degrees} deg");
        let found = [0, 1].map(|mesh: usize| clamped(&computed[mesh], angle));
        cases.push(refined(name, "radial displacement", exact.radial(&pushes, angle), found));
    }
    cases
}

/// Jaws of which every other one is tightened to 3.3 kN and the rest to 2.7 kN, clamped, and turning at 400 rpm with 50 kg·mm each.
fn tightened(jaws: usize) -> Vec<Case> {
    let effects = "[jaw-contact-arc]\narc = \"10 deg\"\n[jaw-imbalance]\ndifference = \"20 %\"\n[centrifugal-unloading]\njaw_moment = \"50 kg*mm\"";
    let computed = rings(&ring(84.0, jaws), effects);
    let thrown = 0.05 * (400.0 * std::f64::consts::TAU / 60.0).powi(2);
    let exact = series(84.0);
    let pushes = |less: f64| -> Vec<Push> {
        let force = |k: usize| if k.is_multiple_of(2) { 3300.0 } else { 2700.0 };
        let angle = |k: usize| std::f64::consts::TAU * k as f64 / jaws as f64;
        (0..jaws).map(|k| Push { angle: angle(k), arc: 10f64.to_radians(), force: force(k) - less }).collect()
    };
    let at = |degrees: f64| {
        let angle = degrees.to_radians();
        let standing = [0, 1].map(|mesh: usize| clamped(&computed[mesh], angle));
        let turning = [0, 1].map(|mesh: usize| -deviations(&computed[mesh], &[angle], &[])[0]);
        let name = |how: &str| format!("{jaws} jaws of 3.3 and 2.7 kN in turn, {how}, at {degrees} deg");
        [(name("clamped"), 0.0, standing), (name("at 400 rpm"), thrown, turning)]
            .map(|(name, less, found)| refined(name, "radial displacement", exact.radial(&pushes(less), angle), found))
    };
    [0.0, 180.0 / jaws as f64, 360.0 / jaws as f64, 200.0].into_iter().flat_map(at).collect()
}
