//! `tests/seeds.md`: every row that it names exists and passes, its numbers are those of the rows, and its
//! summary counts its tables.

use std::collections::BTreeMap;

use super::TABLES;
use fem::validation::Case;

const PAGE: &str = include_str!("../seeds.md");
/// The beginnings of what an item's status may be, in the order of the summary's columns.
const STATUS: [&str; 5] =
    ["agrees", "differs: ", "not computed: missing, ", "not computed: outside, ", "not computed: nothing to compute, "];

/// The cells of a line of a table.
fn cells(line: &str) -> Vec<&str> {
    line.trim_matches('|').split('|').map(str::trim).collect()
}

/// The items of every seed: cells of place, what it says, where, the seed's number, the program's, status.
fn items() -> Vec<(&'static str, Vec<Vec<&'static str>>)> {
    let sections = PAGE.split("\n## ").filter(|section| section.starts_with("Seed "));
    let rows =
        |section: &'static str| section.lines().filter(|line| line.starts_with("| ")).skip(1).map(cells).collect();
    sections.map(|section| (section.lines().next().unwrap(), rows(section))).collect()
}

/// What stands in backticks.
fn quoted(cell: &str) -> impl Iterator<Item = &str> {
    cell.split('`').skip(1).step_by(2)
}

/// Whether a number as it is printed is the value, to its last digit.
fn prints(printed: &str, value: f64) -> bool {
    let (mantissa, exponent) = printed.split_once('e').unwrap_or((printed, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len() as i32);
    let step = 10f64.powi(exponent.parse::<i32>().unwrap() - decimals);
    (printed.parse::<f64>().unwrap() - value).abs() <= 0.501 * step.min(value.abs().max(1e-9))
}

#[test]
fn the_seeds_are_held_to_their_rows() {
    let rows: BTreeMap<String, &Case> = TABLES
        .iter()
        .flat_map(|(_, cases)| cases)
        .map(|case| (format!("{}, {}", case.name, case.quantity), case))
        .collect();
    let mut named = 0;
    for (seed, items) in items() {
        for item in items {
            let [place, says, place_of, by_seed, by_program, _] = item[..] else { panic!("{seed}: {item:?}") };
            let sources: Vec<&str> = quoted(place_of).filter(|name| !name.starts_with("fem ")).collect();
            let [expected, computed] = [by_seed, by_program].map(|cell| cell.split("; ").collect::<Vec<_>>());
            for (i, name) in sources.iter().enumerate() {
                let case = rows.get(*name).unwrap_or_else(|| panic!("{seed}, {place}, {says}: no row `{name}`"));
                assert!(case.passed(), "{name}");
                for (cell, value) in [(&expected, case.expected), (&computed, case.computed)] {
                    let (number, unit) = cell[i].split_once(' ').unwrap_or((cell[i], "-"));
                    assert!(
                        unit == case.unit && prints(number, value),
                        "{seed}, {place}: `{name}` is {value}, not {}",
                        cell[i]
                    );
                }
                named += 1;
            }
            assert!(
                by_seed.is_empty() && sources.is_empty() || expected.len() == sources.len(),
                "{seed}, {place}, {says}"
            );
        }
    }
    assert!(named > 150, "{named} rows are named");
}

#[test]
fn what_commands_print_stands_under_them() {
    let commands: BTreeMap<&str, &str> = PAGE
        .split_once("\n## Commands")
        .unwrap()
        .1
        .split("\n$ ")
        .skip(1)
        .map(|block| block.split_once('\n').unwrap())
        .collect();
    for (seed, items) in items() {
        for item in items {
            let lines: Vec<&str> = quoted(item[2]).filter(|line| line.starts_with("fem ")).collect();
            for words in quoted(item[4]) {
                let is_printed = |line: &&str| commands.get(line).is_some_and(|block| block.contains(words));
                assert!(lines.iter().any(is_printed), "{seed}, {}: `{words}` is not printed by {lines:?}", item[0]);
            }
            assert!(lines.iter().all(|line| commands.contains_key(line)), "{seed}, {}: {lines:?}", item[0]);
        }
    }
}

#[test]
fn the_summary_counts_the_tables() {
    let mut all = [0; STATUS.len()];
    let line = |name: &str, counts: [usize; STATUS.len()]| {
        let [agree, differ, missing, outside, nothing] = counts;
        let (items, computable) = (counts.iter().sum::<usize>(), agree + differ + missing);
        let covered = 100.0 * (agree + differ) as f64 / computable as f64;
        format!(
            "| {name} | {items} | {agree} | {differ} | {missing} | {outside} | {nothing} | {computable} | {covered:.1} % |"
        )
    };
    for (seed, items) in items() {
        let mut counts = [0; STATUS.len()];
        for item in items {
            let status = item[5];
            let kind = STATUS.iter().position(|kind| status.starts_with(kind));
            let kind = kind.unwrap_or_else(|| panic!("{seed}, {}: `{status}` is no status", item[0]));
            let has_source = quoted(item[2]).next().is_some();
            assert_eq!(
                has_source,
                kind < 2,
                "{seed}, {}: what agrees or differs says where, and nothing else",
                item[0]
            );
            counts[kind] += 1;
            all[kind] += 1;
        }
        assert!(PAGE.contains(&line(seed, counts)), "the summary should have {}", line(seed, counts));
    }
    assert!(PAGE.contains(&line("all", all)), "the summary should have {}", line("all", all));
}
