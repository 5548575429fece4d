//! Meshes: nodes, elements in blocks of one kind, named sides.

mod boundary;
mod check;
mod error;
mod file;
mod gmsh;
mod lattice;
mod locate;
mod rectangle;
mod revolved;
mod ring;
mod spacing;
mod stepped;
#[cfg(test)]
mod tests;

use std::collections::BTreeMap;

pub use error::MeshError;
pub use gmsh::{GmshError, read_gmsh};
pub use lattice::{Direction, Lattice};
pub use locate::Place;
pub use rectangle::RectangleMesh;
pub use revolved::{LEFT, RIGHT, RevolvedMesh, Wall};
pub use ring::{BORE, OUTSIDE, RingMesh};
pub use spacing::Grading;
pub use stepped::SteppedMesh;

use crate::element::plane::{EDGE_NODES, EdgeCurve, MAX_NODES, PlaneElement};

/// Elements of one kind.
#[derive(Clone, Debug)]
pub struct Block {
    element: &'static dyn PlaneElement,
    /// Nodes of the elements one after the other, in the order of the element's reference nodes.
    connectivity: Vec<u32>,
}

impl Block {
    /// The elements of kind `element` whose nodes are listed one after the other, (elements, nodes).
    pub fn new(element: &'static dyn PlaneElement, connectivity: Vec<u32>) -> Self {
        Self { element, connectivity }
    }

    /// The kind of its elements.
    pub fn element(&self) -> &'static dyn PlaneElement {
        self.element
    }

    fn len(&self) -> usize {
        self.connectivity.len() / self.element.nodes()
    }
}

/// One element of a mesh.
#[derive(Clone, Copy, Debug)]
pub struct Element<'m> {
    /// Number of the element in the mesh, from 0.
    pub index: usize,
    /// Number of its block.
    pub block: usize,
    /// Kind of the element.
    pub kind: &'static dyn PlaneElement,
    /// Nodes of the element.
    pub nodes: &'m [u32],
}

/// A side of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Side {
    /// The element, from 0.
    pub element: u32,
    /// Number of the side in the element, from 0.
    pub side: u8,
}

/// The nodes of a side: start, end and, in second order, the middle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SideNodes {
    nodes: [u32; EDGE_NODES],
    count: usize,
}

impl SideNodes {
    /// The nodes.
    pub fn as_slice(&self) -> &[u32] {
        &self.nodes[..self.count]
    }
}

/// A plane mesh that has passed its checks: every element has a positive area, every node belongs to one.
#[derive(Clone, Debug)]
pub struct Mesh {
    nodes: Vec<[f64; 2]>,
    blocks: Vec<Block>,
    /// Number of the first element of each block, and the number of elements.
    starts: Vec<usize>,
    sides: BTreeMap<String, Vec<Side>>,
    points: BTreeMap<String, Vec<u32>>,
}

impl Mesh {
    /// A mesh of `nodes` (m), elements and named sides.
    ///
    /// # Errors
    /// An element without a positive area or with nodes that do not exist, a node without element, no element
    /// at all.
    pub fn new(
        nodes: Vec<[f64; 2]>,
        blocks: Vec<Block>,
        sides: BTreeMap<String, Vec<Side>>,
    ) -> Result<Self, MeshError> {
        let mut starts = vec![0];
        for block in &blocks {
            starts.push(starts[starts.len() - 1] + block.len());
        }
        let mesh = Self { nodes, blocks, starts, sides, points: BTreeMap::new() };
        mesh.check()?;
        Ok(mesh)
    }

    /// The mesh with names for some of its nodes.
    #[must_use]
    pub fn with_points(mut self, points: BTreeMap<String, Vec<u32>>) -> Self {
        self.points = points;
        self
    }

    /// Turned about the origin, counter-clockwise by `angle` (rad).
    #[must_use]
    pub fn turned(mut self, angle: f64) -> Self {
        let (sine, cosine) = angle.sin_cos();
        self.nodes.iter_mut().for_each(|[x, y]| (*x, *y) = (cosine * *x - sine * *y, sine * *x + cosine * *y));
        self
    }

