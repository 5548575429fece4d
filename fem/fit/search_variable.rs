//! Search variables: transformed parameters in which the prediction is nearly linear, within bounds.

use super::steps::Steps;
use super::usual::Usual;
use crate::input::{Bounds, Grows, Parameter};
use crate::process::Neutral;
use crate::units::{Knowledge, Quantity};

/// Parameter as the search sees it: transformed, bounded, with its prior and its starts.
#[derive(Clone, Debug)]
pub struct SearchVariable {
    scale: Scale,
    /// Lower bound of the search variable.
    pub low: f64,
    /// Upper bound of the search variable.
    pub high: f64,
    /// Prior value and standard uncertainty, SI.
    pub prior: Option<(f64, f64)>,
    /// Usual size of the search variable, for steps.
    pub unit: f64,
    /// Starting values, SI.
    pub starts: Vec<f64>,
    /// Whether it is an unknown of the set-up itself, of which no law says how many minima χ² has along it.
    pub is_surveyed: bool,
    /// Bounds that never give way; those that are closer do where the data say so.
    limits: (f64, f64),
    /// What is usual, if it belongs to a candidate effect.
    pub usual: Option<Usual>,
    /// Where it may stand, if the law is a step in it.
    pub steps: Option<Steps>,
}

/// Ratio beyond the plausible range up to which a nonlinear parameter is tried.
const BEYOND: f64 = 2.0;

/// Most times that a stiffness may be smaller than its prior value.
const SOFTEST: f64 = 20.0;

/// Largest size of a candidate effect, in terms of the largest plausible one, that a fit tries before it asks whether
/// more is worth its while, and by how much more it goes on.
const FAR: f64 = 10.0;

/// Largest size of an unknown of the model, in terms of its usual one, that a fit tries before it asks.
const AWAY: f64 = 100.0;

/// Usual size of ln (v/v₀) of a value that somebody wrote as v₀, for steps.
const RATIO: f64 = 0.2;

/// Transformation between the search variable s and the value v.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Scale {
    /// s = v.
    Plain,
    /// s = v less the value at which the effect vanishes, where that is not zero: a factor, or a value that somebody wrote and
    /// that is off by an amount.
    From(f64),
    /// s = 1/v: a stiffness, in whose reciprocal deflections are linear and an infinite one is zero.
    Reciprocal,
    /// s = ln v: a positive quantity of unknown size.
    Logarithm,
    /// A value that somebody wrote as v₀, so that s = 0 there: s = v/v₀ − 1, v₀/v − 1 or ln (v/v₀), in which its effect is
    /// the most nearly linear.
    Ratio(f64, Grows),
}

impl SearchVariable {
    /// Makes the search variable of a model's parameter; `entry` is its catalogue entry, if it belongs to an
    /// effect.
    pub fn new(parameter: &Parameter, entry: Option<&crate::process::Parameter>) -> Self {
        let prior = match parameter.quantity.knowledge {
            Knowledge::Rough(std) => Some((parameter.quantity.value, std)),
            Knowledge::Free | Knowledge::Known => None,
        };
        let scale = match (entry.map(|e| e.neutral), parameter.bounds) {
            (Some(Neutral::Infinity), _) => Scale::Reciprocal,
            (Some(Neutral::Value(neutral)), Bounds::Any) if neutral != 0.0 => Scale::From(neutral),
            (Some(Neutral::Written(written, Grows::Evenly)), _) => Scale::From(parameter.kind.to_si(written)),
            (Some(Neutral::Written(written, grows)), _) => Scale::Ratio(parameter.kind.to_si(written), grows),
            _ if entry.is_some_and(|e| e.is_step) => Scale::Plain,
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
            // Only the kind is known of a parameter that belongs to no effect.
            (None, None) => vec![usual, 0.1 * usual, 10.0 * usual],
            _ => vec![usual],
        };
        let (mut low, mut high) = bounds(scale, parameter.bounds);
        if let (Scale::Reciprocal, Some((value, _))) = (scale, prior) {
            // A prior on v levels out in 1/v, and a search that passes the crest would run away to no
            // stiffness at all.
            high = SOFTEST / value;
        }
        let unit = match scale {
            Scale::Logarithm => 1.0,
            Scale::Ratio(..) => RATIO,
            Scale::From(_) => range.map_or(1.0, |(low, high)| 0.5 * (high - low)),
            // Where a search is told to begin it is told a size, too.
            Scale::Plain if prior.is_none() && written.abs() > 0.0 => written.abs(),
            Scale::Plain => prior.map_or(usual.abs(), |p| p.1).max(f64::MIN_POSITIVE),
            Scale::Reciprocal => 1.0 / usual,
        };
        let limits = (low, high);
        if prior.is_none() && matches!(scale, Scale::Plain | Scale::Reciprocal) {
            // Where the data cannot tell a search would run away.
            (low, high) = (low.max(-AWAY * unit), high.min(AWAY * unit));
        }
        let is_surveyed = prior.is_none() && range.is_none();
        Self { scale, low, high, prior, unit, starts, is_surveyed, limits, usual: None, steps: None }
    }

