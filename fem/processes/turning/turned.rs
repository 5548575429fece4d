//! The cut to which a row belongs, and what the joints have been through in it.

use std::collections::HashMap;

use rayon::prelude::*;

use super::cut::Conditions;
use super::elastic::{Borne, Cutting};
use super::history::History;
use super::machine::{Machine, Moment};
use super::rows::{self, CHANGE};
use crate::process::{Failure, Rows, on_lines};

/// The last pass as a row tells of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turned {
    /// Place, part and time of the row.
    moment: Moment,
    conditions: Conditions,
    /// What the pass was programmed to beside the radius that is meant, m.
    change: f64,
}

/// Passes that are told apart: by part, force, time, path, change and angle.
type Key = [i64; 6];

/// A row of a pass, with the angle (rad) at which it was measured, and the depths (m) at the places (m) of all of its rows.
type Own = ((Turned, Option<f64>), Vec<(f64, f64)>);

/// What the joints have been through in the passes of rows.
#[derive(Default)]
pub struct Histories(HashMap<Key, History>);

impl Turned {
    /// The pass of a row at x (m).
    pub fn of(machine: &Machine, rows: &Rows, row: usize, x: f64) -> Self {
        let setup = &*machine.setup;
        let (diameter, part) = (setup.diameter(x), rows::part(rows, row));
        let (time, path) = rows::moment(setup, rows, row, part, x);
        let conditions = rows::conditions(setup, rows, row, diameter);
        let change = rows.get(CHANGE, row).unwrap_or(0.0);
        Self { moment: Moment { x, diameter, part, time, path }, conditions, change }
    }

    /// The cut of the pass, where nothing has been through anything.
    pub fn cutting(&self, machine: &Machine) -> Cutting {
        Cutting::new(machine, &self.moment, self.conditions).programmed(self.change)
    }

    /// The same pass at another place (m), set to some depth (m) there, under a force that changes along it as that of the
    /// model does.
    fn elsewhere(&self, machine: &Machine, x: f64, set_depth: f64) -> Self {
        let (setup, at, own) = (&machine.setup, &self.moment, &self.conditions);
        let (here, there) = (setup.nominal_force(at.x), setup.nominal_force(x));
        let ratio = if here > 0.0 { there / here } else { 1.0 };
        let conditions = Conditions { force: own.force * ratio, nominal: own.nominal * ratio, set_depth, ..*own };
        let on = |of: &dyn Fn(usize, f64) -> f64| of(at.part, x) - of(at.part, at.x);
        let schedule = &setup.schedule;
        let moment = Moment {
            x,
            diameter: setup.diameter(x),
            part: at.part,
            time: at.time + on(&|part, x| schedule.time(part, x)),
            path: at.path + on(&|part, x| schedule.path(part, x)),
        };
        Self { moment, conditions, change: self.change }
    }

    /// The force by that of the model at the same place.
    fn ratio(&self, machine: &Machine) -> f64 {
        let nominal = machine.setup.nominal_force(self.moment.x);
        if nominal > 0.0 { self.conditions.force / nominal } else { 1.0 }
    }

    /// In what rows of one pass agree, to digits that files keep: a millionth of the force, seconds, metres, 0.1 um.
    fn key(&self, machine: &Machine, angle: Option<f64>) -> Key {
        let (schedule, at) = (&machine.setup.schedule, &self.moment);
        let by = |value: f64, step: f64| (value / step).round() as i64;
        [
            at.part as i64,
            by(self.ratio(machine), 1e-6),
            by(at.time - schedule.time(at.part, at.x), 1.0),
            by(at.path - schedule.path(at.part, at.x), 1.0),
            by(self.change, 1e-7),
            by(angle.unwrap_or(0.0), 1e-6),
        ]
    }
}

impl Histories {
    /// Of all passes to which these belong, each at an angle (rad) around the part or on the mean.
    ///
    /// # Errors
    /// No equilibrium at some place.
    pub fn of(machine: &Machine, turned: impl Iterator<Item = (Turned, Option<f64>)>) -> Result<Self, Failure> {
        if !machine.rubs() {
            return Ok(Self::default());
        }
        let mut all: HashMap<Key, Own> = HashMap::new();
        for own in turned {
            let (_, depths) = all.entry(own.0.key(machine, own.1)).or_insert((own, Vec::new()));
            depths.push((own.0.moment.x, own.0.conditions.set_depth));
        }
        let history = |(key, ((turned, angle), mut depths)): (Key, Own)| {
            depths.sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
            let known: Vec<f64> = depths.iter().map(|(x, _)| *x).collect();
            // The set depth is straight between rows.
            let depth = |x: f64| on_lines(known.partition_point(|at| *at < x), depths.len(), |i| depths[i], x);
            let last = |x: f64| turned.elsewhere(machine, x, depth(x)).cutting(machine);
            Ok((key, History::of(machine, angle, &known, last)?))
        };
        Ok(Self(all.into_par_iter().map(history).collect::<Result<_, Failure>>()?))
    }

    /// What the joints bore in every pass before the tool reached a row, N; nothing where nothing rubs.
    pub fn at(&self, machine: &Machine, turned: &Turned, angle: Option<f64>) -> &Borne {
        match self.0.is_empty() {
            true => &[],
            false => self.0.get(&turned.key(machine, angle)).map_or(&[], |history| history.at(turned.moment.x)),
        }
    }
}
