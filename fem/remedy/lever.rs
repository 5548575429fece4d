//! What the shop can change, held against the model: what varies is found in it, and limits have units of their kind.

use std::ops::Range;

use crate::input::{Bounds, InputError, Parameter, Problem, Raw};
use crate::model::{Edit, Entry, Model, Reach, ShopSetting};
use crate::study::no_quantity;
use crate::units::{Knowledge, Quantity};

/// Most values of a count between its limits.
const MOST_COUNTS: i64 = 100;
/// Digits to which people set a quantity.
const DIGITS: i32 = 3;
/// Part of a range within which a value lies at its end.
const AT_END: f64 = 2e-3;

/// A setting with the values that it can have.
#[derive(Clone, Debug)]
pub struct Lever<'m> {
    /// What the model says of it.
    pub setting: &'m ShopSetting,
    /// The values.
    pub ways: Ways,
    /// What it is now, for people; none where it is not there.
    pub now: Option<String>,
    /// The place among its ways where it is now, if it is one.
    pub present: Option<f64>,
    /// The range (SI) in which the model was held against measurements.
    measured: Option<[f64; 2]>,
}

/// The values that a setting can have; each has a place.
#[derive(Clone, Debug)]
pub enum Ways {
    /// Any between two ends, SI, which are its places.
    Between {
        /// The quantity, with its unit and what is known of it.
        quantity: Parameter,
        /// Both ends.
        ends: [f64; 2],
    },
    /// One of a list, by its position.
    Among(Vec<Raw>, Option<Parameter>),
    /// What is written, at the place 0.
    Alone,
}

impl<'m> Lever<'m> {
    /// Finds a setting in a model.
    ///
    /// # Errors
    /// It names what the model does not have, or gives limits of another kind.
    pub fn of(model: &'m Model, setting: &'m ShopSetting) -> Result<Self, InputError> {
        let wrong = |problem: Problem, span: &Option<Range<usize>>| {
            let span = span.clone().or(setting.span.clone());
            InputError::one(model.source.clone(), problem.at(span))
        };
        let edited = match setting.edits.is_empty() {
            true => model.clone(),
            false => model.edited(&setting.edits).map_err(|own| {
                let message = format!("`{}` makes no model: {}", setting.name, own.message);
                wrong(Problem { message, ..own }, &None)
            })?,
        };
        let Some((path, reach)) = &setting.varies else {
            return Ok(Self { setting, ways: Ways::Alone, now: None, present: None, measured: None });
        };
        let is_new = edited.raw(path).is_some() && model.raw(path).is_none();
        let quantity = edited.quantity(path);
        let Some(quantity) = quantity else {
            let raw = edited.raw(path).ok_or_else(|| {
                let (message, help) = no_quantity(&edited, path);
                wrong(Problem::new(message).help(help), &None)
            })?;
            let values = match reach {
                Reach::OneOf(values) => values.clone(),
                Reach::Between(ends) => counts(&raw, ends).map_err(|problem| wrong(problem, &ends[0].span))?,
            };
            let present = values.iter().position(|own| *own == raw).filter(|_| !is_new).map(|at| at as f64);
            let now = (!is_new).then(|| raw.to_string());
            return Ok(Self { setting, ways: Ways::Among(values, None), now, present, measured: None });
        };
        let si = |raw: &Raw| value(quantity, raw).map_err(|problem| wrong(problem, &raw.span));
        let both = |[low, high]: &[Raw; 2]| {
            let ends = [si(low)?, si(high)?];
            match ends[0] < ends[1] {
                true => Ok(ends),
                false => Err(wrong(
                    Problem::new("the range ends before it begins").help("write the lower end first"),
                    &low.span,
                )),
            }
        };
        let now = (!is_new).then(|| quantity.kind.format(quantity.quantity.value));
        let measured = setting.measured.as_ref().map(both).transpose()?;
        let here = |value: f64| value == quantity.quantity.value && !is_new;
        let (ways, present) = match reach {
            Reach::Between(ends) => (Ways::Between { quantity: quantity.clone(), ends: both(ends)? }, None),
            Reach::OneOf(values) => {
                let si = values.iter().map(si).collect::<Result<Vec<f64>, _>>()?;
                let present = si.iter().position(|value| here(*value)).map(|at| at as f64);
                (Ways::Among(values.clone(), Some(quantity.clone())), present)
            }
        };
        Ok(Self { setting, ways, now, present, measured })
    }

    /// Ends between which its places lie.
    pub fn ends(&self) -> [f64; 2] {
        match &self.ways {
            Ways::Between { ends, .. } => *ends,
            Ways::Among(values, _) => [0.0, values.len().saturating_sub(1) as f64],
            Ways::Alone => [0.0; 2],
        }
    }

    /// Whether any place between its ends is one.
    pub fn is_continuous(&self) -> bool {
        matches!(self.ways, Ways::Between { .. })
    }

