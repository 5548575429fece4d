//! Draws the jobs: axes, screws and positioning tests.

use super::{Job, Row, SetUp};
use crate::job::{NoiseKind, Shown};
use crate::random::{Random, decimals, figures};

/// A job that admits all of `hidden`; what is hidden is not shown.
pub fn draw_job(hidden: &[&str], random: &mut Random) -> Option<Job> {
    let travel = decimals(random.log_uniform(180.0, 1200.0), 0);
    let from = random.pick(&[0.0, 0.0, -0.5 * travel, 20.0]);
    let lead = random.pick(&[5.0, 10.0, 10.0, 20.0]);
    let (count, runs) = (random.whole(8, 15), random.pick(&[3, 5, 5]));
    let last = (count - 1) as f64;
    let room = 0.4 * travel / last;
    let target = |(k, shift): (usize, f64)| decimals(from + (travel - room) * k as f64 / last + shift, 2);
    let shifts: Vec<f64> = (0..count).map(|_| random.uniform(0.0, room)).collect();
    let targets: Vec<f64> = shifts.into_iter().enumerate().map(target).collect();
    // Minutes from one reading to the next: a test lasts half an hour to two hours.
    let reading = decimals(random.uniform(30.0, 120.0) / (2 * runs * count) as f64, 3);
    let mut rows = Vec::new();
    for run in 1..=runs {
        let there = targets.iter().map(|x| (*x, false));
        for (x, backward) in there.chain(targets.iter().rev().map(|x| (*x, true))) {
            let time = decimals(reading * (rows.len() + 1) as f64, 3);
            rows.push(Row { run, x, backward, time, pull: 0.0, change: 0.0 });
        }
    }
    let noise = if hidden.contains(&"thermal-growth") {
        // Runs that drift are no repeats.
        NoiseKind::Column
    } else {
        random.pick(&[NoiseKind::Column, NoiseKind::Column, NoiseKind::Repeats, NoiseKind::Neither])
    };
    let own_clock = hidden.contains(&"thermal-growth") || noise == NoiseKind::Column && random.chance(0.4);
    if !own_clock {
        rows.iter_mut().for_each(|row| row.time = 0.0);
    }
    Some(Job {
        travel,
        from,
        lead,
        diameter: decimals(random.uniform(20.0, 50.0), 0),
        fixed_at: from - decimals(random.uniform(10.0, 120.0), 0),
        rows,
        own_clock,
        noise,
        shown: shown(hidden, random),
        set_up: SetUp::default(),
    })
}

/// Some things are known roughly.
fn shown(hidden: &[&str], random: &mut Random) -> Vec<Shown> {
    let mut shown = Vec::new();
    let mut offer = |effect, parameter, (low, high), chance| {
        let written = figures(random.uniform(low, high), 3);
        if random.chance(chance) && !hidden.contains(&effect) {
            shown.push(Shown { effect, parameter, written, std: figures(0.15 * written, 3) });
        }
    };
    offer("scale-error", "slope", (10.0, 40.0), 0.4);
    offer("backlash", "gap", (3.0, 15.0), 0.3);
    shown
}
