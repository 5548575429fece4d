//! Draws the jobs: rings, chucks, set-ups and measuring designs, as varied as a workshop's.

use std::f64::consts::TAU;

use super::elastic::{compliances, step};
use super::job::{Job, Row, SetUp};
use crate::job::{Job as _, NoiseKind, Shown};
use crate::random::{Random, decimals, figures};

/// Modulus (GPa), Poisson's ratio, expansion (1e-6/K).
const MATERIALS: &[(f64, f64, f64)] =
    &[(210.0, 0.3, 11.5), (210.0, 0.3, 11.5), (70.0, 0.33, 23.5), (110.0, 0.26, 10.5)];

/// A job that admits all of `hidden`; what is hidden is not shown.
pub fn draw_job(hidden: &[&str], random: &mut Random) -> Option<Job> {
    let mut job = ring(hidden, random);
    set_ups(&mut job, random);
    let places = random.pick(&[24usize, 36, 36, 48]);
    let blanks = random.chance(0.85) || hidden.contains(&"copying");
    let copies = if job.noise == NoiseKind::Repeats { 2 } else { 1 };
    for set_up in 0..job.set_ups.len() {
        let waves: Vec<(f64, f64, f64)> = [1.0, 2.0, 2.0, 3.0, 5.0]
            .map(|lobes| (lobes, random.uniform(3.0, 25.0), random.uniform(0.0, TAU)))
            .to_vec();
        for i in 0..places {
            let angle = decimals(360.0 * i as f64 / places as f64, 1);
            let blank: f64 = waves.iter().map(|(m, a, p)| a * (m * angle.to_radians() - p).cos()).sum();
            let row = Row { change: 0.0, set_up, angle, blank: if blanks { decimals(blank, 3) } else { 0.0 } };
            job.rows.extend(std::iter::repeat_n(row, copies));
        }
    }
    job.shown = shown(hidden, random);
    hidden.iter().all(|effect| job.admits(effect, &[])).then_some(job)
}

fn ring(hidden: &[&str], random: &mut Random) -> Job {
    let (modulus, poisson, expansion) = random.pick(MATERIALS);
    let outer = decimals(random.uniform(35.0, 85.0), 1);
    let inner = decimals(outer * random.uniform(0.76, 0.92), 1);
    let jaws = match () {
        () if hidden.contains(&"jaw-position") => 3,
        () if hidden.contains(&"jaw-imbalance") => random.pick(&[4, 4, 4, 6]),
        () => random.pick(&[3, 3, 3, 3, 4, 6]),
    };
    let mut job = Job {
        outer,
        inner,
        width: decimals(random.uniform(10.0, 30.0), 1),
        modulus,
        poisson,
        expansion,
        jaws,
        force: 0.0,
        speed: random.uniform(250.0, 900.0).round(),
        force_per_depth: decimals(random.uniform(0.5, 2.0), 2),
        absolute: ["cutting-heat", "chuck-runout"].iter().any(|effect| hidden.contains(effect)) || random.chance(0.65),
        set_ups: Vec::new(),
        rows: Vec::new(),
        noise: random.pick(&[NoiseKind::Column, NoiseKind::Column, NoiseKind::Repeats, NoiseKind::Neither]),
        shown: Vec::new(),
        compliances: compliances(inner / outer, poisson, step(jaws)),
    };
    // As much force as squeezes the bore by so many um.
    let unit = 2.0 * job.compliances[jaws].abs() * jaws as f64 / TAU * 1e6 / (modulus * 1e9 * job.width * 1e-3);
    job.force = (random.uniform(4.0, 40.0) / unit).clamp(300.0, 8000.0).round();
    job
}

/// Three or four set-ups: other forces, speeds and orientations, now and then one measured clamped.
fn set_ups(job: &mut Job, random: &mut Random) {
    let forces: &[f64] =
        random.pick::<&[f64]>(&[&[1.0, 1.0, 1.0], &[1.0, 0.5, 1.0], &[1.0, 0.6, 0.3], &[1.0, 1.0, 0.5, 0.5]]);
    let speeds: &[f64] = random.pick::<&[f64]>(&[&[1.0], &[1.0, 1.0, 0.5], &[1.0, 0.5], &[1.0, 1.5, 0.5, 1.0]]);
    let turns: &[f64] = random.pick::<&[f64]>(&[&[0.0], &[0.0], &[0.0, 45.0, 90.0], &[0.0, 30.0, 0.0, 70.0]]);
    for k in 0..forces.len() {
        job.set_ups.push(SetUp {
            force: decimals(job.force * forces[k], 1),
            speed: (job.speed * speeds[k % speeds.len()]).round(),
            orientation: turns[k % turns.len()],
            clamped: false,
        });
    }
    if random.chance(0.3) {
        job.set_ups.push(SetUp { force: job.force, speed: job.speed, orientation: 0.0, clamped: true });
    }
}

/// The contact arc and the jaws' moment are often known roughly.
fn shown(hidden: &[&str], random: &mut Random) -> Vec<Shown> {
    let mut shown = Vec::new();
    let mut offer = |effect, parameter, (low, high), part: f64| {
        let written = figures(random.uniform(low, high), 3);
        if random.chance(0.45) && !hidden.contains(&effect) {
            shown.push(Shown { effect, parameter, written, std: figures(part * written, 3) });
        }
    };
    offer("jaw-contact-arc", "arc", (10.0, 30.0), 0.12);
    offer("centrifugal-unloading", "jaw_moment", (15.0, 60.0), 0.15);
    shown
}
