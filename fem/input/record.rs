//! Measured records: a quantity over another, such as a room's temperature over time, from a CSV file that
//! the model names where a constant quantity could stand.
//!
//! ```toml
//! temperature = { file = "room.csv", time = "time", value = "temperature" }
//! ```

use std::path::PathBuf;
use std::sync::Arc;

use super::cells::on_line;
use super::parted_by_commas;
use super::{Cache, Field, NamedFile, Problem, Reader, did_you_mean, line_at, name_and_unit, no_csv, number};
use crate::units::{Kind, Quantity, TEMPERATURE, Unit};

/// Largest file, bytes: some million points.
const LARGEST: u64 = 50_000_000;

/// A quantity over another, straight between measured points. SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    points: Vec<[f64; 2]>,
}

/// A quantity that is always the same, or recorded. SI units.
#[derive(Clone, Debug, PartialEq)]
pub enum Varying {
    /// The same everywhere.
    Constant(f64),
    /// Measured.
    Record(Arc<Record>),
}

/// The coordinate of a record and how far the record must reach.
#[derive(Clone, Copy, Debug)]
pub struct Along {
    /// Key that names its column, and the name of the column where the key is left out.
    pub name: &'static str,
    /// Kind of the coordinate.
    pub kind: Kind,
    /// Stretch over which the quantity must be known, SI; an end that is not a number asks for nothing.
    pub needed: [f64; 2],
}

impl Record {
    /// A record of points (coordinate and value), of which there must be one at least, finite and with rising
    /// coordinates; `None` otherwise.
    pub fn new(points: Vec<[f64; 2]>) -> Option<Self> {
        let is_finite = points.as_flattened().iter().all(|v| v.is_finite());
        let rises = points.windows(2).all(|pair| pair[0][0] < pair[1][0]);
        (is_finite && rises && !points.is_empty()).then_some(Self { points })
    }

    /// The points, coordinates rising.
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// First and last coordinate.
    pub fn span(&self) -> [f64; 2] {
        [self.points[0][0], self.points[self.points.len() - 1][0]]
    }

    /// The value at a coordinate; beyond the ends that of the end.
    pub fn at(&self, x: f64) -> f64 {
        let next = self.points.partition_point(|point| point[0] < x);
        let before = self.points[next.saturating_sub(1)];
        match self.points.get(next) {
            Some(after) if after[0] > before[0] => {
                before[1] + (after[1] - before[1]) * (x - before[0]) / (after[0] - before[0])
            }
            _ => before[1],
        }
    }

    /// The value at `x` of the straight line that has the mean and the first moment of the record over a
    /// stretch; where the stretch has no length, that of the record.
    pub fn straightened(&self, x: f64, [from, to]: [f64; 2]) -> f64 {
        let length = to - from;
        if length <= 0.0 {
            return self.at(x);
        }
        let middle = 0.5 * (from + to);
        let inside = self.points.partition_point(|p| p[0] <= from)..self.points.partition_point(|p| p[0] < to);
        let mut before = [from, self.at(from)];
        let (mut whole, mut moment) = (0.0, 0.0);
        for after in self.points[inside].iter().copied().chain([[to, self.at(to)]]) {
            let (width, mean) = (after[0] - before[0], 0.5 * (before[1] + after[1]));
            whole += width * mean;
            moment += width * (mean * (0.5 * (before[0] + after[0]) - middle) + (after[1] - before[1]) * width / 12.0);
            before = after;
        }
        (whole + 12.0 * moment / (length * length) * (x - middle)) / length
    }
}

impl Varying {
    /// The value at a coordinate; beyond the ends of a record that of the end.
    pub fn at(&self, x: f64) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Record(record) => record.at(x),
        }
    }

    /// Last coordinate at which it is known: infinite without a record.
    pub fn known_until(&self) -> f64 {
        match self {
            Self::Constant(_) => f64::INFINITY,
            Self::Record(record) => record.span()[1],
        }
    }

    /// The largest value that it takes, SI; not a number while that is unknown.
    pub fn most(&self) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Record(record) => record.points.iter().fold(f64::NEG_INFINITY, |most, point| most.max(point[1])),
        }
    }

    /// The smallest value that it takes, SI; not a number while that is unknown.
    pub fn least(&self) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Record(record) => record.points.iter().fold(f64::INFINITY, |least, point| least.min(point[1])),
        }
    }
}

impl Field<'_, '_> {
    /// The quantity, or the record of it that a table in its place names: `file`, the coordinate's column
    /// under the coordinate's name, and the quantity's own column under `value`. An absent key is a problem.
    pub fn varying(self, along: Along) -> Varying {
        self.describe(true);
        self.recorded(along).unwrap_or_else(|| Varying::Constant(self.required()))
    }

    /// The same, or `None` where the key is absent.
    pub fn optional_varying(self, along: Along) -> Option<Varying> {
        self.describe(false);
        self.recorded(along).or_else(|| self.optional().map(Varying::Constant))
    }

