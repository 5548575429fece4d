//! FANUC: increments that are output one after another as the axis passes from point to point.

use std::collections::HashMap;

use super::Added;
use super::axis::Files;
use super::text::{linear, value_of};

/// Detection unit of the axis, mm.
const DETECTION: f64 = 1e-4;

/// Numbers of points and their increments.
fn tape(text: &str) -> HashMap<i64, i64> {
    assert!(text.starts_with("%\n") && text.ends_with("%\n"), "{text}");
    let word = |line: &str| {
        let (number, value) = line.strip_prefix('N')?.strip_suffix(';')?.split_once('P')?;
        Some((number.parse::<i64>().ok()? - 10_000, value.parse().ok()?))
    };
    let inner = text.trim_matches(['%', '\n']);
    let words: HashMap<i64, i64> = inner.lines().map(|line| word(line).unwrap_or_else(|| panic!("{line}"))).collect();
    assert_eq!(words.len(), inner.lines().count(), "a number stands twice");
    assert!(words.iter().all(|(number, value)| (0..=1023).contains(number) && (-7..=7).contains(value)), "{words:?}");
    words
}

/// What is added at the points (mm), walking from the reference point to either end.
fn walked(words: &HashMap<i64, i64>, parameters: &str, shift: i64) -> Vec<(f64, f64)> {
    let [reference, first, last, magnification] =
        ["3620", "3621", "3622", "3623"].map(|key| value_of(parameters, &format!("{key} ")) as i64);
    let interval = value_of(parameters, "3624 ");
    let at = parameters.lines().next_back().map(|_| reference_position(parameters)).unwrap();
    let count = DETECTION * magnification as f64;
    let increment = |number: i64| words[&(number + shift)] as f64 * count;
    let place = |number: i64| at + interval * (number - reference) as f64;
    let mut table = vec![(place(first - 1), 0.0)];
    for number in first..=last {
        table.push((place(number), table[table.len() - 1].1 + increment(number)));
    }
    // Nothing is added at the reference point; beyond the ends nothing is added or taken off any more.
    let zero = linear(&table, at);
    table.iter().map(|(place, sum)| (*place, sum - zero)).collect()
}

fn reference_position(parameters: &str) -> f64 {
    let line = parameters.lines().find(|line| line.starts_with("3620 ")).unwrap();
    line.split(" at ").nth(1).unwrap().split(' ').next().unwrap().parse().unwrap()
}

pub fn one_way(files: &Files) -> Added {
    let parameters = files.named("fanuc-parameters.txt");
    assert!(parameters.starts_with("3605#0 0 "));
    let table = walked(&tape(files.named("fanuc.txt")), parameters, 0);
    let backlash = DETECTION * value_of(parameters, "1851 ");
    Box::new(move |at, forward| linear(&table, at) - if forward { 0.0 } else { backlash })
}

pub fn both_ways(files: &Files) -> Added {
    let parameters = files.named("fanuc-bidirectional-parameters.txt");
    assert!(parameters.starts_with("3605#0 1 ") && value_of(parameters, "1851 ") == 0.0);
    let words = tape(files.named("fanuc-bidirectional.txt"));
    let [first, second] = ["3621 ", "3626 "].map(|key| value_of(parameters, key) as i64);
    assert!(second > value_of(parameters, "3622 ") as i64, "the lists overlap");
    let tables = [walked(&words, parameters, 0), walked(&words, parameters, second - first)];
    let offset = DETECTION * value_of(parameters, "3627 ");
    Box::new(move |at, forward| if forward { linear(&tables[0], at) } else { offset + linear(&tables[1], at) })
}
