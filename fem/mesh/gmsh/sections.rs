//! The sections of a Gmsh file that a plane mesh needs.

use std::collections::{BTreeMap, HashMap};

use super::GmshError;
use super::reader::{Encoding, Reader};

/// Elements of one entity.
#[derive(Debug)]
pub(super) struct ElementBlock {
    pub dimension: i32,
    pub entity: i32,
    pub kind: i32,
    /// (Tag, tags of its nodes).
    pub elements: Vec<(u64, Vec<u64>)>,
}

/// The content of a file.
#[derive(Debug)]
pub(super) struct File {
    /// Coordinates by tag.
    pub nodes: HashMap<u64, [f64; 3]>,
    pub elements: Vec<ElementBlock>,
    /// Physical groups of every point and curve, by dimension and entity.
    pub groups: HashMap<(i32, i32), Vec<i32>>,
    /// Names of the physical groups, by dimension and group.
    pub names: BTreeMap<(i32, i32), String>,
}

impl File {
    pub fn parse(bytes: &[u8]) -> Result<Self, GmshError> {
        let encoding = header(bytes)?;
        let section =
            |name: &'static str, encoding| find(bytes, name).map(|at| Reader::new(bytes, at, encoding, &name[1..]));
        let missing = |name: &str| GmshError::Format(format!("it has no section {name}"));
        let nodes = nodes(&mut section("$Nodes", encoding).ok_or_else(|| missing("$Nodes"))?)?;
        let elements = elements(&mut section("$Elements", encoding).ok_or_else(|| missing("$Elements"))?)?;
        // names are text in binary files, too
        let names = section("$PhysicalNames", Encoding::Text);
        let names = names.map_or_else(|| Ok(BTreeMap::new()), |mut reader| group_names(&mut reader))?;
        let entities = section("$Entities", encoding);
        let groups = entities.map_or_else(|| Ok(HashMap::new()), |mut reader| groups(&mut reader))?;
        Ok(Self { nodes, elements, groups, names })
    }

    /// The names of the physical groups that a block of elements belongs to.
    pub fn names_of(&self, block: &ElementBlock) -> Vec<String> {
        let groups = self.groups.get(&(block.dimension, block.entity)).into_iter().flatten();
        let name = |group: &i32| match self.names.get(&(block.dimension, *group)) {
            Some(name) => name.clone(),
            None if block.dimension == 0 => format!("point {group}"),
            None => format!("curve {group}"),
        };
        groups.map(name).collect()
    }
}

/// The place after the line `name`, which begins a section.
fn find(bytes: &[u8], name: &str) -> Option<usize> {
    let mut from = 0;
    while let Some(found) = bytes[from..].windows(name.len()).position(|window| window == name.as_bytes()) {
        let (start, end) = (from + found, from + found + name.len());
        let line_end = bytes[end..].iter().position(|&byte| byte == b'\n').map(|length| end + length);
        let alone = |end: usize, line_end: usize| bytes[end..line_end].iter().all(u8::is_ascii_whitespace);
        if let Some(line_end) = line_end
            && (start == 0 || bytes[start - 1] == b'\n')
            && alone(end, line_end)
        {
            return Some(line_end + 1);
        }
        from = end;
    }
    None
}

fn header(bytes: &[u8]) -> Result<Encoding, GmshError> {
    let wrong = |what: &str| GmshError::Format(what.to_owned());
    let start = find(bytes, "$MeshFormat").ok_or_else(|| wrong("it does not begin with $MeshFormat"))?;
    let length = bytes[start..].iter().position(|&byte| byte == b'\n').unwrap_or(0);
    let line = String::from_utf8_lossy(&bytes[start..start + length]);
    let words: Vec<&str> = line.split_whitespace().collect();
    let [version, binary, size] = words[..] else { return Err(wrong("its header is incomplete")) };
    if version != "4.1" {
        return Err(GmshError::Format(format!("it is of format {version}")));
    }
    if size != "8" {
        return Err(GmshError::Format(format!("its counts have {size} bytes, not 8")));
    }
    if binary == "0" {
        return Ok(Encoding::Text);
    }
    match bytes.get(start + length + 1..start + length + 5) {
        Some([1, 0, 0, 0]) => Ok(Encoding::Little),
        Some([0, 0, 0, 1]) => Ok(Encoding::Big),
        _ => Err(wrong("its header does not tell the order of bytes")),
    }
}

