//! A whole machine in whose batch somebody has corrected the tool's offset and not written it down.

use super::design::STEEL;
use super::job::{Holding, Job, Row};
use super::set_up::SetUp;
use super::shaft::{Segment, Shaft};
use super::writing;
use crate::job::{Job as _, NoiseKind, Shown};
use crate::law::Cause;
use crate::random::Random;

/// Noise of the micrometer, um.
const SIGMA: f64 = 0.8;
/// The part after which the offset was corrected, and by how much of the diameter (um).
pub const CORRECTION: (usize, f64) = (6, -10.0);

/// What the model knows: springs, measured before, and guideways.
const KNOWN: [Shown; 4] = [
    Shown { effect: "headstock-compliance", parameter: "stiffness", written: 55.0, std: 5.0 },
    Shown { effect: "tailstock-compliance", parameter: "stiffness", written: 38.0, std: 4.0 },
    Shown { effect: "carriage-compliance", parameter: "stiffness", written: 60.0, std: 6.0 },
    Shown { effect: "guideway-taper", parameter: "slope", written: 20.0, std: 4.0 },
];

/// What it does not know: the edge wears, and the correction.
fn hidden() -> Vec<Cause> {
    let (after, diameter) = CORRECTION;
    vec![
        Cause { effect: "tool-wear", parameters: vec![("run_in", 2.0), ("run_in_path", 400.0), ("rate", 6.0)] },
        Cause { effect: "offset-correction", parameters: vec![("after", after as f64), ("diameter", diameter)] },
    ]
}

/// Twelve shafts of 450 mm between centres at one force, a pause after the fourth, each measured at nine places.
fn job() -> Job {
    let segments = vec![Segment { length: 450.0, diameter: 45.0, ..Segment::default() }];
    let row = |part: usize, i: usize| Row { part, x: 20.0 + 51.0 * i as f64, force: 400.0, ..Row::default() };
    Job {
        shaft: Shaft { material: STEEL, segments, shear: true },
        holding: Holding::Centres,
        depth: 0.5,
        feed: 0.2,
        speed: 600.0,
        force: 400.0,
        forward: false,
        parts: 12,
        cycle: 6.0,
        pauses: vec![(4, 30.0)],
        rows: (1..=12).flat_map(|part| (0..9).map(move |i| row(part, i))).collect(),
        force_column: false,
        noise: NoiseKind::Column,
        shown: KNOWN.to_vec(),
        survey: None,
        set_up: SetUp::default(),
    }
}

/// Model and measurements, with a noise of their own for each seed. The springs are what the model says.
pub fn files(seed: u64) -> (String, String) {
    let job = job();
    let known: Vec<f64> = KNOWN.iter().map(|shown| shown.written).collect();
    let causes = [job.causes(&known), hidden()].concat();
    let mut random = Random::new("corrected", seed);
    let observed: Vec<f64> = job.predict(&causes).iter().map(|e| e + SIGMA * random.normal()).collect();
    (crate::writing::model(&job, None, &[]), writing::data(&job, &observed, SIGMA))
}
