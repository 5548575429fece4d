//! Rotary: where a rotary axis really goes.
//!
//! deviation = actual − commanded angle, at a target approached forwards (`+`) or backwards (`-`), in a run, at a time,
//! under a torque about the axis. The ideal axis goes where it is told; its drive is a torsional spring behind the motor,
//! which friction, what is out of balance and torques from outside wind up, and in which play is crossed where what it
//! bears changes its sign.

mod advice;
mod allowed;
mod drive;
mod effects;
mod experiments;
mod forward;
mod machine;
mod report;
pub(crate) mod rows;
mod scale;
mod setup;

pub use machine::Machine;
pub use setup::Setup;

use std::sync::Arc;

use crate::input::Reader;
use crate::process::{
    Advice, Allowed, AllowedWords, Answers, CandidateExperiment, CatalogueEffect, Command, Commanded, Coordinate,
    Definition, Failure, Forward, Limit, Misplaced, Observable, Places, Positioning, Rows, RunReport,
};

/// The process `rotary`.
pub struct Rotary;

impl Definition for Rotary {
    type Setup = Setup;
    type Machine = Machine;

    const NAME: &'static str = "rotary";
    const ABOUT: &'static str = "positioning of a rotary axis behind a worm or gears";
    const OBSERVABLES: &'static [Observable] = rows::OBSERVABLES;
    const COORDINATES: &'static [Coordinate] = rows::COORDINATES;
    const STARTING_MODEL: &'static str = include_str!("new.toml");
    const EFFECTS: &'static [&'static dyn CatalogueEffect<Setup, Machine>] = effects::ALL;

    const COMMANDED: Option<Commanded> = Some(Commanded {
        key: "change",
        words: "commanded angle",
        course: "table",
        along: rows::ANGLE_OF_ROW,
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
        &[("thermal-drift", "warms over many runs, and what is warm does not begin anew at a run")];

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

    fn resolved(setup: &Setup, rows: &Rows) -> Rows {
        rows::resolved(setup, rows)
    }

    fn places(setup: &Setup, rows: &Rows) -> Option<Places> {
        Some(rows::places(setup, rows))
    }

    fn candidate_experiments(setup: &Setup, rows: &Rows) -> Vec<CandidateExperiment> {
        experiments::candidate_experiments(setup, rows)
    }

    fn positioning(setup: &Setup) -> Option<&dyn Positioning> {
        Some(setup)
    }

    fn limit(setup: &Setup, _observable: usize) -> Limit {
        Limit {
            size: setup.range,
            why: "as large as the range",
            help: "check torques, stiffness and eccentricities: a unit may be wrong",
        }
    }

    fn observe(machine: &Machine, rows: &Rows) -> Result<Vec<f64>, Failure> {
        Ok(forward::observe(machine, rows))
    }

    fn report(machine: &Machine, forward: &Forward) -> Result<RunReport, Failure> {
        Ok(report::report(machine, forward))
    }
}
