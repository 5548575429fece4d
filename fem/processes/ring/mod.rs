//! Ring: the bore of a ring that a jaw chuck holds by its outside, or the outside of one that it holds by its bore.
//!
//! The jaws move the ring by u_r(θ), the bore (outside) is cut round, and released it moves back:
//! deviation(θ) = −u_r(θ), positive outwards, θ = 0 at jaw 1 [seed 002, ring in a three-jaw chuck].
//! Clamped and not yet bored it is +u_r. Errors of the cut itself add to the released bore.

mod advice;
mod allowed;
mod base;
mod body;
mod chuck;
pub(crate) mod circle;
mod drawn;
mod effects;
mod forward;
mod gauged;
mod grip;
mod instrument;
pub(crate) mod jaws;
mod machine;
mod membrane;
mod report;
mod response;
pub(crate) mod rows;
mod setup;
mod tube;

pub use body::Body;
pub use drawn::Drawn;
pub use grip::Grip;
pub use instrument::{Gauge, Instrument};
pub use machine::{BorePoint, Machine};
pub use membrane::{Grasp, Membrane, Push};
pub use response::MeshSize;
pub use setup::{Lobe, Reference, Setup};

use std::sync::Arc;

use crate::input::Reader;
use crate::process::{
    Advice, Allowed, AllowedWords, Answers, CandidateExperiment, CatalogueEffect, Command, Commanded, Coordinate,
    DatumDirection, Definition, Failure, Forward, Gauged, Limit, Misplaced, Observable, Places, Rows, RunReport, Spot,
};

/// The process `ring`.
pub struct Ring;

impl Definition for Ring {
    type Setup = Setup;
    type Machine = Machine;

    const NAME: &'static str = "ring";
    const ABOUT: &'static str = "bore or outside of a ring clamped in a jaw chuck";
    const OBSERVABLES: &'static [Observable] = rows::OBSERVABLES;
    const COORDINATES: &'static [Coordinate] = rows::COORDINATES;
    const STARTING_MODEL: &'static str = include_str!("new.toml");
    const EFFECTS: &'static [&'static dyn CatalogueEffect<Setup, Machine>] = effects::ALL;

    const COMMANDED: Option<Commanded> = Some(Commanded {
        key: "change",
        words: "radius at which the ring is cut",
        course: "contour",
        along: rows::ANGLE_OF_ROW,
        number: None,
        beside: &[],
        observable: 0,
        gain: 1.0,
        answers: Answers::Here,
        period: Some(std::f64::consts::TAU),
        takes: Some(
            "a ring cut out of round takes a tool that follows the angle; where there is none, the force of the jaws can be changed",
        ),
    });
    const IN_ORDER: Option<&'static str> = Some("run");

    fn read(model: &Reader) -> Option<Setup> {
        Some(Setup::read(model))
    }

    fn ideal(setup: Arc<Setup>) -> Machine {
        Machine::ideal(setup)
    }

    fn command(machine: &mut Machine, command: Arc<Command>) {
        machine.command = Some(command);
    }

    fn advice(machine: &Machine, _rows: &Rows, values: &[f64]) -> Result<Vec<Advice>, Failure> {
        Ok(advice::advice(machine, values))
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

    fn contour(setup: &Setup) -> Option<Vec<Vec<Spot>>> {
        Some(vec![Spot::circle(setup.cut_radius())])
    }

    fn datum_directions(setup: &Setup, rows: &Rows) -> Vec<DatumDirection> {
        rows::datum_directions(setup, rows)
    }

    fn gauged(setup: &Setup, rows: &Rows) -> Option<Gauged> {
        gauged::gauged(setup, rows)
    }

    fn candidate_experiments(setup: &Setup, rows: &Rows) -> Vec<CandidateExperiment> {
        rows::candidate_experiments(setup, rows)
    }

    fn limit(setup: &Setup, _observable: usize) -> Limit {
        Limit {
            size: setup.cut_radius(),
            why: "that is no ring any more",
            help: "check forces, dimensions and material: a unit may be wrong",
        }
    }

    fn observe(machine: &Machine, rows: &Rows) -> Result<Vec<f64>, Failure> {
        forward::observe(machine, rows)
    }

    fn doubts(machine: &Machine, _rows: &Rows) -> Result<Vec<String>, Failure> {
        Ok(report::let_go(machine).into_iter().chain(advice::slips(machine)).collect())
    }

    fn comes_loose(machine: &Machine) -> Option<String> {
        report::let_go(machine).or_else(|| advice::slips(machine))
    }

    fn report(machine: &Machine, forward: &Forward) -> Result<RunReport, Failure> {
        report::report(machine, forward)
    }
}
