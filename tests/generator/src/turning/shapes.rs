//! Structure that no effect of the catalogue can make.

use super::job::Job;
use crate::random::Random;
use std::f64::consts::TAU;

/// Names of the shapes, for the truth.
const SHAPES: &[&str] = &[
    "ripple along x",
    "step between parts",
    "odd and even parts differ",
    "one bad part",
    "lobe along x that shifts with the part",
    "sawtooth along the part number",
    "ripple along x that alternates with the part",
    "every part has an offset of its own",
    "step along x",
];

/// A shape of size about one at every row, with its name.
pub fn draw_shape(job: &Job, random: &mut Random) -> (&'static str, Vec<f64>) {
    let (length, parts) = (job.shaft.length(), job.parts as f64);
    let name = random.pick(SHAPES);
    let periods = random.uniform(2.0, 4.0);
    let phase = random.uniform(0.0, TAU);
    let at = random.uniform(0.3, 0.7);
    let shift = random.sign() * random.uniform(0.6, 1.6);
    let teeth = random.pick(&[4, 5]);
    let own: Vec<f64> = (0..=job.parts).map(|_| random.normal()).collect();
    let bad = random.whole(2, job.parts - 1);
    let shape = |part: usize, share: f64| {
        let wave = (TAU * periods * share + phase).sin();
        let alternate = if part.is_multiple_of(2) { -1.0 } else { 1.0 };
        match name {
            "ripple along x" => wave,
            "step between parts" => f64::from(part as f64 > at * parts),
            "odd and even parts differ" => alternate,
            "one bad part" => f64::from(part == bad),
            "lobe along x that shifts with the part" => {
                (0.5 * TAU * periods * share + shift * part as f64 + phase).sin()
            }
            "sawtooth along the part number" => (part % teeth) as f64 / teeth as f64,
            "ripple along x that alternates with the part" => alternate * wave,
            "every part has an offset of its own" => own[part],
            _ => f64::from(share > at),
        }
    };
    (name, job.rows.iter().map(|r| shape(r.part, r.x / length)).collect())
}
