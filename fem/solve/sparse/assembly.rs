//! Assembly of element matrices straight into the columns of the matrix.
//!
//! The columns are divided into ranges, each owned by one task: it adds up, in the order of the elements,
//! what the elements give to its columns. Elements at the border of two ranges are computed twice, which
//! costs little because ranges of elimination order are compact pieces of the mesh. No entry is written by
//! two tasks, and the sums do not depend on the number of threads.

use std::ops::Range;
use std::sync::Arc;

use rayon::prelude::*;

use super::{Freedoms, Matrix, Pattern, SparseError};
use crate::element::plane::{MAX_NODES, Sampled, Square};
use crate::mesh::{Element, Mesh};

/// Ranges of columns; more balance better, fewer compute fewer elements twice.
const RANGES: usize = 16;
/// Most components of a node.
const MOST_COMPONENTS: usize = 3;

impl Matrix {
    /// Adds up over all elements the matrices that `element` writes into the square it is given (from the
    /// element, its sampled shape functions, and its nodes' coordinates in m).
    ///
    /// # Errors
    /// [`SparseError::NotFinite`] names the element.
    pub fn assemble<const C: usize>(
        mesh: &Mesh,
        pattern: &Arc<Pattern>,
        freedoms: &Freedoms,
        element: impl Fn(Element<'_>, &Sampled, &[[f64; 2]], &mut Square<C>) + Sync,
    ) -> Result<Self, SparseError> {
        let sampled: Vec<Sampled> = mesh.blocks().iter().map(|block| Sampled::new(block.element())).collect();
        let mut values = vec![0.0; pattern.entries()];
        let ranges = ranges(pattern);
        let members = members::<C>(mesh, freedoms, &ranges);
        let mut tasks = Vec::new();
        let mut rest = values.as_mut_slice();
        for (range, members) in ranges.iter().zip(&members) {
            let own = (pattern.starts[range.end] - pattern.starts[range.start]) as usize;
            let (values, other) = rest.split_at_mut(own);
            rest = other;
            tasks.push((range.clone(), members, values));
        }
        tasks.into_par_iter().try_for_each(|(range, members, values)| {
            let mut columns = Columns { pattern, freedoms, range, values };
            let mut square = [[[[0.0; C]; C]; MAX_NODES]; MAX_NODES];
            for &index in members {
                let own = mesh.element(index as usize);
                let coordinates = mesh.coordinates(own);
                element(own, &sampled[own.block], &coordinates[..own.nodes.len()], &mut square);
                if !columns.add(own.nodes, &square) {
                    return Err(SparseError::NotFinite { element: index as usize });
                }
            }
            Ok(())
        })?;
        Ok(Self::from_parts(Arc::clone(pattern), values))
    }

    /// Adds a small matrix over `nodes`, which must share an element: `square[a][b]` couples nodes a and b.
    pub fn add<const C: usize>(&mut self, freedoms: &Freedoms, nodes: &[u32], square: &Square<C>) {
        let (pattern, values) = self.parts_mut();
        let range = 0..pattern.size();
        Columns { pattern, freedoms, range, values }.add(nodes, square);
    }
}

/// Ranges of columns with about as many entries each.
fn ranges(pattern: &Pattern) -> Vec<Range<usize>> {
    let share = pattern.entries().div_ceil(RANGES).max(1) as u32;
    let ends = (1..RANGES as u32).map(|part| pattern.starts.partition_point(|&start| start < part * share));
    let mut borders: Vec<usize> = std::iter::once(0).chain(ends).map(|end| end.min(pattern.size())).collect();
    borders.push(pattern.size());
    borders.windows(2).map(|ends| ends[0]..ends[1]).collect()
}

/// Elements that give something to each range, ascending.
fn members<const C: usize>(mesh: &Mesh, freedoms: &Freedoms, ranges: &[Range<usize>]) -> Vec<Vec<u32>> {
    let mut members = vec![Vec::new(); ranges.len()];
    for element in mesh.elements() {
        let mut touched = [false; RANGES];
        for freedom in element.nodes.iter().flat_map(|&node| (0..C).map(move |i| node as usize * C + i)) {
            let number = freedoms.number(freedom);
            touched[ranges.partition_point(|range| range.end <= number)] = true;
        }
        for (own, _) in members.iter_mut().zip(touched).filter(|(_, touched)| *touched) {
            own.push(element.index as u32);
        }
    }
    members
}

/// Some columns of the matrix and their values.
struct Columns<'a> {
    pattern: &'a Pattern,
    freedoms: &'a Freedoms,
    range: Range<usize>,
    values: &'a mut [f64],
}

impl Columns<'_> {
    /// Adds the part of an element's matrix that belongs to these columns; whether its sums are finite.
    fn add<const C: usize>(&mut self, nodes: &[u32], square: &Square<C>) -> bool {
        // (number in the matrix, node of the element, component), ascending
        let mut places = [(0_u32, 0_u8, 0_u8); MOST_COMPONENTS * MAX_NODES];
        let mut count = 0;
        for (a, &node) in nodes.iter().enumerate() {
            for i in 0..C {
                places[count] = (self.freedoms.number(node as usize * C + i) as u32, a as u8, i as u8);
                count += 1;
            }
        }
        let places = &mut places[..count];
        places.sort_unstable();
        let first = self.pattern.starts[self.range.start];
        let mut sum = 0.0;
        for (k, &(column, b, j)) in places.iter().enumerate() {
            if !self.range.contains(&(column as usize)) {
                continue;
            }
            let start = self.pattern.starts[column as usize];
            let rows = self.pattern.column(column as usize);
            let values = &mut self.values[(start - first) as usize..][..rows.len()];
            let mut entry = 0;
            for &(row, a, i) in &places[k..] {
                // the row is there: all pairs of an element's freedoms are in the pattern
                while rows[entry] < row {
                    entry += 1;
                }
                let value = square[usize::from(a)][usize::from(b)][usize::from(i)][usize::from(j)];
                values[entry] += value;
                sum += value;
            }
        }
        sum.is_finite()
    }
}
