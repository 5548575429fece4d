//! Interface of a process to the layers above: three object-safe traits, made of every
//! [`Definition`](super::Definition) by one adapter.

use std::sync::Arc;

use super::{
    Active, Advice, CandidateExperiment, Characteristic, Command, Commanded, Contradiction, Coordinate, DatumDirection,
    Description, Failure, Limit, Making, Misplaced, NoLaw, Observable, Odds, Places, Positioning, Requirement, Rows,
    RunReport, Spot, UnitRole, Variant,
};
use crate::gcode::Workpiece;
use crate::input::Reader;
use crate::progress::Progress;
use crate::tolerance::Limits;
use crate::units::{Kind, MICRO, SMALL_ANGLE};

/// A way in which the system makes or moves something.
pub trait Process: Sync {
    /// The word after `process =`.
    fn name(&self) -> &'static str;

    /// Subject of its predictions, in half a sentence.
    fn about(&self) -> &'static str;

    /// Quantities that it predicts and that can be measured. Observables of one dimension are two ways to tell the
    /// same, and a file has one of them; those of different dimensions may stand side by side.
    fn observables(&self) -> &[Observable];

    /// Kind in which sizes of its errors are told, whatever is observed: an angle where angles alone are, else micrometres.
    #[doc(hidden)]
    fn size_kind(&self) -> Kind {
        let is_angle = self.observables().iter().all(|observable| observable.error_kind() == SMALL_ANGLE);
        if is_angle { SMALL_ANGLE } else { MICRO }
    }

    /// The coordinates and conditions under which it is measured.
    #[doc(hidden)]
    fn coordinates(&self) -> &[Coordinate];

    /// A commented model to start from.
    fn starting_model(&self) -> &'static str;

    /// Another one, where it has such.
    fn starting_variant(&self, _variant: Variant) -> Option<&'static str> {
        None
    }

    /// Its catalogue of effects, in the order in which people meet them.
    fn effects(&self) -> Vec<Description>;

    /// Coordinate that numbers what is made or measured one after another, if there is one.
    #[doc(hidden)]
    fn in_order(&self) -> Option<&'static str>;

    /// Why an effect cannot change between two numbers, if it cannot, as a sentence that goes on from its name.
    #[doc(hidden)]
    fn carried_over(&self, effect: &str) -> Option<&'static str>;

    /// Quantities of its tables, by their paths, that are what an effect is to the unit that a model tests.
    #[doc(hidden)]
    fn of_unit(&self) -> &'static [(&'static str, UnitRole)];

    /// Reads its tables. Problems are noted in the reader; the system is of use only if there were none,
    /// and `None` where the tables make no system at all.
    #[doc(hidden)]
    fn read(&self, model: &Reader) -> Option<Box<dyn System>>;
}

/// A machine, fixture, tool and workpiece, ideal but for the workpiece's own elasticity.
pub trait System: Send + Sync {
    /// Says why an effect cannot act in this system, if it cannot.
    ///
    /// # Errors
    /// The reason, as a sentence.
    fn admits(&self, effect: &str) -> Result<(), String>;

    /// Odds of an effect in this system, where they are not those of the catalogue.
    fn odds(&self, _effect: &str) -> Option<Odds> {
        None
    }

    /// Contradiction between the written values of an effect and the system, if any.
    fn contradiction(&self, effect: &Active) -> Option<Contradiction>;

    /// The rows that lie outside the system: off the body, beyond the programme.
    fn misplaced(&self, rows: &Rows) -> Vec<Misplaced>;

    /// Bound beyond which a value of an observable, by its number, cannot be meant; `None` where nothing is known of it.
    fn limit(&self, _observable: usize) -> Option<Limit> {
        None
    }

    /// The rows of its own programme, in the order in which they are predicted, every coordinate resolved.
    fn programme(&self) -> Rows;

    /// The rows with every coordinate that they leave to the model filled in.
    fn resolved(&self, rows: &Rows) -> Rows;

    /// Where the rows lie on the body; `None` where the process has none to show.
    fn places(&self, rows: &Rows) -> Option<Places>;

    /// The contour that is made, in the plane of its places, where there is one to draw measured rows on.
    fn contour(&self) -> Option<Vec<Vec<Spot>>>;

