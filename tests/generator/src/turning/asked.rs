//! Further shafts that are turned on the same lathe.

use super::job::{Job, Row};
use crate::asked::Asked;
use crate::random::decimals;

/// The lathe with these rows in the place of its own. Parts beyond the batch are turned after it; before a part with a
/// time of its own the machine rests until then. None where rows ask for another feed, speed or depth.
pub fn asked(job: &Job, rows: &[Asked]) -> Option<Job> {
    let other =
        |row: &Asked| ["feed", "spindle_speed", "depth", "path"].iter().any(|key| row.number(key, 1.0).is_some());
    if rows.iter().any(other) {
        return None;
    }
    let mut next = Job { rows: Vec::new(), ..job.clone() };
    for row in rows {
        if let Some(time) = row.number("time", 1.0 / 60.0) {
            let (part, x) = (row.number("part", 1.0)? as usize, row.number("x", 1e3)?);
            let rested = time - next.start(part) - next.before_last() - next.into_cut(decimals(x, 1));
            // The first row of the part makes the machine rest, and the others find it so.
            if rested > 1.0 {
                next.pauses.push((part - 1, decimals(rested, 1)));
            }
        }
    }
    next.force_column |= rows.iter().any(|row| row.number("radial_force", 1.0).is_some());
    next.rows = rows.iter().map(|row| measured(job, row)).collect::<Option<_>>()?;
    next.parts = next.rows.iter().map(|row| row.part).fold(next.parts, usize::max);
    Some(next)
}

/// A row of a part.
fn measured(job: &Job, row: &Asked) -> Option<Row> {
    Some(Row {
        part: row.number("part", 1.0)? as usize,
        x: decimals(row.number("x", 1e3)?, 4),
        force: decimals(row.number("radial_force", 1.0).unwrap_or(job.force), 1),
        blank: row.number("blank", 1e3).map(|blank| decimals(blank, 4)),
        radius_change: row.number("radius_change", 1e6).unwrap_or(0.0),
        ..Row::default()
    })
}
