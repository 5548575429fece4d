//! Words for a missing effect.

use crate::diagnose::{Along, Bend, Cause, Diagnosis, FreeLaw, Missing};
use crate::fit::Estimate;
use crate::model::{Data, Model};
use crate::output::fit::Short;
use crate::output::measurement;
use crate::output::text::whole;
use crate::units::Knowledge;

/// A missing effect in a few words, with what groups the rows: `zero-shift by run`.
pub fn label(missing: &Missing) -> String {
    match &missing.cause {
        Cause::Physical | Cause::Value { .. } => missing.effect.name.to_string(),
        Cause::Law(law) => format!("{} of {}", missing.effect.name, law.variables.join(", ")),
        Cause::Measurement { by, observable, along, period, .. } => {
            let of = observable.as_ref().map_or(String::new(), |name| format!(" of {name}"));
            let along = along.as_ref().map_or(String::new(), |name| format!(" along {name}"));
            let period = period.map_or(String::new(), |(period, kind)| {
                format!(", once in {:.4} {}", Short(kind.from_si(period)), kind.unit)
            });
            format!("{}{}{along}{of}{period}", missing.effect.name, measurement::grouped(by))
        }
    }
}

/// What is written where a value is wrong: `written as 60 N/um`.
pub fn as_written(missing: &Missing) -> Option<String> {
    let Cause::Value { written } = missing.cause else { return None };
    let kind = missing.effect.parameters.first()?.kind;
    Some(format!("written as {:.4} {}", Short(kind.from_si(written)), kind.unit).trim_end().into())
}

/// What a law adds: `error + a*exp(-feed/f_0)`.
pub fn added(law: &FreeLaw) -> String {
    format!("{} + {}", law.observable, law.formula)
}

/// The effect that has the form of a law.
pub fn like(missing: &Missing) -> Option<String> {
    let Cause::Law(law) = &missing.cause else { return None };
    law.like.map(|like| format!("it has the form of {like}"))
}

/// How many laws fit as well as one, and where they are told.
pub fn rivals(missing: &Missing) -> Option<String> {
    let Cause::Law(law) = &missing.cause else { return None };
    let told = match law.rivals.len() {
        0 => return None,
        1 => "another law fits as well".to_string(),
        count => format!("{count} other laws fit as well"),
    };
    Some(format!("{told}: fem discover tells them apart"))
}

/// Of the change of an effect, the value that its parameter had before, by the parameter's name: `60 -> `.
pub fn value_before(missing: &Missing, name: &str) -> Option<String> {
    let changed = missing.effect.parameters.iter().filter(|p| !p.is_step);
    let (parameter, before) = changed.zip(&missing.before).find(|(p, _)| p.name == *name)?;
    Some(format!("{:.4} -> ", Short(parameter.kind.from_si(*before))))
}

/// Standard uncertainties beyond which the data have moved a value that was roughly known, and the part of its uncertainty
/// that they must have left to speak of it at all, unless they have moved it by as many of what they have left.
const MOVED: f64 = 2.0;
const SHARPENED: f64 = 0.5;
const FAR: f64 = 5.0;

/// Values of the model that were roughly known and that the data move far: what a re-fitted model hides.
pub fn moved(d: &Diagnosis) -> Vec<String> {
    let text = |e: &Estimate| {
        let Knowledge::Rough(rough) = e.parameter.quantity.knowledge else { return None };
        let (written, kind) = (e.parameter.quantity.value, e.parameter.kind);
        let by = (e.value - written).abs();
        let is_moved = by > MOVED * rough && (e.std < SHARPENED * rough || by > FAR * e.std);
        let [value, written, rough] = [e.value, written, rough].map(|si| Short(kind.from_si(si)));
        let unit = kind.unit;
        is_moved
            .then(|| whole(&format!("{} {value:.4} {unit} (written as {written:.4} +- {rough:.2})", e.parameter.path)))
    };
    d.fit.estimates.iter().filter_map(text).collect()
}

