//! Additions to a model: the tables of missing effects, with the settings that `fem add` takes.

use std::path::Path;

use crate::diagnose::{Cause, Diagnosis, Missing};
use crate::fit::{Estimate, Fit};
use crate::model::{Data, Entry, Setting};
use crate::output::fit::Short;

/// Name of a parameter of an effect.
pub fn name(e: &Estimate) -> &str {
    e.parameter.path.key()
}

/// What mends a model by one cause.
pub enum Addition {
    /// A table of an effect more, by its name, with the settings that `fem add` takes.
    Effect(String, Vec<Setting>),
    /// Another value for a key that it has, by its path, as `fem set` takes it.
    Value(Setting),
    /// An effect that it has and that is not there, by its name.
    Without(String),
}

impl Addition {
    /// Name of the effect, or path of the value.
    pub fn name(&self) -> &str {
        match self {
            Self::Effect(name, _) | Self::Without(name) => name,
            Self::Value(setting) => &setting.key,
        }
    }

    /// The command that mends the model in a file so, and the name of the file that it writes.
    pub fn command(&self, from: &str) -> (String, String) {
        match self {
            Self::Effect(name, settings) => add(from, name, settings),
            Self::Value(setting) => set(from, setting),
            Self::Without(name) => leave_out(from, name),
        }
    }
}

/// What mends a model, cause by cause in their order.
pub fn additions(data: &Data, diagnosis: &Diagnosis) -> Vec<Addition> {
    let mut names: Vec<String> = Vec::new();
    let mut addition = |missing: &Missing| {
        let settings = settings(missing, &diagnosis.fit);
        let name = match &missing.cause {
            Cause::Physical | Cause::Law(_) => missing.effect.name.to_string(),
            Cause::Measurement { .. } => data.model.free_table(&missing.effect.name, &names),
            Cause::Value { .. } => {
                let key = missing.effect.name.to_string();
                let vanishes = missing.estimates.iter().any(|e| e.value == 0.0 || e.value.is_infinite());
                return match data.model.effect_of(&key).filter(|_| vanishes) {
                    Some(effect) => Some(Addition::Without(effect.to_string())),
                    None => settings.into_iter().next().map(|own| Addition::Value(Setting { key, ..own })),
                };
            }
        };
        names.push(name.clone());
        Some(Addition::Effect(name, settings))
    };
    diagnosis.missing.iter().filter_map(&mut addition).collect()
}

/// The settings with which a missing effect is added.
pub fn settings(missing: &Missing, fit: &Fit) -> Vec<Setting> {
    let (effect, by, along, period, observable, records, from_line) = match &missing.cause {
        Cause::Physical | Cause::Value { .. } => return fitted_settings(missing, fit),
        Cause::Law(law) => return law.settings.clone(),
        Cause::Measurement { effect, by, along, period, observable, records, from_line, .. } => {
            (effect, by, along, period, observable, records, from_line)
        }
    };
    let setting = |key: &str, value: Entry| Setting { key: key.into(), value };
    let text = |key: &str, value: String| setting(key, Entry::Text(value));
    let by = (!by.is_empty()).then(|| setting("by", Entry::Words(by.iter().map(ToString::to_string).collect())));
    let observable = observable.as_ref().map(|name| text("observable", name.to_string()));
    let rows = if from_line.is_some() { "from" } else { "rows" };
    let rows = (!records.is_empty()).then(|| setting(rows, Entry::Rows(records.clone())));
    let along = along.as_ref().map(|name| text("along", name.to_string()));
    let zeros = effect.beside.iter().filter(|_| !effect.acts.is_reading());
    let zeros = zeros.map(|other| text(other.size.key(), "0 um".into()));
    let over = missing.effect.parameters.iter().find_map(|p| Some((p.over?, p.kind)));
    let ends = over.into_iter().flat_map(|(ends, kind)| {
        let end = |(key, si): (&str, f64)| text(key, format!("{:.6} {}", Short(kind.from_si(si)), kind.unit));
        ["low", "high"].into_iter().zip(ends).map(end).collect::<Vec<_>>()
    });
    let period = period.map(|(si, kind)| text("period", format!("{:.6} {}", Short(kind.from_si(si)), kind.unit)));
    let texts = [by, along, period, observable, rows].into_iter().flatten().chain(zeros).chain(ends);
    let sizes = match effect.acts.is_reading() {
        true => fitted_settings(missing, fit),
        false => missing.estimates.iter().map(size).collect(),
    };
    texts.chain(sizes).collect()
}

/// The size of an effect of the measurement. It is no parameter of a fit, and has no uncertainty in a file.
fn size(e: &Estimate) -> Setting {
    let k = e.parameter.kind;
    let value = format!("{:.5} {}", Short(k.from_si(e.value)), k.unit);
    Setting { key: name(e).into(), value: Entry::Text(value.trim_end().into()) }
}

/// Makes the settings with which an effect is added, as `fem add` takes them.
fn fitted_settings(missing: &Missing, fit: &Fit) -> Vec<Setting> {
    let setting = |e: &Estimate| {
        let k = e.parameter.kind;
        let entry = missing.effect.parameters.iter().find(|p| p.name == name(e));
        // A value that the data leave open is known no better than its plausible range.
        let widest = entry.map_or(f64::INFINITY, |p| 0.5 * (p.range.1 - p.range.0));
        let place = fit.estimates.iter().position(|own| own.parameter.path == e.parameter.path);
        let std = e.std * place.map_or(1.0, |i| fit.known.parts[i]);
        let std = (fit.birge_ratio() * std / k.canonical().factor).min(widest);
        let alone = place.map_or(1.0, |i| fit.known.alone[i]);
        let value = crate::fit::uncertain_beside(k.from_si(e.value), std, alone);
        Setting { key: name(e).into(), value: Entry::Text(format!("{value} {}", k.unit).trim_end().into()) }
    };
    missing.estimates.iter().map(setting).collect()
}

/// The command that adds an effect to the model in a file, and the name of the file that it writes.
pub fn add(from: &str, name: &str, settings: &[Setting]) -> (String, String) {
    let values: Vec<String> = settings.iter().map(|s| format!("'{}={}'", s.key, s.value)).collect();
    let to = file_with(from, name);
    (format!("fem add {} {name} {} -o {}", quoted(from), values.join(" "), quoted(&to)), to)
}

/// The command that puts another value into the model in a file, and the name of the file that it writes.
pub fn set(from: &str, Setting { key, value }: &Setting) -> (String, String) {
    let to = file_with(from, key.rsplit('.').next().unwrap_or(key));
    (format!("fem set {} {} -o {}", quoted(from), quoted(&format!("{key}={value}")), quoted(&to)), to)
}

/// The command that leaves an effect out of the model in a file, and the name of the file that it writes.
pub fn leave_out(from: &str, name: &str) -> (String, String) {
    let to = file_with(from, &format!("without-{name}"));
    (format!("fem set {} --without {name} -o {}", quoted(from), quoted(&to)), to)
}

/// Name of the file for a model with something more.
fn file_with(from: &str, name: &str) -> String {
    let stem = Path::new(from).file_stem().unwrap_or_default().to_string_lossy().into_owned();
    format!("{stem}-{name}.toml")
}

/// Quotes a word for a shell.
pub fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./+,:@%".contains(c);
    if !word.is_empty() && word.chars().all(plain) { word.into() } else { format!("'{}'", word.replace('\'', "'\\''")) }
}
