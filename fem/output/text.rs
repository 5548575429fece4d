//! Answers as plain text.

use super::answer::{Answer, left_undone};
use super::block::{Block, Cell, Table};
use super::plot;

/// An answer as text; curves take as many columns, or those of the usual terminal.
pub fn text(answer: &dyn Answer, columns: Option<usize>) -> String {
    let mut blocks = answer.blocks();
    let undone = left_undone(answer.progress());
    if !undone.is_empty() {
        blocks.extend([Block::Heading("the time was over; left undone:".into()), Block::List(undone)]);
    }
    blocks.iter().map(|block| text_of(block, columns.unwrap_or(plot::USUAL))).collect()
}

/// A block with its line ends.
fn text_of(block: &Block, columns: usize) -> String {
    match block {
        Block::Lines(lines) => lines.clone(),
        Block::Caution(caution) => format!("\ncaution: {caution}\n"),
        Block::Heading(heading) => format!("\n{heading}\n"),
        Block::Sentence(sentence) => format!("  {sentence}\n"),
        Block::List(items) | Block::Commands(items) => items.iter().map(|item| format!("  {item}\n")).collect(),
        Block::Labelled(items) => items.iter().map(|(label, item)| format!("  {label}  {item}\n")).collect(),
        Block::Table(all) => table(all),
        Block::Curve(curve) => format!("\n{}\n", plot::lines(curve, columns).join("\n")),
    }
}

/// A table below an empty line: names to the left, numbers to the right, remarks apart.
fn table(table: &Table) -> String {
    let written = |cell: &Cell| match cell {
        Cell::Text(text) | Cell::Number(text, _) => text.clone(),
        Cell::Missing => "-".into(),
    };
    let width = |i: usize| {
        let cells = table.rows.iter().filter_map(|row| row.get(i)).map(|cell| written(cell).chars().count());
        let column = &table.columns[i];
        column.width.unwrap_or_else(|| cells.max().unwrap_or(0).max(column.name.chars().count()))
    };
    let widths: Vec<usize> = (0..table.columns.len()).map(width).collect();
    let head = table.columns.iter().map(|column| Cell::Text(column.name.clone())).collect();
    let line = |cells: &Vec<Cell>| {
        let mut line = String::from("\n ");
        for ((i, cell), (column, width)) in cells.iter().enumerate().zip(table.columns.iter().zip(&widths)) {
            let gap = if column.is_remark { "   " } else { " " };
            let text = written(cell);
            line += &match cell {
                Cell::Text(_) if column.is_remark => format!("{gap}{text}"),
                Cell::Text(_) if i == 0 => format!("{gap}{text:<width$}"),
                _ => format!("{gap}{text:>width$}"),
            };
        }
        line
    };
    [&head].into_iter().chain(&table.rows).map(line).collect::<String>() + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::block::Column;

    #[test]
    fn columns_stand_below_their_headings() {
        let row = |name: &str, cells: [f64; 2]| {
            [Cell::Text(name.into())].into_iter().chain(cells.map(Cell::finite)).collect::<Vec<_>>()
        };
        let columns = [Column::wide("model"), Column::new("rms", 8), Column::remark("held out", 8)];
        let rows = [row("a", [1.5, f64::NAN]), row("longer", [f64::INFINITY, -0.0]), vec![Cell::Text("b".into())]];
        let told =
            "\n  model       rms   held out\n  a         1.500          -\n  longer        -      0.000\n  b     \n";
        assert_eq!(table(&Table::new(columns, rows)), told);
    }
}
