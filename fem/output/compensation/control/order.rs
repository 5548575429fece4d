//! Input and output of a control's writer, and the points at which a table is taken.

use crate::output::number::{fixed, mm};
use crate::positioning::{Direction, Grid, Node, Steps, Table};

/// How near the points come to the entries that nobody has placed, m: finer than any control's least increment.
const NEAR: f64 = 5e-8;

/// A control whose file is written.
pub struct Control {
    /// Word after `--for`.
    pub name: &'static str,
    /// The control and its function, for people.
    pub about: &'static str,
    /// Makes the files, or says why it cannot.
    pub write: fn(&Order) -> Result<Written, String>,
}

/// Files for a control, with the compensation that they give.
pub struct Written {
    /// Names of the files and what stands in them.
    pub files: Vec<(&'static str, String)>,
    /// Correction that the control applies with them.
    pub table: Table,
    /// Notes for the user: changes made on the way, further settings, and assumptions where the manual is silent.
    pub notes: Vec<String>,
}

/// Tables for a control, and what is known of its points.
pub struct Order<'a> {
    /// Name of the axis in the control.
    pub axis: &'a str,
    /// Table with one value for backlash.
    pub one: &'a Table,
    /// Table for each direction.
    pub both: &'a Table,
    /// Points at which it takes increments, if they are told.
    pub steps: Option<Steps>,
}

/// Why a table of one target is no table.
const ONE_TARGET: &str = "a table needs two targets at least";

impl Order<'_> {
    /// Takes a table at points of equal distance, `most` at most: those of the model's `steps`, or where the targets
    /// stand at equal distances, or else as few as meet the targets, `few` at most; and notes where it misses them.
    pub fn evenly(
        &self,
        table: &Table,
        most: usize,
        few: usize,
        notes: &mut Vec<String>,
    ) -> Result<(Grid, Table), String> {
        let grid = match (self.steps, Grid::of(table)) {
            (Some(steps), _) => grid_from_reference(table, steps, most)?,
            (None, Some(grid)) if grid.points <= most => grid,
            (None, _) => Grid::fitted(table, few, NEAR).ok_or(ONE_TARGET)?,
        };
        let taken = table.on(grid);
        let missed = table.missed_by(&taken);
        if Grid::of(table).is_none_or(|own| own.points != grid.points) || missed > NEAR {
            let (count, every, from, to) = (grid.points, mm(grid.interval, 6), mm(grid.first, 6), mm(grid.last(), 6));
            notes.push(format!(
                "the {} entries of the table are taken at {count} points, every {every} mm from {from} to {to} mm, which \
                 miss them by {} um at most",
                table.nodes.len(),
                fixed(1e6 * missed, 3)
            ));
        }
        Ok((grid, taken))
    }

    /// The points and the count of their increments, for a control that counts them from its reference point.
    pub fn counted(&self, table: &Table, most: usize, notes: &mut Vec<String>) -> Result<Counted, String> {
        let Some(steps) = self.steps.filter(|steps| steps.unit > 0.0) else {
            return Err("it counts increments from its reference point: add `steps` to [controller], with \
                        `reference`, `interval`, `detection_unit` and, where it has one, `magnification`"
                .into());
        };
        let (grid, taken) = self.evenly(table, most, most, notes)?;
        let first = ((grid.first - steps.reference) / steps.interval).round() as i64;
        let zero = taken.correction(steps.reference, Direction::Forward);
        Ok(Counted { first, steps, taken, zero })
    }

    /// The table less what it adds at the reference point forwards, for controls that want none there; unchanged
    /// where nobody has said where that point is.
    pub fn less_reference(&self, table: Table, notes: &mut Vec<String>) -> Table {
        let Some(steps) = self.steps else {
            notes.push(
                "nothing should be added at the reference point, and nobody has said where it stands: add `steps` to \
                 [controller], or have the reference point where the table adds nothing"
                    .into(),
            );
            return table;
        };
        let zero = table.correction(steps.reference, Direction::Forward);
        table.map(|added, _| added - zero)
    }
}

/// Grid through the reference point with the interval that the model gives, `most` points at most.
fn grid_from_reference(table: &Table, steps: Steps, most: usize) -> Result<Grid, String> {
    let grid = Grid::through(table, steps.reference, steps.interval).ok_or(ONE_TARGET)?;
    if grid.points > most {
        let length = grid.last() - grid.first;
        let least = mm((1e6 * length / (most - 1) as f64).ceil() / 1e6, 3);
        let points = grid.points;
        return Err(format!(
            "{points} points every {} mm are more than the {most} that it takes: make `interval` of `steps` {least} mm at \
             least",
            mm(steps.interval, 6)
        ));
    }
    Ok(grid)
}

/// A table in counts from a reference point.
pub struct Counted {
    /// Number of the first point, counted from the reference point.
    pub first: i64,
    /// Points and counts of the control.
    pub steps: Steps,
    /// The table at the points.
    taken: Table,
    /// Its correction at the reference point forwards, m.
    zero: f64,
}

impl Counted {
    /// Correction at each point in a direction, less the forward one at the reference point, in counts of `unit` (m):
    /// rounded as a sum, so that roundings of increments do not add up.
    pub fn sums(&self, direction: Direction, unit: f64) -> Vec<i64> {
        self.sums_from(direction, 0.0, unit)
    }

    /// The same, counted from what is added there and `more` (m).
    pub fn sums_from(&self, direction: Direction, more: f64, unit: f64) -> Vec<i64> {
        let added = |node: &Node| match direction {
            Direction::Forward => node.forward,
            Direction::Backward => node.backward,
        };
        let sums = self.taken.nodes.iter().map(|node| ((added(node) - self.zero - more) / unit).round() as i64);
        let sums: Vec<i64> = sums.collect();
        // At the reference point, or the end that is nearest to it, the control adds nothing more.
        let at = usize::try_from(-self.first).unwrap_or(0).min(sums.len() - 1);
        sums.iter().map(|sum| sum - sums[at]).collect()
    }

    /// Correction at the reference point on the way back, less the forward one there, m.
    pub fn at_reference(&self) -> f64 {
        self.taken.correction(self.steps.reference, Direction::Backward) - self.zero
    }

    /// Backlash of a table with one value for it, as the correction on the way back, in counts of `unit` (m).
    pub fn backlash(&self, unit: f64) -> i64 {
        (self.taken.backlash() / unit).round() as i64
    }

    /// The table that sums, in m, make; less the constant that no sum has.
    pub fn table(&self, forward: &[f64], backward: &[f64]) -> Table {
        let mut table = self.taken.clone();
        for (node, (forward, backward)) in table.nodes.iter_mut().zip(forward.iter().zip(backward)) {
            (node.forward, node.backward) = (*forward, *backward);
        }
        table
    }

    /// Position of a point by its number from the reference point, m.
    pub fn position(&self, number: i64) -> f64 {
        self.steps.reference + number as f64 * self.steps.interval
    }
}

/// Refuses the increments that a control does not take, with the magnification that would do.
pub fn within(increments: &[i64], least: i64, most: i64, magnification: i64) -> Result<(), String> {
    let beyond = increments.iter().copied().filter(|n| !(least..=most).contains(n));
    let Some(worst) = beyond.max_by_key(|n| n.unsigned_abs()) else { return Ok(()) };
    let needed = (worst.unsigned_abs() as f64 / most as f64 * magnification as f64).ceil();
    Err(format!(
        "an increment of {worst} counts is beyond the {least} to {most} that it takes: make `magnification` of `steps` \
         {needed:.0} at least, or `interval` shorter"
    ))
}
