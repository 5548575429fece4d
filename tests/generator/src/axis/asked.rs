//! Further readings of the same axis.

use super::{Job, Row};
use crate::asked::Asked;
use crate::random::decimals;

/// The axis with these readings in the place of its own.
pub fn asked(job: &Job, rows: &[Asked]) -> Option<Job> {
    let one = |row: &Asked| {
        Some(Row {
            run: row.number("run", 1.0).unwrap_or(1.0) as usize,
            x: decimals(row.number("position", 1e3)?, 4),
            backward: row.is("direction", "-"),
            time: decimals(row.number("time", 1.0 / 60.0).unwrap_or(0.0), 4),
            change: row.number("change", 1e6).unwrap_or(0.0),
            pull: decimals(row.number("pull", 1.0).unwrap_or(0.0), 1),
        })
    };
    let rows: Vec<Row> = rows.iter().map(one).collect::<Option<_>>()?;
    let own_clock = job.own_clock || rows.iter().any(|row| row.time > 0.0);
    Some(Job { rows, own_clock, ..job.clone() })
}
