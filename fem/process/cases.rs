//! Validation cases: what a handbook, a closed form or a benchmark says, and what the program computes.

use toml_edit::Document;

use super::{Active, Assembled, Definition, Description, ForwardModel};
use crate::input::Reader;
use crate::progress::Progress;

/// How near the computed value must come, and never a figure fitted to the program: it follows from the
/// precision of the source or from the discretisation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tolerance {
    /// Part of the expected value.
    Relative(f64),
    /// In the case's unit.
    Absolute(f64),
}

/// One row of the validation table.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// What is computed.
    pub name: String,
    /// Which quantity.
    pub quantity: &'static str,
    /// What the source says.
    pub expected: f64,
    /// What the program computes.
    pub computed: f64,
    /// Unit of both.
    pub unit: &'static str,
    /// How near they must be.
    pub tolerance: Tolerance,
    /// Where the expected value comes from.
    pub source: &'static str,
}

impl Case {
    /// Relative error, or the absolute one where the tolerance is absolute.
    pub fn error(&self) -> f64 {
        match self.tolerance {
            Tolerance::Relative(_) => (self.computed - self.expected) / self.expected,
            Tolerance::Absolute(_) => self.computed - self.expected,
        }
    }

    /// The largest |error| that passes.
    pub fn allowed(&self) -> f64 {
        match self.tolerance {
            Tolerance::Relative(allowed) | Tolerance::Absolute(allowed) => allowed,
        }
    }

    /// Whether the error is a number within the tolerance.
    pub fn passed(&self) -> bool {
        self.error().abs() <= self.allowed()
    }

    /// Whether the source says `text`, in whatever case; `seed-002` is `seed 002`.
    pub fn cites(&self, text: &str) -> bool {
        let plain = |words: &str| words.to_lowercase().replace(['-', '_'], " ");
        plain(self.source).contains(&plain(text))
    }

    /// The work or the way of deriving that the source begins with, without where in it: `seed 002`.
    pub fn work(&self) -> &'static str {
        self.source.split([',', ';', ':', '(']).next().unwrap_or_default().trim()
    }
}

/// A row of the table: (expected, computed, unit).
pub fn row(
    name: impl Into<String>,
    quantity: &'static str,
    (expected, computed, unit): (f64, f64, &'static str),
    tolerance: Tolerance,
    source: &'static str,
) -> Case {
    Case { name: name.into(), quantity, expected, computed, unit, tolerance, source }
}

/// The root of a rising function between `low` and `high`, by bisection: slow, and nothing that could go
/// wrong with Newton's method goes wrong with it.
pub fn bisect(mut low: f64, mut high: f64, rising: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if rising(middle) > 0.0 { high = middle } else { low = middle }
    }
    0.5 * (low + high)
}

/// A machine with its effects from the texts of their tables, as a model file would have them. `None` where
/// a text is wrong: the row that needs it then holds NaN, and cannot pass.
pub fn assembled<D: Definition>(model: &str, effects: &str) -> Option<Assembled<D>> {
    let model = Document::parse(model).ok()?;
    let (setup, _, problems) = Reader::document(model.as_table(), D::read);
    let effects = Document::parse(effects).ok()?;
    let known: Vec<Description> = D::EFFECTS.iter().map(|e| e.description()).collect();
    let read = |table: &Reader| {
        let active = |(name, _): (&str, _)| {
            let description = known.iter().find(|d| d.name == name)?;
            Some(table.table(description.name, "", |t| description.read(t)))
        };
        effects.iter().map(active).collect::<Option<Vec<Active>>>()
    };
    let (active, _, more) = Reader::document(effects.as_table(), read);
    (problems.is_empty() && more.is_empty()).then_some(Assembled::new(setup?.into(), &active?))
}

/// A number of a run's figures by the figure's key and its path inside, in the unit in which it is told;
/// NaN where there is none.
pub fn figure<D: Definition>(machine: &Option<Assembled<D>>, key: &str, path: &str) -> f64 {
    let report = machine.as_ref().and_then(|m| m.report(m.predict(&Progress::default()).ok()?).ok());
    let figure = report.as_ref().and_then(|r| r.figures.iter().find(|f| f.key == key));
    figure.and_then(|f| f.told(path)).unwrap_or(f64::NAN)
}

/// A machine with one effect of its catalogue, values in canonical units: for the tests of effects.
#[cfg(test)]
pub fn with_effect<D: Definition>(model: &str, name: &str, canonical: &[f64]) -> Assembled<D> {
    let model = Document::parse(model).unwrap();
    let (setup, _, problems) = Reader::document(model.as_table(), D::read);
    assert_eq!(problems, []);
    let effect = D::EFFECTS.iter().map(|e| e.description()).find(|d| d.name == name).unwrap();
    let values = effect.parameters.iter().zip(canonical).map(|(p, v)| p.kind.to_si(*v)).collect();
    Assembled::new(setup.unwrap().into(), &[effect.with(values)])
}