/// The change of an effect in a line: `stiffness 60 -> 45 N/um after part 12`.
pub fn changed(missing: &Missing) -> Option<String> {
    missing.effect.changes.as_ref()?;
    let value = |e: &Estimate| {
        let (kind, name) = (e.parameter.kind, e.parameter.path.key());
        let before = value_before(missing, name)?;
        Some(format!("{name} {before}{:.4} {}", Short(kind.from_si(e.value)), kind.unit).trim_end().to_string())
    };
    let values: Vec<String> = missing.estimates.iter().filter_map(value).collect();
    let along = missing.effect.parameters.iter().find(|p| p.is_step)?.along.as_ref()?;
    let after = missing.estimates.first()?.value;
    Some(format!("{} after {along} {after}", values.join(", ")))
}

/// What a missing effect does to the rows, `moves the rows by up to`, and its size, `38.0 um`. Where the rows settle that and
/// leave its values open one by one, the size has its uncertainty, and growth from part to part as a shop counts it.
pub fn largest_change(missing: &Missing, data: &Data) -> Option<[String; 2]> {
    let change = missing.largest_change.as_ref()?;
    let seen = &data.observables[change.observable];
    let rows = if data.observables.len() == 1 { "the rows" } else { &*seen.name };
    let moves = format!("moves {rows} by up to");
    let open = open_values(missing);
    let Some(uncertainty) = change.uncertainty.filter(|own| *own < SETTLED * change.value && !open.is_empty()) else {
        let size = format!("{:.3} {}", Short(seen.kind.from_si(change.value)), seen.kind.unit);
        return Some([moves, size.trim_end().into()]);
    };
    let with = |value: f64, uncertainty: f64| {
        let [value, uncertainty] = [value, uncertainty].map(|own| seen.kind.difference().from_si(own));
        format!("{:.3} +- {:.2} {}", Short(value), Short(uncertainty), seen.kind.difference().unit)
    };
    let growth = change.growth.as_ref().filter(|own| own.uncertainty < SETTLED * own.value.abs());
    let growth = growth.map_or(String::new(), |own| format!(", {} a {}", with(own.value, own.uncertainty), own.along));
    let stays = if open.len() == 1 { "stays" } else { "stay" };
    let size = with(change.value, uncertainty);
    Some([moves, format!("{size}{growth}, though {} {stays} open", open.join(" and "))])
}

/// Names of the values of a cause that the rows do not settle: without an end, or wider than they are large.
fn open_values(missing: &Missing) -> Vec<&str> {
    let is_open = |e: &&Estimate| match (e.interval.low, e.interval.high) {
        (Some(low), Some(high)) => high - low > 2.0 * e.value.abs(),
        _ => true,
    };
    missing.estimates.iter().filter(is_open).map(|e| e.parameter.path.key()).collect()
}

/// Largest relative uncertainty of what counts as settled.
const SETTLED: f64 = 0.25;

/// A probability: `97 %`.
pub fn percent(probability: f64) -> String {
    format!("{:.0} %", 100.0 * probability)
}

/// Writes the p-value of an effect.
pub fn chance(p: f64) -> String {
    match p {
        p if p < 1e-6 => "chance alone gives as much in less than one search in a million".into(),
        p => format!("chance alone gives as much in one search of {:.0}", (1.0 / p).max(1.0)),
    }
}

/// A bend that the law of a missing effect does not have.
pub fn bent(bend: &Bend) -> String {
    let along = match &bend.along {
        Along::Coordinate(name) => format!("it bends along {name}"),
        Along::Size => "it bends with its own size".into(),
        Along::Turns => "it has harmonics".into(),
    };
    format!("its shape is not wholly this law: {along}, by up to {:.0} % of itself", 100.0 * bend.share)
}

/// Traits of an effect of the measurement in this process and these rows, and last how to tell it from effects of the
/// machine; nothing of these.
pub fn traits(missing: &Missing, model: &Model) -> Vec<String> {
    let Cause::Measurement { effect, by, from, .. } = &missing.cause else { return Vec::new() };
    let curve = measurement::curve(effect, by, &*model.process);
    let curve = curve.map(|(name, about)| format!("in this process a {name}: {about}"));
    let from = from.as_ref().map(|place| format!("from {place} on"));
    let separates = format!("what separates it from effects of the machine: {}", effect.separates);
    curve.into_iter().chain(from).chain([separates]).collect()
}