    /// The record that a table in the place of the quantity names; the constant NaN where that cannot be read.
    fn recorded(&self, along: Along) -> Option<Varying> {
        let read = |table: &Reader| self.record(table, along);
        let record = self.reader.table_instead(&self.key, self.about, read)?;
        Some(record.map_or(Varying::Constant(f64::NAN), Varying::Record))
    }

    /// Reads a record; `None` where there is none, and the problem is noted.
    fn record(&self, table: &Reader, along: Along) -> Option<Arc<Record>> {
        let file = table.required_file("file", "the record: CSV with a header of name [unit]", LARGEST);
        let coordinate =
            table.text(along.name, "name of the column along which it is recorded; that of this key if left out");
        let value =
            table.text("value", "name of the column of what is recorded; that of the quantity's key if left out");
        let file = file?;
        let columns = [
            Wanted { key: along.name, name: coordinate.unwrap_or(along.name.into()), kind: along.kind },
            Wanted { key: "value", name: value.unwrap_or_else(|| self.key.to_string()), kind: self.kind },
        ];
        let asked = (file.path.clone(), columns);
        let record = table.kept::<Records>().get_or(asked, |(_, columns)| read(&file, columns));
        let told = |(key, problem): Mistake| {
            let message = format!("{}: {}", file.path.display(), problem.message);
            table.problem(key, message, problem.help.unwrap_or_default());
        };
        let record = record.map_err(told).ok()?;
        let within = |value: f64| self.check(Quantity::known(value)).err();
        if let Some(problem) = record.points.iter().find_map(|point| within(point[1])) {
            told(("file", problem));
            return None;
        }
        self.check_span(table, &record, along).then_some(record)
    }

    /// Whether a record reaches as far as it must; the problem is noted where it does not.
    fn check_span(&self, table: &Reader, record: &Record, Along { name, kind, needed }: Along) -> bool {
        let [from, to] = record.span();
        // Times in other units are the same but for rounding.
        let slack = 1e-9 * needed[1].abs();
        let reaches = !(from > needed[0] + slack || to < needed[1] - slack);
        if !reaches {
            let [from, to, first, last] = [from, to, needed[0], needed[1]].map(|x| kind.format(x));
            let message = format!(
                "the record of `{}` reaches from {from} to {to}, and is needed from {first} to {last}",
                self.key
            );
            table.problem("file", message, format!("record it as far as that, or keep the {name} within the record"));
        }
        reaches
    }
}

/// A column that a record needs: the key that names it, its name and its kind.
#[derive(Clone, Debug, PartialEq)]
struct Wanted {
    key: &'static str,
    name: String,
    kind: Kind,
}

/// The records of a model, by their files and columns.
type Records = Cache<(PathBuf, [Wanted; 2]), Record, 16>;

/// A key of the model, and what is wrong with the part of the file that it names.
type Mistake = (&'static str, Problem);

/// Reads two columns of a file.
fn read(file: &NamedFile, wanted: &[Wanted; 2]) -> Result<Record, Mistake> {
    let of_file = |problem: Problem| ("file", problem);
    let source = file.text().map_err(of_file)?;
    let text = source.text.strip_prefix('\u{feff}').unwrap_or(&source.text);
    let skipped = source.text.len() - text.len();
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes());
    let header = reader.headers().map_err(|e| of_file(on_line(&source, no_csv(&e, skipped))))?.clone();
    parted_by_commas(header.iter()).map_err(of_file)?;
    let columns = [column(&header, &wanted[0])?, column(&header, &wanted[1])?];
    let mut points: Vec<[f64; 2]> = Vec::new();
    for row in reader.records() {
        let row = row.map_err(|e| of_file(on_line(&source, no_csv(&e, skipped))))?;
        let place = row.position().map(|p| line_at(text, p.byte() as usize, skipped));
        let refuse = |problem: Problem| of_file(on_line(&source, problem.at(place.clone())));
        let mut point = [0.0; 2];
        for (value, (i, unit)) in point.iter_mut().zip(&columns) {
            let cell = number(row.get(*i).unwrap_or_default(), header.get(*i).unwrap_or_default());
            *value = cell.map_err(refuse)? * unit.factor + unit.offset;
        }
        if wanted[0].kind == TEMPERATURE && point[0] < 0.0 {
            let problem = Problem::new(format!(
                "`{}` is below absolute zero: {}",
                wanted[0].name,
                wanted[0].kind.format(point[0])
            ));
            return Err(refuse(problem.help("look at its sign and its unit")));
        }
        if let Some([before, _]) = points.last().filter(|last| last[0] >= point[0]) {
            let [now, before] = [point[0], *before].map(|x| wanted[0].kind.format(x));
            let problem = Problem::new(format!("`{}` does not rise: {now} after {before}", wanted[0].name));
            return Err(refuse(problem.help("sort the rows, and keep one of those that are equal")));
        }
        points.push(point);
    }
    let empty = || of_file(Problem::new("the file has a header and no rows").help("add at least one"));
    Record::new(points).ok_or_else(empty)
}

