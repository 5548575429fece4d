//! Small tests in which any two effects may meet: the bearing beyond either end of the travel or inside it, two
//! bearings, a friction that is not the same all along, a nut of two halves, a warm screw.

use super::{Job, Row, SetUp};
use crate::job::{Job as _, NoiseKind, Shown};
use crate::preload::Side;
use crate::random::{Random, decimals};

/// Their names.
pub const NAMES: &[&str] = &[
    "fixed before the travel",
    "fixed inside the travel",
    "fixed beyond the travel",
    "two bearings",
    "uneven friction",
    "a nut of two halves",
    "a warm screw",
];

const fn known(effect: &'static str, parameter: &'static str, written: f64) -> Shown {
    Shown { effect, parameter, written, std: 0.1 }
}

/// What is in the model unless it is asked for; nothing in the first scene.
const COMPANY: &[Shown] = &[
    known("elastic-lost-motion", "friction", 700.0),
    known("elastic-lost-motion", "stiffness", 180.0),
    known("backlash", "gap", 7.0),
];

/// A job of a scene; None where it does not admit an effect.
pub fn draw(scene: usize, effects: &[&'static str], random: &mut Random) -> Option<Job> {
    let travel = decimals(random.uniform(300.0, 900.0), 0);
    let from = [0.0, -120.0, 40.0, 0.0, -50.0, 0.0, 25.0][scene];
    let end = from + travel;
    let fixed_at = match scene {
        1 => from + decimals(random.uniform(0.2, 0.8) * travel, 0),
        2 => end + 60.0,
        _ => from - 45.0,
    };
    let mut set_up = SetUp::default();
    match scene {
        3 => set_up.also_fixed_at = Some(end + 30.0),
        4 => set_up.drag = vec![(from - 10.0, 300.0), (from + decimals(0.4 * travel, 0), 500.0), (end + 20.0, 900.0)],
        5 => {
            let side = Side { stiffness: Some(260.0), contact: Some((0.15, 0.5)) };
            set_up.nut = Some((side, 1200.0));
        }
        6 => set_up.temperature = Some(27.5),
        _ => {}
    }
    let target = |k: i32| decimals(from + travel * (0.03 + 0.13 * f64::from(k)) + 1.37 * f64::from(k % 3), 2);
    let mut rows = Vec::new();
    for run in 1..=2 {
        for (k, backward) in (0..8).map(|k| (k, false)).chain((0..8).rev().map(|k| (k, true))) {
            rows.push(Row { run, x: target(k), backward, time: 1.5 * (rows.len() + 1) as f64, pull: 0.0, change: 0.0 });
        }
    }
    let mut job = Job {
        travel,
        from,
        lead: 10.0,
        diameter: 32.0,
        fixed_at,
        rows,
        own_clock: true,
        noise: NoiseKind::Neither,
        shown: if scene == 0 { Vec::new() } else { COMPANY.to_vec() },
        set_up,
    };
    job.shown.retain(|shown| !effects.contains(&shown.effect));
    effects.iter().all(|effect| job.admits(effect, &[])).then_some(job)
}
