//! Writes tables as CSV: one header row `name [unit]`, numbers at full precision.

use std::fmt::Write;

use crate::process::{Column, Table};

/// Makes the CSV text of a table, with numbers that read back exactly.
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
            // A missing value is an empty cell, and so is the stiffness of what does not yield. Writing to a String does not
            // fail.
            let _ = match column.words.of_value(value) {
                _ if !value.is_finite() => write!(text, "{comma}"),
                Some(word) => write!(text, "{comma}{word}"),
                // Nothing has no sign.
                None => write!(text, "{comma}{}", value + 0.0),
            };
        }
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::process::Column;
    use crate::process::Words;

    #[test]
    fn words_stand_as_words() {
        let columns = vec![
            Column::words("direction", vec![1.0, 0.0], Words::Known(&["+", "-"])),
            Column::numbers("deviation", Some("um"), vec![-0.0, -2.0]),
        ];
        assert_eq!(table(&Table { columns }), "direction,deviation [um]\n-,0\n+,-2\n");
    }

    #[test]
    fn what_is_no_number_is_an_empty_cell() {
        let columns = vec![Column::numbers("rate", Some("um"), vec![2.0, f64::INFINITY, f64::NAN])];
        assert_eq!(table(&Table { columns }), "rate [um]\n2\n\n\n");
    }
}
