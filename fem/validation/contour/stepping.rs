//! The whole chain, stepped through time from rest in the centre: two laps and on to the point. Only the
//! command is cut into straight pieces.

use std::f64::consts::TAU;

use super::rig::*;
use crate::validation::Case;

const STEPS: u32 = 40_000;

const EFFECTS: &str = "
    servo-mismatch = { mismatch = 0.2 }
    backlash-x = { gap = \"9 um\" }
    backlash-y = { gap = \"4 um\" }
    squareness = { angle = \"-70 um/m\" }
    scale-mismatch = { mismatch = \"50 um/m\" }
    cyclic-error-x = { amplitude = \"3 um\", phase = \"40 deg\" }
    cyclic-error-y = { amplitude = \"2 um\", phase = \"-110 deg\" }
    centre-offset = { x = \"6 um\", y = \"-5 um\" }
";

pub fn cases() -> Vec<Case> {
    let (radius, feed) = (0.05, 0.05);
    let machine = machine(&circle(50.0, 3000.0, 30.0), EFFECTS);
    // A chord of a step lies R(step)²/8 inside; the play sees it at every reversal.
    let chord = radius * (TAU / f64::from(STEPS)).powi(2) / 8.0;
    let mut cases = Vec::new();
    for direction in WAYS {
        for angle in [0.3, 2.0, 91.0, 170.0, 268.0, 315.0] {
            let turn = direction.sign() * f64::to_radians(angle);
            let expected = stepped(radius, feed, direction.sign(), turn.rem_euclid(TAU));
            cases.push(micro(
                format!("eight effects at once, {} at {angle} deg", direction.word()),
                (expected, deviation(&machine, direction, angle)),
                4.0 * chord,
                "stepped through time; tolerance 4 chords of a step, R*step^2/8",
            ));
        }
    }
    cases
}

/// The deviation when the command has turned by two laps and `turn` (rad) more.
fn stepped(radius: f64, feed: f64, sign: f64, turn: f64) -> f64 {
    let frequency = feed / radius;
    let last = 2.0 * TAU + turn;
    let count = (last / TAU * f64::from(STEPS)).ceil();
    let step = last / frequency / count;
    let command = |i: f64| {
        let angle = sign * frequency * step * i;
        [radius * angle.cos(), radius * angle.sin()]
    };
    let (gains, gaps) = ([30.0 * 1.1, 30.0 * 0.9], [9e-6, 4e-6]);
    let (mut drive, mut slide) = ([0.0; 2], [0.0; 2]);
    for i in 0..count as u32 {
        let (from, to) = (command(f64::from(i)), command(f64::from(i + 1)));
        for axis in 0..2 {
            // u' = K(c − u) with c straight from `from` to `to`.
            let (gain, slope) = (gains[axis], (to[axis] - from[axis]) / step);
            let lag = slope / gain;
            drive[axis] = to[axis] - lag + (drive[axis] - from[axis] + lag) * f64::exp(-gain * step);
            slide[axis] = f64::clamp(slide[axis], drive[axis] - gaps[axis] / 2.0, drive[axis] + gaps[axis] / 2.0);
        }
    }
    let wave = |at: f64, amplitude: f64, phase: f64| at + amplitude * (TAU * at / 0.01 + phase.to_radians()).sin();
    let x = wave(slide[0], 3e-6, 40.0) * (1.0 + 25e-6);
    let y = wave(slide[1], 2e-6, -110.0) * (1.0 - 25e-6);
    f64::hypot(x - 70e-6 * y + 6e-6, y - 5e-6) - radius
}
