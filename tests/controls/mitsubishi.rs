//! MITSUBISHI: the amounts by the manual's own two formulas, (interval − actual) × 2 beyond the reference point and
//! (interval + actual) × 2 before it, in the unit of output.

use super::Added;
use super::axis::Files;
use super::text::linear;

/// Unit of output times the scale factor of the axes, mm.
const UNIT: f64 = 1e-3;

pub fn read(files: &Files) -> Added {
    let rows: Vec<Vec<f64>> = files
        .named("mitsubishi.csv")
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect())
        .collect();
    assert!(rows.iter().all(|row| row[0] != 0.0 && row[2].fract() == 0.0 && (-128.0..=127.0).contains(&row[2])));
    let note = files.notes.iter().find(|note| note.contains("division interval")).unwrap();
    let after =
        |words: &str| note.split(words).nth(1).unwrap().split_whitespace().next().unwrap().parse::<f64>().unwrap();
    let interval = after("division interval to ");
    let (reference, backlash) = (after("division point at "), after("the backlash to "));
    // Outwards from the reference point, where nothing is added: what moves the slide by an interval.
    let mut table = vec![(reference, 0.0)];
    for n in 1.. {
        let Some(row) = rows.iter().find(|row| row[0] == f64::from(n)) else { break };
        // The axis moved too little by half of the amount, which is added.
        let sum = table[table.len() - 1].1 + 0.5 * UNIT * row[2];
        assert!((row[1] - reference - interval * f64::from(n)).abs() < 1e-6);
        table.push((row[1], sum));
    }
    for n in 1.. {
        let Some(row) = rows.iter().find(|row| row[0] == f64::from(-n)) else { break };
        // Coming down, the axis moved too little by half of the amount, and goes on by as much, downwards.
        let sum = table[0].1 - 0.5 * UNIT * row[2];
        table.insert(0, (row[1], sum));
    }
    assert_eq!(table.len(), rows.len() + 1);
    Box::new(move |at, forward| linear(&table, at) - if forward { 0.0 } else { backlash })
}
