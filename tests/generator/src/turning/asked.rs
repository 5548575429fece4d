//! Further shafts that are turned on the same lathe.

use super::job::{Job, Row};
use crate::asked::Asked;
use crate::random::decimals;

/// The lathe with these rows in the place of its own. Another time is a rest after the batch and one part more, a
/// further path more parts: tool and headstock go on from where they were. None where rows ask for another feed,
/// speed or depth.
pub fn asked(job: &Job, rows: &[Asked]) -> Option<Job> {
    let other = |row: &Asked| ["feed", "spindle_speed", "depth"].iter().any(|key| row.number(key, 1.0).is_some());
    if rows.iter().any(other) {
        return None;
    }
    let mut next = Job { rows: Vec::new(), ..job.clone() };
    let first = rows.first()?;
    let mut instead = None;
    if let Some(time) = first.number("time", 1.0 / 60.0) {
        let rested = time - job.start(job.parts) - job.cutting_time();
        next.pauses.push((job.parts, decimals(rested.max(0.0), 1)));
        next.parts += 1;
        instead = Some(next.parts);
    } else if let Some(path) = first.number("path", 1.0) {
        let from = if job.forward { job.shaft.length() } else { 0.0 };
        next.parts = (path / job.path(1, from)).ceil() as usize;
        instead = Some(next.parts);
    }
    next.force_column |= rows.iter().any(|row| row.number("radial_force", 1.0).is_some());
    next.rows = rows.iter().map(|row| measured(job, row, instead)).collect::<Option<_>>()?;
    next.parts = next.rows.iter().map(|row| row.part).fold(next.parts, usize::max);
    Some(next)
}

/// A row, on another part where there is one.
fn measured(job: &Job, row: &Asked, instead: Option<usize>) -> Option<Row> {
    Some(Row {
        part: instead.or(row.number("part", 1.0).map(|part| part as usize))?,
        x: decimals(row.number("x", 1e3)?, 1),
        force: decimals(row.number("radial_force", 1.0).unwrap_or(job.force), 1),
        blank: row.number("blank", 1e3).map(|blank| decimals(blank, 4)),
        ..Row::default()
    })
}
