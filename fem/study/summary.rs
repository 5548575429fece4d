//! Summary of the rows of a study, read once from first to last: memory does not grow with them, and the same rows give
//! the same digits.

use super::acceptance::Acceptance;
use super::indices::{Index, Indices};
use super::layout::{Layout, Nature};

/// Failures that are told one by one.
const MOST_FAILURES: usize = 5;
/// Words of a column that are counted one by one.
const MOST_WORDS: usize = 40;

/// A row of results.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Number of the job, from 1.
    pub job: u64,
    /// Values of the inputs, in their units.
    pub inputs: Vec<f64>,
    /// File of the measurements, if there is one.
    pub data: Option<String>,
    /// Results, in their units; nothing but empty cells where the job failed.
    pub results: Vec<Cell>,
    /// Why the job failed; empty if it did not.
    pub error: String,
}

/// A cell of a result.
#[derive(Clone, Debug, PartialEq)]
pub enum Cell {
    /// A number.
    Number(f64),
    /// A word.
    Word(String),
    /// The job has no such result.
    Empty,
}

/// A value with the job that gave it.
#[derive(Clone, Debug, PartialEq)]
pub struct Extreme {
    /// The value.
    pub value: f64,
    /// Number of the job.
    pub job: u64,
    /// Values of its inputs.
    pub inputs: Vec<f64>,
    /// File of its measurements.
    pub data: Option<String>,
}

/// A column of numbers.
#[derive(Clone, Debug)]
pub struct Numbers {
    /// Number of values of which the moments are: with indices those of the two independent points of each group.
    pub count: u64,
    /// Jobs that did not fail, and yet have no such result.
    pub missing: u64,
    /// Mean.
    pub mean: f64,
    /// Standard deviation; NaN of fewer than two values.
    pub std: f64,
    /// Smallest and largest value of all jobs.
    pub ends: Option<[Extreme; 2]>,
    /// The value that lies furthest beyond its tolerance, or least within it.
    pub worst: Option<Extreme>,
    /// Jobs within and beyond the tolerance, of those of which the moments are.
    pub acceptance: Option<Acceptance>,
    /// Sobol' indices of every input, with the number of groups they are of.
    pub indices: Option<(Vec<Index>, u64)>,
}

/// A column of results.
#[derive(Clone, Debug)]
pub enum Found {
    /// Numbers.
    Numbers(Box<Numbers>),
    /// Words with the number of jobs that gave each, the most frequent first.
    Words(Vec<(String, u64)>),
}

/// Summary of the rows of a study.
#[derive(Clone, Debug)]
pub struct Summary {
    /// Number of rows.
    pub rows: u64,
    /// Number of jobs that failed.
    pub failed: u64,
    /// The first of them, with what they said.
    pub failures: Vec<(u64, String)>,
    /// Each column of results.
    pub results: Vec<Found>,
}

/// Sums over rows.
pub struct Summing<'a> {
    layout: &'a Layout,
    rows: u64,
    failed: u64,
    failures: Vec<(u64, String)>,
    columns: Vec<Column>,
}

enum Column {
    Numbers(Box<Sums>),
    Words(Vec<(String, u64)>),
}

struct Sums {
    count: u64,
    missing: u64,
    mean: f64,
    /// Σ (x − mean)².
    squares: f64,
    ends: Option<[Extreme; 2]>,
    worst: Option<Extreme>,
    acceptance: Acceptance,
    indices: Option<Indices>,
    /// Values of the group that is being read.
    group: Vec<f64>,
}

impl<'a> Summing<'a> {
    /// Begins with no row.
    pub fn new(layout: &'a Layout) -> Self {
        let column = |r: &super::layout::ResultColumn| match r.is_word {
            true => Column::Words(Vec::new()),
            false => Column::Numbers(Box::new(Sums {
                count: 0,
                missing: 0,
                mean: 0.0,
                squares: 0.0,
                ends: None,
                worst: None,
                acceptance: Acceptance::default(),
                indices: (layout.group > 1).then(|| Indices::new(layout.inputs.len())),
                group: Vec::new(),
            })),
        };
        let columns = layout.results.iter().map(column).collect();
        Self { layout, rows: 0, failed: 0, failures: Vec::new(), columns }
    }

