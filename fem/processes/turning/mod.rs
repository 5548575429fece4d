//! Turning: the diameter profile of every part of a batch of shafts.
//!
//! The tool stands at x and pushes the shaft away by y(x); the diameter grows by ΔD = 2·y(x), and everything
//! that moves the tool nose toward or away from the axis adds to it.

mod advice;
mod base;
mod batch;
pub(crate) mod cut;
mod edge;
mod effects;
pub(crate) mod elastic;
mod events;
mod experiments;
pub(crate) mod forward;
mod heating;
mod history;
mod imported;
mod lift_off;
mod log;
mod machine;
mod passes;
mod program;
pub(crate) mod refinement;
pub(crate) mod report;
mod requirements;
pub(crate) mod rows;
pub(crate) mod schedule;
mod setup;
mod tolerance;
mod turned;

pub use elastic::condense;
pub use forward::deflections;
pub use machine::Machine;
pub use setup::Setup;

use std::sync::Arc;

use self::lift_off::LiftOff;
use crate::gcode::Workpiece;
use crate::input::Reader;
use crate::process::{
    Active, Advice, Answers, CandidateExperiment, CatalogueEffect, Characteristic, Command, Commanded, Contradiction,
    Coordinate, Definition, Failure, Forward, Limit, Making, Misplaced, NoLaw, Observable, Odds, Places, RADIUS_CHANGE,
    Requirement, Rows, RunReport, Variant,
};
use crate::progress::Progress;
use crate::tolerance::Limits;

/// The process `turning`.
pub struct Turning;

impl Definition for Turning {
    type Setup = Setup;
    type Machine = Machine;

    const NAME: &'static str = "turning";
    const ABOUT: &'static str = "diameter profile of every shaft of a turned batch";
    const OBSERVABLES: &'static [Observable] = rows::OBSERVABLES;
    const COORDINATES: &'static [Coordinate] = rows::COORDINATES;
    const STARTING_MODEL: &'static str = include_str!("new.toml");
    const STARTING_VARIANTS: &'static [(Variant, &'static str)] =
        &[(Variant::Structure, include_str!("../../../models/lathe-on-bed.toml"))];
    const EFFECTS: &'static [&'static dyn CatalogueEffect<Setup, Machine>] = effects::ALL;
    const IN_ORDER: Option<&'static str> = Some("part");
    const CARRIED_OVER: &'static [(&'static str, &'static str)] = &[
        ("tool-wear", "wears on from part to part: write a new edge as `inserts` in [batch]"),
        ("tool-breakdown", "wears on from part to part: write a new edge as `inserts` in [batch]"),
        ("tool-thermal-growth", "warms over many parts, and what is warm does not begin anew at a part"),
        ("spindle-thermal-drift", "warms over many parts, and what is warm does not begin anew at a part"),
        ("setting-error", "is set anew by a correction of the offset: write `corrections` in [batch]"),
        ("offset-correction", "is an event itself"),
        ("insert-change", "is an event itself"),
    ];

    const COMMANDED: Option<Commanded> = Some(Commanded {
        key: RADIUS_CHANGE,
        words: "programmed radius",
        course: "contour",
        along: rows::X,
        number: Some(rows::PART),
        beside: &[],
        observable: 0,
        gain: 2.0,
        answers: Answers::Here,
        period: None,
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
        Ok(advice::advice(machine, rows, values))
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

    fn requirements(setup: &Setup) -> Vec<Requirement> {
        requirements::requirements(setup)
    }

    fn limits(setup: &Setup, rows: &Rows) -> Vec<Option<Limits>> {
        requirements::limits(setup, rows)
    }

    fn characteristics(setup: &Setup, rows: &Rows, values: &[f64]) -> Vec<Characteristic> {
        requirements::characteristics(setup, rows, values)
    }

    fn program(setup: &Setup) -> Option<Workpiece> {
        Some(setup.programs.workpiece(&setup.segments, setup.schedule.pass, setup.cut.depth))
    }

    fn making(setup: &Setup) -> Option<Making> {
        Some(setup.making())
    }

    fn no_law(setup: &Setup, path: &str) -> Option<NoLaw> {
        cut::no_law(&setup.cut, path)
    }

    fn odds(setup: &Setup, effect: &str) -> Option<Odds> {
        effects::odds(setup, effect)
    }

    fn contradiction(setup: &Setup, effect: &Active) -> Option<Contradiction> {
        effects::contradiction(setup, effect)
    }

    fn candidate_experiments(setup: &Setup, rows: &Rows) -> Vec<CandidateExperiment> {
        experiments::candidate_experiments(setup, rows)
    }

    fn in_sequence(
        setup: &Setup,
        one: &CandidateExperiment,
        other: &CandidateExperiment,
    ) -> Option<CandidateExperiment> {
        experiments::in_sequence(setup, one, other)
    }

    /// A kilometre.
    fn limit(_setup: &Setup, _observable: usize) -> Limit {
        Limit {
            size: 1e3,
            why: "no diameter can be so wrong",
            help: "check the model for values that are far too large",
        }
    }

    fn observe(machine: &Machine, rows: &Rows) -> Result<Vec<f64>, Failure> {
        forward::observe(machine, rows)
    }

    fn doubts(machine: &Machine, rows: &Rows) -> Result<Vec<String>, Failure> {
        let mut all = LiftOff::default();
        forward::standing(machine, rows, |positions, deflections| {
            all.add(LiftOff::of(machine, positions, deflections)?);
            Ok(())
        })?;
        Ok(all.warnings("rows"))
    }

    fn predict(machine: &Machine, programme: &Rows, progress: &Progress) -> Result<Vec<f64>, Failure> {
        forward::predict(machine, programme, progress)
    }

    fn report(machine: &Machine, forward: &Forward) -> Result<RunReport, Failure> {
        report::report(machine, forward)
    }
}
