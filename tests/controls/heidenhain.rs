//! HEIDENHAIN: a `.COM` table; values are positive where the axis goes too far.

use super::Added;
use super::axis::Files;
use super::text::linear;

pub fn read(files: &Files) -> Added {
    let text = files.named("heidenhain.com");
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("BEGIN HEIDENHAIN .COM MM"));
    let columns: Vec<&str> = lines.next().unwrap().split_whitespace().collect();
    let of = |name: &str| columns.iter().position(|column| *column == name).unwrap();
    let (at, back, ahead) = (of("AXISPOS"), of("BACKLASH"), of("X"));
    let rows: Vec<Vec<f64>> = lines
        .take_while(|line| *line != "[END]")
        .map(|line| line.split_whitespace().map(|cell| cell.parse().unwrap()).collect())
        .collect();
    assert!(text.ends_with("[END]\n") && rows.len() <= 256);
    let distance = rows[1][at] - rows[0][at];
    for (number, pair) in rows.windows(2).enumerate() {
        assert!((pair[1][at] - pair[0][at] - distance).abs() < 1.5e-4 && pair[0][0] == number as f64, "{pair:?}");
    }
    Box::new(move |position, forward| {
        let column = if forward { ahead } else { back };
        let table: Vec<(f64, f64)> = rows.iter().map(|row| (row[at], row[column])).collect();
        -linear(&table, position)
    })
}
