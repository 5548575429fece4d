//! Effects: named physical causes with parameters, each in a file of its own.

use std::borrow::Cow;
use std::sync::Arc;

use super::{Belongs, Failure, FormulaLaw};
use crate::input::{Bounds, Doubt, Grows, Name, ParameterId, Reader};
use crate::units::{Kind, NUMBER};

/// An effect of the catalogue, as data: what it is, what it needs of a set-up `S`, and its law, which
/// shapes a machine `M`. The law takes the values of its `N` parameters (SI) in the order in which they are
/// listed.
pub struct Effect<S, M, const N: usize> {
    /// The word in `[effects.NAME]`.
    pub name: &'static str,
    /// The phenomenon, in one sentence.
    pub about: &'static str,
    /// The equation.
    pub law: &'static str,
    /// Where the law comes from.
    pub source: &'static str,
    /// Its owner, where several tests look at one machine.
    pub belongs: Belongs,
    /// How often it acts.
    pub odds: Odds,
    /// In the order of the law.
    pub parameters: [Parameter; N],
    /// Effects whose signature can be the same, and what separates them.
    pub look_alikes: &'static [(&'static str, &'static str)],
    /// Checks the set-up for the tables that it needs; the reason, as a sentence that goes on from the effect's name,
    /// where they are not there.
    pub needs: fn(&S) -> Result<(), String>,
    /// Lets it act.
    pub act: fn([f64; N], &mut M),
}

/// How often machines have an effect at a size that shows, before anything is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Odds {
    /// Odds against one: 1 where every second machine has it.
    pub to_one: f64,
    /// Why.
    pub because: &'static str,
}

impl Odds {
    /// Odds with their reason.
    pub const fn of(to_one: f64, because: &'static str) -> Self {
        Self { to_one, because }
    }
}

/// Needs of an effect that can act in every set-up: none.
pub fn nothing<S>(_setup: &S) -> Result<(), String> {
    Ok(())
}

/// An effect of a catalogue, whatever the number of its parameters.
pub trait CatalogueEffect<S, M>: Sync {
    /// Its name, law, source and parameters.
    fn description(&'static self) -> Description;

    /// Whether it can act in a set-up.
    ///
    /// # Errors
    /// The reason why not, as a sentence that goes on from the effect's name.
    fn admissible(&self, setup: &S) -> Result<(), String>;

    /// Lets it act on a machine, with values (SI) in the order of its parameters.
    ///
    /// # Errors
    /// There are not as many values as parameters.
    fn act(&self, values: &[f64], machine: &mut M) -> Result<(), Failure>;
}

impl<S, M, const N: usize> CatalogueEffect<S, M> for Effect<S, M, N> {
    fn description(&'static self) -> Description {
        Description {
            table: EFFECTS,
            name: Name::new(self.name),
            observable: None,
            about: Cow::Borrowed(self.about),
            law: Cow::Borrowed(self.law),
            source: self.source,
            belongs: self.belongs,
            odds: self.odds,
            parameters: Cow::Borrowed(&self.parameters),
            look_alikes: self.look_alikes,
            changes: None,
        }
    }

    fn admissible(&self, setup: &S) -> Result<(), String> {
        (self.needs)(setup)
    }

