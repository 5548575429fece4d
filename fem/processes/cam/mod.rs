//! Cam: a plane cam ground by a polar grinder, the slide with the wheel against the turning cam, block by
//! block [seed 003].
//!
//! Within a block cam and slide go linearly, and the wheel's centre runs an arc of an Archimedean spiral
//! instead of the curve at the wheel's radius from the profile. The envelope of the wheel then leaves
//! material (+) or cuts too deep (−). `deviation` is measured along the normal of the profile, over the
//! polar angle of the profile's point, counter-clockwise from +x. The wheel goes along the profile in the
//! order in which it is drawn.

mod advice;
mod allowed;
mod before;
pub(crate) mod cartesian;
mod course;
mod division;
mod effects;
pub(crate) mod fewest;
pub(crate) mod forward;
pub(crate) mod guide;
mod machine;
pub(crate) mod motion;
pub(crate) mod profile;
pub(crate) mod program;
pub(crate) mod report;
pub(crate) mod rows;
mod search;
mod setup;
mod shifted;

pub use machine::Machine;
pub use setup::Setup;

use std::sync::Arc;

use crate::input::Reader;
use crate::process::{
    Advice, Allowed, AllowedWords, CandidateExperiment, CatalogueEffect, Coordinate, Definition, Failure, Forward,
    Limit, Misplaced, Observable, Places, Rows, RunReport, Spot,
};
use crate::progress::Progress;

/// The process `cam`.
pub struct CamGrinding;

impl Definition for CamGrinding {
    type Setup = Setup;
    type Machine = Machine;

    const NAME: &'static str = "cam";
    const ABOUT: &'static str = "deviation of a cam that a polar grinder interpolates linearly";
    const OBSERVABLES: &'static [Observable] = rows::OBSERVABLES;
    const COORDINATES: &'static [Coordinate] = rows::COORDINATES;
    const STARTING_MODEL: &'static str = include_str!("new.toml");
    const EFFECTS: &'static [&'static dyn CatalogueEffect<Setup, Machine>] = effects::ALL;

    fn read(model: &Reader) -> Option<Setup> {
        Setup::read(model)
    }

    fn ideal(setup: Arc<Setup>) -> Machine {
        Machine::ideal(setup)
    }

    fn allowed(setup: &Setup) -> Option<(&Allowed, &'static AllowedWords)> {
        Some((&setup.allowed, &allowed::ALLOWED))
    }

    fn advice(machine: &Machine, _rows: &Rows, _values: &[f64]) -> Result<Vec<Advice>, Failure> {
        advice::advice(machine)
    }

    fn misplaced(_setup: &Setup, rows: &Rows) -> Vec<Misplaced> {
        rows::misplaced(rows)
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
        Some(vec![setup.drawn()])
    }

    fn candidate_experiments(setup: &Setup, _rows: &Rows) -> Vec<CandidateExperiment> {
        rows::candidate_experiments(setup)
    }

    fn limit(setup: &Setup, _observable: usize) -> Limit {
        Limit {
            size: setup.profile.length(),
            why: "no cam is off by the length of its own profile",
            help: "check the wheel, the profile and the sizes of the effects: a unit may be wrong",
        }
    }

    fn observe(machine: &Machine, rows: &Rows) -> Result<Vec<f64>, Failure> {
        forward::observe(machine, rows)
    }

    fn predict(machine: &Machine, _programme: &Rows, progress: &Progress) -> Result<Vec<f64>, Failure> {
        forward::predict(machine, progress)
    }

    fn report(machine: &Machine, forward: &Forward) -> Result<RunReport, Failure> {
        Ok(report::report(machine, forward))
    }
}
