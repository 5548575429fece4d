//! Further rings that are bored in the same chuck.

use super::job::{Job, Row, SetUp};
use crate::asked::Asked;
use crate::random::{decimals, figures};

/// The chuck with these rows in the place of its own; a run of a new number is a set-up more.
pub fn asked(job: &Job, rows: &[Asked]) -> Option<Job> {
    let mut next = Job { rows: Vec::new(), ..job.clone() };
    for row in rows {
        let run = row.number("run", 1.0)? as usize;
        let set_up = SetUp {
            force: figures(row.number("jaw_force", 1.0).unwrap_or(job.force), 9),
            speed: figures(row.number("spindle_speed", 60.0 / std::f64::consts::TAU).unwrap_or(job.speed), 9),
            orientation: figures(row.number("orientation", 1.0).unwrap_or(0.0).to_degrees(), 9),
            clamped: row.is("state", "clamped"),
        };
        // Runs that nobody has made are as the last.
        while next.set_ups.len() < run {
            next.set_ups.push(set_up);
        }
        next.set_ups[run - 1] = set_up;
        let angle = decimals(row.number("angle", 1.0)?.to_degrees(), 1);
        let blank = decimals(row.number("blank", 1e6).unwrap_or(0.0), 3);
        let change = row.number("change", 1e6).unwrap_or(0.0);
        next.rows.push(Row { set_up: run - 1, angle, blank, change });
    }
    Some(next)
}
