//! A process as its author writes it: with its own types, and nothing that the adapter can do for all.

use std::sync::Arc;

use super::{
    Active, Advice, Allowed, AllowedWords, CandidateExperiment, CatalogueEffect, Characteristic, Command, Commanded,
    Coordinate, DatumDirection, Failure, Gauged, Making, Misplaced, NoLaw, Observable, Odds, Places, Positioning,
    Requirement, Rows, RunReport, Spot, UnitRole,
};
use crate::gcode::Workpiece;
use crate::input::Reader;
use crate::progress::Progress;
use crate::tolerance::Limits;

/// A process. Its set-up is what the tables of a model file say, its machine what effects make of the
/// set-up, its forward function what every row would show. Formula effects, checks of what is believable
/// and datum directions are none of its business: the adapter sees to them, for predictions and reports
/// alike.
pub trait Definition: Sync + Sized + 'static {
    /// The tables of a model, all but its effects. SI units.
    type Setup: Send + Sync + 'static;
    /// The set-up as effects shape it.
    type Machine: Send + Sync + 'static;

    /// The word after `process =`.
    const NAME: &'static str;
    /// Subject of its predictions, in half a sentence.
    const ABOUT: &'static str;
    /// Quantities that it predicts and that can be measured.
    const OBSERVABLES: &'static [Observable];
    /// The coordinates and conditions under which it is measured.
    const COORDINATES: &'static [Coordinate];
    /// A commented model to start from.
    const STARTING_MODEL: &'static str;
    /// Others, in which more is drawn.
    const STARTING_VARIANTS: &'static [(Variant, &'static str)] = &[];
    /// Its effects, in the order in which people meet them.
    const EFFECTS: &'static [&'static dyn CatalogueEffect<Self::Setup, Self::Machine>];

    /// Coordinate that numbers what is made or measured one after another, if there is one: between two numbers an
    /// effect may change.
    const IN_ORDER: Option<&'static str> = None;

    /// Effects that are not to be written or sought as changed at a number, with the reason, as a sentence that goes on
    /// from the effect's name: those with a memory, which rows of two machines would not have, and those that are such
    /// an event themselves.
    const CARRIED_OVER: &'static [(&'static str, &'static str)] = &[];

    /// Quantities of the tables that are what an effect is to the unit that is tested, by their paths: each is the
    /// only parameter of the effects of its role.
    const OF_UNIT: &'static [(&'static str, UnitRole)] = &[];

    /// How its command is corrected, if it has one.
    const COMMANDED: Option<Commanded> = None;

    /// Reads every table of a model but `[effects]`; `None` where what was read makes no set-up, and the
    /// problems are noted.
    fn read(model: &Reader) -> Option<Self::Setup>;

    /// The machine without any effect.
    fn ideal(setup: Arc<Self::Setup>) -> Self::Machine;

    /// Adds a correction to the command of a machine. Only what is [`COMMANDED`](Self::COMMANDED) is asked to.
    fn command(_machine: &mut Self::Machine, _command: Arc<Command>) {}

    /// The rows that lie outside the set-up.
    fn misplaced(setup: &Self::Setup, rows: &Rows) -> Vec<Misplaced>;

    /// The rows of the model's own programme, every coordinate resolved.
    fn programme(setup: &Self::Setup) -> Rows;

    /// The rows with every coordinate that they leave to the model filled in. As a rule they leave none.
    fn resolved(_setup: &Self::Setup, rows: &Rows) -> Rows {
        rows.clone()
    }

    /// Where the rows lie on the body, if there is one to show.
    fn places(_setup: &Self::Setup, _rows: &Rows) -> Option<Places> {
        None
    }

    /// The contour that is made, if there is one.
    fn contour(_setup: &Self::Setup) -> Option<Vec<Vec<Spot>>> {
        None
    }

    /// Directions of the rows that the way of measuring sets to zero. As a rule there are none.
    fn datum_directions(_setup: &Self::Setup, _rows: &Rows) -> Vec<DatumDirection> {
        Vec::new()
    }

    /// How an instrument reads these rows off others; as a rule it shows what `observe` gives.
    fn gauged(_setup: &Self::Setup, _rows: &Rows) -> Option<Gauged> {
        None
    }

    /// What a drawing allows the first observable at every place, with the words for it, where it asks no more.
    fn allowed(_setup: &Self::Setup) -> Option<(&Allowed, &'static AllowedWords)> {
        None
    }

    /// What a drawing asks of what is made; nothing where the model does not say.
    fn requirements(setup: &Self::Setup) -> Vec<Requirement> {
        Self::allowed(setup).map(|(allowed, words)| allowed.requirements(words)).unwrap_or_default()
    }

    /// The limits that a drawing sets to each row, SI; none to rows of which it asks nothing.
    fn limits(setup: &Self::Setup, rows: &Rows) -> Vec<Option<Limits>> {
        let limits = Self::allowed(setup).and_then(|(allowed, _)| Some(allowed.within.as_ref()?.0));
        (0..rows.len()).map(|row| limits.filter(|_| rows.observable[row] == 0)).collect()
    }

    /// What rows show of each part of that, part by part, given the observable of every row, SI.
    fn characteristics(setup: &Self::Setup, rows: &Rows, values: &[f64]) -> Vec<Characteristic> {
        let numbered = Self::IN_ORDER.and_then(|name| Self::COORDINATES.iter().position(|own| own.name == name));
        let number = |row: usize| Some(rows.get(numbered?, row)? as usize);
        let part = |row: usize| (rows.observable[row] == 0).then(|| number(row));
        Self::allowed(setup).map(|(allowed, _)| allowed.characteristics(values, part)).unwrap_or_default()
    }

    /// What to do beside the command, given the observable of rows of the commanded kind, SI.
    ///
    /// # Errors
    /// The machine cannot be computed.
    fn advice(_machine: &Self::Machine, _rows: &Rows, _values: &[f64]) -> Result<Vec<Advice>, Failure> {
        Ok(Vec::new())
    }

    /// How long its parts take, where it knows.
    fn making(_setup: &Self::Setup) -> Option<Making> {
        None
    }

    /// Why it cannot say what a change of a quantity does, by its path. As a rule it can, or nothing changes.
    fn no_law(_setup: &Self::Setup, _path: &str) -> Option<NoLaw> {
        None
    }

    /// Odds of an effect in such a set-up, where they are not those of the catalogue.
    fn odds(_setup: &Self::Setup, _effect: &str) -> Option<Odds> {
        None
    }

    /// Contradiction between the written values of an effect and the tables, if any: a model that says one thing twice,
    /// and differently.
    fn contradiction(_setup: &Self::Setup, _effect: &Active) -> Option<Contradiction> {
        None
    }

    /// Where along a coordinate a cause may stand though no row is measured there.
    fn reach(_setup: &Self::Setup, _coordinate: &str) -> Option<(f64, f64)> {
        None
    }

    /// Further experiments beside these rows.
    fn candidate_experiments(setup: &Self::Setup, rows: &Rows) -> Vec<CandidateExperiment>;

    /// Two of these experiments as one measurement, the second after the first, in the order in which the process numbers
    /// them; `None` where they cannot be made together.
    fn in_sequence(
        _setup: &Self::Setup,
        one: &CandidateExperiment,
        other: &CandidateExperiment,
    ) -> Option<CandidateExperiment> {
        let numbered = Self::IN_ORDER.and_then(|name| Self::COORDINATES.iter().position(|own| own.name == name));
        Some(numbered.map_or_else(|| one.then(other), |numbered| one.then_the_next(other, numbered)))
    }

    /// The unit of a machine that is tested, where the model names one.
    fn unit(_setup: &Self::Setup) -> Option<&str> {
        None
    }

    /// The part as a program of the machine sees it, if programs of it are corrected.
    fn program(_setup: &Self::Setup) -> Option<Workpiece> {
        None
    }

    /// The rows as a positioning test, if they are one.
    fn positioning(_setup: &Self::Setup) -> Option<&dyn Positioning> {
        None
    }

    /// Bound on the size of an observable, by its position, beyond which no value is believable.
    fn limit(setup: &Self::Setup, observable: usize) -> Limit;

    /// Predicts the observable of every row, SI.
    ///
    /// # Errors
    /// The computation failed.
    fn observe(machine: &Self::Machine, rows: &Rows) -> Result<Vec<f64>, Failure>;

    /// Physical impossibilities that the prediction of these rows implies, in sentences.
    ///
    /// # Errors
    /// The computation failed.
    fn doubts(_machine: &Self::Machine, _rows: &Rows) -> Result<Vec<String>, Failure> {
        Ok(Vec::new())
    }

    /// Why the work would not stay where it is held, as a sentence; as a rule nothing says that it would not.
    fn comes_loose(_machine: &Self::Machine) -> Option<String> {
        None
    }

    /// The same as [`observe`](Self::observe) for the rows of the programme, where their order saves work.
    ///
    /// # Errors
    /// The computation failed.
    fn predict(machine: &Self::Machine, programme: &Rows, progress: &Progress) -> Result<Vec<f64>, Failure> {
        progress.expect(1);
        let values = Self::observe(machine, programme)?;
        progress.advance(1);
        Ok(values)
    }

    /// Everything a run reports. Figures ask `forward` for what they need; what they took from the machine
    /// alone would lack the formula effects.
    ///
    /// # Errors
    /// The computation failed.
    fn report(machine: &Self::Machine, forward: &Forward) -> Result<RunReport, Failure>;
}

