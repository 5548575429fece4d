//! Draws the jobs: tables, tilting axes and joints with their positioning tests.

use super::{Job, Ring, Row};
use crate::job::{Job as _, NoiseKind, Shown};
use crate::random::{Random, decimals, figures};

/// Effects that only a worm has, and only gears.
const OF_WORMS: &[&str] = &["worm-error", "worm-second-harmonic"];
const OF_GEARS: &[&str] = &["tooth-error", "gear-eccentricity", "motor-gear-eccentricity"];
/// Effects that only a torque tells from others.
const OF_TORQUES: &[&str] = &["compliance", "elastic-wind-up", "unbalance"];

/// A job that admits all of `hidden`; what is hidden is not shown.
pub fn draw_job(hidden: &[&str], random: &mut Random) -> Option<Job> {
    let has = |effects: &[&str]| hidden.iter().any(|effect| effects.contains(effect));
    let with_worm = has(OF_WORMS) || !has(OF_GEARS) && random.chance(0.6);
    let pairs = match (has(OF_GEARS), with_worm) {
        (true, true) => vec![[17, 34], [14, 42]],
        (_, false) => vec![[18, random.pick(&[54, 72])], [20, random.pick(&[60, 100])]],
        (false, true) => Vec::new(),
    };
    let worm = with_worm.then(|| [1, random.pick(&[72, 90, 120, 180])]);
    let is_part = has(&["ratio-error"]) || random.chance(0.25);
    let range = if is_part { random.pick(&[120.0, 180.0, 240.0]) } else { 360.0 };
    let from = random.pick(&[0.0, 0.0, -0.5 * range]);
    let ring = (has(&["scale-eccentricity", "scale-second-harmonic", "interpolation-error"]) || random.chance(0.3))
        .then(|| Ring {
            on_motor: false,
            closed: false,
            radius: decimals(random.uniform(40.0, 120.0), 0),
            lines: random.pick(&[1024, 3600, 9000]),
        });
    let is_rigid = has(&["compliance"]) || !has(&["unbalance"]) && random.chance(0.5);
    let rows = draw_rows(hidden, (from, range), random);
    let noise = if hidden.contains(&"thermal-drift") {
        // Runs that drift are no repeats.
        NoiseKind::Column
    } else {
        random.pick(&[NoiseKind::Column, NoiseKind::Column, NoiseKind::Repeats, NoiseKind::Neither])
    };
    let own_clock = hidden.contains(&"thermal-drift") || noise == NoiseKind::Column && random.chance(0.4);
    let mut job = Job {
        range,
        from,
        lies: has(&["unbalance"]) || random.chance(0.3),
        pairs,
        worm,
        wheel: Some(decimals(random.uniform(50.0, 160.0), 0)),
        stiffness: (!is_rigid).then(|| figures(random.log_uniform(0.8, 8.0), 2)),
        ring,
        torque: 0.0,
        rows,
        own_clock,
        noise,
        shown: shown(hidden, random),
    };
    if !own_clock {
        job.rows.iter_mut().for_each(|row| row.time = 0.0);
    }
    hidden.iter().all(|effect| job.admits(effect, &[])).then_some(job)
}

/// Runs there and back at targets that lie anywhere in their part of the range; where torques tell, some runs have one.
fn draw_rows(hidden: &[&str], (from, range): (f64, f64), random: &mut Random) -> Vec<Row> {
    let (count, runs) = (random.whole(12, 20), random.pick(&[3, 5, 5]));
    let last = (count - 1) as f64;
    let room = 0.4 * range / last;
    let shifts: Vec<f64> = (0..count).map(|_| random.uniform(0.0, room)).collect();
    let target = |(k, shift): (usize, f64)| decimals(from + (range - room) * k as f64 / last + shift, 3);
    let targets: Vec<f64> = shifts.into_iter().enumerate().map(target).collect();
    // Minutes from one reading to the next: a test lasts half an hour to two hours.
    let reading = decimals(random.uniform(30.0, 120.0) / (2 * runs * count) as f64, 3);
    let pulls = hidden.iter().any(|effect| OF_TORQUES.contains(effect));
    let pull = decimals(random.uniform(30.0, 80.0), 0);
    let mut rows = Vec::new();
    for run in 1..=runs {
        let torque = pulls.then(|| [0.0, pull, -pull][run % 3]);
        let there = targets.iter().map(|x| (*x, false));
        for (angle, backward) in there.chain(targets.iter().rev().map(|x| (*x, true))) {
            let time = decimals(reading * (rows.len() + 1) as f64, 3);
            rows.push(Row { run, angle, backward, time, torque, change: 0.0 });
        }
    }
    rows
}

/// Some things are known roughly.
fn shown(hidden: &[&str], random: &mut Random) -> Vec<Shown> {
    let written = figures(random.uniform(6.0, 30.0), 3);
    let is_shown = random.chance(0.3) && !hidden.contains(&"backlash");
    let gap = Shown { effect: "backlash", parameter: "gap", written, std: figures(0.15 * written, 3) };
    if is_shown { vec![gap] } else { Vec::new() }
}