fn group_names(reader: &mut Reader<'_>) -> Result<BTreeMap<(i32, i32), String>, GmshError> {
    let count = reader.size()?;
    (0..count).map(|_| Ok(((reader.int()?, reader.int()?), reader.quoted()?))).collect()
}

fn groups(reader: &mut Reader<'_>) -> Result<HashMap<(i32, i32), Vec<i32>>, GmshError> {
    let [points, curves] = [reader.size()?, reader.size()?];
    let (_surfaces, _volumes) = (reader.size()?, reader.size()?);
    let mut groups = HashMap::new();
    for (dimension, count) in [(0, points), (1, curves)] {
        for _ in 0..count {
            let entity = reader.int()?;
            // a point's place, or the box around a curve
            for _ in 0..if dimension == 0 { 3 } else { 6 } {
                reader.float()?;
            }
            groups.insert((dimension, entity), tags(reader)?);
            if dimension == 1 {
                // the points at its ends
                tags(reader)?;
            }
        }
    }
    Ok(groups)
}

/// A count and so many integers.
fn tags(reader: &mut Reader<'_>) -> Result<Vec<i32>, GmshError> {
    let count = reader.size()?;
    (0..count).map(|_| reader.int()).collect()
}

fn nodes(reader: &mut Reader<'_>) -> Result<HashMap<u64, [f64; 3]>, GmshError> {
    let blocks = reader.size()?;
    let (_count, _lowest, _highest) = (reader.size()?, reader.size()?, reader.size()?);
    let mut nodes = HashMap::new();
    for _ in 0..blocks {
        let (dimension, _entity, parametric) = (reader.int()?, reader.int()?, reader.int()?);
        let count = reader.size()?;
        let tags: Vec<u64> = (0..count).map(|_| reader.size()).collect::<Result<_, _>>()?;
        for tag in tags {
            let at = [reader.float()?, reader.float()?, reader.float()?];
            for _ in 0..if parametric == 0 { 0 } else { dimension } {
                reader.float()?;
            }
            if nodes.insert(tag, at).is_some() {
                return Err(reader.problem(format!("node {tag} is given twice")));
            }
        }
    }
    Ok(nodes)
}

fn elements(reader: &mut Reader<'_>) -> Result<Vec<ElementBlock>, GmshError> {
    let blocks = reader.size()?;
    let (_count, _lowest, _highest) = (reader.size()?, reader.size()?, reader.size()?);
    let mut found = Vec::new();
    for _ in 0..blocks {
        let (dimension, entity, kind) = (reader.int()?, reader.int()?, reader.int()?);
        let count = reader.size()?;
        let Some(nodes) = node_count(kind) else {
            return Err(GmshError::Kind { tag: reader.size()?, kind });
        };
        let mut elements = Vec::new();
        for _ in 0..count {
            let tag = reader.size()?;
            elements.push((tag, (0..nodes).map(|_| reader.size()).collect::<Result<_, _>>()?));
        }
        found.push(ElementBlock { dimension, entity, kind, elements });
    }
    Ok(found)
}

/// Nodes of the Gmsh types that may stand in a plane mesh: points, lines, triangles, quadrilaterals.
fn node_count(kind: i32) -> Option<usize> {
    match kind {
        15 => Some(1),
        1 => Some(2),
        2 | 8 => Some(3),
        3 => Some(4),
        9 => Some(6),
        16 => Some(8),
        10 => Some(9),
        _ => None,
    }
}