    /// Adds a row; rows come in the order of their jobs.
    pub fn add(&mut self, row: &Row) {
        self.rows += 1;
        let has_failed = !row.error.is_empty();
        if has_failed {
            self.failed += 1;
            if self.failures.len() < MOST_FAILURES {
                self.failures.push((row.job, row.error.clone()));
            }
        }
        let member = (row.job - 1) % self.layout.group;
        for ((column, about), cell) in self.columns.iter_mut().zip(&self.layout.results).zip(&row.results) {
            match (column, cell) {
                (Column::Numbers(sums), cell) => {
                    let value = if let Cell::Number(value) = cell { *value } else { f64::NAN };
                    sums.add(row, value, about.tolerance, (member, self.layout.group), has_failed);
                }
                (Column::Words(words), Cell::Word(word)) => count(words, word),
                (Column::Words(_), _) => {}
            }
        }
    }

    /// Closes the sums: the summary of all rows that were added.
    pub fn finish(self) -> Summary {
        let tolerances = self.layout.results.iter().map(|r| r.tolerance.is_some());
        let found = self.columns.into_iter().zip(tolerances).map(|(column, has_tolerance)| match column {
            Column::Words(mut words) => {
                words.sort_by(|a, b| b.1.cmp(&a.1).then_with(|| a.0.cmp(&b.0)));
                Found::Words(words)
            }
            Column::Numbers(sums) => Found::Numbers(Box::new(Numbers {
                count: sums.count,
                missing: sums.missing,
                mean: if sums.count > 0 { sums.mean } else { f64::NAN },
                std: if sums.count > 1 { (sums.squares / (sums.count - 1) as f64).sqrt() } else { f64::NAN },
                ends: sums.ends,
                worst: sums.worst,
                acceptance: has_tolerance.then_some(sums.acceptance),
                indices: sums.indices.and_then(|i| Some((i.estimates()?, i.groups()))),
            })),
        });
        Summary { rows: self.rows, failed: self.failed, failures: self.failures, results: found.collect() }
    }
}

impl Sums {
    fn add(
        &mut self,
        row: &Row,
        value: f64,
        tolerance: Option<(f64, f64)>,
        (member, group): (u64, u64),
        has_failed: bool,
    ) {
        if let Some(indices) = &mut self.indices {
            self.group.push(value);
            if member + 1 == group {
                indices.add(&self.group);
                self.group.clear();
            }
        }
        // Mixed points of a group are no further draws.
        let is_draw = member < 2;
        if !value.is_finite() {
            self.missing += u64::from(!has_failed);
            self.acceptance.failed += u64::from(is_draw);
            return;
        }
        if is_draw {
            self.count += 1;
            let change = value - self.mean;
            self.mean += change / self.count as f64;
            self.squares += change * (value - self.mean);
        }
        let here = || Extreme { value, job: row.job, inputs: row.inputs.clone(), data: row.data.clone() };
        match &mut self.ends {
            None => self.ends = Some([here(), here()]),
            Some([smallest, _]) if value < smallest.value => *smallest = here(),
            Some([_, largest]) if value > largest.value => *largest = here(),
            Some(_) => {}
        }
        if let Some((low, high)) = tolerance {
            let beyond = |value: f64| (low - value).max(value - high);
            if is_draw {
                let is_good = beyond(value) <= 0.0;
                self.acceptance.good += u64::from(is_good);
                self.acceptance.bad += u64::from(!is_good);
            }
            if self.worst.as_ref().is_none_or(|worst| beyond(value) > beyond(worst.value)) {
                self.worst = Some(here());
            }
        }
    }
}

/// Counts a word; those beyond the first few kinds together.
fn count(words: &mut Vec<(String, u64)>, word: &str) {
    let word = if words.len() < MOST_WORDS || words.iter().any(|w| w.0 == word) { word } else { "others" };
    match words.iter_mut().find(|w| w.0 == word) {
        Some((_, count)) => *count += 1,
        None => words.push((word.to_string(), 1)),
    }
}

impl Summary {
    /// Caution about a yield from points of this nature, where one is due.
    pub fn caution(nature: Nature) -> Option<&'static str> {
        match nature {
            Nature::Independent => None,
            Nature::Even => Some(
                "the points are spread evenly and are no independent draws: the interval of a yield is that of as many \
                 independent ones, and usually too wide",
            ),
            Nature::Listed => {
                Some("the points are listed and stand for no distribution: shares and means are of them alone")
            }
        }
    }
}
