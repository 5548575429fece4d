//! Small jobs in which any two effects may meet: thick rings and thin ones, three, four and six jaws, bored at
//! several forces, speeds and orientations, and measured clamped too.

use std::f64::consts::TAU;

use super::elastic::{compliances, step};
use super::job::{Job, Row, SetUp};
use crate::job::{Job as _, NoiseKind, Shown};
use crate::random::{Random, decimals};

/// What each is.
struct Scene {
    /// Inner radius over the outer.
    ratio: f64,
    jaws: usize,
    absolute: bool,
    /// Of the second set-up's mark, deg.
    turned: f64,
    clamped: bool,
    /// How many of the company are in the model.
    company: usize,
}

/// In their order.
const SCENES: &[Scene] = &[
    Scene { ratio: 0.7, jaws: 3, absolute: true, turned: 0.0, clamped: false, company: 0 },
    Scene { ratio: 0.9, jaws: 3, absolute: true, turned: 0.0, clamped: false, company: 1 },
    Scene { ratio: 0.84, jaws: 3, absolute: false, turned: 0.0, clamped: false, company: 3 },
    Scene { ratio: 0.84, jaws: 3, absolute: true, turned: 35.0, clamped: false, company: 3 },
    Scene { ratio: 0.84, jaws: 3, absolute: true, turned: 0.0, clamped: true, company: 3 },
    Scene { ratio: 0.8, jaws: 4, absolute: false, turned: 50.0, clamped: true, company: 2 },
    Scene { ratio: 0.88, jaws: 6, absolute: true, turned: 20.0, clamped: false, company: 3 },
];

/// Their names.
pub const NAMES: &[&str] = &[
    "thick",
    "thin, copied",
    "from the circle of least squares",
    "orientations",
    "clamped and released",
    "four jaws, clamped, from the circle of least squares",
    "six jaws, orientations",
];

/// What is in the model unless it is asked for.
const COMPANY: &[Shown] = &[
    Shown { effect: "copying", parameter: "stiffness", written: 9.0, std: 1.0 },
    Shown { effect: "jaw-contact-arc", parameter: "arc", written: 18.0, std: 2.0 },
    Shown { effect: "centrifugal-unloading", parameter: "jaw_moment", written: 40.0, std: 5.0 },
];

/// A job of a scene; None where it does not admit an effect.
pub fn draw(scene: usize, effects: &[&'static str], random: &mut Random) -> Option<Job> {
    let Scene { ratio, jaws, absolute, turned, clamped, company } = SCENES[scene];
    let outer = decimals(random.uniform(40.0, 70.0), 1);
    let inner = decimals(outer * ratio, 1);
    let (poisson, width) = (0.3, decimals(random.uniform(15.0, 25.0), 1));
    let mut job = Job {
        outer,
        inner,
        width,
        modulus: 210.0,
        poisson,
        expansion: 11.5,
        jaws,
        force: 0.0,
        speed: 700.0,
        force_per_depth: 1.6,
        absolute,
        set_ups: Vec::new(),
        rows: Vec::new(),
        noise: NoiseKind::Neither,
        shown: COMPANY[..company].to_vec(),
        compliances: compliances(inner / outer, poisson, step(jaws)),
    };
    // As much force as squeezes the bore by 15 um, and more than the jaws lose at speed.
    let unit = 2.0 * job.compliances[jaws].abs() * jaws as f64 / TAU * 1e6 / (210e9 * width * 1e-3);
    job.force = (15.0 / unit).clamp(1000.0, 9000.0).round();
    let set_up = |force: f64, speed, orientation| SetUp {
        force: decimals(job.force * force, 1),
        speed,
        orientation,
        clamped: false,
    };
    job.set_ups = vec![set_up(1.0, 700.0, 0.0), set_up(0.6, 400.0, turned), set_up(0.35, 900.0, 2.0 * turned)];
    if clamped {
        job.set_ups.push(SetUp { clamped: true, ..job.set_ups[0] });
    }
    let phase = random.uniform(0.0, TAU);
    for set_up in 0..job.set_ups.len() {
        for i in 0..12 {
            let angle = 30.0 * f64::from(i) + 7.0 + 4.0 * set_up as f64;
            let turn = angle.to_radians();
            let blank =
                40.0 * (2.0 * turn - phase).cos() + 20.0 * (turn + phase).cos() - 12.0 * (5.0 * turn).sin() + 6.0;
            job.rows.push(Row { change: 0.0, set_up, angle, blank: decimals(blank, 3) });
        }
    }
    job.shown.retain(|shown| !effects.contains(&shown.effect));
    effects.iter().all(|effect| job.admits(effect, &[])).then_some(job)
}