    /// The edits of a model that put it to a place.
    pub fn edits(&self, at: f64) -> Vec<Edit> {
        let mut edits = self.setting.edits.clone();
        let Some((path, _)) = &self.setting.varies else { return edits };
        edits.push(match &self.ways {
            Ways::Between { quantity, .. } => Edit::Set { path: path.clone(), entry: entry(quantity, at) },
            Ways::Among(values, quantity) => {
                let raw = &values[(at as usize).min(values.len() - 1)];
                let si = quantity.as_ref().and_then(|own| Some((own, value(own, raw).ok()?)));
                match si {
                    Some((quantity, si)) => Edit::Set { path: path.clone(), entry: entry(quantity, si) },
                    None => Edit::Write { path: path.clone(), value: raw.clone() },
                }
            }
            Ways::Alone => return edits,
        });
        edits
    }

    /// A place as people read it; none where there is one alone.
    pub fn shown(&self, at: f64) -> Option<String> {
        match &self.ways {
            Ways::Between { quantity, .. } => Some(quantity.kind.format(at)),
            Ways::Among(values, _) => values.get(at as usize).map(Raw::to_string),
            Ways::Alone => None,
        }
    }

    /// The places next to one that people can set: to three digits.
    pub fn settable(&self, at: f64) -> Vec<f64> {
        let Ways::Between { quantity, ends: [low, high] } = &self.ways else { return vec![at] };
        if [*low, *high].contains(&at) {
            return vec![at];
        }
        let shown = quantity.kind.from_si(at);
        let step = 10f64.powi(shown.abs().max(f64::MIN_POSITIVE).log10().floor() as i32 + 1 - DIGITS);
        let near = [(shown / step).floor(), (shown / step).ceil()].map(|steps| {
            // Written and read again, so that it is the number that people see.
            let written = format!("{:.5e}", steps * step);
            quantity.kind.to_si(written.parse().unwrap_or(shown)).clamp(*low, *high)
        });
        near.to_vec()
    }

    /// Whether a place is an end of its range.
    pub fn is_end(&self, at: f64) -> bool {
        let [low, high] = self.ends();
        self.is_continuous() && (at - low).min(high - at) <= AT_END * (high - low)
    }

    /// Whether the model was held against measurements at a place; none where it is not said where it was.
    pub fn is_measured(&self, at: f64) -> Option<bool> {
        let si = match &self.ways {
            Ways::Between { .. } => Some(at),
            Ways::Among(values, Some(quantity)) => values.get(at as usize).and_then(|raw| value(quantity, raw).ok()),
            Ways::Among(..) | Ways::Alone => None,
        };
        let is_inside = |([low, high], si): ([f64; 2], f64)| (low..=high).contains(&si);
        self.measured.zip(si).map(is_inside)
    }

    /// Whether it can be changed together with another one: neither writes what the other does.
    pub fn goes_with(&self, other: &Self) -> bool {
        let within = |path: &str, above: &str| {
            path.strip_prefix(above).is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
        };
        let meet = |own: &str| other.setting.paths().any(|path| within(own, path) || within(path, own));
        !self.setting.paths().any(meet)
    }
}

/// A value of a quantity, SI.
fn value(quantity: &Parameter, raw: &Raw) -> Result<f64, Problem> {
    let Parameter { kind, bounds, path, .. } = quantity;
    let text = raw.text().unwrap_or_else(|| raw.to_string());
    let read = Quantity::parse(&text, kind).map_err(|error| {
        let help = error.hint.unwrap_or_else(|| format!("write \"{}\"", kind.example()));
        Problem::new(format!("`{path}`: {}", error.message)).help(help)
    })?;
    if read.knowledge != Knowledge::Known {
        return Err(Problem::new(format!("`{path}`: a limit is known")).help(format!("write \"{}\"", kind.example())));
    }
    match bounds.admits(read.value) {
        true => Ok(read.value),
        false => Err(Problem::new(format!("`{path}` cannot be {text}")).help("keep within what the key may be")),
    }
}

/// All counts between two.
fn counts(now: &Raw, [from, to]: &[Raw; 2]) -> Result<Vec<Raw>, Problem> {
    let (Some(_), Some(from), Some(to)) = (now.whole(), from.whole(), to.whole()) else {
        let problem = Problem::new(format!("nothing lies between {from} and {to}"));
        return Err(problem.help("give `values` of what is neither a quantity nor a count"));
    };
    match to.checked_sub(from) {
        Some(1..MOST_COUNTS) => Ok((from..=to).map(Raw::from).collect()),
        Some(..=0) => Err(Problem::new("the range ends before it begins").help("write the lower end first")),
        _ => Err(Problem::new(format!("from {from} to {to} are more than {MOST_COUNTS} counts")).help("give `values`")),
    }
}

/// A value (SI) as the model holds it. What was known roughly is known as roughly then: a positive quantity by the same part
/// of it, any other by the same amount.
fn entry(quantity: &Parameter, si: f64) -> Entry {
    let Parameter { kind, quantity: was, bounds, .. } = quantity;
    let written = format!("{}", kind.from_si(si));
    let Knowledge::Rough(deviation) = was.knowledge else {
        return match kind.unit.is_empty() {
            true => Entry::Number(kind.from_si(si)),
            false => Entry::Text(format!("{written} {}", kind.unit)),
        };
    };
    let deviation = if *bounds == Bounds::Positive { deviation * si / was.value } else { deviation };
    let deviation = deviation / kind.canonical().factor;
    Entry::Text(format!("{written} +- {deviation} {}", kind.unit).trim_end().to_string())
}
