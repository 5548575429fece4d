//! The measurements of the story in `models/story`: a batch of shafts from a machine that its owner
//! believes to be rigid.

use super::design::STEEL;
use super::job::{Holding, Job, Row};
use super::set_up::SetUp;
use super::shaft::{Segment, Shaft};
use super::writing;
use crate::job::{Job as _, NoiseKind};
use crate::law::Cause;
use crate::random::Random;

/// Noise of the micrometer, um.
pub const SIGMA: f64 = 1.0;

/// What the machine really does.
pub fn causes() -> Vec<Cause> {
    vec![
        Cause { effect: "headstock-compliance", parameters: vec![("stiffness", 42.0)] },
        Cause { effect: "tool-wear", parameters: vec![("run_in", 2.5), ("run_in_path", 350.0), ("rate", 6.0)] },
        Cause { effect: "guideway-wear", parameters: vec![("depth", 5.0), ("centre", 210.0), ("width", 45.0)] },
    ]
}

/// Twelve shafts of 500 mm between centres, in turn with whole, half and a quarter of the force, each
/// measured at nine places.
pub fn job() -> Job {
    let segments = vec![Segment { length: 500.0, diameter: 50.0, ..Segment::default() }];
    let row = |part: usize, i: usize| {
        let force = [450.0, 225.0, 112.0][(part - 1) % 3];
        Row { part, x: 20.0 + 57.5 * i as f64, force, ..Row::default() }
    };
    Job {
        shaft: Shaft { material: STEEL, segments, shear: true },
        holding: Holding::Centres,
        depth: 0.5,
        feed: 0.2,
        speed: 600.0,
        force: 450.0,
        forward: false,
        parts: 12,
        cycle: 6.0,
        pauses: vec![(6, 30.0)],
        rows: (1..=12).flat_map(|part| (0..9).map(move |i| row(part, i))).collect(),
        force_column: true,
        noise: NoiseKind::Column,
        shown: Vec::new(),
        survey: None,
        set_up: SetUp::default(),
    }
}

/// The measurement file.
pub fn measured() -> String {
    let job = job();
    let mut random = Random::new("story", 1);
    let observed: Vec<f64> = job.predict(&causes()).iter().map(|e| e + SIGMA * random.normal()).collect();
    let rows = writing::data(&job, &observed, SIGMA);
    format!("# Twelve shafts, each measured at nine places; turned with 450, 225 and 112 N in turn.\n{rows}")
}