    /// Makes the search variable of a parameter of a candidate effect. A nonlinear parameter stays near its
    /// plausible range (a place within `extent`, where it was measured, and a time no longer than that): far from it one effect imitates
    /// another, and no cause is learnt.
    pub fn of_candidate(entry: &crate::process::Parameter, extent: Option<(f64, f64)>) -> Self {
        let parameter = Parameter {
            path: "".into(),
            kind: entry.kind,
            quantity: Quantity { value: f64::NAN, knowledge: Knowledge::Free },
            bounds: entry.bounds,
            span: None,
            doubt: None,
        };
        let mut variable = Self::new(&parameter, Some(entry));
        (variable.low, variable.high) = variable.limits;
        let plausible = (entry.kind.to_si(entry.range.0), entry.kind.to_si(entry.range.1));
        if entry.neutral != Neutral::Shape {
            let largest = match (extent, variable.scale) {
                (Some((low, high)), _) => high - low,
                (None, Scale::Reciprocal) => FAR / plausible.0,
                (None, Scale::From(neutral)) => FAR * (plausible.1 - neutral),
                (None, Scale::Ratio(written, Grows::Otherwise)) => (FAR * plausible.1 / written).ln(),
                (None, Scale::Ratio(written, _)) => FAR * plausible.1 / written,
                (None, Scale::Plain | Scale::Logarithm) => FAR * plausible.1,
            };
            let is_factor = matches!(variable.scale, Scale::From(_)) && !matches!(entry.neutral, Neutral::Written(..));
            let smallest = match variable.scale {
                // As many times too small as too large: nothing can be said by an instrument that shows nothing.
                Scale::From(neutral) if is_factor => neutral * (neutral / (neutral + largest) - 1.0),
                _ => -largest,
            };
            (variable.low, variable.high) = (variable.low.max(smallest), variable.high.min(largest));
            if extent.is_some() || is_factor {
                // Later than the file lasts says nothing, and a scale that is off by more is another instrument.
                variable.limits = (variable.low, variable.high);
            }
            variable.usual = Some(match (variable.scale, entry.default) {
                (Scale::Reciprocal, _) => Usual::size(1.0 / plausible.1, 1.0 / plausible.0),
                // It may as well be left out.
                (Scale::Plain, Some(default)) => {
                    let farthest = (plausible.1 - default).abs().max((plausible.0 - default).abs());
                    Usual::Place { centre: default, spread: 0.5 * farthest }
                }
                (Scale::From(neutral), _) if !is_factor => {
                    Usual::Place { centre: 0.0, spread: 2.0 * Usual::NINE_TENTHS * (plausible.1 - neutral) }
                }
                (Scale::From(neutral), _) => {
                    Usual::Adjusted { spread: (plausible.1 - neutral) * Usual::NINE_TENTHS * 2.0 }
                }
                (Scale::Ratio(written, _), _) => {
                    Usual::Place { centre: 0.0, spread: 2.0 * Usual::NINE_TENTHS * (plausible.1 / written).ln() }
                }
                (Scale::Logarithm, _) => Usual::place(plausible.0.ln(), plausible.1.ln()),
                (Scale::Plain, None) if plausible.0 > 0.0 => Usual::size(plausible.0, plausible.1),
                (Scale::Plain, None) => Usual::size(plausible.1 / Usual::DECADES, plausible.1),
            });
            return variable;
        }
        let (low, high) = match extent {
            Some(extent) => extent,
            None if variable.scale == Scale::Logarithm => (plausible.0 / BEYOND, plausible.1 * BEYOND),
            // A phase begins again past its end, so that no bound may stop it.
            None if entry.period.is_some() => (2.0 * plausible.0, 2.0 * plausible.1),
            // The default of a parameter that may be left out is as plausible as any value.
            None => (entry.default.map_or(plausible.0, |d| d.min(plausible.0)), plausible.1),
        };
        let allowed = (variable.low, variable.high);
        (variable.low, variable.high) = (variable.position(low).max(allowed.0), variable.position(high).min(allowed.1));
        variable.limits = (variable.low, variable.high);
        variable.unit = if variable.scale == Scale::Logarithm { 1.0 } else { 0.5 * (variable.high - variable.low) };
        variable.starts = extent.map_or_else(|| spread(plausible.0, plausible.1), |(low, high)| spread(low, high));
        let ends = extent.unwrap_or(plausible);
        variable.usual = Some(Usual::place(variable.position(ends.0), variable.position(ends.1)));
        variable
    }

