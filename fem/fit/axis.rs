//! The axis along which a parameter is searched: where the prediction is nearly linear in it, and inside its bounds.

use crate::input::{Bounds, Parameter};
use crate::process::Neutral;
use crate::units::{Knowledge, Quantity};

/// A parameter as the search sees it.
#[derive(Clone, Debug)]
pub struct Axis {
    scale: Scale,
    /// Bounds in the search variable.
    pub low: f64,
    /// Upper bound in the search variable.
    pub high: f64,
    /// Prior value and standard uncertainty, SI.
    pub prior: Option<(f64, f64)>,
    /// A usual size of the search variable, for steps.
    pub unit: f64,
    /// Values to start from, SI.
    pub starts: Vec<f64>,
}

/// How far beyond the plausible range a shape is tried, as a ratio.
const BEYOND: f64 = 2.0;

/// A stiffness that is roughly known is not this many times smaller.
const SOFTEST: f64 = 20.0;

/// Effects this many times larger than what is plausible are not tried.
const IMPOSSIBLE: f64 = 10.0;

/// How the search variable s relates to the value v.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Scale {
    /// s = v.
    Plain,
    /// s = 1/v: a stiffness, in whose reciprocal deflections are linear and an infinite one is zero.
    Reciprocal,
    /// s = ln v: a positive quantity of unknown size.
    Logarithm,
}

impl Axis {
    /// The axis of a model's parameter; `entry` is its place in the catalogue, if it belongs to an effect.
    pub fn new(parameter: &Parameter, entry: Option<&'static crate::process::Parameter>) -> Self {
        let prior = match parameter.quantity.knowledge {
            Knowledge::Rough(std) => Some((parameter.quantity.value, std)),
            Knowledge::Free | Knowledge::Known => None,
        };
        let scale = match (entry.map(|e| e.neutral), parameter.bounds) {
            (Some(Neutral::Infinity), _) => Scale::Reciprocal,
            (_, Bounds::Positive) => Scale::Logarithm,
            _ => Scale::Plain,
        };
        let range = entry.map(|e| (e.kind.to_si(e.range.0), e.kind.to_si(e.range.1)));
        let usual = entry.map_or_else(
            || parameter.kind.to_si(parameter.kind.usual.parse().unwrap_or(1.0)),
            |e| e.kind.to_si(e.example()),
        );
        let shapes = entry.is_some_and(|e| e.neutral == Neutral::Shape);
        let written = parameter.quantity.value;
        let starts = match (prior, range) {
            (Some((value, _)), _) => vec![value],
            _ if !written.is_nan() => vec![written],
            (None, Some((low, high))) if shapes => spread(low, high),
            // Of what belongs to no effect only the kind is known.
            (None, None) => vec![usual, 0.1 * usual, 10.0 * usual],
            _ => vec![usual],
        };
        let (low, mut high) = bounds(scale, parameter.bounds);
        if let (Scale::Reciprocal, Some((value, _))) = (scale, prior) {
            // In 1/v a prior on v levels out, and a search that passes the crest would run away to no stiffness at all.
            high = SOFTEST / value;
        }
        let unit = match scale {
            Scale::Logarithm => 1.0,
            Scale::Plain => prior.map_or(usual.abs(), |p| p.1).max(f64::MIN_POSITIVE),
            Scale::Reciprocal => 1.0 / usual,
        };
        Self { scale, low, high, prior, unit, starts }
    }

