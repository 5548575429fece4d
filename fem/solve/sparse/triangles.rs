//! Solving with the triangles of a factor, L y = b and Lᵀ x = y, supernode by supernode.
//!
//! ```text
//!   [ first half | second half | top ]     columns in elimination order
//! ```
//!
//! The elimination tree falls apart below its top: the two halves share no row but those of the top, so that
//! two tasks solve with them at a time. Each sums up what it gives to the top by itself, and the sums are
//! added in a fixed order: the result does not depend on the number of threads. The work is reading the
//! factor once for each triangle.

use std::ops::Range;

use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;

/// Entries of the factor below which a second task costs more than it saves.
const SMALL: usize = 200_000;
/// Largest share of the greater half, and of the top.
const HALF: f64 = 0.62;
const TOP: f64 = 0.25;

/// The two halves of the elimination tree: the supernodes `..middle`, `middle..top`, and `top..`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Halves {
    pub middle: usize,
    pub top: usize,
}

impl Halves {
    /// Takes supernodes away from the end (the root) until the trees below fall into two groups of about
    /// equal size.
    pub fn find(symbolic: &SymbolicSupernodalCholesky<u32>) -> Option<Self> {
        let entries = symbolic.col_ptr_for_val();
        let whole = f64::from(entries[symbolic.n_supernodes()]);
        if whole < SMALL as f64 {
            return None;
        }
        let firsts = first_descendants(symbolic);
        for top in (1..=symbolic.n_supernodes()).rev() {
            let below = f64::from(entries[top]);
            if whole - below > TOP * whole {
                return None;
            }
            // trees from the last one back, until they make up half
            let mut middle = top;
            while middle > 0 && below - f64::from(entries[middle]) < 0.5 * below {
                middle = firsts[middle - 1];
                let share = f64::from(entries[middle]) / below;
                if (1.0 - HALF..=HALF).contains(&share) {
                    return Some(Self { middle, top });
                }
            }
        }
        None
    }
}

/// First supernode of the subtree of every supernode (they are in post-order).
fn first_descendants(symbolic: &SymbolicSupernodalCholesky<u32>) -> Vec<usize> {
    let begins = symbolic.supernode_begin();
    let mut firsts: Vec<usize> = (0..symbolic.n_supernodes()).collect();
    for node in 0..firsts.len() {
        if let Some(&row) = symbolic.supernode(node).pattern().first() {
            let parent = begins.partition_point(|&begin| begin <= row) - 1;
            firsts[parent] = firsts[parent].min(firsts[node]);
        }
    }
    firsts
}

/// The factor.
pub(super) struct Triangles<'f> {
    pub symbolic: &'f SymbolicSupernodalCholesky<u32>,
    pub values: &'f [f64],
}

/// One supernode: its columns, the rows below them, and its values, column by column.
struct Supernode<'f> {
    columns: Range<usize>,
    rows: &'f [u32],
    values: &'f [f64],
}

/// Columns from `first` on; rows from `top` on are kept apart.
struct Part<'x> {
    nodes: Range<usize>,
    first: usize,
    top: usize,
    x: &'x mut [f64],
}

