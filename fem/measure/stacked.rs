//! Tables that stand side by side: columns that come again are rows of their own.

use super::heading::{Condition, Heading};
use super::records::Records;
use super::vocabulary::Vocabulary;
use crate::process::Holds;

/// Puts tables that stand side by side below each other. Those whose headings do not say of which run they are are numbered
/// as runs, where the process numbers runs and no column does.
///
/// What is observed must come again with a coordinate, each as often as the others; all else is left as it is.
pub fn stacked(
    headings: Vec<Heading>,
    records: Records,
    vocabulary: Vocabulary,
    told: &mut Vec<String>,
) -> (Vec<Heading>, Records) {
    let places = |name: &str| -> Vec<usize> {
        (0..headings.len()).filter(|i| headings[*i].is_known && headings[*i].name == name).collect()
    };
    let is_observable = |name: &str| name == "actual" || vocabulary.observables.iter().any(|o| o.name == *name);
    let mut again: Vec<(&str, Vec<usize>)> = Vec::new();
    for heading in headings.iter().filter(|heading| heading.is_known) {
        let all = places(&heading.name);
        if all.len() > 1 && again.iter().all(|(name, _)| *name != heading.name) {
            again.push((&heading.name, all));
        }
    }
    let count = again.first().map_or(0, |(_, all)| all.len());
    let has_observed = again.iter().any(|(name, _)| is_observable(name));
    let has_places = again.iter().any(|(name, _)| vocabulary.coordinate(name).is_some());
    let is_even = again.iter().all(|(_, all)| {
        let same_unit = |i: &usize| headings[*i].unit == headings[all[0]].unit;
        all.len() == count && all.iter().all(same_unit)
    });
    if !(has_observed && has_places && is_even) {
        return (headings, records);
    }
    // The condition under which a table stands is told by any of its headings.
    let conditions = |block: usize| -> Vec<Condition> {
        let own = again.iter().flat_map(|(_, all)| &headings[all[block]].at);
        own.fold(Vec::new(), |mut all, one| {
            if !all.contains(one) {
                all.push(one.clone());
            }
            all
        })
    };
    let mut blocks: Vec<Vec<Condition>> = (0..count).map(conditions).collect();
    let run = vocabulary.coordinates.iter().position(|c| c.name == "run" && matches!(c.holds, Holds::Number(_)));
    let is_numbered = blocks.iter().all(Vec::is_empty) && places("run").is_empty();
    let runs = run.filter(|_| is_numbered);
    if let Some(coordinate) = runs {
        for (block, number) in blocks.iter_mut().zip(1..) {
            block.push(Condition { coordinate, value: format!("{number}"), unit: String::new() });
        }
    }
    let fixed: Vec<usize> = blocks[0].iter().map(|own| own.coordinate).collect();
    let is_same = |block: &Vec<Condition>| block.iter().map(|own| own.coordinate).eq(fixed.iter().copied());
    if !blocks.iter().all(is_same) {
        return (headings, records);
    }
    let shared: Vec<usize> = (0..headings.len()).filter(|i| again.iter().all(|(_, all)| !all.contains(i))).collect();
    let mut long: Vec<Heading> = shared.iter().map(|i| headings[*i].clone()).collect();
    long.extend(fixed.iter().map(|i| Heading::made(&vocabulary.coordinates[*i].name, "")));
    long.extend(again.iter().map(|(_, all)| Heading { at: Vec::new(), ..headings[all[0]].clone() }));
    let mut written = Records::written(records.text().clone(), long.len());
    for (block, conditions) in blocks.iter().enumerate() {
        let mut reader = records.reader();
        for number in 0..records.len() {
            let cells = reader.read(number);
            let own: Vec<&str> = again.iter().map(|(_, all)| &cells[all[block]]).collect();
            // Tables of different lengths end where they end.
            if own.iter().any(|cell| !cell.is_empty()) {
                let shared = shared.iter().map(|i| &cells[*i]);
                let fixed = conditions.iter().map(|own| &*own.value);
                written.push_written(records.byte(number), shared.chain(fixed).chain(own));
            }
        }
    }
    let as_runs = if runs.is_some() { format!(", as run 1 to {count}") } else { String::new() };
    told.push(format!("{count} tables side by side{as_runs}"));
    (long, written)
}