    /// The datum directions of these rows: what the way of measuring sets to zero, such as the centre of a
    /// least-squares circle. They are taken out of measured and predicted values alike, and each costs a
    /// degree of freedom.
    fn datum_directions(&self, rows: &Rows) -> Vec<DatumDirection>;

    /// What a drawing asks of what is made, as far as the model says.
    fn requirements(&self) -> Vec<Requirement>;

    /// The limits that a drawing sets to each row, SI; none to rows of which it asks nothing.
    fn limits(&self, rows: &Rows) -> Vec<Option<Limits>>;

    /// The value at which the maker of each row aims, SI: the middle of its limits; nothing where there are none.
    fn aims(&self, rows: &Rows) -> Vec<f64> {
        let middle = |limits: Option<Limits>| limits.and_then(|limits| limits.middle()).unwrap_or(0.0);
        self.limits(rows).into_iter().map(middle).collect()
    }

    /// The value of each row that a part without any error shows, SI: a set diameter. `None` where that is nothing for all.
    fn references(&self, rows: &Rows) -> Option<Vec<f64>> {
        let references = self.places(rows)?.references;
        references.iter().any(|own| *own != 0.0).then_some(references)
    }

    /// How its command is corrected, if it has one.
    fn commanded(&self) -> Option<Commanded>;

    /// The part as a program of the machine sees it, if programs of it are corrected.
    fn program(&self) -> Option<Workpiece>;

    /// What rows show of each part of that, given the observable of every row, SI.
    fn characteristics(&self, rows: &Rows, values: &[f64]) -> Vec<Characteristic>;

    /// How long its parts take, where it knows.
    fn making(&self) -> Option<Making> {
        None
    }

    /// Why it cannot say what a change of a quantity does, by its path.
    fn no_law(&self, _path: &str) -> Option<NoLaw> {
        None
    }

    /// Where along a coordinate a cause may stand though no row is measured there: on the body, where its
    /// warmth is felt. `None` where a cause shows only where it is measured.
    fn reach(&self, coordinate: &str) -> Option<(f64, f64)>;

    /// Further experiments beside these rows, for causes that they cannot tell apart.
    fn candidate_experiments(&self, rows: &Rows) -> Vec<CandidateExperiment>;

    /// Two of these experiments as one measurement; `None` where they cannot be made together.
    fn in_sequence(&self, one: &CandidateExperiment, other: &CandidateExperiment) -> Option<CandidateExperiment>;

    /// The unit of a machine that is tested, where the model names one.
    fn unit(&self) -> Option<&str>;

    /// The rows as a positioning test, where they are one: then errors can be compensated.
    fn positioning(&self) -> Option<&dyn Positioning>;

    /// The system with effects acting, ready to predict.
    fn with_effects(&self, effects: &[Active]) -> Box<dyn ForwardModel>;

    /// The same with a correction of its command, if it has one.
    fn with_command(&self, effects: &[Active], command: &Arc<Command>) -> Box<dyn ForwardModel>;
}

/// A system with its effects acting: rows in, values out.
pub trait ForwardModel: Send + Sync {
    /// The observable at every point of the model's own programme, SI units.
    ///
    /// # Errors
    /// The computation failed: the body is loose, an equilibrium was not found, or a value is not believable.
    fn predict(&self, progress: &Progress) -> Result<Vec<f64>, Failure>;

    /// Predicts each row, in SI units of its observable.
    ///
    /// # Errors
    /// The computation failed, or a value is not believable.
    fn observe(&self, rows: &Rows) -> Result<Vec<f64>, Failure>;

    /// Physical impossibilities that the prediction of these rows implies, in sentences.
    ///
    /// # Errors
    /// The computation failed.
    fn doubts(&self, rows: &Rows) -> Result<Vec<String>, Failure>;

    /// Why the work would not stay where it is held, as a sentence.
    fn comes_loose(&self) -> Option<String> {
        None
    }

    /// What to do beside the command, given the observable of rows of the commanded kind, SI.
    ///
    /// # Errors
    /// The computation failed.
    fn advice(&self, _rows: &Rows, _values: &[f64]) -> Result<Vec<Advice>, Failure> {
        Ok(Vec::new())
    }

    /// Everything a run reports, given the prediction of the programme.
    ///
    /// # Errors
    /// The computation failed.
    fn report(&self, prediction: Vec<f64>) -> Result<RunReport, Failure>;
}
