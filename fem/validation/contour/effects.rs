//! First-order formulas of effects, the servos following at once. What they leave out is of the second
//! order in amplitude over radius.

use std::f64::consts::TAU;

use super::rig::*;
use crate::validation::Case;

const RADIUS: f64 = 0.15;

pub fn cases() -> Vec<Case> {
    let text = circle(150.0, 1000.0, STIFF);
    let mut cases = Vec::new();
    let mut add = |effect: &str, angles: &[f64], formula: &dyn Fn(f64) -> f64, amplitude: f64, source| {
        let machine = machine(&text, effect);
        let name = effect.split(['[', ']']).nth(1).unwrap_or_default();
        for angle in angles {
            for direction in WAYS {
                let pair = (formula(angle.to_radians()), deviation(&machine, direction, *angle));
                cases.push(micro(
                    format!("{name}, {} at {angle} deg", direction.word()),
                    pair,
                    amplitude * amplitude / RADIUS + 1e-12,
                    source,
                ));
            }
        }
    };
    let (shear, ratio) = (40e-6, -60e-6);
    add(
        "[squareness]\nangle = \"40 um/m\"",
        &[45.0, 110.0],
        &|a| shear * RADIUS / 2.0 * (2.0 * a).sin(),
        shear * RADIUS,
        "(angle*R/2)*sin(2*alpha); tolerance amplitude^2/R",
    );
    add(
        "[scale-mismatch]\nmismatch = \"-60 um/m\"",
        &[0.0, 70.0],
        &|a| ratio * RADIUS / 2.0 * (2.0 * a).cos(),
        ratio * RADIUS,
        "(mismatch*R/2)*cos(2*alpha); tolerance amplitude^2/R",
    );
    add(
        "[centre-offset]\nx = \"5 um\"\ny = \"-9 um\"",
        &[30.0, 200.0],
        &|a| 5e-6 * a.cos() - 9e-6 * a.sin(),
        11e-6,
        "x*cos(alpha) + y*sin(alpha); tolerance amplitude^2/R",
    );
    // Ten millimetres a wave; the position is that of the circle itself.
    let wave = |at: f64, phase: f64| 2e-6 * (TAU * at / 0.01 + phase).sin();
    // The lag of 1e-7 rad moves the wave by R times that: 1e-5 of it.
    let waved = "seed 000, wave of the feedback: A*sin(2*pi*position/lead + phase) along the axis; tolerance amplitude^2/R and the lag v/Kv";
    let moved = (2e-6f64 * TAU / 0.01 * (1.0 / 60.0 / STIFF) * RADIUS).sqrt();
    add(
        "[cyclic-error-x]\namplitude = \"2 um\"\nphase = \"30 deg\"",
        &[20.0, 155.0],
        &|a| wave(RADIUS * a.cos(), 30f64.to_radians()) * a.cos(),
        2e-6 + moved,
        waved,
    );
    add(
        "[cyclic-error-y]\namplitude = \"2 um\"\nphase = \"-70 deg\"",
        &[20.0, 250.0],
        &|a| wave(RADIUS * a.sin(), -70f64.to_radians()) * a.sin(),
        2e-6 + moved,
        waved,
    );
    cases.extend(spikes());
    cases
}

/// height·e^(−Δt/τ)·|cos α|, Δt = (α − atan(v/RKv))·R/v behind a reversal, with servos of 50/s.
fn spikes() -> Vec<Case> {
    let text = circle(150.0, 1000.0, 50.0);
    let plain = machine(&text, "");
    let feed = 1.0 / 60.0;
    let lag = (feed / (RADIUS * 50.0)).atan();
    let mut cases = Vec::new();
    for (axis, behind) in [("x", 0.0), ("y", 90.0)] {
        let machine =
            machine(&text, &format!("[reversal-spike-{axis}]\nheight = \"12 um\"\ntime_constant = \"250 ms\""));
        for (direction, after) in [(CCW, 2.0), (CCW, 181.0), (CW, -2.0), (CW, 179.0)] {
            let angle = behind + after;
            // From the reversal, whichever of the two it is and whichever way round.
            let turned = direction.sign() * f64::to_radians(after);
            let since = (turned - lag).rem_euclid(std::f64::consts::PI) * RADIUS / feed;
            let shows = if axis == "x" { angle.to_radians().cos() } else { angle.to_radians().sin() }.abs();
            let spike = deviation(&machine, direction, angle) - deviation(&plain, direction, angle);
            cases.push(micro(
                format!("spike of {axis}, {} at {angle} deg", direction.word()),
                (12e-6 * (-since / 0.25).exp() * shows, spike),
                1e-13,
                "height*exp(-dt/tau)*|cos(alpha)|, dt from the reversal behind the servo",
            ));
        }
    }
    cases
}
