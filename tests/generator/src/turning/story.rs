//! The measurements of the story in `models/story`: a batch of shafts from a machine that its owner
//! believes to be rigid, and the same job made again with a correction.

use super::design::STEEL;
use super::job::{Holding, Job, Row};
use super::set_up::SetUp;
use super::shaft::{Segment, Shaft};
use super::writing;
use crate::job::{Job as _, NoiseKind};
use crate::law::Cause;
use crate::random::{Random, decimals};
use std::fmt::Write as _;

/// Noise of the micrometer, um.
pub const SIGMA: f64 = 1.0;
/// Length and diameter of the shafts, mm.
const LENGTH: f64 = 500.0;
const DIAMETER: f64 = 50.0;
/// Least step of an offset of the radius, um: a thousandth of a millimetre of diameter.
const STEP: f64 = 0.5;

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
    let segments = vec![Segment { length: LENGTH, diameter: DIAMETER, ..Segment::default() }];
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

/// Places (mm from the headstock) and radii (mm) of a program that cuts along straight lines: X a diameter, Z 0 at the
/// tailstock end.
///
/// # Panics
/// Where a word is no number.
fn contour(program: &str) -> Vec<(f64, f64)> {
    let (mut points, mut x, mut z) = (Vec::new(), None, None);
    for line in program.lines().filter(|line| !line.starts_with('(')) {
        for word in line.split_whitespace() {
            let number = || Some(word[1..].parse::<f64>().expect("a letter and a number"));
            match &word[..1] {
                "X" => x = number(),
                "Z" => z = number(),
                _ => {}
            }
        }
        points.extend(x.zip(z).map(|(x, z)| (LENGTH + z, 0.5 * x)));
    }
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points
}

/// Radius of the contour at a place, mm.
fn radius(contour: &[(f64, f64)], x: f64) -> f64 {
    let next = contour.partition_point(|(place, _)| *place <= x).clamp(1, contour.len() - 1);
    let ((from, a), (to, b)) = (contour[next - 1], contour[next]);
    a + (b - a) * (x - from) / (to - from)
}

/// The measurement file of the job that is made again, on the same machine with a new edge: every shaft by this program of the
/// finishing pass, with an offset of the radius (um) for each part, and with the whole force.
pub fn corrected(program: &str, offsets: &[f64]) -> String {
    let contour = contour(program);
    let mut job = job();
    for row in &mut job.rows {
        let offset = STEP * (offsets[row.part - 1] / STEP).round();
        let programmed = 1e3 * (radius(&contour, row.x) - 0.5 * DIAMETER);
        (row.force, row.radius_change) = (job.force, decimals(programmed + offset, 3));
    }
    let mut random = Random::new("story", 2);
    let errors = job.predict(&causes());
    let mut text = "# The same job made again with a new edge, by the corrected contour and an offset for each part.\n\
                    part,x [mm],radius_change [um],diameter_error [um],u [um]\n"
        .to_string();
    for (row, error) in job.rows.iter().zip(errors) {
        let observed = error + SIGMA * random.normal();
        let _ = writeln!(text, "{},{:.1},{:.3},{observed:.3},{SIGMA}", row.part, row.x, row.radius_change);
    }
    text
}
