//! Draws the jobs: joints and the forces under which they are read.

use super::{Job, Loading, Row};
use crate::job::{NoiseKind, Shown};
use crate::random::{Random, figures};

/// A job that admits all of `hidden`; what is hidden is not shown.
pub fn draw_job(hidden: &[&str], random: &mut Random) -> Option<Job> {
    let max_force = figures(random.log_uniform(600.0, 3000.0), 2);
    let steps = random.whole(14, 36);
    let noise = random.pick(&[NoiseKind::Column, NoiseKind::Column, NoiseKind::Repeats, NoiseKind::Neither]);
    let copies = if noise == NoiseKind::Repeats { 2 } else { 1 };
    // Without a reading under no force clearance and a gauge that is off are one.
    let first = usize::from(!hidden.iter().any(|e| ["gap", "datum-offset"].contains(e)) && random.chance(0.3));
    let forces = (first..=steps).map(|i| max_force * i as f64 / steps as f64);
    let up: Vec<f64> = forces.flat_map(|force| std::iter::repeat_n(force, copies)).collect();
    let row = |unload: bool| move |force: &f64| Row { force: *force, unload };
    let mut rows: Vec<Row> = up.iter().map(row(false)).collect();
    rows.extend(up.iter().rev().map(row(true)));
    Some(Job {
        stiffness: figures(random.uniform(40.0, 160.0), 3),
        max_force,
        loading: Loading::FromZero,
        rows,
        noise,
        shown: shown(hidden, random),
    })
}

/// Friction is often known roughly.
fn shown(hidden: &[&str], random: &mut Random) -> Vec<Shown> {
    let written = figures(random.uniform(20.0, 90.0), 3);
    if !random.chance(0.35) || hidden.contains(&"dry-friction") {
        return Vec::new();
    }
    vec![Shown { effect: "dry-friction", parameter: "force", written, std: figures(0.1 * written, 3) }]
}
