//! A list in a file of its own: CSV with a header, every cell as it is written.

use std::path::PathBuf;
use std::sync::Arc;

use super::cells::on_line;
use super::{Cache, NamedFile, Problem, Reader, line_at, no_csv, parted_by_commas};

/// Largest file, bytes: some hundred thousand rows.
const LARGEST: u64 = 5_000_000;

/// The rows of a list.
#[derive(Clone, Debug, PartialEq)]
pub struct Listing {
    /// Path from the working directory.
    pub path: PathBuf,
    /// The cells of the header.
    pub header: Vec<String>,
    /// The rows in their order, as many cells in each as in the header.
    pub rows: Vec<ListedRow>,
}

/// A row of a list.
#[derive(Clone, Debug, PartialEq)]
pub struct ListedRow {
    /// Its line in the file, from 1.
    pub line: usize,
    /// Its cells.
    pub cells: Vec<String>,
}

/// The lists of a model, by their files.
type Listings = Cache<PathBuf, Listing, 4>;

impl Reader<'_> {
    /// A key with the path of a list; `None` where the key is absent, or the problem is noted.
    pub fn listing(&self, key: &'static str, about: &'static str) -> Option<Arc<Listing>> {
        let file = self.file(key, about, LARGEST)?;
        let read = |_: &PathBuf| read(&file);
        let told = |problem: Problem| {
            let message = format!("{}: {}", file.path.display(), problem.message);
            self.problem(key, message, problem.help.unwrap_or_default());
        };
        self.kept::<Listings>().get_or(file.path.clone(), read).map_err(told).ok()
    }

    /// Notes a problem with a line of the list that a key names.
    pub fn problem_on_line(&self, key: &str, listing: &Listing, line: usize, problem: &Problem) {
        let message = format!("{}: line {line}: {}", listing.path.display(), problem.message);
        self.problem(key, message, problem.help.clone().unwrap_or_default());
    }
}

fn read(file: &NamedFile) -> Result<Listing, Problem> {
    let source = file.text()?;
    let text = source.text.strip_prefix('\u{feff}').unwrap_or(&source.text);
    let skipped = source.text.len() - text.len();
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes());
    let wrong = |e: &csv::Error| on_line(&source, no_csv(e, skipped));
    let header: Vec<String> = reader.headers().map_err(|e| wrong(&e))?.iter().map(str::to_string).collect();
    parted_by_commas(header.iter().map(String::as_str))?;
    let mut rows = Vec::new();
    for row in reader.records() {
        let row = row.map_err(|e| wrong(&e))?;
        let start = row.position().map_or(0, |p| line_at(text, p.byte() as usize, skipped).start);
        let line = source.line_column(start).0;
        rows.push(ListedRow { line, cells: row.iter().map(str::to_string).collect() });
    }
    Ok(Listing { path: file.path.clone(), header, rows })
}
