//! Metamorphic relations: what is told of the same readings in another order, in other units and words, in other files, twice
//! over, or beside a column that says nothing, is the same.
//!
//! Comparisons of all hidden cases, and diagnoses of the short ones, are a sample; diagnoses of every hidden case are
//! `FEM_EVERY=1 cargo test --release --test measurements relations -- --nocapture`, of every third with `FEM_EVERY=3`.

use fem::compare::compare;
use fem::diagnose::MOST_EFFECTS;
use fem::discover::diagnose;
use fem::input::Source;
use fem::measure::Measurements;
use fem::model::{Data, Model};
use fem::progress::Progress;
use generator::random::Random;

use super::clothes::{Table, UNITS, WORDS, scaled};
use super::{folder, truths};

/// Part of the relations that may be violated where all are tried: round-off decides between twins.
const VIOLATED: f64 = 0.01;
/// Part of its standard uncertainty by which a value may move: a fit ends when a step is smaller than that.
const OF_UNCERTAINTY: f64 = 0.01;
/// Relative difference that is the round-off of sums.
const ROUND_OFF: f64 = 1e-6;

/// What is told of readings.
#[derive(Debug)]
struct Told {
    /// Verdict, and the names of causes.
    words: Vec<String>,
    /// Values, each with its standard uncertainty; of χ² and the root mean square, which are exact, none.
    values: Vec<(f64, f64)>,
}

impl Told {
    fn is_like(&self, other: &Self) -> bool {
        let is_near = |(own, other): (&(f64, f64), &(f64, f64))| {
            let least = ROUND_OFF * own.0.abs().max(other.0.abs());
            (own.0 - other.0).abs() <= least.max(OF_UNCERTAINTY * own.1) || (own.0.is_nan() && other.0.is_nan())
        };
        self.words == other.words
            && self.values.len() == other.values.len()
            && self.values.iter().zip(&other.values).all(is_near)
    }
}

/// The table as files of a relation.
fn text(table: &Table) -> String {
    let head = table.columns.iter().map(|(name, unit)| match &**unit {
        "" => name.clone(),
        unit => format!("{name} [{unit}]"),
    });
    let mut lines = vec![head.collect::<Vec<_>>().join(",")];
    lines.extend(table.rows.iter().map(|row| row.join(",")));
    lines.join("\n") + "\n"
}

/// The same readings in other files, each relation with its name.
fn relations(table: &Table, seed: u64) -> Vec<(&'static str, Vec<Table>)> {
    let with = |rows: Vec<Vec<String>>| Table { columns: table.columns.clone(), rows };
    let random = &mut Random::new("relations", seed);
    let mut shuffled = table.rows.clone();
    for i in (1..shuffled.len()).rev() {
        shuffled.swap(i, random.whole(0, i));
    }
    let reversed: Vec<_> = table.rows.iter().rev().cloned().collect();
    let mut mirrored = table.clone();
    mirrored.columns.reverse();
    mirrored.rows.iter_mut().for_each(|row| row.reverse());
    let (first, second) = table.rows.split_at(table.rows.len() / 2);
    let every_other = |from: usize| with(table.rows.iter().skip(from).step_by(2).cloned().collect());
    let mut constant = table.clone();
    constant.columns.push(("hall".into(), String::new()));
    constant.rows.iter_mut().for_each(|row| row.push("7".into()));
    vec![
        ("rows in another order", vec![with(shuffled)]),
        ("rows from the last to the first", vec![with(reversed)]),
        ("columns in another order", vec![mirrored]),
        ("other units", vec![in_other_units(table)]),
        ("other words", vec![in_other_words(table)]),
        ("parted in the middle", vec![with(first.to_vec()), with(second.to_vec())]),
        ("parted row by row", vec![every_other(0), every_other(1)]),
        ("a copy under another name", vec![table.clone(), table.clone()]),
        ("doubled rows", vec![doubled(table)]),
        ("a column of one value", vec![constant]),
    ]
}

/// Every length, angle, time and force in another unit.
fn in_other_units(table: &Table) -> Table {
    let mut other = table.clone();
    for i in 0..other.columns.len() {
        let unit = &other.columns[i].1;
        let Some((_, all)) = UNITS.iter().find(|(own, _)| own == unit) else { continue };
        let Some((new, factor)) = all.iter().find(|(_, factor)| *factor != 1.0) else { continue };
        other.columns[i].1 = new.to_string();
        other.rows.iter_mut().for_each(|row| row[i] = scaled(&row[i], *factor));
    }
    other
}

/// Headings in German.
fn in_other_words(table: &Table) -> Table {
    let mut other = table.clone();
    for (name, _) in &mut other.columns {
        if let Some((_, words)) = WORDS.iter().find(|(own, _)| own == name) {
            *name = words[0].to_string();
        }
    }
    other
}

