//! The answer of `fem diagnose`: which effects are missing.

mod absent;
mod additions;
mod campaign;
mod commands;
mod kinds;
mod short;
mod text;
mod verdict;
mod words;

pub(super) use absent::{bound, note};
pub(super) use additions::name;
pub use additions::{Addition, add, additions, leave_out, quoted, set};
pub(super) use commands::commands;
pub use commands::with;
pub use short::some_of as group_sentence;
pub(super) use text::{
    errors, experiment, next_measurement, separated, separated_pairs, separations, told_apart, unexplained,
};
pub(super) use verdict::{counted, verdict};
pub(super) use words::{bent, chance, changed, label, largest_change, traits};

use serde_json::{Map, Value as Json, json};

use super::OutputError;
use super::answer::Answer;
use super::apart;
use super::block::Block;
use super::chart::Svg;
use super::falling::Falling;
use super::json::{finite, json as document};
use super::measurement::{self, curve, files};
use super::staged::Staged;
use crate::diagnose::{
    Along, Believed, Bend, Cause, Diagnosis, GoodnessOfFit, Group, Missing, Next, Outlier, Outlook, Verdict,
};
use crate::fit::Estimate;
use crate::model::{Data, Model};
use crate::noise::MEASUREMENT;
use crate::process::{Description, ON_TRIAL, Parameter};
use crate::progress::Progress;
use crate::units::Kind;

/// The error of the model as it is re-fitted, and with each missing effect added.
fn falling(data: &Data, diagnosis: &Diagnosis) -> Falling {
    let kind = data.kind();
    let first = (format!("{} re-fitted", data.model.stem().display()), diagnosis.before.rms);
    let added = diagnosis.missing.iter().map(|m| (format!("+ {}", label(m)), m.goodness.rms));
    Falling {
        title: format!("root mean square error of {}", data.model.stem().display()),
        steps: std::iter::once(first).chain(added).map(|(label, rms)| (label, kind.from_si(rms))).collect(),
        apart: None,
        noise: kind.from_si(diagnosis.noise.together()),
        unit: kind.unit,
    }
}

/// The diagnosis of data with their model: the missing effects, and the way to them.
pub struct DiagnosisAnswer<'a> {
    data: &'a Data<'a>,
    diagnosis: &'a Diagnosis,
    is_verbose: bool,
}

impl<'a> DiagnosisAnswer<'a> {
    /// The answer whose text is some 25 lines.
    #[must_use]
    pub fn new(data: &'a Data<'a>, diagnosis: &'a Diagnosis) -> Self {
        Self { data, diagnosis, is_verbose: false }
    }

    /// The answer whose text is all that is known: where the model fails, every cause, every effect on trial, every
    /// command.
    #[must_use]
    pub fn verbose(self) -> Self {
        Self { is_verbose: true, ..self }
    }
}

impl Answer for DiagnosisAnswer<'_> {
    fn blocks(&self) -> Vec<Block> {
        let blocks = if self.is_verbose { text::blocks } else { short::blocks };
        blocks(self.data, self.diagnosis)
    }

    /// `fem diagnose --json`: `fem-diagnosis/1`.
    fn json(&self) -> Json {
        let Self { data, diagnosis: d, .. } = *self;
        let kind = data.kind();
        let mut all = json!({
            "schema": "fem-diagnosis/1",
            "model": &*data.model.source.name,
            "data": data.name,
            "files": files(data),
            "observations": data.len(),
            "observations_used": d.rows,
            "cautions": d.cautions,
            "released": d.released,
            "odds": data.model.odds.iter().map(|(name, odds)| (name.to_string(), json!(odds))).collect::<Map<_, _>>(),
            "noise": super::comparison::noise(d.noise_before(), kind),
            "measurement": measurement::json(&data.terms, &*data.model.process, Some(data)),
            "before": goodness(&d.before, kind),
            "features": d.features.iter().map(super::comparison::feature).collect::<Vec<_>>(),
            "verdict": d.verdict.word(),
            "missing": d.missing.iter().map(|m| missing(m, data)).collect::<Vec<_>>(),
            "described": d.missing.iter().filter(|m| m.describes()).map(label).collect::<Vec<_>>(),
            "outliers": d.outliers.iter().map(|o| outlier(o, data)).collect::<Vec<_>>(),
            "after": after(d, kind),
            "parameters": d.fit.estimates.iter().map(|e| (e.parameter.path.to_string(), estimate(e))).collect::<Map<_, _>>(),
            "candidates": d.candidates.iter().map(|c| outlook(c, d, kind)).collect::<Vec<_>>(),
            "sets": d.posterior.sets.iter().map(believed).collect::<Vec<_>>(),
            "groups": d.posterior.groups.iter().map(group).collect::<Vec<_>>(),
            "unexplained": remaining(data, d),
            "next_measurement": d.next.as_ref().map(|n| next(n, data.model)).or_else(|| said_to_separate(d)),
            "separated_by": text::told_otherwise(d).iter().map(|[a, b, by]| json!({ "separates": [a, b], "text": by })).collect::<Vec<_>>(),
            "held_out_by": d.cross_validation_by,
            "failed_trials": d.trials.0,
            "evaluations": d.trials.1,
            "notes": data.notes_of_fit(),
        });
        if let Some(campaign) = data.model.campaign() {
            campaign::extend(&mut all, campaign, data, d);
        }
        all
    }

    fn figures(&self) -> Vec<(String, Svg)> {
        vec![("diagnosis".into(), falling(self.data, self.diagnosis).svg())]
    }

    fn progress(&self) -> Option<&Progress> {
        Some(&self.data.progress)
    }

    fn stage(&self, files: &mut Staged) -> Result<(), OutputError> {
        files.text("diagnosis.json", &document(self))?;
        files.figures(self.figures())
    }
}

