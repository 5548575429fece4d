//! The faces of a plane body: what of its border lies on supports, and what is pressed or milled.

use crate::mesh::{Mesh, Side};
use crate::units::LENGTH;

/// Places that differ by less than this part of the length are one.
const SAME: f64 = 1e-9;

/// The sides `underside` and `top` of a mesh, each straight, level, and of second order.
#[derive(Clone, Debug)]
pub struct Faces {
    /// Level pieces of the underside, from end to end.
    pub underside: Vec<Level>,
    /// Those of the top.
    pub top: Vec<Level>,
}

/// Sides beside each other on one height.
#[derive(Clone, Debug)]
pub struct Level {
    /// Above the origin, m.
    pub height: f64,
    /// One at least, from end to end.
    pub sides: Vec<LevelSide>,
}

/// A side along x.
#[derive(Clone, Copy, Debug)]
pub struct LevelSide {
    /// Begin, m.
    pub from: f64,
    /// End, m.
    pub to: f64,
    /// Its nodes in the mesh: begin, middle, end.
    pub nodes: [usize; 3],
}

/// A border that no part has which is laid on supports.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FaceError {
    /// There are no sides of this name.
    #[error("{0}")]
    Missing(String),
    /// A side of first order.
    #[error("`{name}` has sides without a node in their middle, at x = {}", LENGTH.format(*x))]
    FirstOrder {
        /// The face.
        name: &'static str,
        /// Where, m.
        x: f64,
    },
    /// A side that is no straight line along x.
    #[error("`{name}` is not level at x = {}", LENGTH.format(*x))]
    Slopes {
        /// The face.
        name: &'static str,
        /// Where, m.
        x: f64,
    },
    /// Two sides at one x.
    #[error("two pieces of `{name}` lie above each other at x = {}", LENGTH.format(*x))]
    Doubled {
        /// The face.
        name: &'static str,
        /// Where, m.
        x: f64,
    },
}

impl Faces {
    /// Those of a mesh.
    ///
    /// # Errors
    /// A face is missing, slopes, or covers another.
    pub fn of(mesh: &Mesh) -> Result<Self, FaceError> {
        let along = || mesh.nodes().iter().map(|node| node[0]);
        let slack = SAME * (along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min));
        Ok(Self { underside: levels(mesh, "underside", slack)?, top: levels(mesh, "top", slack)? })
    }
}

impl Level {
    /// Begin and end, m.
    pub fn ends(&self) -> (f64, f64) {
        (self.sides[0].from, self.sides[self.sides.len() - 1].to)
    }
}

/// The pieces of a face from end to end.
fn levels(mesh: &Mesh, name: &'static str, slack: f64) -> Result<Vec<Level>, FaceError> {
    let sides = mesh.sides(name).map_err(|error| FaceError::Missing(error.to_string()))?;
    let mut sides: Vec<(f64, LevelSide)> =
        sides.iter().map(|side| level(mesh, name, *side, slack)).collect::<Result<_, _>>()?;
    sides.sort_by(|a, b| a.1.from.total_cmp(&b.1.from));
    let mut all: Vec<Level> = Vec::new();
    for (height, side) in sides {
        let Some(last) = all.last_mut() else {
            all.push(Level { height, sides: vec![side] });
            continue;
        };
        let apart = side.from - last.ends().1;
        if apart < -slack {
            return Err(FaceError::Doubled { name, x: side.from });
        }
        match apart <= slack && (last.height - height).abs() <= slack {
            true => last.sides.push(side),
            false => all.push(Level { height, sides: vec![side] }),
        }
    }
    Ok(all)
}

/// The height of a side, and itself from left to right.
fn level(mesh: &Mesh, name: &'static str, side: Side, slack: f64) -> Result<(f64, LevelSide), FaceError> {
    let nodes = mesh.side_nodes(side);
    let at = |node: u32| mesh.nodes()[node as usize];
    let &[begin, end, middle] = nodes.as_slice() else {
        return Err(FaceError::FirstOrder { name, x: nodes.as_slice().first().map_or(0.0, |node| at(*node)[0]) });
    };
    let (begin, end) = if at(begin)[0] <= at(end)[0] { (begin, end) } else { (end, begin) };
    let [[from, height], [between, raised], [to, other]] = [begin, middle, end].map(at);
    let is_level = (height - other).abs() <= slack && (height - raised).abs() <= slack && to > from;
    if !is_level || (2.0 * between - from - to).abs() > slack {
        return Err(FaceError::Slopes { name, x: from });
    }
    Ok((height, LevelSide { from, to, nodes: [begin, middle, end].map(|node| node as usize) }))
}
