//! How far a prediction may be off: 95 % of what the values of a model may be, drawn together.

use serde_json::{Value as Json, json};

use super::json::finite;
use super::number::trimmed;
use super::tolerance;
use crate::knowledge::{Band, failed};
use crate::model::Model;
use crate::process::{Column, Rows, Table};
use crate::units::Kind;

/// The observables of rows of a model, each with its rows by their numbers.
pub fn observed(model: &Model, rows: &Rows) -> Vec<(usize, Vec<usize>)> {
    let own = |observable: usize| (0..rows.len()).filter(|row| rows.observable[*row] == observable).collect::<Vec<_>>();
    let all = (0..model.process.observables().len()).map(|observable| (observable, own(observable)));
    all.filter(|(_, rows)| !rows.is_empty()).collect()
}

/// Says that a model failed against the measurements that it was fitted to, where it did.
pub fn failure(band: &Band, kind: Kind) -> Option<String> {
    failed(band.unexplained, &kind).map(|failed| format!("the model {failed}"))
}

/// Width of the band of each observable, what it comes from, and the probability of being within what is asked.
pub fn lines(model: &Model, band: &Band) -> Vec<String> {
    let observables = model.process.observables();
    let of = |(observable, rows): &(usize, Vec<usize>)| {
        let kind = observables[*observable].error_kind();
        let widest = trimmed(kind.from_si(band.widest(rows.iter().copied())), 2);
        format!("{} up to \u{b1}{widest} {}", observables[*observable].words, kind.unit)
    };
    let all: Vec<String> = observed(model, &model.system.programme()).iter().map(of).collect();
    let values = match band.uncertain {
        0 => None,
        1 => Some("one value is known roughly".to_string()),
        several => Some(format!("{several} values are known roughly, drawn together")),
    };
    let left = (band.unexplained > 0.0).then(|| {
        let kind = model.process.size_kind();
        let left = trimmed(kind.from_si(band.unexplained), 2);
        format!("{left} {} of the measurements stay unexplained", kind.unit)
    });
    let from: Vec<String> = values.into_iter().chain(others(band)).chain(left).collect();
    let within = band.probability.as_ref().map(tolerance::probability);
    [format!("{}: {}", all.join(", "), from.join("; "))].into_iter().chain(within).collect()
}

/// Says that other sets of effects explain the measurements as well, where some do.
pub fn others(band: &Band) -> Option<String> {
    match band.others {
        0 => None,
        1 => Some("another set of effects explains the measurements as well, and counts".into()),
        several => Some(format!("{several} other sets of effects explain the measurements as well, and count")),
    }
}

/// The same for programs.
pub fn json(model: &Model, band: &Band) -> Json {
    let observables = model.process.observables();
    let of = |(observable, rows): &(usize, Vec<usize>)| {
        let kind = observables[*observable].error_kind();
        let widest = finite(kind.from_si(band.widest(rows.iter().copied())));
        json!({ "observable": observables[*observable].name, "widest": widest, "unit": kind.unit })
    };
    json!({
        "observables": observed(model, &model.system.programme()).iter().map(of).collect::<Vec<_>>(),
        "uncertain_values": band.uncertain,
        "unexplained": finite(model.process.size_kind().from_si(band.unexplained)),
        "unexplained_unit": model.process.size_kind().unit,
        "other_sets": band.others,
        "probability_in": band.probability.as_ref().map(|own| own.of_all),
        "parts": tolerance::parts(band.probability.as_ref()),
    })
}

/// `bands`, of several observables `bands-NAME`: every row with its prediction, its band and its limits.
pub fn tables(model: &Model, rows: &Rows, predicted: &[f64], band: &Band) -> Vec<(String, Table)> {
    let limits = model.system.limits(rows);
    let observed = observed(model, rows);
    let is_one = observed.len() == 1;
    let of = |(observable, own): (usize, Vec<usize>)| {
        let observable = &model.process.observables()[observable];
        let some = rows.some(&own);
        let coordinates = model.process.coordinates().iter().zip(&some.columns);
        let coordinates = coordinates.map(|(coordinate, values)| Column::coordinate(coordinate, values));
        let quantities = |name: &'static str, value: &dyn Fn(usize) -> f64| {
            let values: Vec<f64> = own.iter().map(|row| value(*row)).collect();
            Column::quantities(name, observable.kind, &values)
        };
        let mut columns: Vec<Column> = coordinates.collect();
        columns.extend([
            quantities("predicted", &|row| predicted[row]),
            quantities("from", &|row| band.interval[row][0]),
            quantities("to", &|row| band.interval[row][1]),
        ]);
        if own.iter().any(|row| limits[*row].is_some()) {
            let end =
                |row: usize, upper: bool| limits[row].map_or(f64::NAN, |own| if upper { own.upper } else { own.lower });
            columns.push(quantities("lower_limit", &|row| end(row, false)));
            columns.push(quantities("upper_limit", &|row| end(row, true)));
        }
        let name = if is_one { "bands".to_string() } else { format!("bands-{}", observable.name) };
        (name, Table { columns })
    };
    observed.into_iter().map(of).collect()
}
