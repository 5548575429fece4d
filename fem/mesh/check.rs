//! Checks of a mesh; every message names the element or node.

use super::{Mesh, MeshError};
use crate::element::plane::Sampled;

/// Smallest Jacobian of an element over its mean that passes: below, an element is flat to rounding.
const FLAT: f64 = 1e-9;

impl Mesh {
    pub(super) fn check(&self) -> Result<(), MeshError> {
        for block in &self.blocks {
            let (count, kind) = (block.connectivity.len(), block.element);
            if !count.is_multiple_of(kind.nodes()) {
                return Err(MeshError::Ragged { kind: kind.name(), count });
            }
        }
        if self.element_count() == 0 {
            return Err(MeshError::Empty);
        }
        if let Some((node, &at)) = self.nodes.iter().enumerate().find(|(_, at)| !at.iter().all(|x| x.is_finite())) {
            return Err(MeshError::NotFinite { node, at });
        }
        self.check_elements()?;
        self.check_sides()
    }

    fn check_elements(&self) -> Result<(), MeshError> {
        let sampled: Vec<Sampled> = self.blocks.iter().map(|block| Sampled::new(block.element)).collect();
        let mut used = vec![false; self.nodes.len()];
        for element in self.elements() {
            for &node in element.nodes {
                let last = self.nodes.len().saturating_sub(1);
                *used.get_mut(node as usize).ok_or(MeshError::UnknownNode { element: element.index, node, last })? =
                    true;
            }
            let coordinates = self.coordinates(element);
            let distortion = sampled[element.block].distortion(&coordinates[..element.nodes.len()]);
            if distortion.is_nan() || distortion <= FLAT {
                let (kind, at) = (element.kind.name(), coordinates[0]);
                return Err(MeshError::Inverted { element: element.index, kind, at, distortion });
            }
        }
        match used.iter().position(|used| !used) {
            Some(node) => Err(MeshError::Unused { node, at: self.nodes[node] }),
            None => Ok(()),
        }
    }

    fn check_sides(&self) -> Result<(), MeshError> {
        for (name, sides) in &self.sides {
            for side in sides {
                let element = side.element as usize;
                let exists =
                    element < self.element_count() && usize::from(side.side) < self.element(element).kind.edges().len();
                if !exists {
                    let (name, element, side) = (name.clone(), side.element, side.side);
                    return Err(MeshError::UnknownSide { name, element, side });
                }
            }
        }
        Ok(())
    }

    /// Piece (from 0, in the order of their first elements) of every node; nodes of one piece hang together
    /// through elements.
    pub fn pieces(&self) -> Vec<u32> {
        let mut roots: Vec<u32> = (0..).take(self.nodes.len()).collect();
        for element in self.elements() {
            let first = root(&mut roots, element.nodes[0]);
            for &node in &element.nodes[1..] {
                let other = root(&mut roots, node);
                roots[other as usize] = first;
            }
        }
        let mut numbers = vec![u32::MAX; self.nodes.len()];
        let mut next = 0;
        for element in self.elements() {
            let number = &mut numbers[root(&mut roots, element.nodes[0]) as usize];
            if *number == u32::MAX {
                *number = next;
                next += 1;
            }
        }
        (0..).take(self.nodes.len()).map(|node| numbers[root(&mut roots, node) as usize]).collect()
    }

    /// Passes where the mesh is one piece.
    ///
    /// # Errors
    /// [`MeshError::Disconnected`] names an element of the first and of the second piece.
    pub fn connected(&self) -> Result<(), MeshError> {
        let pieces = self.pieces();
        let piece = |element: super::Element<'_>| pieces[element.nodes[0] as usize];
        match self.elements().find(|&element| piece(element) != 0) {
            Some(element) => {
                let count = pieces.iter().max().map_or(0, |&last| last as usize + 1);
                Err(MeshError::Disconnected { pieces: count, other: 0, element: element.index })
            }
            None => Ok(()),
        }
    }
}

/// Root of a node in a forest of joined nodes, shortening the way there.
fn root(roots: &mut [u32], mut node: u32) -> u32 {
    while roots[node as usize] != node {
        let above = roots[node as usize];
        roots[node as usize] = roots[above as usize];
        node = above;
    }
    node
}
