//! Prescribed displacements, and whether they hold a body.

use nalgebra::{Matrix3, Vector3};

use super::{ElasticError, LooseMotion};
use crate::element::plane::Thickness;
use crate::mesh::Mesh;

/// One prescribed component of a node's displacement.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prescribed {
    /// The node.
    pub node: usize,
    /// 0 = x, 1 = y.
    pub axis: usize,
    /// Displacement, m.
    pub displacement: f64,
}

impl Prescribed {
    /// Number of the freedom.
    pub fn freedom(&self) -> usize {
        2 * self.node + self.axis
    }

    /// Holds all nodes on the sides called `name` in the direction `axis`.
    ///
    /// # Errors
    /// The mesh has no such sides.
    pub fn fixed_side(mesh: &Mesh, name: &str, axis: usize) -> Result<Vec<Self>, ElasticError> {
        let nodes = mesh.nodes_on(name)?;
        Ok(nodes.into_iter().map(|node| Self { node: node as usize, axis, displacement: 0.0 }).collect())
    }
}

/// Holds what lies on the axis of a body of revolution: no circle is there to widen.
pub(super) fn hold_axis(mesh: &Mesh, prescribed: &mut Vec<Prescribed>) {
    /// Radius over the largest below which a node is on the axis.
    const ON_AXIS: f64 = 1e-9;
    let largest = mesh.nodes().iter().fold(0.0_f64, |largest, node| largest.max(node[1]));
    let known: Vec<usize> = prescribed.iter().map(Prescribed::freedom).collect();
    let on_axis = mesh.nodes().iter().enumerate().filter(|(_, node)| node[1] <= ON_AXIS * largest);
    let held = on_axis.map(|(node, _)| Prescribed { node, axis: 1, displacement: 0.0 });
    prescribed.extend(held.filter(|own| !known.contains(&own.freedom())));
}

pub(super) fn check(mesh: &Mesh, thickness: Thickness, prescribed: &[Prescribed]) -> Result<(), ElasticError> {
    let mut seen = vec![false; 2 * mesh.nodes().len()];
    for support in prescribed {
        let fail = |reason| Err(ElasticError::Prescribed { node: support.node, reason });
        if support.node >= mesh.nodes().len() {
            return fail("there is no such node");
        }
        if support.axis > 1 {
            return fail("the axis is 0 (x) or 1 (y)");
        }
        if !support.displacement.is_finite() {
            return fail("the displacement is not finite");
        }
        if std::mem::replace(&mut seen[support.freedom()], true) {
            return fail("it is prescribed twice");
        }
    }
    match loose_motion(mesh, thickness, prescribed) {
        Some((element, motion)) => Err(ElasticError::Loose { element, motion }),
        None => Ok(()),
    }
}

/// Resistance of a rigid motion over that of the best held one below which it counts as none.
const LOOSE: f64 = 1e-10;

/// The first piece of the mesh that can move as a rigid body, by one of its elements, and how.
///
/// Rows g of the constraints over the rigid motions (slide x, slide y, turn · size) of each piece add up to
/// the Gram matrix Σ g gᵀ; a motion in its null space is loose.
fn loose_motion(mesh: &Mesh, thickness: Thickness, prescribed: &[Prescribed]) -> Option<(usize, LooseMotion)> {
    let pieces = mesh.pieces();
    let count = pieces.iter().max().map_or(0, |&last| last as usize + 1);
    let size = mesh.nodes().iter().fold(0.0_f64, |size, [x, y]| size.max(x.hypot(*y)));
    let mut sums = vec![([0.0; 2], 0.0_f64); count];
    for (&piece, [x, y]) in pieces.iter().zip(mesh.nodes()) {
        let (sum, nodes) = &mut sums[piece as usize];
        *sum = [sum[0] + x, sum[1] + y];
        *nodes += 1.0;
    }
    let centres: Vec<[f64; 2]> = sums.iter().map(|([x, y], nodes)| [x / nodes, y / nodes]).collect();
    // A body of revolution can slide along its axis alone.
    let resisted = if thickness.is_revolved() { Vector3::new(0.0, 1.0, 1.0) } else { Vector3::zeros() };
    let mut grams = vec![Matrix3::from_diagonal(&resisted); count];
    for support in prescribed {
        let piece = pieces[support.node] as usize;
        let [x, y] = [0, 1].map(|axis| (mesh.nodes()[support.node][axis] - centres[piece][axis]) / size);
        let row = if support.axis == 0 { Vector3::new(1.0, 0.0, -y) } else { Vector3::new(0.0, 1.0, x) };
        grams[piece] += row * row.transpose();
    }
    for (piece, gram) in grams.into_iter().enumerate() {
        let eigen = gram.symmetric_eigen();
        let smallest = eigen.eigenvalues.imin();
        if eigen.eigenvalues[smallest] > LOOSE * eigen.eigenvalues.max() {
            continue;
        }
        let motion = eigen.eigenvectors.column(smallest);
        let (slide, turn) = ([motion[0], motion[1]], motion[2]);
        let element = mesh.elements().find(|element| pieces[element.nodes[0] as usize] as usize == piece)?.index;
        let [x, y] = centres[piece];
        return Some((
            element,
            if turn.abs() < 1e-6 {
                LooseMotion::Slide(slide)
            } else {
                LooseMotion::Turn([x - slide[1] / turn * size, y + slide[0] / turn * size])
            },
        ));
    }
    None
}
