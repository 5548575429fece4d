//! LinuxCNC: lines of nominal, forward and reverse position; the motor goes to where the axis would be off to the
//! other side.

use super::Added;
use super::axis::Files;
use super::text::linear;

pub fn read(files: &Files) -> Added {
    let rows: Vec<Vec<f64>> = files
        .named("linuxcnc.comp")
        .lines()
        .map(|line| line.split(' ').map(|cell| cell.parse().unwrap()).collect())
        .collect();
    assert!(rows.len() <= 256 && rows.windows(2).all(|pair| pair[1][0] > pair[0][0]));
    Box::new(move |at, forward| {
        let column = if forward { 1 } else { 2 };
        let table: Vec<(f64, f64)> = rows.iter().map(|row| (row[0], row[0] - row[column])).collect();
        linear(&table, at)
    })
}
