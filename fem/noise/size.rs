//! The sizes of effects of the measurement, as a model writes them.

use super::term::{Acts, MeasurementEffect, Size};
use crate::input::Problem;
use crate::process::Process;
use crate::units::{Kind, Knowledge, NUMBER, Quantity};

/// The word for amplitudes that are free: each has a flat prior.
pub const FREE: &str = "free";

/// Positions and kinds of the observables on which an effect can act.
pub fn observed(process: &dyn Process, only: Option<usize>) -> Vec<(usize, Kind)> {
    let all = process.observables().iter().enumerate().map(|(i, o)| (i, o.error_kind()));
    all.filter(|(i, _)| only.is_none_or(|only| only == *i)).collect()
}

/// Reads the size of an effect that acts on one of `observed`: its value in SI, not a number where it is
/// unknown and infinite where amplitudes are free, and the observables of whose kind it is.
///
/// # Errors
/// It is no quantity of any of them, or cannot be meant.
pub fn size(effect: &MeasurementEffect, observed: &[(usize, Kind)], text: &str) -> Result<(f64, Vec<usize>), Problem> {
    if text.trim() == FREE && matches!(effect.acts, Acts::Shared(_)) {
        return Ok((f64::INFINITY, observed.iter().map(|(position, _)| *position).collect()));
    }
    let parse = |(position, kind): &(usize, Kind)| {
        let kind = match &effect.size {
            Size::OfObservable(..) | Size::OfReading(_) => kind,
            Size::Number(..) | Size::File(..) => &NUMBER,
            Size::Quantity(parameter) => &parameter.kind,
        };
        // Of what is unknown the unit need not be said.
        let text = if text.trim() == "?" { format!("? {}", kind.unit) } else { text.to_string() };
        Quantity::parse(&text, kind).map(|quantity| (*position, quantity))
    };
    let (read, wrong): (Vec<_>, Vec<_>) = observed.iter().map(parse).partition(Result::is_ok);
    let read: Vec<(usize, Quantity)> = read.into_iter().flatten().collect();
    let Some((_, quantity)) = read.first() else {
        let error = wrong.into_iter().find_map(Result::err);
        let (message, hint) = error.map_or((String::new(), None), |e| (e.message, e.hint));
        let example = effect.example;
        return Err(Problem::new(message).help(hint.unwrap_or_else(|| format!("write \"{example}\""))));
    };
    let of = read.iter().map(|(position, _)| *position).collect();
    meant(effect, quantity).map(|value| (value, of))
}

/// The value of a size, if it can be meant.
fn meant(effect: &MeasurementEffect, quantity: &Quantity) -> Result<f64, Problem> {
    let is_weight = matches!(effect.acts, Acts::Weighs);
    match quantity.knowledge {
        Knowledge::Free if is_weight => {
            Err(Problem::new("it cannot be estimated from single rows").help("leave it out, and it is 10"))
        }
        Knowledge::Free => Ok(f64::NAN),
        Knowledge::Rough(_) if !effect.acts.is_reading() => {
            let problem = Problem::new("the size of a scatter has no `+-`");
            Err(problem.help("write the value alone, or \"?\" to have it estimated"))
        }
        // A clock may be early, and of two sizes in a table one may be at work alone.
        _ if matches!(effect.acts, Acts::Times(_)) || matches!(effect.size, Size::OfReading(_)) => Ok(quantity.value),
        _ if !effect.beside.is_empty() && quantity.value == 0.0 => Ok(quantity.value),
        _ if quantity.value > 0.0 => Ok(quantity.value),
        _ if is_weight => Err(Problem::new("it must be above zero").help("leave it out, and it is 10")),
        _ => Err(Problem::new("it must be above zero").help("leave the table out, or write \"?\"")),
    }
}
