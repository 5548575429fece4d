//! Mach4: at even points the error, expected less actual position, for each direction.

use super::Added;
use super::axis::Files;
use super::text::linear;

pub fn read(files: &Files) -> Added {
    let text = files.named("mach4.csv");
    let head = text.lines().next().unwrap();
    let after =
        |words: &str| head.split(words).nth(1).unwrap().split([' ', ',']).next().unwrap().parse::<f64>().unwrap();
    let (start, length) = (after("start "), after("length "));
    let rows: Vec<Vec<f64>> =
        text.lines().skip(2).map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
    assert!(head.ends_with(&format!(", {} points", rows.len())), "{head}");
    let step = length / (rows.len() - 1) as f64;
    Box::new(move |at, forward| {
        let column = if forward { 2 } else { 3 };
        let table: Vec<(f64, f64)> = rows.iter().map(|row| (start + step * (row[0] - 1.0), row[column])).collect();
        linear(&table, at)
    })
}
