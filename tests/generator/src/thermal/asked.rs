//! Further readings of the same rod, through the same heating.

use super::job::{Job, Row, Seen};
use crate::asked::Asked;
use crate::random::decimals;

/// To what times are read, min: a whole number of the steps in which lags are followed.
const CLOCK: f64 = 0.25;

/// The rod with these readings in the place of its own, at the times to which a clock is read.
pub fn asked(job: &Job, rows: &[Asked]) -> Option<Job> {
    let mut next = Job { rows: Vec::new(), ..job.clone() };
    for row in rows {
        let time = (row.number("time", 1.0 / 60.0)? / CLOCK).round().max(1.0) * CLOCK;
        let seen = match row.observable.as_str() {
            "temperature" => {
                let x = decimals(row.number("x", 1e3)?, 3);
                let sensor = next.sensors.iter().position(|at| *at == x).unwrap_or(next.sensors.len());
                if sensor == next.sensors.len() {
                    next.sensors.push(x);
                }
                Seen::Temperature(sensor)
            }
            "elongation" => Seen::Elongation,
            _ => return None,
        };
        next.rows.push(Row { time, seen, change: row.number("change", 1e6).unwrap_or(0.0) });
    }
    next.rows.sort_by(|a, b| a.time.total_cmp(&b.time));
    Some(next)
}