    /// The axis of a parameter of an effect that is tried. What shapes the effect stays near what is plausible (a place within `extent`,
    /// where it was measured): far from it one effect imitates another, and no cause is learnt.
    pub fn on_trial(entry: &'static crate::process::Parameter, extent: Option<(f64, f64)>) -> Self {
        let parameter = Parameter {
            path: String::new(),
            kind: entry.kind,
            quantity: Quantity { value: f64::NAN, knowledge: Knowledge::Free },
            bounds: entry.bounds,
            span: None,
        };
        let mut axis = Self::new(&parameter, Some(entry));
        let plausible = (entry.kind.to_si(entry.range.0), entry.kind.to_si(entry.range.1));
        if entry.neutral != Neutral::Shape {
            let largest = IMPOSSIBLE * if axis.is_reversed() { 1.0 / plausible.0 } else { plausible.1 };
            (axis.low, axis.high) = (axis.low.max(-largest), axis.high.min(largest));
            return axis;
        }
        let (low, high) = match extent {
            Some(extent) => extent,
            None if axis.scale == Scale::Logarithm => (plausible.0 / BEYOND, plausible.1 * BEYOND),
            // Past its end a phase begins again: there is no bound to be stopped by.
            None if entry.period.is_some() => (2.0 * plausible.0, 2.0 * plausible.1),
            // What is left out has a value that is as plausible as any.
            None => (entry.default.map_or(plausible.0, |d| d.min(plausible.0)), plausible.1),
        };
        let allowed = (axis.low, axis.high);
        (axis.low, axis.high) = (axis.position(low).max(allowed.0), axis.position(high).min(allowed.1));
        axis.unit = if axis.scale == Scale::Logarithm { 1.0 } else { 0.5 * (axis.high - axis.low) };
        axis.starts = extent.map_or_else(|| spread(plausible.0, plausible.1), |(low, high)| spread(low, high));
        axis
    }

    /// The search variable of a value.
    pub fn position(&self, value: f64) -> f64 {
        match self.scale {
            Scale::Plain => value,
            Scale::Reciprocal => 1.0 / value,
            Scale::Logarithm => value.ln(),
        }
        .clamp(self.low, self.high)
    }

    /// The value at a search variable.
    pub fn value(&self, position: f64) -> f64 {
        match self.scale {
            Scale::Plain => position,
            Scale::Reciprocal => 1.0 / position,
            Scale::Logarithm => position.exp(),
        }
    }

    /// |dv/ds|.
    pub fn rate(&self, position: f64) -> f64 {
        match self.scale {
            Scale::Plain => 1.0,
            Scale::Reciprocal => 1.0 / (position * position),
            Scale::Logarithm => position.exp(),
        }
    }

    /// Evenly spaced search variables over the bounds, both of which are finite.
    pub fn grid(&self, count: usize) -> Vec<f64> {
        self.grid_within(self.low, self.high, count)
    }

    /// The same between two search variables.
    pub fn grid_within(&self, low: f64, high: f64, count: usize) -> Vec<f64> {
        let part = |i: usize| (i as f64 + 0.5) / count as f64;
        (0..count).map(|i| (low + (high - low) * part(i)).clamp(self.low, self.high)).collect()
    }

    /// The search variable at which the effect is switched off, for a parameter that switches it.
    pub fn neutral(&self) -> f64 {
        0f64.clamp(self.low, self.high)
    }

    /// The bounds, of a positive quantity of unknown size no more than a factor of some hundred thousand away: further off it is as good as zero or
    /// infinite.
    pub fn within_reach(&self, of: f64) -> (f64, f64) {
        const REACH: f64 = 12.0;
        match self.scale {
            Scale::Logarithm => (self.low.max(of - REACH), self.high.min(of + REACH)),
            Scale::Plain | Scale::Reciprocal => (self.low, self.high),
        }
    }

    /// Whether values fall where the search variable rises.
    pub fn is_reversed(&self) -> bool {
        self.scale == Scale::Reciprocal
    }
}

/// Five values over a plausible range, evenly by ratio where it is positive.
fn spread(low: f64, high: f64) -> Vec<f64> {
    let part = |i: i32| f64::from(2 * i + 1) / 10.0;
    let at = |i| if low > 0.0 { low * (high / low).powf(part(i)) } else { low + (high - low) * part(i) };
    (0..5).map(at).collect()
}

fn bounds(scale: Scale, bounds: Bounds) -> (f64, f64) {
    match (scale, bounds) {
        // An infinite stiffness is zero compliance.
        (Scale::Reciprocal, _) => (0.0, f64::INFINITY),
        // e^±80 spans every physical size.
        (Scale::Logarithm, _) => (-80.0, 80.0),
        (Scale::Plain, Bounds::Positive) => (f64::MIN_POSITIVE, f64::INFINITY),
        (Scale::Plain, Bounds::NotNegative) => (0.0, f64::INFINITY),
        (Scale::Plain, Bounds::Within(low, high)) => (low + 1e-3 * (high - low), high),
        (Scale::Plain, Bounds::Any) => (f64::NEG_INFINITY, f64::INFINITY),
    }
}