    fn act(&self, values: &[f64], machine: &mut M) -> Result<(), Failure> {
        let values: [f64; N] = values.try_into().map_err(|_| Failure {
            message: format!("`{}` has {N} parameters, and {} values were given", self.name, values.len()),
            help: "give one value for each parameter, in the order of its list".into(),
        })?;
        (self.act)(values, machine);
        Ok(())
    }
}

/// Table of a model file for effects of the machine, the fixture and the part.
pub const EFFECTS: &str = "effects";

/// In the place of a table: a value that the model file has already, under the path that is its name, is on trial.
pub const ON_TRIAL: &str = "on trial";

/// An effect as `fem effects` describes it, with all that is needed to read it from a model.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Description {
    /// Table of a model file under which it stands: [`EFFECTS`], or that of the measurement.
    pub table: &'static str,
    /// The word in `[effects.NAME]`.
    pub name: Name,
    /// Observable on which an effect of the measurement acts, where there are several.
    #[doc(hidden)]
    pub observable: Option<Name>,
    /// The phenomenon, in one sentence.
    pub about: Cow<'static, str>,
    /// The equation.
    pub law: Cow<'static, str>,
    /// Where the law comes from.
    pub source: &'static str,
    /// Its owner, where several tests look at one machine.
    #[doc(hidden)]
    pub belongs: Belongs,
    /// How often it acts.
    #[doc(hidden)]
    pub odds: Odds,
    /// In the order of the law.
    pub parameters: Cow<'static, [Parameter]>,
    /// Effects whose signature can be the same, and what separates them.
    pub look_alikes: &'static [(&'static str, &'static str)],
    /// The effect whose values it changes, where it is the change of one.
    #[doc(hidden)]
    pub changes: Option<Name>,
}

/// A parameter of an effect.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// The key.
    pub name: Name,
    /// Its kind, with the canonical unit.
    pub kind: Kind,
    /// Its meaning, in a few words.
    pub about: &'static str,
    /// Where the effect vanishes.
    pub neutral: Neutral,
    /// Physically plausible range, in the canonical unit.
    pub range: (f64, f64),
    /// Values with which the law can be computed.
    pub bounds: Bounds,
    /// SI value where the key is left out; `None` where it must be written.
    pub default: Option<f64>,
    /// A parameter without which this one may be left out: while that one is zero it has nothing to shape.
    pub needed_with: Option<&'static str>,
    /// The coordinate along which it is a place, if it is one.
    pub along: Option<Name>,
    /// In the canonical unit, where values that differ by it are the same: results stand within half of it
    /// on either side of zero.
    pub period: Option<f64>,
    /// Whether the law is a step in it, which numbers parts or the like: between whole numbers it has no slope.
    pub is_step: bool,
    /// The values of what is observed (SI) between which a shape of the instrument's scale is told, if it is one.
    pub over: Option<[f64; 2]>,
}

/// The value of a parameter at which its effect vanishes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Neutral {
    /// A number in the canonical unit.
    Value(f64),
    /// A stiffness that does not yield.
    Infinity,
    /// The parameter shapes the effect and does not switch it.
    Shape,
    /// What somebody wrote, in the canonical unit: a value on trial, and how its effect grows with it.
    Written(f64, Grows),
}

/// An effect of a model with the values of its parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct Active {
    /// The effect.
    pub description: Description,
    /// SI values in the order of its parameters.
    pub values: Vec<f64>,
    /// Its law, where it is a formula; effects of the catalogue have theirs in the catalogue.
    pub formula: Option<Arc<FormulaLaw>>,
}

impl Description {
    /// Whether it is a step: something that is otherwise from a place in a series on.
    #[doc(hidden)]
    pub fn is_step(&self) -> bool {
        self.parameters.iter().any(|parameter| parameter.is_step)
    }

