//! Decimal marks: which of comma and point is one, and numbers written with a point.

use super::records::{Records, Refused};
use crate::input::Problem;

/// The decimal mark of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decimal {
    /// `1,5`; points group thousands.
    Comma,
    /// `1.5`; commas group thousands.
    Point,
}

impl Decimal {
    /// The mark, and the one that groups thousands.
    fn marks(self) -> (char, char) {
        match self {
            Self::Comma => (',', '.'),
            Self::Point => ('.', ','),
        }
    }
}

/// How a cell writes a number.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Style {
    /// With one mark: it could be the decimal mark.
    With(char),
    /// With both marks, or one of them several times.
    Grouped,
    /// No number, or one without a mark.
    Other,
}

/// Writes the numbers of the `numeric` columns with a point. Where nobody `said` which mark is the decimal one,
/// it is the only one that occurs, or the one that is `kept`; commas then are not the separator of the columns.
///
/// Refuses single numbers that have marks where none can stand.
///
/// # Errors
/// Which mark is the decimal one cannot be told, so that no number can be read.
pub fn settle(
    records: &mut Records,
    numeric: &[bool],
    separator: char,
    (said, kept): (Option<Decimal>, Option<Decimal>),
    told: &mut Vec<String>,
) -> Result<Refused, Problem> {
    let decimal = match said {
        Some(decimal) => decimal,
        // Quoted cells such as "1,500" are refused as no numbers.
        None if separator == ',' => return Ok(Refused::default()),
        None => found(records, numeric).or_else(|problem| kept.ok_or(problem))?,
    };
    if decimal == Decimal::Comma {
        told.push("a decimal comma".into());
    }
    if decimal == Decimal::Point && said.or(kept).is_none() {
        return Ok(Refused::default());
    }
    let numeric: Vec<usize> = (0..numeric.len()).filter(|column| numeric[*column]).collect();
    Ok(records.rewrite_or_refuse(&numeric, |_, cells, column| plain(&cells[column], decimal).transpose()))
}

/// A number with a point of a cell that holds a text, where its decimal mark is said, or is a comma beyond doubt: spreadsheets
/// keep numbers as such, and these need none. `None` where the text is no number, or could be two.
pub fn of_text(text: &str, said: Option<Decimal>) -> Option<String> {
    let mantissa = mantissa(text)?;
    let decimal = said.or_else(|| {
        let fraction = mantissa.split_once(',')?.1;
        (!mantissa.contains('.') && !fraction.contains(',') && fraction.len() != 3).then_some(Decimal::Comma)
    })?;
    plain(text, decimal)?.ok()
}

/// The mark that alone occurs; a point where none does.
fn found(records: &Records, numeric: &[bool]) -> Result<Decimal, Problem> {
    let mut first: [Option<(String, usize)>; 2] = [None, None];
    let mut columns = vec![Grouping::default(); numeric.len()];
    let mut reader = records.reader();
    for record in 0..records.len() {
        let cells = reader.read(record).iter().zip(numeric).zip(&mut columns);
        for ((cell, _), column) in cells.filter(|((_, numeric), _)| **numeric) {
            column.see(cell, record);
            let place = match style(cell) {
                Style::With(',') => &mut first[0],
                Style::With(_) => &mut first[1],
                Style::Grouped => {
                    let problem = Problem::new(format!("which mark of `{cell}` is the decimal one cannot be told"));
                    return Err(problem.help(ASK).at(Some(records.place(record))));
                }
                Style::Other => continue,
            };
            if place.is_none() {
                *place = Some((cell.to_string(), record));
            }
            if let [Some((comma, one)), Some((point, other))] = &first {
                let [one, other] = [one, other].map(|record| records.line(*record));
                let message = format!(
                    "numbers are written with a comma, `{comma}` in line {one}, and with a point, `{point}` in line {other}"
                );
                return Err(Problem::new(message).help(ASK).at(Some(records.place(record))));
            }
        }
    }
    if first[0].is_some() {
        return Ok(Decimal::Comma);
    }
    match columns.iter().find_map(Grouping::doubted) {
        Some((cell, record)) => {
            let message = format!("`{cell}` in line {} may be one and a fraction, or thousands", records.line(record));
            Err(Problem::new(message).help(ASK).at(Some(records.place(record))))
        }
        None => Ok(Decimal::Point),
    }
}

