//! The pattern of a matrix over all freedoms: compressed columns of its lower triangle.

use rayon::prelude::*;

use super::{Freedoms, Graph};

/// Columns handled at a time.
const CHUNK: usize = 8192;

/// Rows of every column, ascending, from the diagonal down. Rows of held freedoms come last.
#[derive(Clone, Debug)]
pub struct Pattern {
    pub(super) starts: Vec<u32>,
    pub(super) rows: Vec<u32>,
    /// Entries of each free column in free rows.
    pub(super) free_rows: Vec<u32>,
    /// (Column, entry) of the entries in free columns and held rows.
    pub(super) border: Vec<(u32, u32)>,
}

impl Pattern {
    /// The pattern of the matrices of elements on `graph`.
    pub fn new(graph: &Graph, freedoms: &Freedoms) -> Self {
        let components = freedoms.components();
        let columns = |first: usize| {
            let (mut sizes, mut rows) = (Vec::with_capacity(CHUNK), Vec::with_capacity(20 * CHUNK));
            for number in first..(first + CHUNK).min(freedoms.len()) {
                let start = rows.len();
                let node = (freedoms.freedom(number) / components) as u32;
                for &other in std::iter::once(&node).chain(graph.neighbours(node)) {
                    for component in 0..components {
                        let row = freedoms.number(other as usize * components + component);
                        if row >= number {
                            rows.push(row as u32);
                        }
                    }
                }
                rows[start..].sort_unstable();
                sizes.push((rows.len() - start) as u32);
            }
            (sizes, rows)
        };
        let firsts: Vec<usize> = (0..freedoms.len()).step_by(CHUNK).collect();
        let parts: Vec<(Vec<u32>, Vec<u32>)> = firsts.into_par_iter().map(columns).collect();
        let mut pattern = Self { starts: vec![0], rows: Vec::new(), free_rows: Vec::new(), border: Vec::new() };
        pattern.rows.reserve_exact(parts.iter().map(|part| part.1.len()).sum());
        for (sizes, rows) in parts {
            for size in sizes {
                pattern.starts.push(pattern.starts[pattern.starts.len() - 1] + size);
            }
            pattern.rows.extend(rows);
        }
        let free = freedoms.free() as u32;
        let free_rows = |number| pattern.column(number).partition_point(|&row| row < free) as u32;
        pattern.free_rows = (0..freedoms.free()).map(free_rows).collect();
        for (column, &free_rows) in (0..).zip(&pattern.free_rows) {
            let [start, end] = [column, column + 1].map(|column: u32| pattern.starts[column as usize]);
            pattern.border.extend((start + free_rows..end).map(|entry| (column, entry)));
        }
        pattern
    }

    /// Number of columns.
    pub fn size(&self) -> usize {
        self.starts.len() - 1
    }

    /// Number of entries.
    pub fn entries(&self) -> usize {
        self.rows.len()
    }

    /// Rows of a column, the first being the column itself.
    pub fn column(&self, number: usize) -> &[u32] {
        &self.rows[self.starts[number] as usize..self.starts[number + 1] as usize]
    }

    /// The upper triangle of the leading block of `free` columns in compressed columns: (starts, rows). This
    /// is what the symbolic analysis of an already ordered matrix needs.
    pub(super) fn leading_upper(&self) -> (Vec<u32>, Vec<u32>) {
        let free = self.free_rows.len();
        let lower = |number: usize| &self.column(number)[..self.free_rows[number] as usize];
        let mut starts = vec![0_u32; free + 1];
        for &row in (0..free).flat_map(lower) {
            starts[row as usize + 1] += 1;
        }
        for number in 0..free {
            starts[number + 1] += starts[number];
        }
        let mut next = starts.clone();
        let mut rows = vec![0; starts[free] as usize];
        for number in 0..free {
            for &row in lower(number) {
                rows[next[row as usize] as usize] = number as u32;
                next[row as usize] += 1;
            }
        }
        (starts, rows)
    }

    /// Bytes held.
    pub fn bytes(&self) -> usize {
        4 * (self.starts.len() + self.rows.len() + self.free_rows.len())
    }
}