    /// Name for people: with the observable, where several effects have the name.
    pub fn label(&self) -> Cow<'static, str> {
        match &self.observable {
            Some(observable) => format!("{} of {observable}", self.name).into(),
            None => self.name.clone().into(),
        }
    }

    /// Path of one of its parameters in a model file.
    #[doc(hidden)]
    pub fn path(&self, parameter: &Parameter) -> ParameterId {
        if self.table == ON_TRIAL {
            return (&*self.name).into();
        }
        let of = self.observable.as_ref().map_or(String::new(), |name| format!("-{name}"));
        format!("{}.{}{of}.{}", self.table, self.name, parameter.name).into()
    }

    /// Reads the parameters from an effect's table.
    #[doc(hidden)]
    pub fn read(&self, table: &Reader) -> Active {
        let mut values: Vec<f64> = Vec::with_capacity(self.parameters.len());
        for p in &*self.parameters {
            let field = table.quantity(p.name.clone(), p.kind, p.about).bounds(p.bounds);
            let is_zero = |name: &str| {
                let read = || self.parameters.iter().zip(&values);
                read().any(|(p, v)| p.name == name && *v == 0.0) && !table.is_uncertain(name)
            };
            values.push(match (p.default, p.needed_with) {
                (Some(default), _) => field.or(default),
                (None, Some(other)) if is_zero(other) => field.or(p.kind.to_si(p.range.0)),
                _ => field.required(),
            });
        }
        self.with(values)
    }

    /// The effect with these values of its parameters, SI.
    #[doc(hidden)]
    pub fn with(&self, values: Vec<f64>) -> Active {
        Active { description: self.clone(), values, formula: None }
    }

    /// The effect with every parameter at its neutral value, and a plausible one where it has none.
    #[doc(hidden)]
    pub fn neutral(&self) -> Active {
        let value = |p: &Parameter| match p.neutral {
            Neutral::Value(value) | Neutral::Written(value, _) => p.kind.to_si(value),
            Neutral::Infinity => f64::INFINITY,
            Neutral::Shape => p.kind.to_si(p.example()),
        };
        self.with(self.parameters.iter().map(value).collect())
    }

    /// The effect with every parameter at a plausible value.
    #[doc(hidden)]
    pub fn typical(&self) -> Active {
        self.with(self.parameters.iter().map(|p| p.kind.to_si(p.example())).collect())
    }
}

impl Parameter {
    const fn new(
        name: &'static str,
        kind: Kind,
        about: &'static str,
        neutral: Neutral,
        bounds: Bounds,
        range: (f64, f64),
    ) -> Self {
        Self {
            name: Name::new(name),
            kind,
            about,
            neutral,
            range,
            bounds,
            default: None,
            needed_with: None,
            along: None,
            period: None,
            is_step: false,
            over: None,
        }
    }

    /// A stiffness: infinite is neutral.
    pub const fn stiffness(kind: Kind, about: &'static str, range: (f64, f64)) -> Self {
        Self::conductance("stiffness", kind, about, range)
    }

    /// A conductance or a hold: infinite is neutral.
    pub const fn conductance(name: &'static str, kind: Kind, about: &'static str, range: (f64, f64)) -> Self {
        Self::new(name, kind, about, Neutral::Infinity, Bounds::Positive, range)
    }

    /// A quantity of either sign that is neutral at zero.
    pub const fn signed(name: &'static str, kind: Kind, about: &'static str, range: (f64, f64)) -> Self {
        Self::new(name, kind, about, Neutral::Value(0.0), Bounds::Any, range)
    }

    /// A factor of either side of one, at which it is neutral.
    pub const fn factor(name: &'static str, kind: Kind, about: &'static str, range: (f64, f64)) -> Self {
        Self::new(name, kind, about, Neutral::Value(1.0), Bounds::Any, range)
    }

    /// A quantity that is never negative and neutral at zero.
    pub const fn amplitude(name: &'static str, kind: Kind, about: &'static str, range: (f64, f64)) -> Self {
        Self::new(name, kind, about, Neutral::Value(0.0), Bounds::NotNegative, range)
    }

    /// A positive quantity that shapes the effect without switching it: a time constant, a width.
    pub const fn shape(name: &'static str, kind: Kind, about: &'static str, range: (f64, f64)) -> Self {
        Self::new(name, kind, about, Neutral::Shape, Bounds::Positive, range)
    }

    /// A value (in the canonical unit) for this parameter that may have been written wrongly, by a factor that is usually
    /// no more than this.
    pub fn on_trial(&self, value: f64, factor: f64) -> Self {
        let grows = match self.neutral {
            Neutral::Infinity => Grows::Inversely,
            Neutral::Value(0.0) => Grows::Linearly,
            Neutral::Value(_) | Neutral::Shape | Neutral::Written(..) => Grows::Otherwise,
        };
        let range = (value / factor, value * factor);
        Self::written(self.name.clone(), self.kind, self.bounds, Neutral::Written(value, grows), range)
    }

