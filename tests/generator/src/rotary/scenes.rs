//! Small tests in which any two effects may meet: a table on a worm, a worm behind gears, a train, a direct drive; standing
//! and lying, rigid and yielding, with a scale on the table, on the motor or in the loop.

use super::{Job, Ring, Row};
use crate::job::{Job as _, NoiseKind, Shown};
use crate::random::{Random, decimals};

/// Their names.
pub const NAMES: &[&str] = &[
    "a table on a worm",
    "a worm behind gears that lies",
    "a train that yields",
    "a loop over the table",
    "a direct drive that lies",
    "a worm of two starts under a torque",
];

const fn known(effect: &'static str, parameter: &'static str, written: f64) -> Shown {
    Shown { effect, parameter, written, std: 0.1 }
}

/// What is in the model unless it is asked for; nothing in the first scene.
const COMPANY: &[Shown] = &[
    known("elastic-wind-up", "friction", 6.0),
    known("elastic-wind-up", "stiffness", 2.5),
    known("backlash", "gap", 14.0),
];

/// A job of a scene; None where it does not admit an effect.
pub fn draw(scene: usize, effects: &[&'static str], random: &mut Random) -> Option<Job> {
    let ring = Ring { on_motor: false, closed: false, radius: 70.0, lines: 1000 };
    let plain = Job {
        range: 360.0,
        from: 0.0,
        lies: false,
        pairs: Vec::new(),
        worm: Some([1, 180]),
        wheel: Some(decimals(random.uniform(60.0, 150.0), 0)),
        stiffness: None,
        ring: None,
        torque: 0.0,
        rows: Vec::new(),
        own_clock: true,
        noise: NoiseKind::Neither,
        shown: if scene == 0 { Vec::new() } else { COMPANY.to_vec() },
    };
    let mut job = match scene {
        0 => plain,
        // Whatever there is may act here.
        1 => Job {
            range: 210.0,
            from: -60.0,
            lies: true,
            pairs: vec![[17, 51], [12, 47]],
            worm: Some([1, 90]),
            ring: Some(ring),
            ..plain
        },
        2 => Job {
            range: 300.0,
            lies: true,
            pairs: vec![[15, 60], [18, 54], [20, 100]],
            worm: None,
            stiffness: Some(1.6),
            ring: Some(Ring { on_motor: true, lines: 500, ..ring }),
            ..plain
        },
        3 => Job { ring: Some(Ring { closed: true, ..ring }), stiffness: Some(4.0), ..plain },
        4 => Job { range: 720.0, lies: true, worm: None, wheel: None, ring: Some(ring), ..plain },
        _ => Job { worm: Some([2, 60]), stiffness: Some(3.0), torque: -4.0, from: -180.0, ..plain },
    };
    let target = |k: i32| decimals(job.from + job.range * (0.03 + 0.12 * f64::from(k)) + 0.137 * f64::from(k % 3), 3);
    let mut rows = Vec::new();
    for run in 1..=2 {
        for (k, backward) in (0..8).map(|k| (k, false)).chain((0..8).rev().map(|k| (k, true))) {
            let time = 1.5 * (rows.len() + 1) as f64;
            // Pulled to either side in the second run, by less than friction and by more.
            let torque = (run == 2).then(|| [4.0, -4.0, 25.0, -25.0][k as usize % 4]);
            let torque = torque.or((scene != 5).then_some(0.0));
            rows.push(Row { run, angle: target(k), backward, time, torque, change: 0.0 });
        }
    }
    job.rows = rows;
    let asked = |shown: &Shown| effects.contains(&shown.effect);
    let company: Vec<Shown> = job.shown.iter().filter(|s| !asked(s) && job.admits(s.effect, &[])).copied().collect();
    job.shown = company;
    effects.iter().all(|effect| job.admits(effect, &[])).then_some(job)
}