/// Position and unit of a column.
fn column(header: &csv::StringRecord, wanted: &Wanted) -> Result<(usize, Unit), Mistake> {
    let Wanted { key, name, kind } = wanted;
    let cells: Vec<(&str, &str)> = header.iter().map(name_and_unit).collect();
    let mut own = cells.iter().enumerate().filter(|(_, (given, _))| given == name);
    match (own.next(), own.next()) {
        (Some((i, (_, unit))), None) => match kind.unit_of(unit) {
            Ok(unit) => Ok((i, unit)),
            Err(e) => {
                let problem = Problem::new(format!("`{name}`: {}", e.message));
                Err((*key, problem.help(format!("write {name} [{}] in its header", kind.unit))))
            }
        },
        (Some(_), Some(_)) => {
            Err((*key, Problem::new(format!("the column `{name}` stands twice")).help("keep one of them")))
        }
        (None, _) => {
            let names = || cells.iter().map(|(name, _)| *name);
            let help = format!(
                "{}its columns are {}",
                did_you_mean(name, names(), '`'),
                names().collect::<Vec<_>>().join(", ")
            );
            Err((*key, Problem::new(format!("there is no column `{name}`")).help(help)))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Kept;
    use super::*;
    use crate::units::{FORCE, TIME};

    fn record() -> Record {
        Record::new(vec![[0.0, 1.0], [2.0, 5.0], [3.0, -1.0], [7.0, 0.0]]).unwrap()
    }

    #[test]
    fn it_is_straight_between_its_points_and_ends_at_its_ends() {
        for (x, y) in [(-1.0, 1.0), (0.0, 1.0), (1.0, 3.0), (2.0, 5.0), (2.5, 2.0), (5.0, -0.5), (7.0, 0.0), (9.0, 0.0)]
        {
            assert_eq!(record().at(x), y, "{x}");
        }
        let one = Record::new(vec![[1.0, 4.0]]).unwrap();
        assert_eq!([0.0, 1.0, 2.0].map(|x| one.at(x)), [4.0; 3]);
        for points in [vec![], vec![[0.0, 1.0], [0.0, 2.0]], vec![[0.0, f64::NAN]]] {
            assert_eq!(Record::new(points), None);
        }
    }

    /// Against the mean and the first moment by a sum of many midpoints.
    #[test]
    fn its_line_over_a_stretch_has_its_mean_and_its_moment() {
        for [from, to] in [[0.5, 1.5], [0.5, 6.0], [2.9, 3.1], [-2.0, 9.0]] {
            let (count, length) = (200_000, to - from);
            let middle = 0.5 * (from + to);
            let sum = |of: &dyn Fn(f64) -> f64| {
                let at = |i: i32| from + length * (f64::from(i) + 0.5) / f64::from(count);
                (0..count).map(|i| of(at(i))).sum::<f64>() * length / f64::from(count)
            };
            let line = |x: f64| record().straightened(x, [from, to]);
            for weight in [&(|_| 1.0) as &dyn Fn(f64) -> f64, &|x| x - middle] {
                let apart = sum(&|x| weight(x) * (record().at(x) - line(x)));
                assert!(apart.abs() < 1e-6, "{from} to {to}: {apart}");
            }
            assert!((line(from) + line(to) - 2.0 * line(middle)).abs() < 1e-12);
        }
        assert_eq!(record().straightened(2.5, [2.5, 2.5]), 2.0);
    }

    /// A second reading of the tables takes what the first has kept.
    #[test]
    fn a_file_is_read_once_and_its_values_keep_their_bounds() {
        let place = tempfile::tempdir().unwrap();
        let text = "[load]\nforce = { file = \"force.csv\", value = \"f\" }";
        let document = toml_edit::Document::parse(text).unwrap();
        let along = Along { name: "time", kind: TIME, needed: [0.0, 60.0] };
        let read = |kept: &Kept, at_least_zero: bool| {
            let of_table = |t: &Reader| {
                let force = t.quantity("force", FORCE, "that presses");
                if at_least_zero { force.not_negative() } else { force }.varying(along)
            };
            Reader::of_file(document.as_table(), place.path(), kept, Default::default(), |m| {
                m.table("load", "what presses", of_table)
            })
        };
        std::fs::write(place.path().join("force.csv"), "f [kN],time [s]\n1,0\n-2,60\n").unwrap();
        let kept = Kept::default();
        let (force, found) = read(&kept, false);
        assert_eq!(found.problems, []);
        assert_eq!(force, Varying::Record(Arc::new(Record::new(vec![[0.0, 1000.0], [60.0, -2000.0]]).unwrap())));
        std::fs::remove_file(place.path().join("force.csv")).unwrap();
        assert_eq!(read(&kept, false).0, force);
        let message = &read(&kept, true).1.problems[0].message;
        assert!(message.ends_with("force.csv: `force` is -2000 N"), "{message}");
        assert!(read(&Kept::default(), false).1.problems[0].message.contains("cannot be read"));
    }
}