/// A value of an effect that says otherwise than a table of the model.
#[derive(Clone, Debug, PartialEq)]
pub struct Contradiction {
    /// Key of the value.
    pub parameter: &'static str,
    /// Both of them, as a sentence.
    pub message: String,
    /// Remedy: the text to write instead.
    pub help: String,
}

/// Bound on a prediction: a number beyond it, or none, comes from values that cannot be meant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// In SI units of the observable.
    pub size: f64,
    /// Why such a value is not believable: "no diameter can be so wrong".
    pub why: &'static str,
    /// Remedy: the inputs to check.
    pub help: &'static str,
}

/// What more a model to start from may have than the plain one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variant {
    /// The machine as beams and joints.
    Structure,
    /// The part as it is drawn, in finite elements.
    Sketch,
}

/// The forward function of a report: predictions with every effect acting, those that are formulas included.
pub struct Forward<'a> {
    /// The rows of the programme.
    pub programme: &'a Rows,
    /// Prediction of each of them, SI.
    pub prediction: &'a [f64],
    pub(super) observe: &'a (dyn Fn(&Rows) -> Result<Vec<f64>, Failure> + Sync),
    pub(super) add_formulas: &'a (dyn Fn(&Rows, &mut [f64]) + Sync),
    pub(super) has_formulas: bool,
}

impl Forward<'_> {
    /// Predicts the observable of any rows, SI.
    ///
    /// # Errors
    /// The computation failed.
    pub fn observe(&self, rows: &Rows) -> Result<Vec<f64>, Failure> {
        (self.observe)(rows)
    }

    /// Adds what formula effects change in `values` (SI, one per row), which were computed without them:
    /// whole fields, which would be too dear to ask for row by row.
    pub fn add_formulas(&self, rows: &Rows, values: &mut [f64]) {
        (self.add_formulas)(rows, values);
    }

    /// The same model with other predictions for the programme (SI), as an instrument may show them.
    pub fn showing<'b>(&'b self, prediction: &'b [f64]) -> Forward<'b> {
        Forward { prediction, ..*self }
    }

    /// Whether there are formula effects: else [`add_formulas`](Self::add_formulas) adds nothing.
    pub fn has_formulas(&self) -> bool {
        self.has_formulas
    }
}
