//! Answers as plain text.

use super::answer::{Answer, left_undone};
use super::block::{Block, Cell, Table};
use super::plot;

/// Columns into which words are wrapped on any wider terminal, and where there is none.
const WIDEST: usize = 100;

/// Space at which no line is wrapped.
const NO_BREAK: char = '\u{a0}';

/// Words that no line parts, such as a value with its unit.
pub(super) fn whole(text: &str) -> String {
    text.replace(' ', &NO_BREAK.to_string())
}

/// A sentence with \u{b5}m where files and terminals have um.
pub(super) fn micro(text: &str) -> String {
    let mut all = String::with_capacity(text.len() + 4);
    let is_word = |c: char| c.is_alphanumeric() || "_-".contains(c);
    for (place, part) in text.split("um").enumerate() {
        if place > 0 {
            let is_unit = !all.ends_with(is_word) && !part.starts_with(is_word);
            all.push_str(if is_unit { "\u{b5}m" } else { "um" });
        }
        all.push_str(part);
    }
    all
}

/// The title of a file, or else its name, on one line.
pub(super) fn titled(title: Option<&str>, name: &str) -> String {
    title.unwrap_or(name).replace(|c: char| c.is_control(), " ")
}

/// An answer as text; curves take as many columns, or those of the usual terminal.
pub fn text(answer: &dyn Answer, columns: Option<usize>) -> String {
    let mut blocks = answer.blocks();
    let undone = left_undone(answer.progress());
    if !undone.is_empty() {
        blocks.extend([Block::Heading("the time was over; left undone:".into()), Block::List(undone)]);
    }
    blocks.iter().map(|block| text_of(block, columns)).collect()
}

/// A block with its line ends.
fn text_of(block: &Block, columns: Option<usize>) -> String {
    let width = columns.map_or(WIDEST, |columns| columns.min(WIDEST));
    match block {
        Block::Lines(lines) => lines.clone(),
        Block::Caution(caution) => format!("\n{}", wrapped("", &format!("caution: {caution}"), 2, width)),
        Block::Heading(heading) => format!("\n{heading}\n"),
        Block::Sentence(sentence) => format!("  {sentence}\n"),
        Block::Paragraph(text) => format!("\n{}", wrapped("", text, 2, width)),
        Block::Entries(items) => format!("\n{}", entries(items, width)),
        Block::List(items) | Block::Commands(items) => items.iter().map(|item| format!("  {item}\n")).collect(),
        Block::Labelled(items) => items.iter().map(|(label, item)| format!("  {label}  {item}\n")).collect(),
        Block::Table(all) => table(all),
        Block::Curve(curve) => format!("\n{}\n", plot::lines(curve, columns.unwrap_or(plot::USUAL)).join("\n")),
    }
}

/// Entries below one another, behind the column of their labels; what an entry goes on with stands deeper than others.
fn entries(items: &[(String, String)], width: usize) -> String {
    let column = items.iter().map(|(label, _)| label.chars().count()).max().unwrap_or(0);
    items.iter().map(|(label, text)| wrapped(&format!("{label:<column$}  "), text, column + 4, width)).collect()
}

/// Words behind a label, wrapped at spaces; further lines are indented. A word that is longer than a line is left whole,
/// and so is what no-break spaces hold together.
fn wrapped(label: &str, text: &str, indent: usize, width: usize) -> String {
    let (mut lines, mut end, mut gap) = (label.to_string(), label.chars().count(), "");
    for word in text.split(' ') {
        let letters = word.chars().count();
        if !gap.is_empty() && end + 1 + letters > width {
            lines += &format!("\n{}", " ".repeat(indent));
            (end, gap) = (indent, "");
        }
        lines += gap;
        lines += &word.replace(NO_BREAK, " ");
        end += gap.len() + letters;
        gap = " ";
    }
    lines + "\n"
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
    fn entries_stand_behind_their_labels() {
        let items = [("open", "a 73\u{a0}%, b 8\u{a0}%"), ("", "c"), ("ruled out", "word"), ("", "longer-than-a-line")];
        let items = items.map(|(label, text)| (label.to_string(), text.to_string()));
        let told =
            "open       a 73 %,\n             b 8 %\n           c\nruled out  word\n           longer-than-a-line\n";
        assert_eq!(entries(&items, 19), told);
    }

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