/// Every row twice, with √2 times its uncertainty.
fn doubled(table: &Table) -> Table {
    let is_u = |i: usize| table.columns[i].0 == "u" || table.columns[i].0.starts_with("u_");
    let wider = |row: &Vec<String>| -> Vec<String> {
        let cell = |(i, cell): (usize, &String)| scaled(cell, if is_u(i) { 2f64.sqrt() } else { 1.0 });
        row.iter().enumerate().map(cell).collect()
    };
    let rows = table.rows.iter().flat_map(|row| [wider(row), wider(row)]).collect();
    Table { columns: table.columns.clone(), rows }
}

/// The measurements of a relation.
fn read(model: &Model, files: &[Table]) -> Result<Measurements, String> {
    let one = |(number, table): (usize, &Table)| {
        let source = Source::new(format!("{number}.csv"), text(table));
        Measurements::parse(source, &*model.process).map_err(|error| error.to_string())
    };
    let all = files.iter().enumerate().map(one).collect::<Result<Vec<_>, _>>()?;
    Measurements::joined(all).map_err(|problem| problem.message)
}

fn compared(model: &Model, measured: Measurements) -> Result<Told, String> {
    let data = Data::of(model, measured).map_err(|error| error.to_string())?;
    let found = compare(&data).map_err(|failure| failure.to_string())?;
    let values = [found.reduced_chi2, found.rms].map(|value| (value, 0.0)).to_vec();
    Ok(Told { words: vec![format!("{:?}, {} features", found.adequacy(), found.features.len())], values })
}

fn diagnosed(model: &Model, measured: Measurements) -> Result<Told, String> {
    let data = Data::of(model, measured).map_err(|error| error.to_string())?;
    let found = diagnose(&data, MOST_EFFECTS, &Progress::default()).map_err(|failure| failure.to_string())?;
    let mut words: Vec<String> = found.missing.iter().map(|own| own.effect.name.to_string()).collect();
    words.sort();
    words.insert(0, found.verdict.word().into());
    let mut values: Vec<_> = found.fit.estimates.iter().map(|own| (own.value, own.std)).collect();
    values.sort_by(|a, b| a.0.total_cmp(&b.0));
    values.push((found.before.reduced_chi2, 0.0));
    Ok(Told { words, values })
}

/// Relations that were tried, and what those say that are violated.
#[derive(Default)]
struct Tried {
    count: usize,
    violated: Vec<String>,
}

impl Tried {
    fn all(&mut self, name: &str, model: &Model, table: &Table, ask: fn(&Model, Measurements) -> Result<Told, String>) {
        let told = read(model, std::slice::from_ref(table)).and_then(|own| ask(model, own)).unwrap();
        for (relation, files) in relations(table, self.count as u64) {
            self.count += 1;
            match read(model, &files).and_then(|own| ask(model, own)) {
                Ok(other) if other.is_like(&told) => {}
                Ok(other) => self.violated.push(format!("{name}, {relation}: {told:?} and {other:?}")),
                Err(error) => self.violated.push(format!("{name}, {relation}: {error}")),
            }
        }
    }
}

fn hidden(name: &str) -> (Model, Table) {
    let of = |file: &str| folder().join(name).join(file);
    (Model::load(&of("model.toml")).unwrap(), Table::of(&std::fs::read_to_string(of("measured.csv")).unwrap()))
}

#[test]
fn a_comparison_is_of_the_readings_and_not_of_their_file() {
    let mut tried = Tried::default();
    for (name, _) in truths() {
        let (model, table) = hidden(&name);
        if model.require_values().is_ok() {
            tried.all(&name, &model, &table, compared);
        }
    }
    assert!(tried.count > 150 && tried.violated.is_empty(), "of {}: {}", tried.count, tried.violated.join("\n"));
}

#[test]
fn a_diagnosis_is_of_the_readings_and_not_of_their_file() {
    let every: Option<usize> = std::env::var("FEM_EVERY").ok().and_then(|own| own.parse().ok());
    let all = truths().into_iter().map(|(name, _)| name);
    let names: Vec<String> = match every {
        Some(every) => all.step_by(every.max(1)).collect(),
        None => all.filter(|name| name.starts_with("stiffness")).take(2).collect(),
    };
    let mut tried = Tried::default();
    for name in names {
        let (model, table) = hidden(&name);
        tried.all(&name, &model, &table, diagnosed);
        if every.is_some() {
            println!("{name}: {} of {} violated", tried.violated.len(), tried.count);
        }
    }
    let most = if every.is_some() { VIOLATED * tried.count as f64 } else { 0.0 };
    let told = tried.violated.join("\n");
    assert!(tried.violated.len() as f64 <= most, "{} of {}: {told}", tried.violated.len(), tried.count);
}