impl Triangles<'_> {
    /// Overwrites `x` with the solution of L Lᵀ x = b.
    pub fn solve(&self, halves: Option<Halves>, x: &mut [f64]) {
        let (count, size) = (self.symbolic.n_supernodes(), x.len());
        let Some(Halves { middle, top }) = halves else {
            let mut whole = Part { nodes: 0..count, first: 0, top: size, x };
            self.forward(&mut whole, &mut []);
            self.backward(&mut whole, &[]);
            return;
        };
        let begin = |node: usize| self.symbolic.supernode_begin().get(node).map_or(size, |&begin| begin as usize);
        let (border, top_column) = (begin(middle), begin(top));
        let (below, above) = x.split_at_mut(top_column);
        let (first, second) = below.split_at_mut(border);
        let mut first = Part { nodes: 0..middle, first: 0, top: top_column, x: first };
        let mut second = Part { nodes: middle..top, first: border, top: top_column, x: second };
        let [mut sum, mut other] = [vec![0.0; above.len()], vec![0.0; above.len()]];
        rayon::join(|| self.forward(&mut first, &mut sum), || self.forward(&mut second, &mut other));
        for (x, (sum, other)) in above.iter_mut().zip(sum.iter().zip(&other)) {
            *x += sum + other;
        }
        let mut last = Part { nodes: top..count, first: top_column, top: size, x: above };
        self.forward(&mut last, &mut []);
        self.backward(&mut last, &[]);
        rayon::join(|| self.backward(&mut first, last.x), || self.backward(&mut second, last.x));
    }

    fn supernode(&self, node: usize) -> Supernode<'_> {
        let [start, end] = [self.symbolic.supernode_begin()[node], self.symbolic.supernode_end()[node]];
        let values = self.symbolic.col_ptr_for_val();
        Supernode {
            columns: start as usize..end as usize,
            rows: self.symbolic.supernode(node).pattern(),
            values: &self.values[values[node] as usize..values[node + 1] as usize],
        }
    }

    /// L y = b over a part; what it gives to the rows of the top is added to `above`.
    fn forward(&self, part: &mut Part<'_>, above: &mut [f64]) {
        let mut below = Vec::new();
        for node in part.nodes.clone() {
            let Supernode { columns, rows, values } = self.supernode(node);
            let width = columns.len();
            let x = &mut part.x[columns.start - part.first..columns.end - part.first];
            below.clear();
            below.resize(rows.len(), 0.0);
            for (j, column) in values.chunks_exact(width + rows.len()).enumerate() {
                let value = x[j] / column[j];
                x[j] = value;
                subtract(&mut x[j + 1..], &column[j + 1..width], value);
                subtract(&mut below, &column[width..], value);
            }
            let inside = rows.partition_point(|&row| (row as usize) < part.top);
            for (&row, change) in rows[..inside].iter().zip(&below) {
                part.x[row as usize - part.first] += change;
            }
            for (&row, change) in rows[inside..].iter().zip(&below[inside..]) {
                above[row as usize - part.top] += change;
            }
        }
    }

    /// Lᵀ x = y over a part; `above` is the solution in the top.
    fn backward(&self, part: &mut Part<'_>, above: &[f64]) {
        let mut below = Vec::new();
        for node in part.nodes.clone().rev() {
            let Supernode { columns, rows, values } = self.supernode(node);
            let width = columns.len();
            let inside = rows.partition_point(|&row| (row as usize) < part.top);
            below.clear();
            below.extend(rows[..inside].iter().map(|&row| part.x[row as usize - part.first]));
            below.extend(rows[inside..].iter().map(|&row| above[row as usize - part.top]));
            let x = &mut part.x[columns.start - part.first..columns.end - part.first];
            for (j, column) in values.chunks_exact(width + rows.len()).enumerate().rev() {
                let sum = dot(&column[width..], &below) + dot(&column[j + 1..width], &x[j + 1..]);
                x[j] = (x[j] - sum) / column[j];
            }
        }
    }
}

/// y −= factor · column.
fn subtract(y: &mut [f64], column: &[f64], factor: f64) {
    for (y, value) in y.iter_mut().zip(column) {
        *y -= factor * value;
    }
}

/// a · b in four sums, so that they are formed side by side.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let (fours_a, fours_b) = (a.chunks_exact(4), b.chunks_exact(4));
    let rest: f64 = fours_a.remainder().iter().zip(fours_b.remainder()).map(|(a, b)| a * b).sum();
    let mut sums = [0.0; 4];
    for (a, b) in fours_a.zip(fours_b) {
        for (sum, (a, b)) in sums.iter_mut().zip(a.iter().zip(b)) {
            *sum += a * b;
        }
    }
    rest + (sums[0] + sums[1]) + (sums[2] + sums[3])
}
