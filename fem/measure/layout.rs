//! Where in a text the table stands: what stands before it, its headings, and its separator.
//!
//! Rows of data are told from all else by their cells: a column of numbers has numbers, moments or nothing in them. What
//! stands above the first of them is the headings, and above these whatever an instrument has to say.

use std::ops::Range;

use super::moment::Moment;
use super::words;
use crate::input::Problem;

/// Separators of columns, in the order in which they are tried: a decimal comma may stand beside the first two.
pub const SEPARATORS: [char; 3] = [';', '\t', ','];

/// Most columns of a file: more are lines that were joined.
pub const MOST_COLUMNS: usize = 1000;

/// Most bytes of a line: ten thousand for each column.
const LONGEST_LINE: usize = 10_000_000;

/// Most separators of one kind in a line, before anything is known of it: marks of decimals may stand beside them.
const MOST_SEPARATORS: usize = 2 * MOST_COLUMNS;

/// Lines by which a text is judged, beyond what stands before the table.
const JUDGED: usize = 200;

/// Most lines above a table.
const MOST_ABOVE: usize = 200;

/// A line that is no comment and not blank.
struct Line {
    /// Bytes of the text.
    place: Range<usize>,
    cells: Vec<Cell>,
}

/// What a cell may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Cell {
    Blank,
    Number,
    Moment,
    /// A word of a label, such as a direction.
    Label,
    Text,
}

/// The table of a text.
#[derive(Clone, Debug, PartialEq)]
pub struct Layout {
    /// Separator of the columns.
    pub separator: char,
    /// Bytes of the line of headings; none where the table has no headings.
    pub headings: Option<Range<usize>>,
    /// Byte from which records are read.
    pub begin: usize,
    /// Number of columns.
    pub columns: usize,
    /// Number of lines above the headings that are none of the table's.
    pub above: usize,
}

/// The problem of a line that is longer than that of any table, or has more cells.
pub fn too_wide(text: &str) -> Option<Problem> {
    let help = "has the file lost its line ends? leave out columns that are not needed";
    let mut start = 0;
    for (number, line) in (1..).zip(text.split_inclusive('\n')) {
        let count = |separator: u8| line.bytes().filter(|byte| *byte == separator).count();
        let most = || SEPARATORS.iter().map(|separator| count(*separator as u8)).max().unwrap_or(0);
        let message = match line.len() {
            bytes if bytes > LONGEST_LINE => {
                Some(format!("line {number} has {bytes} bytes; at most {LONGEST_LINE} are read"))
            }
            // A short line has few.
            bytes if bytes > MOST_SEPARATORS && most() > MOST_SEPARATORS => {
                Some(format!("line {number} has {} columns; at most {MOST_COLUMNS} are read", most() + 1))
            }
            _ => None,
        };
        if let Some(message) = message {
            return Some(Problem::new(message).help(help).at(Some(start..start + 1)));
        }
        start += line.len();
    }
    None
}

/// Finds the table in a text. The separator is tried out unless a file `said` it, and so is the line of the headings:
/// `Some(None)` where there are none.
pub fn find(text: &str, said: Option<char>, headings: Option<Option<usize>>) -> Layout {
    let all: Vec<Layout> = match said {
        Some(separator) => vec![with(text, separator, headings)],
        None => SEPARATORS.iter().map(|separator| with(text, *separator, headings)).collect(),
    };
    // The first that parts a table into columns; else the one that parts it into most.
    let first = all.iter().find(|layout| layout.columns > 1 && is_even(text, layout));
    let widest = all.iter().rev().max_by_key(|layout| layout.columns);
    first.or(widest).cloned().unwrap_or(Layout { separator: ',', headings: None, begin: 0, columns: 0, above: 0 })
}

