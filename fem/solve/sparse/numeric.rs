//! The numbers of a sparse Cholesky factor, supernode by supernode, two halves of the elimination tree at a
//! time.
//!
//! ```text
//!   L_s := A_s − Σ_d L_d(rows ≥ s) L_d(columns of s)ᵀ      over the supernodes d before s that reach into it
//!   L_s := L_s (top block factored)⁻ᵀ
//! ```
//!
//! Each finished supernode waits in the list of the next one that it reaches into (Ng and Peyton 1993). Dense
//! kernels are faer's. The halves share no supernode ([`Halves`]); the top follows when both are done. The
//! result does not depend on the number of threads.

use std::ops::Range;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{LltError, cholesky_in_place, cholesky_in_place_scratch};
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::solve_lower_triangular_in_place;
use faer::prelude::{Reborrow, ReborrowMut};
use faer::sparse::linalg::cholesky::supernodal::SymbolicSupernodalCholesky;
use faer::{Accum, MatMut, MatRef, Par};

use super::Matrix;
use super::error::FactorError;
use super::triangles::Halves;

/// No supernode.
const NONE: u32 = u32::MAX;

/// A supernode that still reaches into later ones, and the first of its rows there.
type Waiting = (u32, u32);

/// Writes the factor of the free part of `matrix` into `values`.
pub(super) fn factor(
    symbolic: &SymbolicSupernodalCholesky<u32>,
    halves: Option<Halves>,
    matrix: &Matrix,
    values: &mut [f64],
) -> Result<(), FactorError> {
    let count = symbolic.n_supernodes();
    let task = Task { symbolic, owners: &owners(symbolic), matrix };
    let Some(Halves { middle, top }) = halves else {
        return task.run(0..count, &[], values, &[]).map(|_| ());
    };
    let offset = |node: usize| symbolic.col_ptr_for_val()[node] as usize;
    let (below, above) = values.split_at_mut(offset(top));
    let (first, second) = below.split_at_mut(offset(middle));
    let (left, right) =
        rayon::join(|| task.run(0..middle, &[], first, &[]), || task.run(middle..top, &[], second, &[]));
    let waiting = [left?, right?].concat();
    task.run(top..count, below, above, &waiting).map(|_| ())
}

/// Supernode of every column.
fn owners(symbolic: &SymbolicSupernodalCholesky<u32>) -> Vec<u32> {
    let columns = symbolic.supernode_begin().iter().zip(symbolic.supernode_end());
    (0..).zip(columns).flat_map(|(node, (begin, end))| std::iter::repeat_n(node, (end - begin) as usize)).collect()
}

struct Task<'a> {
    symbolic: &'a SymbolicSupernodalCholesky<u32>,
    owners: &'a [u32],
    matrix: &'a Matrix,
}

/// Lists of the supernodes that wait for each supernode, linked.
struct Lists {
    nodes: Range<usize>,
    heads: Vec<u32>,
    next: Vec<u32>,
    positions: Vec<u32>,
    /// Supernodes that reach beyond `nodes`.
    beyond: Vec<Waiting>,
}

/// One supernode: its first column, number of columns, rows below, and height of its block.
#[derive(Clone, Copy)]
struct Shape<'a> {
    first: usize,
    width: usize,
    rows: &'a [u32],
}

impl Shape<'_> {
    fn height(&self) -> usize {
        self.width + self.rows.len()
    }
}