/// What speaks for points that group thousands in a column: whole numbers of three digits, and none but numbers that would go on
/// from there as thousands, and as fractions fall to a few.
#[derive(Clone, Debug)]
struct Grouping {
    /// Whether every number with a point has three digits behind it and one to three before.
    is_grouped: bool,
    /// Largest of these, read as fractions, and where the first stands.
    most: f64,
    first: Option<(String, usize)>,
    /// Least number without a point, if it is a hundred at least.
    least: f64,
}

/// Ratio of numbers without a point to those with one from which these are no fractions.
const APART: f64 = 20.0;

impl Default for Grouping {
    fn default() -> Self {
        Self { is_grouped: true, most: 0.0, first: None, least: f64::INFINITY }
    }
}

impl Grouping {
    fn see(&mut self, cell: &str, record: usize) {
        // One fraction of another length settles it, of whatever comes.
        if !self.is_grouped {
            return;
        }
        let Some(digits) = mantissa(cell) else { return };
        match digits.split_once('.') {
            // Nothing is written alike either way.
            None => self.least = self.least.min(digits.parse().ok().filter(|own| *own != 0.0).unwrap_or(f64::INFINITY)),
            Some((whole, fraction)) => {
                let is_grouped = (1..=3).contains(&whole.len()) && !whole.starts_with('0') && fraction.len() == 3;
                self.is_grouped &= is_grouped && digits.len() == cell.trim_start_matches(['+', '-', '−']).len();
                self.most = self.most.max(digits.parse().unwrap_or(f64::INFINITY));
                if self.first.is_none() {
                    self.first = Some((cell.to_string(), record));
                }
            }
        }
    }

    /// The first number that may be thousands.
    fn doubted(&self) -> Option<(&str, usize)> {
        let is_doubted =
            self.is_grouped && self.least >= 100.0 && self.least.is_finite() && APART * self.most < self.least;
        self.first.as_ref().filter(|_| is_doubted).map(|(cell, record)| (&**cell, *record))
    }
}

const ASK: &str = "say --decimal comma, and points group thousands, or --decimal point, and commas do";

fn style(cell: &str) -> Style {
    let Some(mantissa) = mantissa(cell) else { return Style::Other };
    let mut marks = mantissa.chars().filter(|c| matches!(c, ',' | '.'));
    match (marks.next(), marks.next()) {
        (Some(mark), None) => Style::With(mark),
        (Some(_), Some(_)) if is_number(mantissa, Decimal::Comma) || is_number(mantissa, Decimal::Point) => {
            Style::Grouped
        }
        _ => Style::Other,
    }
}

/// The digits and marks of a number before its exponent; `None` where there is something else.
fn mantissa(cell: &str) -> Option<&str> {
    let end = cell.find(['e', 'E']).unwrap_or(cell.len());
    let digits = cell[..end].strip_prefix(['+', '-', '−']).unwrap_or(&cell[..end]);
    let is_one = digits.contains(|c: char| c.is_ascii_digit())
        && digits.chars().all(|c| c.is_ascii_digit() || matches!(c, ',' | '.'));
    is_one.then_some(digits)
}

/// Whether the marks of a mantissa stand where they may: one decimal mark, and groups of three digits before.
fn is_number(mantissa: &str, decimal: Decimal) -> bool {
    let (mark, group) = decimal.marks();
    let (whole, fraction) = mantissa.split_once(mark).unwrap_or((mantissa, ""));
    let mut groups = whole.split(group);
    let first = groups.next().unwrap_or_default();
    let mut more = groups.peekable();
    let is_grouped = more.peek().is_some();
    !fraction.contains([mark, group])
        && more.all(|digits| digits.len() == 3)
        && (!is_grouped || (1..=3).contains(&first.len()))
}

/// A number with a decimal point and no other marks; `None` where the cell is no number.
fn plain(cell: &str, decimal: Decimal) -> Option<Result<String, Problem>> {
    let (mark, group) = decimal.marks();
    let mantissa = mantissa(cell)?;
    if !is_number(mantissa, decimal) {
        let problem = Problem::new(format!("in `{cell}` a mark stands where it groups no thousands"));
        return Some(Err(problem.help("mend the cell, or say the other --decimal")));
    }
    Some(Ok(cell.replace(group, "").replace(mark, ".")))
}