/// Number of rows of a text, up to some hundreds, that have numbers in columns of numbers.
pub fn rows(text: &str, separator: char) -> usize {
    let all: Vec<Line> = lines(text, 0, separator).take(MOST_ABOVE + JUDGED).collect();
    let Some((columns, _, kinds)) = shape(&all) else { return 0 };
    let has_number = |line: &&Line| line.cells.len() >= columns && line.cells.contains(&Cell::Number);
    all.iter().filter(has_number).filter(|line| is_data(&line.cells, &kinds)).count()
}

/// Whether the headings have as many cells as the line below them.
fn is_even(text: &str, layout: &Layout) -> bool {
    let first = lines(text, layout.begin, layout.separator).next();
    let count = |place: &Range<usize>| cells(&text[place.clone()], layout.separator).len();
    match (&layout.headings, first) {
        (Some(headings), Some(first)) => count(headings) == first.cells.len(),
        _ => true,
    }
}

fn with(text: &str, separator: char, said: Option<Option<usize>>) -> Layout {
    let all: Vec<Line> = lines(text, 0, separator).take(MOST_ABOVE + JUDGED).collect();
    let line_of = |line: &Line| 1 + text[..line.place.start].matches('\n').count();
    let layout = |headings: Option<usize>, first: usize| {
        let begin = all.get(first).map_or(text.len(), |line| line.place.start);
        let columns = headings.or((first < all.len()).then_some(first)).map_or(0, |own| all[own].cells.len());
        let headings = headings.map(|own| all[own].place.clone());
        Layout { separator, headings, begin, columns, above: 0 }
    };
    match said {
        Some(None) => return layout(None, 0),
        Some(Some(number)) => {
            let own = all.iter().position(|line| line_of(line) >= number).unwrap_or(0);
            return Layout { above: own, ..layout(Some(own), own + 1) };
        }
        None => {}
    }
    let Some((columns, widest, kinds)) = shape(&all) else { return layout((!all.is_empty()).then_some(0), 1) };
    let fits = |line: &Line| line.cells.len() >= columns && is_data(&line.cells, &kinds);
    // One row that fits may stand among the lines above; of the table, the next fits too.
    let begins = |i: &usize| fits(&all[*i]) && all.get(i + 1).is_none_or(fits);
    let Some(first) = (0..all.len()).find(begins) else { return layout((!all.is_empty()).then_some(0), 1) };
    // What stands above and is parted as the table is, without a number where the table has numbers.
    let is_heading = |line: &Line| {
        let has_number = line.cells.iter().zip(&kinds).any(|(cell, kind)| *kind == *cell && *cell != Cell::Text);
        // Either may end with a separator, and one heading may be forgotten where that leaves several.
        let fewest = if columns > 2 { columns - 1 } else { columns };
        let is_as_wide = (fewest..=widest + 1).contains(&line.cells.len());
        is_as_wide && !has_number && line.cells.contains(&Cell::Text)
    };
    // The uppermost of the headings that follow each other; rows between them and the first that fits are wrong ones.
    let Some(last) = (0..first).rev().find(|i| is_heading(&all[*i])) else {
        return match first {
            0 => Layout { headings: commented(text, all[0].place.start, separator, columns), ..layout(None, 0) },
            _ if all[..first].iter().all(|line| line.cells.len() == columns) => layout(Some(0), 1),
            _ => Layout { above: first, ..layout(None, first) },
        };
    };
    // A line above that has fewer cells, and none of them blank, is a title.
    let is_title = |line: &Line| line.cells.len() < columns && !line.cells.contains(&Cell::Blank);
    let following = || (0..=last).rev().take_while(|i| is_heading(&all[*i]));
    let top = following().take_while(|i| *i == last || !is_title(&all[*i])).last().unwrap_or(last);
    Layout { above: top, ..layout(Some(top), top + 1) }
}