    /// Coordinates of the nodes, m. (nodes, 2)
    pub fn nodes(&self) -> &[[f64; 2]] {
        &self.nodes
    }

    /// The blocks of elements.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// Number of elements.
    pub fn element_count(&self) -> usize {
        self.starts[self.blocks.len()]
    }

    /// Element `index`.
    pub fn element(&self, index: usize) -> Element<'_> {
        let block = self.starts.partition_point(|&start| start <= index) - 1;
        let Block { element: kind, connectivity } = &self.blocks[block];
        let first = (index - self.starts[block]) * kind.nodes();
        Element { index, block, kind: *kind, nodes: &connectivity[first..first + kind.nodes()] }
    }

    /// All elements in their order.
    pub fn elements(&self) -> impl Iterator<Item = Element<'_>> {
        self.blocks.iter().enumerate().flat_map(move |(block, own)| {
            let nodes = own.connectivity.chunks_exact(own.element.nodes());
            let number = self.starts[block]..;
            number.zip(nodes).map(move |(index, nodes)| Element { index, block, kind: own.element, nodes })
        })
    }

    /// Coordinates of an element's nodes (m); only the first `element.nodes.len()` count.
    pub fn coordinates(&self, element: Element<'_>) -> [[f64; 2]; MAX_NODES] {
        let mut coordinates = [[0.0; 2]; MAX_NODES];
        for (own, &node) in coordinates.iter_mut().zip(element.nodes) {
            *own = self.nodes[node as usize];
        }
        coordinates
    }

    /// The sides called `name`, in the order in which they were given.
    ///
    /// # Errors
    /// [`MeshError::UnknownName`] tells which names there are.
    pub fn sides(&self, name: &str) -> Result<&[Side], MeshError> {
        let unknown = || MeshError::UnknownName {
            name: name.to_owned(),
            known: self.sides.keys().cloned().collect::<Vec<_>>().join(", "),
        };
        self.sides.get(name).map(Vec::as_slice).ok_or_else(unknown)
    }

    /// The nodes called `name`, none if no point has this name.
    pub fn points(&self, name: &str) -> &[u32] {
        self.points.get(name).map_or(&[], Vec::as_slice)
    }

    /// Names of points.
    pub fn point_names(&self) -> impl Iterator<Item = &str> {
        self.points.keys().map(String::as_str)
    }

    /// Names of sides.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.sides.keys().map(String::as_str)
    }

    /// Nodes of a side.
    pub fn side_nodes(&self, side: Side) -> SideNodes {
        let element = self.element(side.element as usize);
        let own = element.kind.edges()[usize::from(side.side)];
        let mut nodes = [0; EDGE_NODES];
        for (node, &local) in nodes.iter_mut().zip(own) {
            *node = element.nodes[local];
        }
        SideNodes { nodes, count: own.len() }
    }

    /// The curve of a side; the body lies to its left.
    pub fn curve(&self, side: Side) -> EdgeCurve {
        let nodes = self.side_nodes(side);
        let mut coordinates = [[0.0; 2]; EDGE_NODES];
        for (own, &node) in coordinates.iter_mut().zip(nodes.as_slice()) {
            *own = self.nodes[node as usize];
        }
        EdgeCurve::new(&coordinates[..nodes.as_slice().len()])
    }

    /// All nodes on the sides called `name`, each once, in ascending order.
    ///
    /// # Errors
    /// As [`sides`](Self::sides).
    pub fn nodes_on(&self, name: &str) -> Result<Vec<u32>, MeshError> {
        let sides = self.sides(name)?;
        let mut nodes: Vec<u32> = sides.iter().flat_map(|&side| self.side_nodes(side).as_slice().to_vec()).collect();
        nodes.sort_unstable();
        nodes.dedup();
        Ok(nodes)
    }

    /// The node nearest to a place (m).
    pub fn nearest_node(&self, [x, y]: [f64; 2]) -> usize {
        let distance = |node: &[f64; 2]| (node[0] - x).hypot(node[1] - y);
        let nearer = |a: &(usize, f64), b: &(usize, f64)| a.1.total_cmp(&b.1);
        self.nodes.iter().map(distance).enumerate().min_by(nearer).map_or(0, |(node, _)| node)
    }
}
