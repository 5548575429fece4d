//! Contour: a circle, a rectangle or a polygon that two servo axes travel together.
//!
//! Command → each axis behind its servo 1/(1 + s/Kv) → play → cyclic error → scale → squareness → centre →
//! deviation from the path, positive outwards, plus spikes: in that order, in the steady state that laps
//! before have brought about, at the commanded point [seed 000; ISO 230-4].

mod advice;
mod drive;
mod effects;
mod followed;
pub(crate) mod forward;
mod machine;
mod motion;
pub(crate) mod path;
mod play;
mod report;
mod rows;
mod setup;

pub use machine::Machine;
pub use path::{Direction, Path};
pub use setup::Setup;

use std::sync::Arc;

use crate::input::Reader;
use crate::process::{
    Advice, Allowed, AllowedWords, Answers, CandidateExperiment, CatalogueEffect, Command, Commanded, Coordinate,
    Definition, Failure, Forward, Limit, Misplaced, Observable, Places, Rows, RunReport, Spot,
};

/// The process `contour`.
pub struct Contour;

impl Definition for Contour {
    type Setup = Setup;
    type Machine = Machine;

    const NAME: &'static str = "contour";
    const ABOUT: &'static str = "circle, rectangle or polygon travelled by two servo axes";
    const OBSERVABLES: &'static [Observable] = rows::OBSERVABLES;
    const COORDINATES: &'static [Coordinate] = rows::COORDINATES;
    const STARTING_MODEL: &'static str = include_str!("new.toml");
    const EFFECTS: &'static [&'static dyn CatalogueEffect<Setup, Machine>] = effects::ALL;

    const COMMANDED: Option<Commanded> = Some(Commanded {
        key: "change",
        words: "commanded path, outwards",
        course: "contour",
        along: rows::ANGLE_OF_ROW,
        number: None,
        beside: &[rows::DIRECTION],
        observable: 0,
        gain: 1.0,
        answers: Answers::Along,
        period: Some(std::f64::consts::TAU),
        takes: None,
    });

    fn read(model: &Reader) -> Option<Setup> {
        Some(Setup::read(model))
    }

    fn ideal(setup: Arc<Setup>) -> Machine {
        Machine::ideal(setup)
    }

    fn command(machine: &mut Machine, command: Arc<Command>) {
        machine.command = Some(command);
    }

    fn advice(machine: &Machine, rows: &Rows, values: &[f64]) -> Result<Vec<Advice>, Failure> {
        advice::advice(machine, rows, values)
    }

    fn allowed(setup: &Setup) -> Option<(&Allowed, &'static AllowedWords)> {
        Some((&setup.allowed, &rows::ALLOWED))
    }

    fn misplaced(setup: &Setup, rows: &Rows) -> Vec<Misplaced> {
        rows::misplaced(setup, rows)
    }

    fn programme(setup: &Setup) -> Rows {
        rows::programme(setup)
    }

    fn resolved(setup: &Setup, rows: &Rows) -> Rows {
        rows::resolved(setup, rows)
    }

    fn places(setup: &Setup, rows: &Rows) -> Option<Places> {
        Some(rows::places(setup, rows))
    }

    fn contour(setup: &Setup) -> Option<Vec<Vec<Spot>>> {
        Some(setup.path.drawn())
    }

    fn candidate_experiments(setup: &Setup, rows: &Rows) -> Vec<CandidateExperiment> {
        rows::candidate_experiments(setup, rows)
    }

    fn limit(setup: &Setup, _observable: usize) -> Limit {
        Limit {
            size: setup.path.reach(),
            why: "that is no contour any more",
            help: "check feed, gain and dimensions: a unit may be wrong",
        }
    }

    fn observe(machine: &Machine, rows: &Rows) -> Result<Vec<f64>, Failure> {
        forward::observe(machine, rows)
    }

    fn report(machine: &Machine, forward: &Forward) -> Result<RunReport, Failure> {
        report::report(machine, forward)
    }
}
