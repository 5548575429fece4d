//! Further cams that are ground on the same machine.

use std::f64::consts::TAU;

use super::{Job, Pass, Row};
use crate::asked::Asked;
use crate::random::{decimals, figures};

/// The grinder with these readings in the place of its own.
pub fn asked(job: &Job, rows: &[Asked]) -> Option<Job> {
    let mut next = Job { passes: Vec::new(), rows: Vec::new(), ..job.clone() };
    for row in rows {
        let speed = figures(row.number("cam_speed", 60.0 / TAU).unwrap_or(job.speed), 9);
        let pass = Pass { speed, reverse: row.is("direction", "reverse") };
        let number = next.passes.iter().position(|own| *own == pass).unwrap_or(next.passes.len());
        if number == next.passes.len() {
            next.passes.push(pass);
        }
        next.rows.push(Row { pass: number, angle: decimals(row.number("angle", 1.0)?.to_degrees(), 4) % 360.0 });
    }
    Some(next)
}
