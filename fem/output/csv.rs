//! Tables as CSV: one header row `name [unit]`, numbers at full precision.

use std::fmt::Write;

use crate::process::{Column, Table};

/// The table as CSV text, with numbers that read back exactly.
pub fn table(table: &Table) -> String {
    let header = |c: &Column| match c.unit {
        Some(unit) => format!("{} [{unit}]", c.name),
        None => c.name.to_string(),
    };
    let mut text = table.columns.iter().map(header).collect::<Vec<_>>().join(",");
    text.push('\n');
    let rows = table.columns.first().map_or(0, |c| c.values.len());
    for row in 0..rows {
        for (i, column) in table.columns.iter().enumerate() {
            let comma = if i == 0 { "" } else { "," };
            let value = column.values[row];
            // What is not there is an empty cell. Writing to a String does not fail.
            let _ = if value.is_nan() { write!(text, "{comma}") } else { write!(text, "{comma}{value}") };
        }
        text.push('\n');
    }
    text
}
