//! Diagnosis of several tests, test by test: where a cause acts, how well the test fits, what to add to its model.

use std::collections::BTreeMap;
use std::fmt::Write;

use serde_json::{Value as Json, json};

use super::additions::{Addition, quoted, settings};
use crate::compare::rms;
use crate::diagnose::{Cause, Diagnosis, Missing, thinned};
use crate::model::{Acting, Campaign, Data, Entry, Setting};
use crate::noise::{Acts, time_of};
use crate::units::Kind;

/// How well an observable of a test fits, in its kind.
struct TestFit<'d> {
    model: String,
    data: String,
    observable: &'d str,
    kind: Kind,
    rows: usize,
    before: f64,
    after: f64,
    noise: f64,
}

/// The fit of every observable of every test, without rows that are wrong by themselves.
fn test_fits<'d>(data: &'d Data, d: &Diagnosis) -> Vec<TestFit<'d>> {
    let Some(campaign) = data.model.campaign() else { return Vec::new() };
    let some = thinned(data);
    let used = some.as_ref().unwrap_or(data);
    let is_wrong = |row: usize| d.outliers.iter().any(|o| o.record == used.record(row));
    let own = used.observables.iter().zip(used.rows_by_observable()).zip(&d.noise.of);
    let fit = |((seen, rows), noise): ((&crate::measure::MeasuredObservable, Vec<usize>), &f64)| {
        let rows: Vec<usize> = rows.into_iter().filter(|row| !is_wrong(*row)).collect();
        let left = |predicted: &[f64]| {
            let left: Vec<f64> = rows.iter().map(|row| used.observed[*row] - predicted[*row]).collect();
            seen.kind.from_si(rms(&left))
        };
        TestFit {
            model: campaign.test_of(seen.position).model.source.name.to_string(),
            data: rows.first().and_then(|row| used.file_of(*row)).unwrap_or_default().to_string(),
            observable: campaign.name_in_test(seen.position),
            kind: seen.kind,
            rows: rows.len(),
            before: left(&d.before.predicted),
            after: left(&d.after.predicted),
            noise: seen.kind.from_si(*noise),
        }
    };
    own.map(fit).collect()
}

/// The table of the tests.
pub fn fits(data: &Data, d: &Diagnosis) -> String {
    let all = test_fits(data, d);
    let label = |fit: &TestFit| match all.iter().filter(|other| other.model == fit.model).count() {
        1 => fit.model.clone(),
        _ => format!("{}: {}", fit.model, fit.observable),
    };
    let width = all.iter().map(|fit| label(fit).chars().count()).max().unwrap_or(0).max(5);
    let mut text = format!("\n  {:<width$} {:>11} {:>11} {:>11}\n", "rms of", "before", "after", "noise");
    for fit in &all {
        let TestFit { before, after, noise, kind, .. } = fit;
        let _ = writeln!(text, "  {:<width$} {before:>11.3} {after:>11.3} {noise:>11.3}  {}", label(fit), kind.unit);
    }
    text
}

/// The tests in which a cause acts, by their numbers, and as what.
fn acts<'c>(campaign: &'c Campaign, data: &Data, missing: &Missing) -> Vec<(usize, Option<&'c Acting>)> {
    match &missing.cause {
        // A value of what they draw.
        Cause::Value { .. } => {
            let has_it = |test: &usize| campaign.tests[*test].model.quantity(&missing.effect.name).is_some();
            (0..campaign.tests.len()).filter(has_it).map(|test| (test, None)).collect()
        }
        // No law is sought in tests together.
        Cause::Physical | Cause::Law(_) => {
            let shared = campaign.effect(&missing.effect.name);
            shared.map_or(Vec::new(), |shared| shared.acts.iter().map(|(test, acting)| (*test, Some(acting))).collect())
        }
        Cause::Measurement { observable: Some(name), .. } => {
            let seen = data.observables.iter().find(|seen| seen.name == *name);
            seen.map(|seen| (campaign.number_of(seen.position), None)).into_iter().collect()
        }
        Cause::Measurement { effect, records, .. } => {
            let has_time = |test: usize| time_of(&*campaign.tests[test].model.process).is_some();
            let all = (0..campaign.tests.len()).filter(|test| match records[..] {
                [] => !matches!(effect.acts, Acts::Times(_)) || has_time(*test),
                _ => records.iter().any(|record| file_of(data, *record).0 == *test),
            });
            all.map(|test| (test, None)).collect()
        }
    }
}

/// The number of the file of a record, counted from 1, which is that of its test, and the record's number there.
fn file_of(data: &Data, record: usize) -> (usize, usize) {
    let number = data.files.partition_point(|file| file.first_record < record).saturating_sub(1);
    (number, record - data.files[number].first_record)
}

/// Where a cause acts: the models of the tests, and what it is called there if that is something else.
pub fn places(campaign: &Campaign, data: &Data, missing: &Missing) -> Vec<String> {
    let place = |(test, acting): (usize, Option<&Acting>)| {
        let file = &campaign.tests[test].model.source.name;
        match acting {
            Some(Acting::Effect(own)) if own.name != missing.effect.name => format!("{file} as {}", own.name),
            Some(Acting::Quantity(path)) => format!("{file} as {path}"),
            _ => file.to_string(),
        }
    };
    acts(campaign, data, missing).into_iter().map(place).collect()
}

