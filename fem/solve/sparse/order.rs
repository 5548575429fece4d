//! The order in which nodes are eliminated.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;

use super::dissection::dissect;
use super::{Graph, SparseError};

/// A way to find an order of elimination with little fill.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Order {
    /// Nested dissection by coordinates: least work in the factorisation of large meshes.
    #[default]
    Dissection,
    /// Approximate minimum degree (faer): needs no coordinates.
    MinimumDegree,
    /// The order in which the nodes are numbered.
    Natural,
}

impl Order {
    /// The nodes in their order of elimination; `nodes` are their coordinates (m). The order is post-ordered:
    /// every subtree of the elimination tree is contiguous, as supernodes need it.
    ///
    /// # Errors
    /// No memory.
    pub fn find(self, graph: &Graph, nodes: &[[f64; 2]]) -> Result<Vec<u32>, SparseError> {
        let order = match self {
            Self::Dissection => dissect(graph, nodes),
            Self::MinimumDegree => minimum_degree(graph)?,
            Self::Natural => (0..).take(nodes.len()).collect(),
        };
        Ok(postordered(graph, order))
    }
}

fn minimum_degree(graph: &Graph) -> Result<Vec<u32>, SparseError> {
    let count = graph.len();
    let failed = SparseError::OutOfMemory { unknowns: count };
    let (starts, neighbours) = graph.rows();
    let pattern = SymbolicSparseColMatRef::new_checked(count, count, starts, None, neighbours);
    let mut memory =
        MemBuffer::try_new(amd::order_scratch::<u32>(count, neighbours.len())).map_err(|_| failed.clone())?;
    let (mut order, mut inverse) = (vec![0; count], vec![0; count]);
    amd::order(&mut order, &mut inverse, pattern, Default::default(), MemStack::new(&mut memory))
        .map_err(|_| failed)?;
    Ok(order)
}

/// No parent.
const ROOT: u32 = u32::MAX;

/// The same elimination with every subtree of the elimination tree contiguous.
fn postordered(graph: &Graph, order: Vec<u32>) -> Vec<u32> {
    let parents = elimination_tree(graph, &order);
    let count = order.len();
    // children in ascending order, as linked lists
    let (mut first, mut next) = (vec![ROOT; count], vec![ROOT; count]);
    for column in (0..count).rev() {
        let parent = parents[column];
        if parent != ROOT {
            next[column] = first[parent as usize];
            first[parent as usize] = column as u32;
        }
    }
    let mut post = Vec::with_capacity(count);
    let mut stack = Vec::new();
    for root in (0..count).filter(|&column| parents[column] == ROOT) {
        stack.push(root as u32);
        while let Some(&column) = stack.last() {
            let child = first[column as usize];
            if child == ROOT {
                post.push(order[column as usize]);
                stack.pop();
            } else {
                first[column as usize] = next[child as usize];
                stack.push(child);
            }
        }
    }
    post
}

/// Parent of every column (Liu 1986, with path compression).
fn elimination_tree(graph: &Graph, order: &[u32]) -> Vec<u32> {
    let ranks = ranks(order);
    let (mut parents, mut ancestors) = (vec![ROOT; order.len()], vec![ROOT; order.len()]);
    for (column, &node) in (0..).zip(order) {
        for &neighbour in graph.neighbours(node) {
            let mut row = ranks[neighbour as usize];
            while row < column {
                let above = std::mem::replace(&mut ancestors[row as usize], column);
                if above == ROOT {
                    parents[row as usize] = column;
                }
                row = above;
            }
        }
    }
    parents
}

/// Place of every node in `order`.
pub(super) fn ranks(order: &[u32]) -> Vec<u32> {
    let mut ranks = vec![0; order.len()];
    for (rank, &node) in (0..).zip(order) {
        ranks[node as usize] = rank;
    }
    ranks
}
