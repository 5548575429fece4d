//! Files with the covariance of all rows: a matrix of numbers, or a header and the entries that are not zero.

use nalgebra::DMatrix;

use super::given::GivenCovariance;
use crate::input::{NamedFile, Problem, number};

/// Largest file, bytes.
pub const LARGEST: u64 = 200_000_000;
/// Most rows of a covariance: factoring it takes their third power.
const MOST_ROWS: usize = 3000;
/// Header of a file of entries.
const ENTRIES: [&str; 3] = ["row", "column", "covariance"];
/// Largest difference between two entries that should be equal, relative to the standard uncertainties.
const ASYMMETRY: f64 = 1e-6;

/// Reads the covariance of rows, in the square of a unit of `factor` SI units.
///
/// # Errors
/// The file is no such file, or the matrix is not square, not symmetric, or not positive definite.
pub fn read(file: &NamedFile, factor: f64) -> Result<GivenCovariance, Problem> {
    let source = file.text()?;
    let text = source.text.strip_prefix('\u{feff}').unwrap_or(&source.text);
    let is_told = |(_, line): &(usize, &str)| !(line.trim().is_empty() || line.starts_with('#'));
    let lines = || text.lines().enumerate().map(|(i, line)| (i + 1, line)).filter(is_told);
    let is_list = lines().next().is_some_and(|(_, first)| first.split(',').map(str::trim).eq(ENTRIES));
    let matrix = if is_list { of_entries(lines().skip(1))? } else { of_matrix(&lines().collect::<Vec<_>>())? };
    check_symmetry(&matrix)?;
    GivenCovariance::new(matrix * (factor * factor)).ok_or_else(|| {
        let problem = Problem::new("the covariance is not positive definite: some sum of rows would have no scatter");
        problem.help("check signs and units; a covariance made of fewer repeats than rows is never so")
    })
}

fn too_many(rows: usize) -> Result<(), Problem> {
    if rows <= MOST_ROWS {
        return Ok(());
    }
    Err(Problem::new(format!("the covariance has {rows} rows, and no more than {MOST_ROWS} can be factored"))
        .help("give the rows in fewer files, or say what they share: zero-shift, correlated-noise"))
}

fn of_matrix(lines: &[(usize, &str)]) -> Result<DMatrix<f64>, Problem> {
    let n = lines.len();
    too_many(n)?;
    let mut matrix = DMatrix::zeros(n, n);
    for (i, (line, text)) in lines.iter().enumerate() {
        let cells: Vec<&str> = text.split(',').map(str::trim).collect();
        if cells.len() != n {
            let problem =
                Problem::new(format!("line {line} has {} numbers, and the file {n} lines of them", cells.len()));
            return Err(problem.help("a covariance is square; a list of entries begins with `row,column,covariance`"));
        }
        for (j, cell) in cells.iter().enumerate() {
            matrix[(i, j)] = entry(cell, *line, "the matrix")?;
        }
    }
    Ok(matrix)
}

fn of_entries<'t>(lines: impl Iterator<Item = (usize, &'t str)>) -> Result<DMatrix<f64>, Problem> {
    let mut entries = Vec::new();
    for (line, text) in lines {
        let cells: Vec<&str> = text.split(',').map(str::trim).collect();
        let &[i, j, value] = &cells[..] else {
            let problem = Problem::new(format!("line {line} has {} cells, the header 3", cells.len()));
            return Err(problem.help("write row, column and covariance"));
        };
        let row = |cell: &str| -> Result<usize, Problem> {
            cell.parse()
                .ok()
                .filter(|row| *row > 0)
                .ok_or_else(|| Problem::new(format!("line {line}: `{cell}` is no row")).help("rows are counted from 1"))
        };
        entries.push((line, row(i)? - 1, row(j)? - 1, entry(value, line, ENTRIES[2])?));
    }
    let n = entries.iter().map(|(_, i, j, _)| i.max(j) + 1).max().unwrap_or(0);
    too_many(n)?;
    let mut matrix = DMatrix::from_element(n, n, f64::NAN);
    for (line, i, j, value) in &entries {
        if !matrix[(*i, *j)].is_nan() {
            let problem = Problem::new(format!("line {line}: the entry of rows {} and {} stands twice", i + 1, j + 1));
            return Err(problem.help("keep one of them"));
        }
        matrix[(*i, *j)] = *value;
    }
    // An entry stands for its mirror image too, and what is not said is zero.
    let said = |i: usize, j: usize| Some(matrix[(i, j)]).filter(|v| !v.is_nan());
    Ok(DMatrix::from_fn(n, n, |i, j| said(i, j).or_else(|| said(j, i)).unwrap_or(0.0)))
}

fn entry(cell: &str, line: usize, column: &str) -> Result<f64, Problem> {
    number(cell, column).map_err(|p| Problem { message: format!("line {line}: {}", p.message), ..p })
}

fn check_symmetry(matrix: &DMatrix<f64>) -> Result<(), Problem> {
    for i in 0..matrix.nrows() {
        for j in 0..i {
            let (a, b) = (matrix[(i, j)], matrix[(j, i)]);
            if (a - b).abs() > ASYMMETRY * (matrix[(i, i)] * matrix[(j, j)]).abs().sqrt() {
                let (i, j) = (i + 1, j + 1);
                let told = format!("the covariance is not symmetric: {a} of rows {i} and {j}, {b} of {j} and {i}");
                return Err(Problem::new(told).help("both are the same number"));
            }
        }
    }
    Ok(())
}
