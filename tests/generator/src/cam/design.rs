//! Draws the jobs: cams, wheels, programmes and how they were run.

use super::profile::Profile;
use super::{Job, Pass, Row};
use crate::job::{NoiseKind, Shown};
use crate::random::{Random, decimals, figures};

/// Of all cams together.
const READINGS: (usize, usize) = (60, 300);

/// A job that admits all of `hidden`; what is hidden is not shown.
pub fn draw_job(hidden: &[&str], random: &mut Random) -> Option<Job> {
    let base = decimals(random.uniform(12.0, 22.0), 1);
    let nose = decimals(base * random.uniform(0.4, 0.8), 1);
    let speed = decimals(random.uniform(10.0, 40.0), 0);
    let noise = random.pick(&[NoiseKind::Column, NoiseKind::Column, NoiseKind::Repeats, NoiseKind::Neither]);
    let has_cut = hidden.contains(&"grinding-deflection") || random.chance(0.5);
    let mut job = Job {
        profile: Profile { base, nose, lift: decimals(base - nose + random.uniform(3.0, 12.0), 1) },
        wheel: decimals(random.uniform(60.0, 175.0), 0),
        step: decimals(random.uniform(0.5, 1.5), 2),
        speed,
        cut: has_cut.then(|| (decimals(random.uniform(10.0, 30.0), 0), decimals(random.uniform(8.0, 20.0), 0))),
        before: None,
        passes: passes(speed, random),
        rows: Vec::new(),
        noise,
        shown: shown(hidden, random),
    };
    let copies = if noise == NoiseKind::Repeats { 2 } else { 1 };
    let each = copies * job.passes.len();
    let places = random.whole(READINGS.0, READINGS.1) / each;
    for pass in 0..job.passes.len() {
        let start = random.uniform(0.0, 360.0);
        for i in 0..places {
            let angle = decimals((start + 360.0 * i as f64 / places as f64) % 360.0, 2) % 360.0;
            job.rows.extend(std::iter::repeat_n(Row { pass, angle }, copies));
        }
    }
    Some(job)
}

/// As the model says, and sometimes the other way or at another speed.
fn passes(speed: f64, random: &mut Random) -> Vec<Pass> {
    let mut passes = vec![Pass { speed, reverse: false }];
    if random.chance(0.6) {
        passes.push(Pass { speed, reverse: true });
    }
    if random.chance(0.6) {
        passes.push(Pass { speed: figures(speed * random.pick(&[0.5, 2.0]), 3), reverse: false });
    }
    passes
}

/// Some things are known roughly.
fn shown(hidden: &[&str], random: &mut Random) -> Vec<Shown> {
    let mut shown = Vec::new();
    let mut offer = |chance, effect, parameter, written, std| {
        if random.chance(chance) && !hidden.contains(&effect) {
            shown.push(Shown { effect, parameter, written, std });
        }
    };
    offer(0.4, "wheel-wear", "loss", 10.0, 3.0);
    offer(0.3, "centre-height", "height", 0.0, 30.0);
    offer(0.2, "infeed-backlash", "gap", 8.0, 2.0);
    shown
}
