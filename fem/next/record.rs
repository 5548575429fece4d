//! What would have been left of every part of the history, had it been told one part ahead.

use super::filter::{Told, run};
use super::line::Line;
use super::sizes::Sizes;
use super::tuning::tuned;

/// Measured parts after which sizes are found anew, at first, and how many more there must be each time.
const FIRST: usize = 4;
const MORE: f64 = 1.5;

/// What the model with its filter would have told of each measured part, knowing those before it alone: sizes that only later
/// parts tell are not used.
pub fn told(line: &Line) -> Vec<Told> {
    let measured: Vec<usize> =
        line.steps.iter().enumerate().filter(|(_, step)| !step.readings.is_empty()).map(|(i, _)| i).collect();
    let (mut all, mut sizes) = (Vec::new(), Sizes::usual(line));
    let (mut begun, mut end) = (0, FIRST.min(measured.len()));
    while begun < measured.len() {
        if begun > 0 {
            sizes = tuned(sizes, line, measured[begun]);
        }
        let until = measured.get(end).copied().unwrap_or(line.steps.len());
        all.extend(run(line, &sizes, until).told.into_iter().skip(begun).map(|(_, own)| own));
        begun = end;
        end = ((end as f64 * MORE) as usize).clamp(end + 1, measured.len().max(end + 1));
    }
    all
}