/// The headings in a comment right above the table, as programs of laboratories write them.
fn commented(text: &str, begin: usize, separator: char, columns: usize) -> Option<Range<usize>> {
    let above = text[..begin].trim_end();
    let start = above.rfind('\n').map_or(0, |at| at + 1);
    let line = above[start..].strip_prefix('#')?;
    let cells = cells(line, separator);
    let is_name = |cell: &String| kind(cell) == Cell::Text;
    (columns > 1 && cells.len() == columns && cells.iter().all(is_name)).then(|| above.len() - line.len()..above.len())
}

/// Number of columns, of cells that most lines have, which may be blank at the end, and the kind of most cells of each
/// column; `None` where no column has numbers.
fn shape(all: &[Line]) -> Option<(usize, usize, Vec<Cell>)> {
    let count = |wanted: usize| all.iter().filter(|line| line.cells.len() == wanted).count();
    let widest = all.iter().map(|line| line.cells.len()).max_by_key(|own| (count(*own), *own))?;
    let table: Vec<&Line> = all.iter().filter(|line| line.cells.len() == widest).collect();
    let kind = |column: usize| {
        let of = |kind: Cell| table.iter().filter(|line| line.cells[column] == kind).count();
        let kinds = [Cell::Number, Cell::Moment, Cell::Label, Cell::Text];
        let filled: usize = kinds.iter().map(|kind| of(*kind)).sum();
        let most = kinds.into_iter().rev().max_by_key(|kind| of(*kind)).unwrap_or(Cell::Text);
        // A column that most rows leave blank says nothing.
        if filled == 0 { Cell::Blank } else { most }
    };
    let mut kinds: Vec<Cell> = (0..widest).map(kind).collect();
    while kinds.last() == Some(&Cell::Blank) {
        kinds.pop();
    }
    let has_numbers = kinds.iter().any(|kind| matches!(kind, Cell::Number | Cell::Moment));
    has_numbers.then_some((kinds.len(), widest, kinds))
}

/// Whether cells may stand in columns of these kinds, with something in one of them that is no text.
fn is_data(cells: &[Cell], kinds: &[Cell]) -> bool {
    let may = |(cell, kind): (&Cell, &Cell)| match kind {
        Cell::Number | Cell::Moment => *cell != Cell::Text,
        _ => true,
    };
    let tells = |cell: &Cell| matches!(cell, Cell::Number | Cell::Moment);
    cells.iter().zip(kinds).all(may) && cells.iter().any(tells)
}

/// Lines that are no comments and not blank, from a byte on.
fn lines(text: &str, from: usize, separator: char) -> impl Iterator<Item = Line> {
    let mut begin = from;
    std::iter::from_fn(move || {
        while begin < text.len() {
            let start = begin;
            let mut end = line_end(text, start);
            // A cell in quotes may hold a line end.
            for _ in 0..8 {
                if end >= text.len() || !is_open(&text[start..end], separator) {
                    break;
                }
                end = line_end(text, end + 1);
            }
            begin = end + 1;
            let line = &text[start..end];
            if !line.trim().is_empty() && !line.starts_with('#') {
                let place = start..start + line.trim_end().len();
                return Some(Line { cells: cells(line, separator).iter().map(|cell| kind(cell)).collect(), place });
            }
        }
        None
    })
}

fn line_end(text: &str, from: usize) -> usize {
    text.get(from..).and_then(|rest| rest.find('\n')).map_or(text.len(), |at| from + at)
}

/// Whether a quote that begins a cell is not closed.
fn is_open(line: &str, separator: char) -> bool {
    let (mut quoted, mut begins) = (false, true);
    for c in line.chars() {
        match c {
            '"' if quoted || begins => quoted = !quoted,
            _ => {}
        }
        begins = (c == separator || (begins && c.is_whitespace())) && !quoted;
    }
    quoted
}

/// The cells of a line.
pub fn cells(line: &str, separator: char) -> Vec<String> {
    let mut reader = super::records::csv_builder(separator as u8).has_headers(false).from_reader(line.as_bytes());
    let mut record = csv::StringRecord::new();
    match reader.read_record(&mut record) {
        Ok(true) => record.iter().map(str::to_string).collect(),
        _ => Vec::new(),
    }
}

