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
    let own: Vec<Row> = rows.iter().map(one).collect::<Option<_>>()?;
    let mut command = [Vec::new(), Vec::new()];
    for (row, asked) in own.iter().zip(rows) {
        if let Some(change) = asked.number("change", 1e6) {
            command[usize::from(row.clockwise)].push((row.angle, change));
        }
    }
    command.iter_mut().for_each(|table| table.sort_by(|a, b| a.0.total_cmp(&b.0)));
    Some(Job { rows: own, command, ..job.clone() })
}
