//! Further laps round the same circle.

use super::{Job, Row};
use crate::asked::Asked;
use crate::random::{decimals, figures};

/// Size of one metre per second, mm/min.
const FEED: f64 = 6e4;

/// The axes with these readings in the place of their own.
pub fn asked(job: &Job, rows: &[Asked]) -> Option<Job> {
    let one = |row: &Asked| {
        Some(Row {
            lap: 0,
            clockwise: row.is("direction", "cw"),
            feed: figures(row.number("feed", FEED).unwrap_or(job.feed), 9),
            angle: decimals(row.number("angle", 1.0)?.to_degrees(), 4) % 360.0,
        })
    };
    Some(Job { rows: rows.iter().map(one).collect::<Option<_>>()?, ..job.clone() })
}
