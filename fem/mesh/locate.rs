//! Locating a point in a mesh.

use super::{Element, Mesh};
use crate::element::plane::MAX_NODES;

/// Newton steps to the reference coordinates; straight-sided elements need one or two.
const STEPS: usize = 20;
/// Distance outside its reference shape at which a point may lie: rounding, and the sag of curved sides
/// between nodes.
const SLACK: f64 = 1e-6;

/// A point of a mesh: its element's nodes with their shape functions there.
#[derive(Clone, Debug, PartialEq)]
pub struct Place {
    /// Each node with its shape function: (node, Nₐ).
    pub shares: Vec<(usize, f64)>,
}

impl Mesh {
    /// The element around a point (m), if there is one; on a border of elements the first.
    pub fn locate(&self, point: [f64; 2]) -> Option<Place> {
        self.elements().find_map(|element| self.locate_in(element, point))
    }

    fn locate_in(&self, element: Element<'_>, [x, y]: [f64; 2]) -> Option<Place> {
        let coordinates = self.coordinates(element);
        let nodes = &coordinates[..element.nodes.len()];
        let range = |axis: usize| {
            nodes.iter().fold((f64::MAX, f64::MIN), |(low, high), n| (low.min(n[axis]), high.max(n[axis])))
        };
        let within = |value: f64, (low, high): (f64, f64)| {
            let slack = 0.1 * (high - low);
            (low - slack..=high + slack).contains(&value)
        };
        if !within(x, range(0)) || !within(y, range(1)) {
            return None;
        }
        let reference = element.kind.reference();
        let corners = element.kind.corners();
        let mut at = [0, 1].map(|i| reference[..corners].iter().map(|r| r[i]).sum::<f64>() / corners as f64);
        for _ in 0..STEPS {
            let (shapes, slopes) = (element.kind.shapes(at), element.kind.slopes(at));
            let (mut off, mut j) = ([-x, -y], [[0.0; 2]; 2]);
            for (a, node) in nodes.iter().enumerate() {
                for i in 0..2 {
                    off[i] += shapes[a] * node[i];
                    j[i][0] += slopes[a][0] * node[i];
                    j[i][1] += slopes[a][1] * node[i];
                }
            }
            let determinant = j[0][0] * j[1][1] - j[0][1] * j[1][0];
            let step = [
                (off[0] * j[1][1] - off[1] * j[0][1]) / determinant,
                (off[1] * j[0][0] - off[0] * j[1][0]) / determinant,
            ];
            at = [at[0] - step[0], at[1] - step[1]];
            if step[0].hypot(step[1]).is_nan() || step[0].hypot(step[1]) <= 1e-13 {
                break;
            }
        }
        let inside = match corners {
            3 => at[0] >= -SLACK && at[1] >= -SLACK && at[0] + at[1] <= 1.0 + SLACK,
            _ => at[0].abs() <= 1.0 + SLACK && at[1].abs() <= 1.0 + SLACK,
        };
        let shapes: [f64; MAX_NODES] = element.kind.shapes(at);
        inside.then(|| Place { shares: element.nodes.iter().zip(shapes).map(|(n, s)| (*n as usize, s)).collect() })
    }
}
