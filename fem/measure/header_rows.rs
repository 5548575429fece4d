//! Headings in several rows: names under groups, names in two languages, what an instrument says above its table.

use super::heading::{self, parts};
use super::layout;
use super::reading::Reading;
use super::sheet::Sheet;
use super::vocabulary::Vocabulary;
use super::worded;

/// Most rows of headings.
const MOST_ROWS: usize = 4;

/// Takes the row of which most is understood for the headings, of those at the top that have no numbers where others have
/// some. Groups that stand above it, `Lauf 1` over several columns, go with each of theirs.
pub fn settle(sheet: &mut Sheet, vocabulary: Vocabulary, said: &Reading) {
    let texts = texts(sheet);
    let rows: Vec<&Vec<String>> = std::iter::once(&sheet.header).chain(&texts).collect();
    let understood = |cells: &[String]| cells.iter().filter(|cell| is_understood(cell, vocabulary, said)).count();
    // Of several of which as much is understood, the first.
    let Some(best) = (0..rows.len()).rev().max_by_key(|row| understood(rows[*row])) else { return };
    if best > 0 {
        sheet.told.push(format!("headings from line {}", sheet.records.line(best - 1)));
        sheet.place = sheet.records.place(best - 1);
        sheet.header = under_groups(rows[best - 1], rows[best], vocabulary, said);
        (0..best).for_each(|_| sheet.records.leave_first_out());
    }
    let is_again = |cells: &&Vec<String>| understood(cells) > 0 && !are_units(cells);
    for _ in texts.iter().skip(best).take_while(is_again) {
        sheet.told.push(format!("line {}, headings once more, left out", sheet.records.line(0)));
        sheet.records.leave_first_out();
    }
}

/// The records at the top that are texts, where numbers stand below them.
fn texts(sheet: &Sheet) -> Vec<Vec<String>> {
    let is_text = |cell: &str| !cell.is_empty() && !layout::is_value(cell);
    let mut all = Vec::new();
    let mut reader = sheet.records.reader();
    for record in 0..sheet.records.len().min(MOST_ROWS + 1) {
        let cells = reader.read(record);
        let has_values = cells.iter().any(|cell| !cell.is_empty() && !is_text(cell));
        if has_values {
            return all;
        }
        all.push(cells.iter().map(str::to_string).collect());
    }
    // Texts all the way are no headings.
    Vec::new()
}

fn are_units(cells: &[String]) -> bool {
    cells.iter().all(|cell| matches!(&**cell, "" | "-") || heading::is_unit(heading::bare_unit(cell)))
}

fn is_understood(cell: &str, vocabulary: Vocabulary, said: &Reading) -> bool {
    said.of(cell).is_some() || worded::heading(cell, vocabulary, &[]).is_ok_and(|own| own.is_known)
}

/// The lower row, each heading with the group that stands above it where both together mean more.
fn under_groups(upper: &[String], lower: &[String], vocabulary: Vocabulary, said: &Reading) -> Vec<String> {
    // Only the first column of a group has its name.
    let mut group = "";
    let mut all = Vec::new();
    for (above, own) in upper.iter().zip(lower) {
        if !above.is_empty() {
            group = above;
        }
        let (name, unit) = parts(own, |_| false);
        let unit = if unit.is_empty() { String::new() } else { format!(" [{unit}]") };
        let whole = format!("{name} {group}{unit}");
        let means_more =
            || worded::heading(&whole, vocabulary, &[]).is_ok_and(|own| own.is_known && !own.at.is_empty());
        all.push(match own.is_empty() {
            true if is_understood(above, vocabulary, said) => above.clone(),
            false if said.of(own).is_none() && means_more() => whole,
            _ => own.clone(),
        });
    }
    all
}
