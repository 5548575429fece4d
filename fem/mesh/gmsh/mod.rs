//! Gmsh meshes, format MSH 4.1, text and binary: plane elements, and sides named by physical curves.
//!
//! Only the file's nodes of plane elements are kept (centres of circles are not). Elements that turn
//! clockwise are turned over. Lengths have no unit in the file; the caller gives it. Format: Gmsh reference
//! manual, "MSH file format".
//!
//! The reader is the crate's own: mshio 0.4 forgets the tags of nodes whenever they are dense, though they
//! need not be in order, and panics on malformed numbers.

mod error;
mod reader;
mod sections;
#[cfg(test)]
mod tests;

use std::collections::{BTreeMap, HashMap};

use super::{Block, Mesh, MeshError, Side};
use crate::element::plane::{PlaneElement, Quad4, Quad8, Quad9, Sampled, Tri3, Tri6};
pub use error::GmshError;
use sections::File;

/// Reads a mesh whose lengths are in `unit` (m).
///
/// # Errors
/// [`GmshError`] tells the element, node, line or byte.
pub fn read_gmsh(bytes: &[u8], unit: f64) -> Result<Mesh, GmshError> {
    let file = File::parse(bytes)?;
    let mut nodes = Nodes { file: &file, unit, numbers: HashMap::new(), nodes: Vec::new(), tags: Vec::new() };
    let mut connectivity: BTreeMap<i32, (Vec<u32>, Vec<u64>)> = BTreeMap::new();
    for block in file.elements.iter().filter(|block| block.dimension == 2) {
        let (own, own_tags) = connectivity.entry(block.kind).or_default();
        let Some(element) = plane_element(block.kind) else {
            let tag = block.elements.first().map_or(0, |element| element.0);
            return Err(GmshError::Kind { tag, kind: block.kind });
        };
        let sampled = Sampled::new(element);
        for (tag, tags) in &block.elements {
            let mut numbers = nodes.numbers(*tag, tags)?;
            let coordinates: Vec<[f64; 2]> = numbers.iter().map(|&number| nodes.nodes[number as usize]).collect();
            if sampled.area(&coordinates) < 0.0 {
                turn_over(element, &mut numbers);
            }
            own.extend(numbers);
            own_tags.push(*tag);
        }
    }
    if let Some(block) = file.elements.iter().find(|block| block.dimension == 3 && !block.elements.is_empty()) {
        return Err(GmshError::Kind { tag: block.elements[0].0, kind: block.kind });
    }
    let (mut blocks, mut tags) = (Vec::new(), Vec::new());
    for (kind, (connectivity, own_tags)) in connectivity {
        blocks.extend(plane_element(kind).map(|element| Block::new(element, connectivity)));
        tags.extend(own_tags);
    }
    let sides = named_sides(&file, &nodes, &blocks)?;
    let points = named_points(&file, &nodes)?;
    let in_file = |error: MeshError| error.renumbered(&tags, &nodes.tags);
    let mesh = Mesh::new(nodes.nodes, blocks, sides).map_err(in_file)?.with_points(points);
    mesh.connected().map_err(in_file)?;
    Ok(mesh)
}

/// The element of a Gmsh type; the orders of their nodes agree.
fn plane_element(kind: i32) -> Option<&'static dyn PlaneElement> {
    match kind {
        2 => Some(&Tri3),
        3 => Some(&Quad4),
        9 => Some(&Tri6),
        10 => Some(&Quad9),
        16 => Some(&Quad8),
        _ => None,
    }
}

/// Turns an element's nodes to run the other way around from the same first corner.
fn turn_over(element: &dyn PlaneElement, nodes: &mut [u32]) {
    let corners = element.corners();
    nodes[1..corners].reverse();
    if nodes.len() >= 2 * corners {
        nodes[corners..2 * corners].reverse();
    }
}

/// The nodes that are used, numbered as they are met.
struct Nodes<'f> {
    file: &'f File,
    unit: f64,
    numbers: HashMap<u64, u32>,
    nodes: Vec<[f64; 2]>,
    /// Tags of the nodes in the file.
    tags: Vec<u64>,
}

impl Nodes<'_> {
    fn numbers(&mut self, element: u64, tags: &[u64]) -> Result<Vec<u32>, GmshError> {
        tags.iter().map(|&tag| self.number(element, tag)).collect()
    }

    fn number(&mut self, element: u64, tag: u64) -> Result<u32, GmshError> {
        if let Some(&number) = self.numbers.get(&tag) {
            return Ok(number);
        }
        let &[x, y, z] = self.file.nodes.get(&tag).ok_or(GmshError::UnknownNode { element, node: tag })?;
        if z.abs() > 1e-9 * (x.abs() + y.abs()) {
            return Err(GmshError::OffPlane { node: tag, z });
        }
        let number = self.nodes.len() as u32;
        self.nodes.push([x * self.unit, y * self.unit]);
        self.tags.push(tag);
        self.numbers.insert(tag, number);
        Ok(number)
    }
}

/// The sides of elements on every physical curve.
fn named_sides(file: &File, nodes: &Nodes<'_>, blocks: &[Block]) -> Result<BTreeMap<String, Vec<Side>>, GmshError> {
    let mut by_ends = HashMap::new();
    let mut element = 0;
    for block in blocks {
        for own in block.connectivity.chunks_exact(block.element.nodes()) {
            for (side, edge) in (0..).zip(block.element.edges()) {
                by_ends.entry(ends(own[edge[0]], own[edge[1]])).or_insert(Side { element, side });
            }
            element += 1;
        }
    }
    let mut sides: BTreeMap<String, Vec<Side>> = BTreeMap::new();
    for block in file.elements.iter().filter(|block| block.dimension == 1) {
        for name in file.names_of(block) {
            let own = sides.entry(name.clone()).or_default();
            for (tag, tags) in &block.elements {
                let found = match tags[..] {
                    [start, end, ..] => nodes.numbers.get(&start).zip(nodes.numbers.get(&end)),
                    _ => None,
                };
                let side = found.and_then(|(&start, &end)| by_ends.get(&ends(start, end)));
                own.push(*side.ok_or(GmshError::LooseLine { name: name.clone(), element: *tag })?);
            }
        }
    }
    Ok(sides)
}

/// The nodes at every physical point.
fn named_points(file: &File, nodes: &Nodes<'_>) -> Result<BTreeMap<String, Vec<u32>>, GmshError> {
    let mut points: BTreeMap<String, Vec<u32>> = BTreeMap::new();
    for block in file.elements.iter().filter(|block| block.dimension == 0) {
        for name in file.names_of(block) {
            let own = points.entry(name.clone()).or_default();
            for (tag, tags) in &block.elements {
                let node = tags.first().and_then(|node| nodes.numbers.get(node));
                own.push(*node.ok_or(GmshError::LoosePoint { name: name.clone(), element: *tag })?);
            }
        }
    }
    Ok(points)
}

/// The two ends of a side whichever way it runs.
fn ends(a: u32, b: u32) -> (u32, u32) {
    (a.min(b), a.max(b))
}