    /// Keeps it between two values (SI), as a place is kept on the body that it belongs to.
    #[must_use]
    pub fn within(mut self, (low, high): (f64, f64)) -> Self {
        let ends = (self.position(low), self.position(high));
        (self.low, self.high) = (self.low.max(ends.0), self.high.min(ends.1));
        self.limits = (self.low, self.high);
        if self.starts.len() > 1 {
            self.starts = spread(low, high);
        }
        self
    }

    /// Lets it stand at these places alone, if there are any.
    #[must_use]
    pub fn stepping(mut self, steps: Option<Steps>) -> Self {
        let Some(steps) = steps else { return self };
        (self.low, self.high) = steps.bounds();
        self.limits = (self.low, self.high);
        self.unit = 1.0;
        match self.usual {
            // A search begins at every place by itself.
            Some(_) => (self.starts, self.usual) = (steps.spread(1), Some(Usual::OneOf(steps.count()))),
            None if self.starts.len() > 1 => self.starts = steps.spread(steps.count()),
            None => {}
        }
        self.steps = Some(steps);
        self
    }

    /// Search variable of a value.
    pub fn position(&self, value: f64) -> f64 {
        let position = match self.scale {
            Scale::Plain => value,
            Scale::From(neutral) => value - neutral,
            Scale::Reciprocal => 1.0 / value,
            Scale::Logarithm => value.ln(),
            Scale::Ratio(written, Grows::Linearly) => value / written - 1.0,
            Scale::Ratio(written, Grows::Inversely) => written / value - 1.0,
            Scale::Ratio(written, Grows::Otherwise | Grows::Evenly) => (value / written).ln(),
        };
        let position = self.steps.as_ref().map_or(position, |steps| steps.at(position));
        position.clamp(self.low, self.high)
    }

    /// Value at a search variable.
    pub fn value(&self, position: f64) -> f64 {
        match self.scale {
            Scale::Plain => self.steps.as_ref().map_or(position, |steps| steps.at(position)),
            Scale::From(neutral) => neutral + position,
            Scale::Reciprocal => 1.0 / position,
            Scale::Logarithm => position.exp(),
            Scale::Ratio(written, Grows::Linearly) => written * (1.0 + position),
            Scale::Ratio(written, Grows::Inversely) => written / (1.0 + position),
            Scale::Ratio(written, Grows::Otherwise | Grows::Evenly) => written * position.exp(),
        }
    }

