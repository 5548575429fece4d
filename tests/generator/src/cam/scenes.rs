//! Small batches in which any two effects may meet: short blocks and long ones, both ways round, at two speeds, a
//! small wheel and a large one.

use super::profile::Profile;
use super::{Before, Job, Pass, Row};
use crate::job::{Job as _, NoiseKind, Shown};
use crate::random::{Random, decimals};

/// Their names.
pub const NAMES: &[&str] =
    &["short blocks", "long blocks", "small wheel", "large wheel, fast", "after a pass of long blocks"];

const fn known(effect: &'static str, parameter: &'static str, written: f64) -> Shown {
    Shown { effect, parameter, written, std: 0.1 }
}

/// What is in the model unless it is asked for; nothing in the first scene.
const COMPANY: &[Shown] = &[
    known("wheel-wear", "loss", 12.0),
    known("servo-lag", "time", 1.2),
    known("infeed-backlash", "gap", 14.0),
    known("grinding-deflection", "stiffness", 25.0),
];

/// A job of a scene; None where it does not admit an effect.
pub fn draw(scene: usize, effects: &[&'static str], random: &mut Random) -> Option<Job> {
    let base = decimals(random.uniform(14.0, 20.0), 1);
    let nose = decimals(base * random.uniform(0.45, 0.7), 1);
    let speed = [20.0, 15.0, 25.0, 45.0, 20.0][scene];
    let passes = [(speed, false), (speed, true), (2.0 * speed, false)].map(|(speed, reverse)| Pass { speed, reverse });
    // None at an end of blocks or of segments, where the envelope is bent.
    let places = (0..16).map(|i| decimals(5.3 + 22.5 * f64::from(i) + random.uniform(0.0, 3.0), 2)).collect::<Vec<_>>();
    let mut job = Job {
        profile: Profile { base, nose, lift: decimals(base - nose + random.uniform(4.0, 9.0), 1) },
        wheel: [120.0, 100.0, 45.0, 175.0, 110.0][scene],
        step: [0.4, 2.5, 1.0, 0.8, 0.6][scene],
        speed,
        cut: Some((20.0, 14.0)),
        before: (scene == 4).then_some(Before { step: 3.5, wheel: 125.0, stock: 50.0 }),
        rows: (0..passes.len()).flat_map(|pass| places.iter().map(move |angle| Row { pass, angle: *angle })).collect(),
        passes: passes.to_vec(),
        noise: NoiseKind::Neither,
        shown: if scene == 0 { Vec::new() } else { COMPANY.to_vec() },
    };
    job.shown.retain(|shown| !effects.contains(&shown.effect));
    effects.iter().all(|effect| job.admits(effect, &[])).then_some(job)
}
