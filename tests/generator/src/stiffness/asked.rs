//! Further readings of the same joint.

use super::{Job, Row};
use crate::asked::Asked;
use crate::random::figures;

/// The joint with these readings in the place of its own.
pub fn asked(job: &Job, rows: &[Asked]) -> Option<Job> {
    let one =
        |row: &Asked| Some(Row { force: figures(row.number("force", 1.0)?, 9), unload: row.is("branch", "unload") });
    Some(Job { rows: rows.iter().map(one).collect::<Option<_>>()?, ..job.clone() })
}
