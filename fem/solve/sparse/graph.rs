//! The graph of a mesh: nodes that share an element.

use rayon::prelude::*;

use crate::mesh::Mesh;

/// Nodes handled at a time.
const CHUNK: usize = 4096;

/// The neighbours of every node in compressed rows; a node is not its own neighbour.
#[derive(Clone, Debug, PartialEq)]
pub struct Graph {
    starts: Vec<u32>,
    neighbours: Vec<u32>,
}

/// Elements at every node, in compressed rows.
fn incidence(mesh: &Mesh) -> (Vec<u32>, Vec<u32>) {
    let mut starts = vec![0_u32; mesh.nodes().len() + 1];
    for &node in mesh.elements().flat_map(|element| element.nodes) {
        starts[node as usize + 1] += 1;
    }
    for node in 1..starts.len() {
        starts[node] += starts[node - 1];
    }
    let mut next = starts.clone();
    let mut elements = vec![0; starts[starts.len() - 1] as usize];
    for element in mesh.elements() {
        for &node in element.nodes {
            elements[next[node as usize] as usize] = element.index as u32;
            next[node as usize] += 1;
        }
    }
    (starts, elements)
}

impl Graph {
    /// The graph of the mesh: nodes of an element are neighbours.
    pub fn new(mesh: &Mesh) -> Self {
        let count = mesh.nodes().len();
        let (starts, elements) = incidence(mesh);
        let rows = |first: usize| {
            let (mut sizes, mut neighbours) = (Vec::with_capacity(CHUNK), Vec::with_capacity(16 * CHUNK));
            for node in first..(first + CHUNK).min(count) {
                let row = neighbours.len();
                for &element in &elements[starts[node] as usize..starts[node + 1] as usize] {
                    neighbours.extend(mesh.element(element as usize).nodes.iter().filter(|&&n| n as usize != node));
                }
                neighbours[row..].sort_unstable();
                let end = deduplicate(&mut neighbours, row);
                sizes.push((end - row) as u32);
            }
            (sizes, neighbours)
        };
        let firsts: Vec<usize> = (0..count).step_by(CHUNK).collect();
        let parts: Vec<(Vec<u32>, Vec<u32>)> = firsts.into_par_iter().map(rows).collect();
        let mut graph = Self { starts: vec![0], neighbours: Vec::new() };
        graph.neighbours.reserve_exact(parts.iter().map(|part| part.1.len()).sum());
        for (sizes, neighbours) in parts {
            for size in sizes {
                graph.starts.push(graph.starts[graph.starts.len() - 1] + size);
            }
            graph.neighbours.extend(neighbours);
        }
        graph
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// Whether there are no nodes.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Neighbours of a node, ascending.
    pub fn neighbours(&self, node: u32) -> &[u32] {
        &self.neighbours[self.starts[node as usize] as usize..self.starts[node as usize + 1] as usize]
    }

    /// Row starts and neighbours.
    pub(super) fn rows(&self) -> (&[u32], &[u32]) {
        (&self.starts, &self.neighbours)
    }
}

/// Removes repeated neighbours from the sorted tail that begins at `row`; the new length.
fn deduplicate(neighbours: &mut Vec<u32>, row: usize) -> usize {
    let mut end = row;
    for read in row..neighbours.len() {
        if end == row || neighbours[end - 1] != neighbours[read] {
            neighbours[end] = neighbours[read];
            end += 1;
        }
    }
    neighbours.truncate(end);
    end
}
