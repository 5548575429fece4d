//! Draws the jobs: rods, sources, sensors and times.

use super::job::{Job, Row, Seen, SetUp};
use crate::job::{Job as _, NoiseKind, Shown};
use crate::random::{Random, decimals, figures};

/// A job that admits all of `hidden`; what is hidden is not shown.
pub fn draw_job(hidden: &[&str], random: &mut Random) -> Option<Job> {
    let mut job = rod(random);
    job.shown = shown(hidden, random);
    let every = random.pick(&[4.0, 5.0, 5.0, 8.0]);
    let copies = if job.noise == NoiseKind::Repeats { 2 } else { 1 };
    let both = random.pick(&[(true, true), (true, true), (true, true), (true, false), (false, true)]);
    let lag = hidden.contains(&"sensor-lag");
    let (temperatures, elongations) = (both.0 || lag, both.1);
    for k in 1..=(job.end / every) as usize {
        let row = |seen| Row { change: 0.0, time: decimals(every * k as f64, 2), seen };
        let sensors = (0..job.sensors.len()).filter(|_| temperatures).map(|s| row(Seen::Temperature(s)));
        for row in sensors.chain(elongations.then(|| row(Seen::Elongation))) {
            job.rows.extend(std::iter::repeat_n(row, copies));
        }
    }
    // What drifts around is felt through what is shown or hidden with it.
    let others: Vec<&str> = hidden.iter().copied().chain(job.shown.iter().map(|s| s.effect)).collect();
    let felt = others.iter().any(|e| ["convection", "base-conductance"].contains(e));
    let fits = hidden.iter().all(|e| if *e == "ambient-drift" { felt } else { job.admits(e, &[]) });
    (fits && (40..=420).contains(&job.rows.len())).then_some(job)
}

fn rod(random: &mut Random) -> Job {
    let length = decimals(random.uniform(120.0, 320.0), 0);
    let diameter = decimals(random.uniform(14.0, 42.0), 1);
    let mut segments = vec![(length, diameter)];
    if random.chance(0.35) {
        let first = decimals(length * random.uniform(0.3, 0.7), 0);
        segments = vec![(first, decimals(diameter * random.uniform(1.1, 1.5), 1)), (length - first, diameter)];
    }
    let end = random.pick(&[120.0, 160.0, 200.0, 240.0]);
    // As much power as warms the rod by so many kelvin while it is on, were it to keep its heat.
    let (on, rise) = (decimals(end * random.uniform(0.3, 0.6), 0), random.uniform(8.0, 30.0));
    let volume: f64 = segments.iter().map(|s| s.0 * 0.25 * std::f64::consts::PI * s.1 * s.1).sum();
    let power = figures(7850.0 * 470.0 * volume * 1e-9 * rise / (60.0 * on), 3);
    let at = if random.chance(0.7) { length } else { decimals(length * random.uniform(0.4, 0.9), 0) };
    let places = random.pick::<&[f64]>(&[&[0.2, 0.6, 0.95], &[0.1, 0.5, 0.9], &[0.15, 0.4, 0.7, 0.9], &[0.3, 0.8]]);
    Job {
        segments,
        source: (at, power, 0.0, on),
        ambient: decimals(random.uniform(17.0, 24.0), 1),
        end,
        sensors: places.iter().map(|p| decimals(p * length, 0)).collect(),
        rows: Vec::new(),
        kelvin: random.pick(&[0.02, 0.05, 0.05, 0.1]),
        noise: random.pick(&[NoiseKind::Column, NoiseKind::Column, NoiseKind::Repeats, NoiseKind::Neither]),
        shown: Vec::new(),
        set_up: SetUp::default(),
    }
}

/// Losses are often known roughly.
fn shown(hidden: &[&str], random: &mut Random) -> Vec<Shown> {
    let mut shown = Vec::new();
    let mut offer = |effect, parameter, (low, high), chance| {
        let written = figures(random.uniform(low, high), 3);
        if random.chance(chance) && !hidden.contains(&effect) {
            shown.push(Shown { effect, parameter, written, std: figures(0.15 * written, 3) });
        }
    };
    offer("convection", "coefficient", (8.0, 25.0), 0.65);
    offer("base-conductance", "conductance", (0.05, 0.3), 0.2);
    shown
}