    /// Sign with which the value goes with the search variable.
    pub fn sign(&self) -> f64 {
        if self.is_reversed() { -1.0 } else { 1.0 }
    }

    /// Whether a bound that gives way is in the way at a position.
    pub fn is_barred(&self, position: f64) -> bool {
        position >= self.high && self.high < self.limits.1 || position <= self.low && self.low > self.limits.0
    }

    /// Whether it stands at one of its bounds.
    pub fn is_at_bound(&self, position: f64) -> bool {
        position <= self.low || position >= self.high
    }

    /// Whether it is a size that no machine has.
    pub fn is_beyond_belief(&self, position: f64) -> bool {
        self.usual.is_some_and(|own| own.is_beyond_belief(position))
    }

    /// Moves the bounds further away.
    pub fn give_way(&mut self) {
        (self.low, self.high) = ((FAR * self.low).max(self.limits.0), (FAR * self.high).min(self.limits.1));
    }

    /// |dv/ds|.
    pub fn rate(&self, position: f64) -> f64 {
        match self.scale {
            Scale::Plain | Scale::From(_) => 1.0,
            Scale::Reciprocal => 1.0 / (position * position),
            Scale::Logarithm => position.exp(),
            Scale::Ratio(written, Grows::Linearly) => written.abs(),
            Scale::Ratio(written, Grows::Inversely) => written.abs() / (1.0 + position).powi(2),
            Scale::Ratio(written, Grows::Otherwise | Grows::Evenly) => written.abs() * position.exp(),
        }
    }

    /// Evenly spaced grid over the bounds, both of which are finite.
    pub fn grid(&self, count: usize) -> Vec<f64> {
        self.grid_within(self.low, self.high, count)
    }

    /// Evenly spaced grid between two values of the search variable.
    pub fn grid_within(&self, low: f64, high: f64, count: usize) -> Vec<f64> {
        let part = |i: usize| (i as f64 + 0.5) / count as f64;
        (0..count).map(|i| (low + (high - low) * part(i)).clamp(self.low, self.high)).collect()
    }

    /// Neutral value of a linear parameter: the effect vanishes there.
    pub fn neutral(&self) -> f64 {
        0f64.clamp(self.low, self.high)
    }

    /// The usual size, if it is a size.
    pub fn typical_size(&self) -> Option<f64> {
        match self.usual {
            Some(Usual::Size { centre, .. }) => Some(centre.exp()),
            _ => None,
        }
    }

    /// Where a size vanishes, and the middle start of what shapes an effect.
    pub fn middle(&self) -> f64 {
        let middle = self.starts.get(self.starts.len() / 2).filter(|_| self.starts.len() > 1);
        middle.map_or(self.neutral(), |value| self.position(*value))
    }

    /// Bounds; those of a positive quantity of unknown size no more than a factor of some hundred thousand
    /// away: further off it is as good as zero or infinite.
    pub fn within_reach(&self, of: f64) -> (f64, f64) {
        const REACH: f64 = 12.0;
        match self.scale {
            Scale::Logarithm => (self.low.max(of - REACH), self.high.min(of + REACH)),
            Scale::Plain | Scale::From(_) | Scale::Reciprocal | Scale::Ratio(..) => (self.low, self.high),
        }
    }

    /// Whether the value falls as the search variable rises.
    pub fn is_reversed(&self) -> bool {
        self.scale.is_reversed()
    }
}

impl Scale {
    /// Whether the value falls as the search variable rises.
    fn is_reversed(self) -> bool {
        match self {
            Self::Reciprocal => true,
            Self::Ratio(written, grows) => (written < 0.0) != (grows == Grows::Inversely),
            Self::Plain | Self::From(_) | Self::Logarithm => false,
        }
    }
}

/// Five values over a plausible range, evenly spaced by ratio where the range is positive.
fn spread(low: f64, high: f64) -> Vec<f64> {
    let part = |i: i32| f64::from(2 * i + 1) / 10.0;
    let at = |i| if low > 0.0 { low * (high / low).powf(part(i)) } else { low + (high - low) * part(i) };
    (0..5).map(at).collect()
}

