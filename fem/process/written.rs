//! Effects that users write: a formula over the process's coordinates and the effect's own parameters, added to what is observed.

use std::collections::HashSet;
use std::sync::{Arc, Mutex, PoisonError};

use super::{Active, Description, Failure, Holds, Job, Outcome, Parameter, Process, Rows, System};
use crate::formula::Formula;
use crate::progress::Progress;
use crate::units::Dimension;

/// The law of an effect that a user has written.
#[derive(Clone, Debug, PartialEq)]
pub struct WrittenLaw {
    formula: Formula,
    /// What each name of the formula stands for.
    meanings: Vec<Meaning>,
    /// Which observables it adds to, by their position in the process's list.
    adds_to: Vec<bool>,
}

/// What a name in a formula stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Meaning {
    /// A coordinate, by its position in the process's list.
    Coordinate(usize),
    /// A parameter, by its position in the effect's.
    Parameter(usize),
}

impl WrittenLaw {
    /// A formula whose names have these meanings and whose result adds to these observables.
    pub fn new(formula: Formula, meanings: Vec<Meaning>, adds_to: Vec<bool>) -> Self {
        Self { formula, meanings, adds_to }
    }

    /// What it adds to every row, SI; `rows` with every coordinate resolved.
    fn values(&self, rows: &Rows, parameters: &[f64]) -> Vec<f64> {
        let mut names = vec![0.0; self.meanings.len()];
        let value = |row: usize| {
            if !self.adds_to[rows.observable[row]] {
                return 0.0;
            }
            for (name, meaning) in names.iter_mut().zip(&self.meanings) {
                *name = match *meaning {
                    Meaning::Coordinate(column) => rows.columns[column][row],
                    Meaning::Parameter(i) => parameters[i],
                };
            }
            self.formula.value(&names)
        };
        (0..rows.len()).map(value).collect()
    }
}

/// The dimension of a coordinate's values in a formula; numbers and words are pure.
pub fn dimension(holds: Holds) -> Dimension {
    match holds {
        Holds::Quantity(kind) => kind.canonical().dimension,
        Holds::Number(_) | Holds::Word(_) => Dimension::NONE,
    }
}

/// A system with effects acting, those that users have written among them.
pub fn equip(system: &Arc<dyn System>, effects: &[Active]) -> Box<dyn Job> {
    let job = system.equip(effects);
    let written: Vec<Active> = effects.iter().filter(|e| e.written.is_some()).cloned().collect();
    if written.is_empty() { job } else { Box::new(WithWritten { job, system: system.clone(), written }) }
}

struct WithWritten {
    job: Box<dyn Job>,
    system: Arc<dyn System>,
    written: Vec<Active>,
}

impl WithWritten {
    fn add(&self, mut values: Vec<f64>, rows: &Rows) -> Vec<f64> {
        let blind = self.system.blind(rows);
        let rows = self.system.resolved(rows);
        for active in &self.written {
            let Some(law) = active.written else { continue };
            values.iter_mut().zip(law.values(&rows, &active.values)).for_each(|(v, more)| *v += more);
        }
        blind.iter().for_each(|direction| direction.take_out(&mut values));
        values
    }
}

impl Job for WithWritten {
    fn predict(&self, progress: &Progress) -> Result<Vec<f64>, Failure> {
        let values = self.add(self.job.predict(progress)?, &self.system.programme());
        match values.iter().all(|v| v.is_finite()) {
            true => Ok(values),
            false => Err(Failure {
                message: "a formula of the model gives no finite number somewhere".into(),
                help: "check it for divisions by zero, roots and logarithms of what is negative".into(),
            }),
        }
    }

    fn observe(&self, rows: &Rows) -> Result<Vec<f64>, Failure> {
        Ok(self.add(self.job.observe(rows)?, rows))
    }

    fn outcome(&self, prediction: Vec<f64>) -> Result<Outcome, Failure> {
        self.job.outcome(prediction)
    }
}

/// Descriptions and laws are kept for the life of the program, each once however often a model is read: they stand beside those of the
/// catalogue, which are constants.
static KEPT: Mutex<Vec<(&'static Description, &'static WrittenLaw)>> = Mutex::new(Vec::new());
static WORDS: Mutex<Option<HashSet<&'static str>>> = Mutex::new(None);

/// Keeps a written effect: its name, what it is, its formula as written, its parameters and its law.
pub fn keep(
    name: &'static str,
    about: &str,
    formula: &str,
    parameters: &[Parameter],
    law: WrittenLaw,
) -> (&'static Description, &'static WrittenLaw) {
    // A panic while the list was held leaves it whole: entries are added in one step each.
    let mut kept = KEPT.lock().unwrap_or_else(PoisonError::into_inner);
    let same = |d: &Description| d.name == name && d.about == about && d.law == formula && d.parameters == parameters;
    if let Some(known) = kept.iter().find(|(d, l)| same(d) && **l == law) {
        return *known;
    }
    let description = Description {
        name,
        about: word(about),
        law: word(formula),
        source: "written in the model file",
        parameters: Box::leak(parameters.into()),
        look_alikes: &[],
    };
    let entry: (&'static Description, &'static WrittenLaw) =
        (Box::leak(Box::new(description)), Box::leak(Box::new(law)));
    kept.push(entry);
    entry
}

/// Keeps a word.
pub fn word(text: &str) -> &'static str {
    let mut words = WORDS.lock().unwrap_or_else(PoisonError::into_inner);
    let words = words.get_or_insert_default();
    if let Some(known) = words.get(text) {
        return known;
    }
    let kept: &'static str = Box::leak(text.to_string().into_boxed_str());
    words.insert(kept);
    kept
}

/// What names may stand for in formulas of a process.
pub fn coordinates(process: &dyn Process) -> impl Iterator<Item = (&'static str, Dimension)> {
    process.coordinates().iter().map(|c| (c.name, dimension(c.holds)))
}
