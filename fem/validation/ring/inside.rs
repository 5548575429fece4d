//! Rings that are held by their bore: Lamé, the solved ring, and what a turning chuck and a V-block do.

use std::f64::consts::TAU;

use super::rig::*;
use crate::mesh::BORE;
use crate::solve::elastic::{ElasticSystem, Loads};
use crate::solve::ring::{ContactArc, add_jaws_on};
use crate::validation::{Case, Tolerance};

/// Error of 360 by 6 elements, as against Michell's series.
const MESH: Tolerance = Tolerance::Relative(1e-4);

pub fn cases() -> Vec<Case> {
    [lame(), solved(), turning(), block()].concat()
}

fn held() -> String {
    ring(84.0, 3).replace("jaws = 3", "grip = \"inside\", jaws = 3")
}

/// Jaws that press all around the bore with p spread the outside by 2·p·Ri²·Ro/(E·(Ro² − Ri²)).
fn lame() -> Vec<Case> {
    let chuck = chuck(&held(), "[jaw-contact-arc]\narc = \"120 deg\"");
    let (outer, inner, force) = (0.05f64, 0.042f64, 9000.0);
    let pressure = force / (TAU * inner * 0.02);
    let expected = 2.0 * pressure * inner * inner * outer / (210e9 * (outer * outer - inner * inner));
    vec![row("ring spread all around", "radial displacement", (expected, clamped(&chuck, 0.4), "m"), MESH, "Lamé")]
}

/// Three jaws over 7.3° in the bore, as loads on the mesh: a jaw pushes the wall out where it stands.
fn solved() -> Vec<Case> {
    let held = chuck(&held(), "[jaw-contact-arc]\narc = \"7.3 deg\"");
    let solution = outside_of_the_solved();
    let at = |degrees: usize| {
        let expected = solution.as_ref().map_or(f64::NAN, |all| all[degrees]);
        let pair = (expected, clamped(&held, (degrees as f64).to_radians()), "m");
        row(
            format!("jaws in the bore, outside at {degrees} deg"),
            "radial displacement",
            pair,
            MESH,
            "the same elements, jaws as loads",
        )
    };
    [0, 20, 60].map(at).to_vec()
}

/// Radial displacement of the outside at every degree, m, its first harmonic taken out.
fn outside_of_the_solved() -> Option<Vec<f64>> {
    let (mesh, law) = mesh()?;
    let jaw = |k: usize| ContactArc { angle: TAU * k as f64 / 3.0, width: 7.3f64.to_radians(), force: -3000.0 };
    let mut loads = Loads::none(&mesh);
    add_jaws_on(BORE, &mut loads, &mesh, &[jaw(0), jaw(1), jaw(2)]).ok()?;
    let solution = ElasticSystem::free(&mesh, law).ok()?.solve(&loads).ok()?;
    let angle = |degrees: usize| (degrees as f64).to_radians();
    let radial = |degrees: usize| {
        let (sine, cosine) = angle(degrees).sin_cos();
        let node = mesh.nearest_node([0.05 * cosine, 0.05 * sine]);
        let [u, v] = solution.nodes[node];
        u * cosine + v * sine
    };
    let all: Vec<f64> = (0..360).map(radial).collect();
    let wave = |of: fn(f64) -> f64| all.iter().enumerate().map(|(i, u)| u * of(angle(i))).sum::<f64>() / 180.0;
    let (cosine, sine) = (wave(f64::cos), wave(f64::sin));
    let without = |(i, u): (usize, &f64)| u - cosine * angle(i).cos() - sine * angle(i).sin();
    Some(all.iter().enumerate().map(without).collect())
}

/// Jaws of 60 kg·mm that fly out at 400 rpm press from inside with F + m·r·ω².
fn turning() -> Vec<Case> {
    let moment = 60e-3;
    let omega = 400.0 * TAU / 60.0;
    let at = |effects| deviations(&chuck(&held(), effects), &[0.3], &[])[0];
    let times = at("[centrifugal-unloading]\njaw_moment = \"60 kg*mm\"") / at("");
    let expected = 1.0 + moment * omega * omega / 3000.0;
    vec![row(
        "jaws that fly out in the bore",
        "force over that at rest",
        (expected, times, "-"),
        ROUND_OFF,
        "mechanics of rotation",
    )]
}

/// Two waves around, on a V-block of 90°, show as they are.
fn block() -> Vec<Case> {
    let more = "reference = \"absolute\", gauge = \"v-block\"";
    let text = held().replace("3 kN", "0 N").replace("reference = \"absolute\"", more);
    let text = text.replace("circumferential = 360, radial = 6", "circumferential = 36, radial = 1");
    let oval = chuck(&text, "[residual-stress]\namplitude = \"4 um\"\nphase = \"20 deg\"");
    let pair = (8.0, figure_of(&oval, "gauges", "/v_block"), "um");
    let source = "ISO 4292: 1 + cos n(90 deg + a/2)/sin(a/2) of n = 2 waves is 1";
    vec![row("readings over a V-block of 90 deg differ by", "oval of 4 um", pair, Tolerance::Absolute(1e-9), source)]
}
