//! Trials of settings: the model with them, what it leaves and what they cost.

use std::sync::{Mutex, PoisonError};

use rayon::prelude::*;

use super::left::{Left, Made};
use super::lever::Lever;
use crate::input::ParameterId;
use crate::model::{Edit, Entry, Model};
use crate::process::{Failure, Making};
use crate::progress::Progress;
use crate::units::TIME;

/// Time between two parts that is longer than any cut, min: the cut is not known before the model is read.
const LONG: f64 = 1e7;

/// Where every setting is: its place, or none where it is as it is now.
pub type Places = Vec<Option<f64>>;

/// A trial.
#[derive(Clone, Debug, PartialEq)]
pub struct Trial {
    /// Where every setting is.
    pub places: Places,
    /// What is left.
    pub left: Left,
    /// Time more than now, s, for all parts.
    pub time: f64,
}

/// A model with what can be changed in it, and all that was tried.
pub struct Bench<'m> {
    /// The model.
    pub model: &'m Model,
    /// What can be changed.
    pub levers: Vec<Lever<'m>>,
    /// How long the parts take now.
    making: Option<Making>,
    /// Time from part to part where the model says it, s.
    cycle: Option<(ParameterId, f64)>,
    /// How many parts are made.
    pub parts: usize,
    /// What is made now.
    pub now: Made,
    /// Whether the work stays where it is held.
    is_held: bool,
    tried: Mutex<Vec<Trial>>,
    /// Counts evaluations.
    progress: &'m Progress,
}

impl<'m> Bench<'m> {
    /// Makes the parts as they are.
    ///
    /// # Errors
    /// The model cannot be computed.
    pub fn new(model: &'m Model, levers: Vec<Lever<'m>>, progress: &'m Progress) -> Result<Self, Failure> {
        let making = model.system.making();
        let written = |own: &Making| model.quantity(own.cycle);
        let cycle = making.as_ref().and_then(written).map(|own| (own.path.clone(), own.quantity.value));
        let bench = Self {
            model,
            making,
            cycle,
            parts: parts(model),
            is_held: model.forward().comes_loose().is_none(),
            now: Made::of(model)?,
            tried: Mutex::default(),
            levers,
            progress,
        };
        Ok(bench)
    }

    /// Everything as it is.
    pub fn nothing(&self) -> Trial {
        Trial { places: vec![None; self.levers.len()], left: self.now.left, time: 0.0 }
    }

    /// The edits that put settings to places.
    ///
    /// # Errors
    /// There is no such model; the reason.
    pub fn edits_at(&self, places: &Places) -> Result<Vec<Edit>, String> {
        let set = || self.levers.iter().zip(places).filter_map(|(lever, at)| Some((lever, (*at)?)));
        let mut edits: Vec<Edit> = set().flat_map(|(lever, at)| lever.edits(at)).collect();
        let says = |path: &str| set().any(|(lever, _)| lever.setting.paths().any(|own| own == path));
        // Where the cut becomes longer, loading between two parts does not become shorter.
        if let (Some((path, cycle)), Some(now)) = (self.cycle.as_ref().filter(|(path, _)| !says(path)), self.making) {
            let every =
                |minutes: f64| Edit::Set { path: path.clone(), entry: Entry::Text(format!("{minutes} {}", TIME.unit)) };
            edits.push(every(LONG));
            let part = self.edited(&edits)?.system.making().map_or(now.part, |own| own.part);
            edits.pop();
            if part != now.part {
                edits.push(every(TIME.from_si(cycle + (part - now.part))));
            }
        }
        Ok(edits)
    }

    /// The model with settings at places.
    ///
    /// # Errors
    /// There is no such model; the reason.
    pub fn model_at(&self, places: &Places) -> Result<Model, String> {
        self.edited(&self.edits_at(places)?)
    }

    fn edited(&self, edits: &[Edit]) -> Result<Model, String> {
        self.model.edited(edits).map_err(|problem| problem.message)
    }

    /// Tries settings at places.
    ///
    /// # Errors
    /// There is no such model, or it cannot be computed; the reason.
    pub fn at(&self, places: &Places) -> Result<(Trial, Made), String> {
        self.progress.evaluated();
        let model = self.model_at(places)?;
        let made = Made::of(&model).map_err(|failure| failure.message)?;
        if !made.left.rms.is_finite() {
            return Err("it leaves no number".into());
        }
        // Work that is loose already is not loosened by a setting.
        if let Some(loose) = model.forward().comes_loose().filter(|_| self.is_held) {
            return Err(loose);
        }
        let trial = Trial { places: places.clone(), left: made.left, time: self.time(&model, places) };
        self.tried.lock().unwrap_or_else(PoisonError::into_inner).push(trial.clone());
        Ok((trial, made))
    }

    /// Tries many.
    pub fn all(&self, all: Vec<Places>) -> Vec<Result<(Trial, Made), String>> {
        all.par_iter().map(|places| self.at(places)).collect()
    }

    /// Time that settings cost beside what is made now, s.
    fn time(&self, model: &Model, places: &Places) -> f64 {
        let changed = self.levers.iter().zip(places).filter(|(_, at)| at.is_some());
        let asked: f64 = changed.map(|(lever, _)| lever.setting.once + self.parts as f64 * lever.setting.each).sum();
        let longer = self.making.zip(model.system.making()).map_or(0.0, |(now, then)| then.whole - now.whole);
        asked + longer
    }

    /// All that was tried, in an order that does not depend on threads.
    pub fn tried(&self) -> Vec<Trial> {
        let mut all = self.tried.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let key =
            |trial: &Trial| -> Vec<f64> { trial.places.iter().map(|at| at.unwrap_or(f64::NEG_INFINITY)).collect() };
        all.sort_by(|a, b| {
            let order = key(a).into_iter().zip(key(b)).map(|(a, b)| a.total_cmp(&b));
            order.fold(std::cmp::Ordering::Equal, std::cmp::Ordering::then)
        });
        all.dedup_by(|a, b| a.places == b.places);
        all
    }

    /// Places with one setting changed.
    pub fn with(&self, lever: usize, at: f64) -> Places {
        let mut places = vec![None; self.levers.len()];
        places[lever] = (self.levers[lever].present != Some(at)).then_some(at);
        places
    }
}

/// How many parts a programme makes.
fn parts(model: &Model) -> usize {
    let programme = model.system.programme();
    let numbered = model.process.in_order();
    let column = model.process.coordinates().iter().position(|own| Some(&*own.name) == numbered);
    let Some(column) = column else { return 1 };
    let mut numbers: Vec<u64> =
        programme.columns[column].iter().filter(|own| own.is_finite()).map(|own| own.to_bits()).collect();
    numbers.sort_unstable();
    numbers.dedup();
    numbers.len().max(1)
}