    /// A quantity of a table, with its value in SI, that may have been written wrongly.
    pub fn doubted(name: Name, (kind, bounds): (Kind, Bounds), si: f64, doubt: Doubt) -> Self {
        let (low, high) = match doubt.grows {
            Grows::Evenly => (si - doubt.off, si + doubt.off),
            Grows::Linearly | Grows::Inversely | Grows::Otherwise => (si / doubt.off, si * doubt.off),
        };
        let neutral = Neutral::Written(kind.from_si(si), doubt.grows);
        Self::written(name, kind, bounds, neutral, (kind.from_si(low), kind.from_si(high)))
    }

    fn written(name: Name, kind: Kind, bounds: Bounds, neutral: Neutral, range: (f64, f64)) -> Self {
        Self { name, ..Self::new("", kind, "the value that is written", neutral, bounds, range) }
    }

    /// A value for an example, in the canonical unit: in the middle of the plausible range, with one digit.
    pub fn example(&self) -> f64 {
        let (low, high) = self.range;
        let middle = if low > 0.0 { (low * high).sqrt() } else { 0.5 * high };
        let digit = 10f64.powf(middle.abs().log10().floor());
        if middle == 0.0 { 0.0 } else { (middle / digit).round() * digit }
    }

    /// With other bounds.
    #[must_use]
    pub const fn within(mut self, bounds: Bounds) -> Self {
        self.bounds = bounds;
        self
    }

    /// A place along a coordinate, which shapes the effect without switching it.
    pub const fn place(
        name: &'static str,
        kind: Kind,
        about: &'static str,
        along: &'static str,
        range: (f64, f64),
    ) -> Self {
        Self {
            name: Name::new(name),
            kind,
            about,
            neutral: Neutral::Shape,
            range,
            bounds: Bounds::Any,
            default: None,
            needed_with: None,
            along: Some(Name::new(along)),
            period: None,
            is_step: false,
            over: None,
        }
    }

    /// The number, of those that count along a coordinate, after which something happens; what is no whole number is
    /// rounded to one by the law.
    pub const fn after(name: &'static str, about: &'static str, along: &'static str, range: (f64, f64)) -> Self {
        let mut after = Self::place(name, NUMBER, about, along, range);
        after.bounds = Bounds::Positive;
        after.is_step = true;
        after
    }

    /// A phase, which shapes the effect without switching it and comes round after `period` (in the
    /// canonical unit).
    pub const fn phase(name: &'static str, kind: Kind, about: &'static str, period: f64) -> Self {
        let range = (-0.5 * period, 0.5 * period);
        let mut phase = Self::new(name, kind, about, Neutral::Shape, Bounds::Any, range);
        phase.period = Some(period);
        phase
    }

    /// Whether a value (SI) is within the plausible range.
    pub fn is_plausible(&self, value: f64) -> bool {
        (self.range.0..=self.range.1).contains(&self.kind.from_si(value))
    }

    /// Multiple of the period that brings a value (SI) into the half-open period about zero when added; zero where
    /// there is no period.
    pub fn turn(&self, value: f64) -> f64 {
        match self.period.map(|p| self.kind.to_si(p)) {
            Some(period) if value.is_finite() => -period * (value / period - 0.5).ceil(),
            _ => 0.0,
        }
    }

    /// May be left out, and is then `si`.
    #[must_use]
    pub const fn or(mut self, si: f64) -> Self {
        self.default = Some(si);
        self
    }

    /// May be left out while `other` is zero.
    #[must_use]
    pub const fn needed_with(mut self, other: &'static str) -> Self {
        self.needed_with = Some(other);
        self
    }
}
