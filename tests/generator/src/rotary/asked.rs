//! Further readings of the same axis.

use super::{ARCSEC, Job, Row};
use crate::asked::Asked;
use crate::random::decimals;

/// The axis with these readings in the place of its own.
pub fn asked(job: &Job, rows: &[Asked]) -> Option<Job> {
    let one = |row: &Asked| {
        Some(Row {
            run: row.number("run", 1.0).unwrap_or(1.0) as usize,
            angle: decimals(row.number("angle", 1.0)?.to_degrees(), 6),
            backward: row.is("direction", "-"),
            time: decimals(row.number("time", 1.0 / 60.0).unwrap_or(0.0), 4),
            change: row.number("change", ARCSEC).unwrap_or(0.0),
            torque: row.number("torque", 1.0).map(|torque| decimals(torque, 2)),
        })
    };
    let rows: Vec<Row> = rows.iter().map(one).collect::<Option<_>>()?;
    let own_clock = job.own_clock || rows.iter().any(|row| row.time > 0.0);
    Some(Job { rows, own_clock, ..job.clone() })
}
