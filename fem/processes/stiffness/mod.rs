//! Stiffness: a joint or a whole machine is pushed up to a force and let go again, and gives way by y(F).
//!
//! The ideal one is a spring, y = F/k. Clearance, contact, friction and preload bend its curve, and where
//! loading and unloading part, the area between them is the work of friction [seed 000, fig. 5]. A whole machine may be
//! drawn as a structure: then it is pushed at several places, dials watch several of its nodes, and the joint stands
//! between the force and the place that is pushed.

mod allowed;
mod base;
pub(crate) mod curve;
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
    Allowed, AllowedWords, CandidateExperiment, CatalogueEffect, Coordinate, Definition, Failure, Forward, Limit,
    Misplaced, Observable, Rows, RunReport, UnitRole, Variant,
};

/// The process `stiffness`.
pub struct Stiffness;

impl Definition for Stiffness {
    type Setup = Setup;
    type Machine = Machine;

    const NAME: &'static str = "stiffness";
    const ABOUT: &'static str = "displacement of a joint that is loaded and unloaded";
    const OBSERVABLES: &'static [Observable] = rows::OBSERVABLES;
    const COORDINATES: &'static [Coordinate] = rows::COORDINATES;
    const STARTING_MODEL: &'static str = include_str!("new.toml");
    const STARTING_VARIANTS: &'static [(Variant, &'static str)] =
        &[(Variant::Structure, include_str!("../../../models/pushed-lathe.toml"))];
    const EFFECTS: &'static [&'static dyn CatalogueEffect<Setup, Machine>] = effects::ALL;

    const OF_UNIT: &'static [(&'static str, UnitRole)] = &[("joint.stiffness", UnitRole::Spring)];

    fn read(model: &Reader) -> Option<Setup> {
        Some(Setup::read(model))
    }

    fn ideal(setup: Arc<Setup>) -> Machine {
        Machine::ideal(setup)
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

    fn unit(setup: &Setup) -> Option<&str> {
        setup.unit.as_deref()
    }

    fn candidate_experiments(setup: &Setup, rows: &Rows) -> Vec<CandidateExperiment> {
        rows::candidate_experiments(setup, rows)
    }

    fn limit(_setup: &Setup, _observable: usize) -> Limit {
        Limit { size: 1.0, why: "that is no joint any more", help: "check forces and stiffness: a unit may be wrong" }
    }

    fn observe(machine: &Machine, rows: &Rows) -> Result<Vec<f64>, Failure> {
        forward::observe(machine, rows)
    }

    fn report(machine: &Machine, forward: &Forward) -> Result<RunReport, Failure> {
        report::report(machine, forward)
    }
}
