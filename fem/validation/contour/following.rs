//! Gains that follow the feed, and waves of stick-slip.

use std::f64::consts::PI;

use super::rig::*;
use crate::validation::Case;

pub fn cases() -> Vec<Case> {
    [sides(), lobes(), waves()].concat()
}

/// Kvx = 50·(1 + 0.2·|vx|/v), Kvy = 50·(1 − 0.1·|vy|/v), 1/s.
const CHANGES: &str = "[gain-with-feed-x]\nchange = 0.2\n[gain-with-feed-y]\nchange = -0.1";
/// v, m/s.
const FEED: f64 = 1.0 / 60.0;

/// A side that runs at β, counter-clockwise: v·(Kvx − Kvy)/(2KvxKvy)·sin 2β outwards, each gain at its own
/// speed. The middles of the sides of a rectangle at 25 deg.
fn sides() -> Vec<Case> {
    let machine = machine(&rectangle(25.0, 50.0), CHANGES);
    let case = |(side, sign): (f64, f64)| {
        // The side that faces an angle runs a quarter ahead of it.
        let (sine, cosine) = (side + 90.0).to_radians().sin_cos();
        let [x, y] = [50.0 * (1.0 + 0.2 * cosine.abs()), 50.0 * (1.0 - 0.1 * sine.abs())];
        let expected = sign * FEED * (x - y) / (2.0 * x * y) * 2.0 * sine * cosine;
        let direction = if sign > 0.0 { CCW } else { CW };
        let name = format!("gains that follow the feed, side that faces {side} deg, {}", direction.word());
        // A corner 25 mm behind has faded by e^(−25/(1/3)).
        micro(name, (expected, deviation(&machine, direction, side)), 1e-12, "seed 000, each gain at its own speed")
    };
    [(25.0, 1.0), (115.0, 1.0), (205.0, 1.0), (295.0, 1.0), (25.0, -1.0), (115.0, -1.0)].map(case).to_vec()
}

/// On a circle the lag that a change of both gains adds is v·c·(|sin α| − |cos α|)/Kv·sin α·cos α to its
/// first order, four lobes; held against the servo stepped through time, dx/dt = v(e), e = c − x, the
/// speed of which solves v = e·Kv(1 + change·v/feed).
fn lobes() -> Vec<Case> {
    let (radius, gain, change) = (0.15, 50.0, 0.2);
    let text = circle(150.0, 1000.0, gain);
    let alike = machine(&text, "[gain-with-feed-x]\nchange = 0.2\n[gain-with-feed-y]\nchange = 0.2");
    let omega = FEED / radius;
    let stepped = |degrees: f64| {
        const STEPS: usize = 40_000;
        let step = (2.0 * PI + degrees.to_radians()) / omega / STEPS as f64;
        let mut at = [radius, 0.0];
        let speed = |error: f64| gain * error / (1.0 - gain * change * error.abs() / FEED);
        for i in 0..STEPS {
            let rate = |at: [f64; 2], time: f64| {
                let (sine, cosine) = (omega * time).sin_cos();
                [speed(radius * cosine - at[0]), speed(radius * sine - at[1])]
            };
            let time = i as f64 * step;
            let first = rate(at, time);
            let middle = rate([0, 1].map(|k| at[k] + 0.5 * step * first[k]), time + 0.5 * step);
            at = [0, 1].map(|k| at[k] + step * middle[k]);
        }
        at[0].hypot(at[1]) - radius
    };
    let case = |degrees: f64| {
        let name = format!("both gains follow the feed, circle at {degrees} deg");
        // Left out is what the change leaves of the square of the lag, R·(ω/Kv)².
        let allowed = radius * (omega / gain).powi(2);
        let source = "stepped through time; tolerance R*(v/(R*Kv))^2";
        micro(name, (stepped(degrees), deviation(&alike, CCW, degrees)), allowed, source)
    };
    [22.5, 67.5, 110.0, 200.0, 290.0].map(case).to_vec()
}

/// 3 Hz at 1000 mm/min: one wave in 5.556 mm of path. On a side that faces 0 deg, 40 mm from the centre, x
/// alone shows.
fn waves() -> Vec<Case> {
    let text = rectangle(0.0, STIFF).replace("lead = \"10 mm\"", "frequency = \"3 Hz\"");
    let machine = machine(&text, "[stick-slip-x]\namplitude = \"2 um\"\nphase = \"20 deg\"");
    let length = FEED / 3.0;
    let case = |along: f64| {
        // Counter-clockwise the lap begins with this side, at −25 mm.
        let expected = 2e-6 * (2.0 * PI * (along + 0.025) / length + 20f64.to_radians()).sin();
        let angle = (along / 0.04).atan().to_degrees();
        let name = format!("stick-slip at 3 Hz, {} mm along a side", 1e3 * along);
        micro(name, (expected, deviation(&machine, CCW, angle)), 1e-12, "seed 000, stick-slip: lambda = v/f")
    };
    let mut cases: Vec<Case> = [-0.011, 0.004, 0.02].map(case).to_vec();
    let told = figure_of(&machine, "stick_slip", "/length");
    cases.push(row(
        "stick-slip at 3 Hz",
        "length of a wave",
        (1e3 * length, told, "mm"),
        ROUND_OFF,
        "seed 000, stick-slip: lambda = v/f",
    ));
    cases
}
