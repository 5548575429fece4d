//! Thermal: temperature and growth of a body that is heated, over time.
//!
//! A rod by one-dimensional conduction with sources at points, ρcA T_t = (kA T_x)_x − h p (T − T_a) +
//! Σ Q δ, or a plane body or a body of revolution by finite elements. The body is all at one temperature T₀ at the start, that of the
//! surroundings unless it has its own; surfaces and ends are insulated unless an effect, or an edge of a
//! plane body, opens them. The free end moves by ∫ α (T − T₀) dx [seed 002 (35)–(39)]; a plane body also
//! bows where it is warmer above than below, and the diameters of a body of revolution change. The temperature of the surroundings and the power of a source
//! may be records.

mod advice;
mod allowed;
mod body;
pub(crate) mod boundary;
mod circles;
mod effects;
pub(crate) mod follow;
pub(crate) mod forward;
pub(crate) mod machine;
mod over_temperature;
mod plate;
mod recording;
pub(crate) mod report;
mod revolved;
mod rod;
pub(crate) mod rows;
pub(crate) mod setup;
mod source;
mod steps;
mod surroundings;

pub use machine::Machine;
pub use setup::Setup;

use std::sync::Arc;

use crate::input::Reader;
use crate::process::{
    Advice, Allowed, AllowedWords, Answers, CandidateExperiment, CatalogueEffect, Command, Commanded, Coordinate,
    Definition, Failure, Forward, Limit, Misplaced, Observable, Rows, RunReport, Variant,
};
use crate::progress::Progress;

/// The process `thermal`.
pub struct Thermal;

impl Definition for Thermal {
    type Setup = Setup;
    type Machine = Machine;

    const NAME: &'static str = "thermal";
    const ABOUT: &'static str = "temperature and growth of a heated body over time";
    const OBSERVABLES: &'static [Observable] = rows::OBSERVABLES;
    const COORDINATES: &'static [Coordinate] = rows::COORDINATES;
    const STARTING_MODEL: &'static str = include_str!("new.toml");
    const STARTING_VARIANTS: &'static [(Variant, &'static str)] =
        &[(Variant::Sketch, include_str!("../../../models/bored-sleeve.toml"))];
    const EFFECTS: &'static [&'static dyn CatalogueEffect<Setup, Machine>] = effects::ALL;

    const COMMANDED: Option<Commanded> = Some(Commanded {
        key: "change",
        words: "commanded length",
        course: "course",
        along: rows::TIME_OF_ROW,
        number: None,
        beside: &[],
        observable: 0,
        gain: 1.0,
        answers: Answers::Here,
        period: None,
        takes: Some("a length that follows time takes a control that compensates over time or temperature"),
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
        Ok(advice::advice(machine, rows, values))
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

    fn reach(setup: &Setup, coordinate: &str) -> Option<(f64, f64)> {
        (coordinate == "x").then(|| setup.body.extent().into())
    }

    fn candidate_experiments(setup: &Setup, rows: &Rows) -> Vec<CandidateExperiment> {
        rows::candidate_experiments(setup, rows)
    }

    fn limit(setup: &Setup, observable: usize) -> Limit {
        rows::limit(setup, observable)
    }

    fn predict(machine: &Machine, programme: &Rows, _progress: &Progress) -> Result<Vec<f64>, Failure> {
        forward::predict(machine, programme)
    }

    fn observe(machine: &Machine, rows: &Rows) -> Result<Vec<f64>, Failure> {
        forward::observe(machine, rows)
    }

    fn report(machine: &Machine, forward: &Forward) -> Result<RunReport, Failure> {
        report::report(machine, forward)
    }
}
