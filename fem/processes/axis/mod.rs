//! Axis: where a feed axis really goes.
//!
//! deviation = actual − commanded position, at a target approached forwards (`+`) or backwards (`-`), in a
//! run, at a time. The ideal axis goes where it is told; the ball screw is a bar on its bearing, stretched
//! by whatever the slide's friction asks of it [seed 000, fig. 2].

mod advice;
mod allowed;
mod drag;
mod effects;
mod forward;
mod machine;
mod report;
pub(crate) mod rows;
mod setup;

pub use machine::Machine;
pub use setup::Setup;

use std::sync::Arc;

use crate::input::Reader;
use crate::process::{
    Advice, Allowed, AllowedWords, Answers, CandidateExperiment, CatalogueEffect, Command, Commanded, Coordinate,
    Definition, Failure, Forward, Limit, Misplaced, Observable, Places, Positioning, Rows, RunReport,
};

/// The process `axis`.
pub struct Axis;

impl Definition for Axis {
    type Setup = Setup;
    type Machine = Machine;

    const NAME: &'static str = "axis";
    const ABOUT: &'static str = "positioning of a feed axis driven by a ball screw";
    const OBSERVABLES: &'static [Observable] = rows::OBSERVABLES;
    const COORDINATES: &'static [Coordinate] = rows::COORDINATES;
    const STARTING_MODEL: &'static str = include_str!("new.toml");
    const EFFECTS: &'static [&'static dyn CatalogueEffect<Setup, Machine>] = effects::ALL;

    const COMMANDED: Option<Commanded> = Some(Commanded {
        key: "change",
        words: "commanded position",
        course: "table",
        along: rows::POSITION,
        number: Some(rows::RUN),
        beside: &[rows::DIRECTION],
        observable: 0,
        gain: 1.0,
        answers: Answers::Here,
        period: None,
        takes: Some("a table for each run takes a control that follows time or temperature; one table takes none"),
    });
    const IN_ORDER: Option<&'static str> = Some("run");
    const CARRIED_OVER: &'static [(&'static str, &'static str)] =
        &[("thermal-growth", "warms over many runs, and what is warm does not begin anew at a run")];

    fn read(model: &Reader) -> Option<Setup> {
        Some(Setup::read(model))
    }

    fn ideal(setup: Arc<Setup>) -> Machine {
        Machine::ideal(setup)
    }

    fn command(machine: &mut Machine, command: Arc<Command>) {
        machine.command = Some(command);
    }

    fn advice(_machine: &Machine, rows: &Rows, values: &[f64]) -> Result<Vec<Advice>, Failure> {
        Ok(advice::advice(rows, values))
    }

    fn allowed(setup: &Setup) -> Option<(&Allowed, &'static AllowedWords)> {
        Some((&setup.allowed, &allowed::ALLOWED))
    }

    fn misplaced(setup: &Setup, rows: &Rows) -> Vec<Misplaced> {
        rows::misplaced(setup, rows)
    }

    fn programme(setup: &Setup) -> Rows {
        rows::programme(setup)
    }

    fn places(_setup: &Setup, rows: &Rows) -> Option<Places> {
        Some(rows::places(rows))
    }

    fn candidate_experiments(setup: &Setup, rows: &Rows) -> Vec<CandidateExperiment> {
        rows::candidate_experiments(setup, rows)
    }

    fn positioning(setup: &Setup) -> Option<&dyn Positioning> {
        Some(setup)
    }

    fn limit(setup: &Setup, _observable: usize) -> Limit {
        Limit {
            size: setup.travel,
            why: "as large as the travel",
            help: "check friction, stiffness and slopes: a unit may be wrong",
        }
    }

    fn observe(machine: &Machine, rows: &Rows) -> Result<Vec<f64>, Failure> {
        Ok(forward::observe(machine, rows))
    }

    fn report(machine: &Machine, forward: &Forward) -> Result<RunReport, Failure> {
        Ok(report::report(machine, forward))
    }
}