/// The commands that complete the model of each test.
pub fn commands(campaign: &Campaign, data: &Data, d: &Diagnosis) -> Vec<String> {
    let mut lines = Vec::new();
    let mut files: Vec<String> = campaign.tests.iter().map(|test| test.model.source.name.to_string()).collect();
    let mut tables: BTreeMap<usize, Vec<String>> = BTreeMap::new();
    let mut by_hand: Vec<(usize, String)> = Vec::new();
    let mut more = |test: usize, addition: Addition| {
        let (line, to) = addition.command(&files[test]);
        lines.push(line);
        files[test] = to;
    };
    for missing in &d.missing {
        let all = settings(missing, &d.fit);
        for (test, acting) in acts(campaign, data, missing) {
            let model = &campaign.tests[test].model;
            match acting {
                None if matches!(missing.cause, Cause::Value { .. }) => {
                    let own = all.first().map(|own| Setting { key: missing.effect.name.to_string(), ..own.clone() });
                    own.into_iter().for_each(|own| more(test, Addition::Value(own)));
                }
                Some(Acting::Quantity(path)) => {
                    let value = all.first().map_or(String::new(), |setting| setting.value.to_string());
                    by_hand.push((test, format!("{path} = \"{value}\"")));
                }
                Some(Acting::Effect(own)) => more(test, Addition::Effect(own.name.to_string(), all.clone())),
                None => {
                    let names = tables.entry(test).or_default();
                    let name = model.free_table(&missing.effect.name, names);
                    names.push(name.clone());
                    more(test, Addition::Effect(name, in_test(campaign, data, test, &all)));
                }
            }
        }
    }
    lines.extend(by_hand.iter().map(|(test, line)| format!("in {}: {line}", quoted(&files[*test]))));
    lines.push(format!("fem diagnose {}{}", each_with(&files, data).join(" "), said(data)));
    lines
}

/// The commands that seek a law in what is left of each test by itself.
pub fn discover(campaign: &Campaign, data: &Data) -> Vec<String> {
    let files: Vec<String> = campaign.tests.iter().map(|test| test.model.source.name.to_string()).collect();
    each_with(&files, data).iter().map(|each| format!("fem discover {each}{}", said(data))).collect()
}

/// The files of models, each with the measurements of its test.
fn each_with(models: &[String], data: &Data) -> Vec<String> {
    let each = models.iter().zip(&data.files);
    each.map(|(model, file)| format!("{} --with {}", quoted(model), quoted(&file.name))).collect()
}

/// The options that were given for all tests.
fn said(data: &Data) -> String {
    data.said.iter().map(|word| format!(" {}", quoted(word))).collect()
}

/// Settings of an effect of the measurement as the model of one test takes them.
fn in_test(campaign: &Campaign, data: &Data, test: usize, all: &[Setting]) -> Vec<Setting> {
    let own = data.observables.iter().filter(|seen| campaign.number_of(seen.position) == test);
    let several = own.count() > 1;
    let setting = |setting: &Setting| match (&*setting.key, &setting.value) {
        ("observable", Entry::Text(name)) => {
            let seen = data.observables.iter().find(|seen| seen.name == *name)?;
            let value = Entry::Text(campaign.name_in_test(seen.position).to_string());
            several.then(|| Setting { value, ..setting.clone() })
        }
        (_, Entry::Rows(records)) => {
            let own = records.iter().map(|record| file_of(data, *record)).filter(|(file, _)| *file == test);
            Some(Setting { value: Entry::Rows(own.map(|(_, record)| record).collect()), ..setting.clone() })
        }
        _ => Some(setting.clone()),
    };
    all.iter().filter_map(setting).collect()
}

/// Adds to the JSON of a diagnosis what is said of each test.
pub fn extend(all: &mut Json, campaign: &Campaign, data: &Data, d: &Diagnosis) {
    let machine = data.model.machine.as_ref();
    all["machine"] = json!(machine.map(|m| json!({ "file": m.path.display().to_string(), "name": m.name })));
    let test = |fit: &TestFit| {
        json!({
            "model": fit.model,
            "data": fit.data,
            "observable": fit.observable,
            "unit": fit.kind.unit,
            "observations_used": fit.rows,
            "rms_before": fit.before,
            "rms_after": fit.after,
            "noise": fit.noise,
        })
    };
    all["tests"] = test_fits(data, d).iter().map(test).collect();
    for (number, missing) in d.missing.iter().enumerate() {
        let place = |(test, acting): (usize, Option<&Acting>)| {
            let (own, path) = match acting {
                None if matches!(missing.cause, Cause::Value { .. }) => (None, Some(&*missing.effect.name)),
                Some(Acting::Effect(own)) => (Some(&own.name), None),
                Some(Acting::Quantity(path)) => (None, Some(*path)),
                None => (Some(&missing.effect.name), None),
            };
            json!({ "model": &*campaign.tests[test].model.source.name, "effect": own, "quantity": path })
        };
        all["missing"][number]["acts_in"] = acts(campaign, data, missing).into_iter().map(place).collect();
    }
}