fn believed(set: &Believed) -> Json {
    json!({ "effects": set.effects, "probability": set.probability, "chi2_per_dof": finite(set.reduced_chi2) })
}

fn group(group: &Group) -> Json {
    json!({ "at_least": group.at_least, "effects": group.effects, "probability": group.probability })
}

fn goodness(goodness: &GoodnessOfFit, kind: Kind) -> Json {
    json!({
        "rms": kind.from_si(goodness.rms),
        "sigma": kind.from_si(goodness.noise.together()),
        "chi2_per_dof": finite(goodness.reduced_chi2),
        "p_value": goodness.p_value,
        "held_out": goodness.cross_validation.filter(|h| h.is_finite()),
    })
}

/// The goodness of the model with everything that was found, and the verdict on it.
fn after(d: &Diagnosis, kind: Kind) -> Json {
    let mut after = goodness(&d.after, kind);
    after["verdict"] = json!(d.verdict_after.word());
    after
}

/// Row counted from 1, as people do.
fn outlier(outlier: &Outlier, data: &Data) -> Json {
    let kind = data.observables[outlier.observable].kind;
    json!({
        "row": outlier.record,
        "line": outlier.line,
        "file": data.file_of_record(outlier.record - 1).unwrap_or(&data.name),
        "value": kind.from_si(outlier.value),
        "predicted": kind.from_si(outlier.predicted),
        "unit": kind.unit,
        "weight": outlier.weight,
    })
}

fn missing(missing: &Missing, data: &Data) -> Json {
    let kind = data.kind();
    let name = |e: &Estimate| e.parameter.path.key().to_string();
    let measurement = match &missing.cause {
        Cause::Physical | Cause::Value { .. } | Cause::Law(_) => None,
        Cause::Measurement { effect, by, observable, records, from_line, along, period, .. } => {
            Some((effect, by, observable, records, from_line, along, period))
        }
    };
    let mut told = json!({
        "effect": missing.effect.name,
        "kind": match &missing.cause {
            Cause::Law(_) => "law",
            _ if missing.doubt.is_some() => "description",
            _ => kind_of(&missing.effect),
        },
        "doubt": missing.doubt,
        "written": match missing.cause {
            Cause::Value { written } => missing.estimates.first().map(|e| e.parameter.kind.from_si(written)),
            Cause::Physical | Cause::Law(_) | Cause::Measurement { .. } => None,
        },
        "by": measurement.map(|m| m.1),
        "observable": measurement.map(|m| m.2),
        "rows": measurement.map(|m| m.3),
        "from_line": measurement.map(|m| m.4),
        "along": measurement.map(|m| m.5),
        "period": measurement.and_then(|m| *m.6).map(|(period, kind)| json!({ "value": kind.from_si(period), "unit": kind.unit })),
        "separated_by": measurement.map(|m| m.0.separates),
        "known_as": measurement.and_then(|m| curve(m.0, m.1, &*data.model.process)).map(|c| c.0),
        "rms_after": kind.from_si(missing.goodness.rms),
        "chi2_per_dof_after": finite(missing.goodness.reduced_chi2),
        "held_out_after": missing.goodness.cross_validation.filter(|h| h.is_finite()),
        "p_value": missing.p_value,
        "probability": missing.probability,
        "largest_change": missing.largest_change.as_ref().map(|change| {
            let seen = &data.observables[change.observable];
            let difference = |own: f64| seen.kind.difference().from_si(own);
            json!({
                "value": seen.kind.from_si(change.value),
                "uncertainty": change.uncertainty.map(|own| finite(difference(own))),
                "unit": seen.kind.unit,
                "observable": seen.name,
                "growth": change.growth.as_ref().map(|own| json!({
                    "along": own.along,
                    "value": finite(difference(own.value)),
                    "uncertainty": finite(difference(own.uncertainty)),
                })),
            })
        }),
        "parameters": missing.estimates.iter().map(|e| (name(e), estimate(e))).collect::<Map<_, _>>(),
        "indistinguishable_from": missing.indistinguishable_from.iter().map(|e| &e.name).collect::<Vec<_>>(),
        "bend": missing.bend.as_ref().map(|b| json!({ "along": along(b), "share": b.share })),
    });
    if let Cause::Law(law) = &missing.cause {
        told["observable"] = json!(law.observable);
        told["formula"] = json!(law.formula);
        told["variables"] = json!(law.variables);
        told["like"] = json!(law.like);
        told["rivals"] = json!(law.rivals.iter().map(|own| &own.formula).collect::<Vec<_>>());
        told["apart"] = law.rivals.iter().map(|own| own.apart.as_ref().map(apart::json)).collect();
    }
    if let Some(changes) = &missing.effect.changes {
        let changed = missing.effect.parameters.iter().filter(|p| !p.is_step).zip(&missing.before);
        let value = |(p, si): (&Parameter, &f64)| {
            (p.name.to_string(), json!({ "value": finite(p.kind.from_si(*si)), "unit": p.kind.unit }))
        };
        told["changes"] = json!(changes);
        told["before"] = changed.map(value).collect::<Map<_, _>>().into();
    }
    told
}