fn bounds(scale: Scale, bounds: Bounds) -> (f64, f64) {
    match (scale, bounds) {
        // An infinite stiffness is zero compliance.
        (Scale::Reciprocal, _) => (0.0, f64::INFINITY),
        (Scale::Ratio(_, Grows::Inversely), _) => (-1.0, f64::INFINITY),
        (Scale::Ratio(written, Grows::Linearly), bounds) => match bounds {
            Bounds::Any => (f64::NEG_INFINITY, f64::INFINITY),
            Bounds::Positive => (-1.0 + 1e-6, f64::INFINITY),
            Bounds::NotNegative => (-1.0, f64::INFINITY),
            Bounds::Within(low, high) => {
                let (first, last) = if scale.is_reversed() { (high, low) } else { (low, high) };
                (first / written - 1.0, last / written - 1.0)
            }
        },
        (Scale::Ratio(written, Grows::Otherwise), Bounds::Within(low, high)) if written > 0.0 => {
            ((low.max(1e-3 * written) / written).ln(), (high / written).ln())
        }
        // e^±80 spans every physical size.
        (Scale::Ratio(..), _) => (-80.0, 80.0),
        (Scale::Logarithm, _) => (-80.0, 80.0),
        (Scale::Plain, Bounds::Positive) => (f64::MIN_POSITIVE, f64::INFINITY),
        (Scale::Plain, Bounds::NotNegative) => (0.0, f64::INFINITY),
        (Scale::Plain, Bounds::Within(low, high)) => (low + 1e-3 * (high - low), high),
        (Scale::From(_), _) | (Scale::Plain, Bounds::Any) => (f64::NEG_INFINITY, f64::INFINITY),
    }
}

#[cfg(test)]
mod tests {
    use super::SearchVariable;
    use crate::input::Bounds;
    use crate::process::Parameter;
    use crate::units::NUMBER;

    /// Of a value on trial that may have either sign, whichever it has.
    #[test]
    fn a_value_stays_within_its_bounds_whatever_its_sign() {
        let effect = Parameter::amplitude("difference", NUMBER, "", (0.0, 1.0)).within(Bounds::Within(-2.0, 2.0));
        for written in [0.5, -0.5, -0.1] {
            let variable = SearchVariable::of_candidate(&effect.on_trial(written, 3.0), None);
            let values = [-5.0, -2.0, written, 2.0, 5.0].map(|value| variable.value(variable.position(value)));
            assert!(values.iter().all(|value| value.abs() <= 2.0 + 1e-12), "{written}: {values:?}");
            assert!((values[2] - written).abs() < 1e-12, "{written}: {values:?}");
        }
    }

    /// The rate and its sign, with which covariances of values are told, are the slope of the value, in all scales.
    #[test]
    fn the_slope_of_a_value_is_its_rate_with_its_sign() {
        let signed = Parameter::signed("shift", NUMBER, "", (-1.0, 1.0));
        let shape = Parameter::shape("width", NUMBER, "", (0.5, 2.0));
        let stiffness = Parameter::stiffness(NUMBER, "", (1.0, 4.0));
        let factor = Parameter::factor("gain", NUMBER, "", (0.5, 1.5));
        let on_trial = |own: &Parameter, written: f64| own.on_trial(written, 3.0);
        let cases = [
            on_trial(&signed, 0.5),
            on_trial(&signed, -0.5),
            on_trial(&shape, 0.7),
            on_trial(&factor, -0.7),
            on_trial(&stiffness, 2.0),
            signed,
            shape,
            stiffness,
            factor,
        ];
        for entry in cases {
            let variable = SearchVariable::of_candidate(&entry, None);
            let (at, step) = (0.3 * variable.unit, 1e-6 * variable.unit);
            let slope = (variable.value(at + step) - variable.value(at - step)) / (2.0 * step);
            let told = variable.sign() * variable.rate(at);
            assert!((slope - told).abs() < 1e-6 * told.abs(), "{entry:?}: {slope} and {told}");
        }
    }
}