/// A text whose columns are parted by blanks alone, with tabs in their place; `None` where it is none. Lines stay lines.
pub fn of_blanks(text: &str) -> Option<String> {
    let is_number = |token: &str| {
        let bare = token.strip_prefix('+').unwrap_or(token).replacen(',', ".", 1);
        bare.starts_with(|c: char| c.is_ascii_digit() || c == '-' || c == '.') && bare.parse::<f64>().is_ok()
    };
    let is_row = |line: &str| {
        let tells = |token: &str| is_number(token) || Moment::parse(token).is_some() || words::is_label(token);
        let count = line.split_whitespace().count();
        let told = line.split_whitespace().filter(|token| tells(token)).count();
        !line.contains([';', '\t']) && told > 1 && 3 * told >= 2 * count && line.contains(is_digit)
    };
    let count = |line: &str| line.split_whitespace().count();
    let rows = || text.lines().filter(|line| !line.starts_with('#')).skip(1).take(MOST_ABOVE + JUDGED);
    let of_rows: Vec<usize> = rows().filter(|line| is_row(line)).map(count).collect();
    let columns = *of_rows.iter().max_by_key(|own| of_rows.iter().filter(|other| other == own).count())?;
    let even = of_rows.iter().filter(|own| **own == columns).count();
    let parted = rows().filter(|line| line.contains([';', '\t'])).count();
    if columns < 2 || even < 2 || parted > even {
        return None;
    }
    let mut written = String::with_capacity(text.len());
    for line in text.split_inclusive('\n') {
        let end = line.trim_end();
        let cells = match is_row(end) {
            true => end.split_whitespace().map(str::to_string).collect(),
            false => named(end, columns).unwrap_or_else(|| vec![end.to_string()]),
        };
        written.push_str(&cells.join("\t"));
        written.push_str(&line[end.len()..]);
    }
    Some(written)
}

fn is_digit(c: char) -> bool {
    c.is_ascii_digit()
}

/// The headings of a line whose columns are parted by blanks: by two and more of them, each word for itself, or each word
/// with the unit behind it, whatever makes as many as there are columns.
fn named(line: &str, columns: usize) -> Option<Vec<String>> {
    let bare = line.trim_start_matches('#');
    let by_two = bare.split("  ").map(str::trim).filter(|cell| !cell.is_empty()).map(str::to_string).collect();
    let words: Vec<String> = bare.split_whitespace().map(str::to_string).collect();
    let mut with_units: Vec<String> = Vec::new();
    for word in &words {
        match with_units.last_mut().filter(|_| word.starts_with(['[', '('])) {
            Some(last) => *last += &format!(" {word}"),
            None => with_units.push(word.clone()),
        }
    }
    [by_two, words, with_units].into_iter().find(|cells| cells.len() == columns)
}

/// Whether a cell is a number, a moment or the word of a label.
pub fn is_value(cell: &str) -> bool {
    !matches!(kind(cell), Cell::Text | Cell::Blank)
}

fn kind(cell: &str) -> Cell {
    let is_number = |cell: &str| {
        let cell = cell.replace(['\u{a0}', '\''], "");
        let bare = cell.trim_start_matches(['+', '-', '−', '<', '>']);
        let digits = bare.chars().any(|c| c.is_ascii_digit());
        digits && bare.chars().all(|c| c.is_ascii_digit() || matches!(c, '.' | ',' | 'e' | 'E' | '+' | '-'))
    };
    match cell {
        "" => Cell::Blank,
        _ if Moment::parse(cell).is_some() => Cell::Moment,
        _ if is_number(cell) => Cell::Number,
        _ if words::is_label(cell) => Cell::Label,
        _ => Cell::Text,
    }
}