fn estimate(e: &Estimate) -> Json {
    let kind = e.parameter.kind;
    let end = |si: Option<f64>| si.map(|v| kind.from_si(v));
    json!({
        "value": finite(kind.from_si(e.value)),
        "unit": kind.unit,
        "std": finite(e.std / kind.canonical().factor),
        "interval95": [end(e.interval.low), end(e.interval.high)],
        "warnings": e.warnings,
    })
}

/// Word for the origin of an effect, in JSON.
fn kind_of(effect: &Description) -> &'static str {
    match effect.table {
        MEASUREMENT => "measurement",
        ON_TRIAL => "value",
        _ => "physical",
    }
}

fn outlook(outlook: &Outlook, diagnosis: &Diagnosis, kind: Kind) -> Json {
    json!({
        "effect": outlook.effect.name,
        "kind": kind_of(&outlook.effect),
        "observable": outlook.effect.observable,
        "rms_after": outlook.rms.map(|r| kind.from_si(r)),
        "delta_bic": outlook.delta_bic,
        "p_value": outlook.p_value,
        "probability": diagnosis.posterior.of(&outlook.effect.name),
        "note": note(outlook, diagnosis),
    })
}

/// Where nothing on the menu tells look-alikes apart: what the catalogue says would.
fn said_to_separate(d: &Diagnosis) -> Option<Json> {
    let [a, b, by] = text::told_otherwise(d).into_iter().next()?;
    Some(json!({
        "text": by, "coordinate": null, "values": [], "unit": "", "observations": null, "repeats": null,
        "separation": null, "enough": null, "separates": [[a, b]],
    }))
}

/// The experiment to do next, with its values in the coordinate's canonical unit.
pub(super) fn next(next: &Next, model: &Model) -> Json {
    let coordinates = model.process.coordinates();
    let kind = coordinates.iter().find(|c| c.name == next.experiment.coordinate).and_then(|c| c.holds.kind());
    json!({
        "text": next.experiment.words,
        "coordinate": next.experiment.coordinate,
        "values": next.experiment.values.iter().map(|v| kind.map_or(*v, |k| k.from_si(*v))).collect::<Vec<_>>(),
        "unit": kind.map(|k| k.unit).unwrap_or_default(),
        "observations": next.observations(),
        "repeats": next.repeats,
        "steps": next.steps,
        "minutes": finite(next.cost() / 60.0),
        "separation": finite(next.separation),
        "enough": next.enough,
        "separates": next.pairs.iter().map(|(a, b)| json!([a.name, b.name])).collect::<Vec<_>>(),
        "decides": next.whether.iter().map(|effect| &effect.name).collect::<Vec<_>>(),
        "sets": next.sets.map(|(now, then)| json!({ "now": now, "expected": then })),
    })
}

fn remaining(data: &Data, diagnosis: &Diagnosis) -> Json {
    match diagnosis.verdict {
        Verdict::Adequate | Verdict::MissingEffect | Verdict::NotJudged => Json::Null,
        Verdict::PartlyExplained | Verdict::Unexplained => {
            let features: Vec<Json> = diagnosis.remaining.iter().map(super::comparison::feature).collect();
            json!({ "text": unexplained(data, diagnosis), "features": features })
        }
    }
}

/// What a law bends along: a coordinate, its `turns`, or null for its own size.
fn along(bend: &Bend) -> Json {
    match &bend.along {
        Along::Coordinate(name) => json!(name),
        Along::Turns => json!("turns"),
        Along::Size => Json::Null,
    }
}
