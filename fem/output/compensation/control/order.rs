//! Input and output of a control's writer, and the points at which a table is taken.

use std::f64::consts::TAU;

use crate::output::number::{fixed, trimmed};
use crate::positioning::{Direction, Grid, Law, Measures, Node, Steps, Table, goes_around};

/// How near the points come to the entries that nobody has placed, m or rad: finer than any control's least increment.
const NEAR: f64 = 5e-8;

/// Steps to which a distance is rounded up that nobody has said, in the unit of positions: 1 um, 0.001 deg.
const STEP: f64 = 1e-3;

/// A control whose file is written.
pub struct Control {
    /// Word after `--for`.
    pub name: &'static str,
    /// The control and its function, for people.
    pub about: &'static str,
    /// Whether its file takes the angles of a rotary axis, in degrees.
    pub turns: bool,
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
    /// In what the axis is told.
    pub measures: Measures,
}

/// Why a table of one target is no table.
const ONE_TARGET: &str = "a table needs two targets at least";

impl Order<'_> {
    /// A position, or a value of the table, in mm or deg with six decimals, without zeros behind.
    pub fn in_units(&self, si: f64) -> String {
        trimmed(self.measures.position.from_si(si), 6)
    }

    /// The same with zeros behind.
    pub fn in_full(&self, si: f64) -> String {
        fixed(self.measures.position.from_si(si), 6)
    }

    /// The unit of both.
    pub fn unit(&self) -> &str {
        self.measures.position_unit()
    }

    /// A value as it is left by six decimals of that unit.
    pub fn rounded(&self, si: f64) -> f64 {
        let least = self.measures.position.to_si(1e-6);
        (si / least).round() * least
    }

    /// Whether a grid goes round a whole turn, so that its first point and its last are one place.
    pub fn is_round(&self, grid: &Grid) -> bool {
        self.measures.is_rotary() && (grid.last() - grid.first - TAU).abs() < 1e-9
    }

    /// The table of a whole turn with one value where it begins and ends: the mean of both.
    pub fn closed(&self, table: Table, notes: &mut Vec<String>) -> Table {
        let Some((first, last)) = table.nodes.first().copied().zip(table.nodes.last().copied()) else { return table };
        let mean = |of: fn(&Node) -> f64| 0.5 * (of(&first) + of(&last));
        let ends = [mean(|n| n.forward), mean(|n| n.backward)];
        let off = (first.forward - ends[0]).abs().max((first.backward - ends[1]).abs());
        notes.push(format!(
            "the table goes round a whole turn: where it begins and ends one value is entered, the mean of both, {} {} from \
             either",
            fixed(self.measures.off(off), 3),
            self.measures.deviation_unit()
        ));
        let mut table = table;
        let count = table.nodes.len();
        for end in [0, count - 1] {
            (table.nodes[end].forward, table.nodes[end].backward) = (ends[0], ends[1]);
        }
        table
    }

    /// Takes a table at points of equal distance, `most` at most: those of the model's `steps`, or where the targets
    /// stand at equal distances, or else as few as meet the targets, `few` at most; and notes where it misses them.
    pub fn evenly(
        &self,
        table: &Table,
        most: usize,
        few: usize,
        notes: &mut Vec<String>,
    ) -> Result<(Grid, Table), String> {
        let table = &self.whole(table, notes);
        let grid = match (self.steps, Grid::of(table)) {
            (Some(steps), _) => self.grid_from_reference(table, steps, most)?,
            (None, Some(grid)) if grid.points <= most => grid,
            (None, _) => Grid::fitted(table, few, NEAR, self.measures.position.to_si(STEP)).ok_or(ONE_TARGET)?,
        };
        let taken = table.on(grid);
        let missed = table.missed_by(&taken);
        if Grid::of(table).is_none_or(|own| own.points != grid.points) || missed > NEAR {
            let [every, from, to] = [grid.interval, grid.first, grid.last()].map(|si| self.in_units(si));
            notes.push(format!(
                "the {} entries of the table are taken at {} points, every {every} {unit} from {from} to {to} {unit}, which \
                 miss them by {} {} at most",
                table.nodes.len(),
                grid.points,
                fixed(self.measures.off(missed), 3),
                self.measures.deviation_unit(),
                unit = self.unit()
            ));
        }
        Ok((grid, taken))
    }

    /// The table of a rotary axis whose targets go round a whole turn but for its end, with its first entry there once more.
    pub fn whole(&self, table: &Table, notes: &mut Vec<String>) -> Table {
        let mut table = table.clone();
        let places: Vec<f64> = table.nodes.iter().map(|n| n.position).collect();
        if let (true, Some(first), Some(last)) =
            (self.measures.is_rotary(), table.nodes.first().copied(), places.last())
            && goes_around(&places)
            && first.position + TAU - last > NEAR
            && table.law == Law::Points
        {
            let position = first.position + TAU;
            table.nodes.push(Node { position, ..first });
            let [from, at] = [*last, position].map(|si| self.in_units(si));
            notes.push(format!(
                "the targets end at {from} {unit}: at {at} {unit}, the place of the first, its entry stands once more, and the table \
                 goes round",
                unit = self.unit()
            ));
        }
        table
    }

    /// Grid through the reference point with the interval that the model gives, `most` points at most.
    fn grid_from_reference(&self, table: &Table, steps: Steps, most: usize) -> Result<Grid, String> {
        let grid = Grid::through(table, steps.reference, steps.interval).ok_or(ONE_TARGET)?;
        if grid.points > most {
            let length = self.measures.position.from_si(grid.last() - grid.first);
            let least = trimmed((1e3 * length / (most - 1) as f64).ceil() / 1e3, 3);
            let (points, unit) = (grid.points, self.unit());
            return Err(format!(
                "{points} points every {} {unit} are more than the {most} that it takes: make `interval` of `steps` {least} \
                 {unit} at least",
                self.in_units(steps.interval)
            ));
        }
        Ok(grid)
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