impl<'a> Task<'a> {
    fn shape(&self, node: usize) -> Shape<'a> {
        let [first, end] = [self.symbolic.supernode_begin()[node], self.symbolic.supernode_end()[node]];
        Shape { first: first as usize, width: (end - first) as usize, rows: self.symbolic.supernode(node).pattern() }
    }

    fn offset(&self, node: usize) -> usize {
        self.symbolic.col_ptr_for_val()[node] as usize
    }

    /// Factors the supernodes `nodes` into `own`. `before` holds the values of all supernodes before them, of
    /// which those of `waiting` reach into them. Returns those that wait for what follows.
    fn run(
        &self,
        nodes: Range<usize>,
        before: &[f64],
        own: &mut [f64],
        waiting: &[Waiting],
    ) -> Result<Vec<Waiting>, FactorError> {
        let count = self.symbolic.n_supernodes();
        let mut lists = Lists {
            heads: vec![NONE; nodes.len()],
            next: vec![NONE; count],
            positions: vec![0; count],
            beyond: Vec::new(),
            nodes: nodes.clone(),
        };
        for &(node, position) in waiting {
            self.wait(&mut lists, node, position);
        }
        let start = self.offset(nodes.start);
        let mut work = Work { places: vec![0; self.owners.len()], locals: Vec::new(), product: Vec::new() };
        for node in nodes {
            let shape = self.shape(node);
            let (done, rest) = own.split_at_mut(self.offset(node) - start);
            let block = &mut rest[..self.offset(node + 1) - self.offset(node)];
            work.assemble(self.matrix, shape, block);
            let mut other = std::mem::replace(&mut lists.heads[node - lists.nodes.start], NONE);
            while other != NONE {
                let following = lists.next[other as usize];
                let values = match self.offset(other as usize).checked_sub(start) {
                    Some(offset) => &done[offset..],
                    None => &before[self.offset(other as usize)..],
                };
                let position = lists.positions[other as usize];
                let position = work.update(shape, block, self.shape(other as usize), values, position as usize);
                self.wait(&mut lists, other, position);
                other = following;
            }
            dense(shape, block)?;
            self.wait(&mut lists, node as u32, 0);
        }
        Ok(lists.beyond)
    }

    /// Puts a supernode into the list of the one that its row at `position` belongs to.
    fn wait(&self, lists: &mut Lists, node: u32, position: u32) {
        let Some(&row) = self.shape(node as usize).rows.get(position as usize) else { return };
        let target = self.owners[row as usize] as usize;
        if lists.nodes.contains(&target) {
            lists.positions[node as usize] = position;
            let head = &mut lists.heads[target - lists.nodes.start];
            lists.next[node as usize] = std::mem::replace(head, node);
        } else {
            lists.beyond.push((node, position));
        }
    }
}

/// Storage kept between supernodes.
struct Work {
    /// Place in the present block of every row of the matrix.
    places: Vec<u32>,
    locals: Vec<u32>,
    product: Vec<f64>,
}

impl Work {
    /// Writes the columns of the matrix into the block.
    fn assemble(&mut self, matrix: &Matrix, shape: Shape<'_>, block: &mut [f64]) {
        for (place, &row) in (shape.width as u32..).zip(shape.rows) {
            self.places[row as usize] = place;
        }
        for column in 0..shape.width {
            self.places[shape.first + column] = column as u32;
        }
        let pattern = matrix.pattern();
        for (column, target) in (shape.first..).zip(block.chunks_exact_mut(shape.height())) {
            let start = pattern.starts[column] as usize;
            let end = start + pattern.free_rows[column] as usize;
            for (&row, value) in pattern.rows[start..end].iter().zip(&matrix.values()[start..end]) {
                target[self.places[row as usize] as usize] = *value;
            }
        }
    }

    /// Takes away what `other` gives to the block, from its row `position` on; its first row beyond the
    /// block's columns.
    fn update(
        &mut self,
        shape: Shape<'_>,
        block: &mut [f64],
        other: Shape<'_>,
        values: &[f64],
        position: usize,
    ) -> u32 {
        let rows = &other.rows[position..];
        let columns = rows.partition_point(|&row| (row as usize) < shape.first + shape.width);
        self.locals.clear();
        self.locals.extend(rows.iter().map(|&row| self.places[row as usize]));
        let values = &values[..other.height() * other.width];
        let all = MatRef::from_column_major_slice(values, other.height(), other.width);
        let lower = all.subrows(other.width + position, rows.len());
        self.product.resize(rows.len() * columns, 0.0);
        let product = MatMut::from_column_major_slice_mut(&mut self.product, rows.len(), columns);
        matmul(product, Accum::Replace, lower, lower.subrows(0, columns).transpose(), 1.0, Par::Seq);
        for (column, product) in self.product.chunks_exact(rows.len()).enumerate() {
            let target = &mut block[self.locals[column] as usize * shape.height()..][..shape.height()];
            for (&local, value) in self.locals[column..].iter().zip(&product[column..]) {
                target[local as usize] -= value;
            }
        }
        (position + columns) as u32
    }
}

/// Factors the top of a block and solves its rows below with it.
fn dense(shape: Shape<'_>, block: &mut [f64]) -> Result<(), FactorError> {
    let scratch = cholesky_in_place_scratch::<f64>(shape.width, Par::Seq, Default::default());
    let mut memory = MemBuffer::try_new(scratch).map_err(|_| FactorError::OutOfMemory)?;
    let block = MatMut::from_column_major_slice_mut(block, shape.height(), shape.width);
    let (mut top, below) = block.split_at_row_mut(shape.width);
    cholesky_in_place(top.rb_mut(), Default::default(), Par::Seq, MemStack::new(&mut memory), Default::default())
        .map_err(|LltError::NonPositivePivot { index }| FactorError::Pivot(shape.first + index))?;
    solve_lower_triangular_in_place(top.rb(), below.transpose_mut(), Par::Seq);
    Ok(())
}
