//! Closed surfaces that hang on the points of a grid.

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::TAU;

use crate::process::{Cell, Grid, Segment};

/// Points around a round body.
const AROUND: usize = 24;
/// Points around a thread.
const THREAD: usize = 6;

/// A point of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SkinPoint {
    /// The point of the grid that it moves with, and whose values it shows; `None` where it stands still.
    pub node: Option<u32>,
    /// From that point, or from the origin, m.
    pub offset: [f64; 3],
}

/// A surface of triangles and quadrilaterals, counter-clockwise as seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Skin {
    /// Its points.
    pub points: Vec<SkinPoint>,
    /// Three points each.
    pub triangles: Vec<[u32; 3]>,
    /// Four points each.
    pub quads: Vec<[u32; 4]>,
}

/// Closure of the first and the last of several rings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// A flat end each.
    Capped,
    /// The last ring is joined to the first.
    Joined,
}

impl Skin {
    /// Through rings of equally many points, each counter-clockwise about the way from ring to ring.
    pub fn lofted(rings: &[Vec<SkinPoint>], ends: Ends) -> Self {
        let Some(around) = rings.first().map(Vec::len).filter(|around| *around > 2) else { return Self::default() };
        let mut skin = Self { points: rings.concat(), ..Self::default() };
        let count = around as u32;
        let at = |ring: usize, i: u32| (ring % rings.len()) as u32 * count + i % count;
        let gaps = if ends == Ends::Joined { rings.len() } else { rings.len() - 1 };
        for ring in 0..gaps {
            for i in 0..count {
                skin.quads.push([at(ring, i), at(ring, i + 1), at(ring + 1, i + 1), at(ring + 1, i)]);
            }
        }
        if ends == Ends::Capped {
            let last = rings.len() - 1;
            for (ring, is_last) in [(0, false), (last, true)] {
                skin.cap(&rings[ring], at(ring, 0), is_last);
            }
        }
        skin
    }

    /// Closes a flat ring whose points are numbered from `first` on: about its middle, where all of it moves with one
    /// point, else about its first point.
    fn cap(&mut self, ring: &[SkinPoint], first: u32, is_last: bool) {
        let count = ring.len() as u32;
        let mut fan = |centre: u32, a: u32, b: u32| {
            self.triangles.push(if is_last { [centre, a, b] } else { [centre, b, a] });
        };
        if ring.iter().any(|point| point.node != ring[0].node) {
            (1..count - 1).for_each(|i| fan(first, first + i, first + i + 1));
            return;
        }
        let centre = self.points.len() as u32;
        (0..count).for_each(|i| fan(centre, first + i, first + (i + 1) % count));
        let middle = [0, 1, 2].map(|c| ring.iter().map(|p| p.offset[c]).sum::<f64>() / f64::from(count));
        self.points.push(SkinPoint { node: ring[0].node, offset: middle });
    }

    /// A ring of some points about a direction, around a point of the grid; radius in m.
    pub fn ring(node: Option<u32>, direction: [f64; 3], radius: f64) -> Vec<SkinPoint> {
        let size = direction.iter().map(|c| c * c).sum::<f64>().sqrt();
        let axis = if size > 0.0 { direction.map(|c| c / size) } else { [1.0, 0.0, 0.0] };
        let [u, v] = across(axis);
        let point = |i: usize| {
            let (sine, cosine) = (TAU * i as f64 / THREAD as f64).sin_cos();
            SkinPoint { node, offset: [0, 1, 2].map(|c| radius * (cosine * u[c] + sine * v[c])) }
        };
        (0..THREAD).map(point).collect()
    }

    /// A body of round segments along x to scale, from end to end, with its steps and its bore; it hangs on nodes (m,
    /// rising) on its axis, of which it shows some of more than `most`.
    pub fn stepped(nodes: &[f64], segments: &[Segment], most: usize) -> Self {
        let every = nodes.len().div_ceil(most);
        let hollow = segments.iter().any(|s| s.section.bore > 0.0);
        let (mut outside, mut inside) = (Vec::new(), Vec::new());
        let (mut from, slack) = (0.0, 1e-9 * nodes.last().copied().unwrap_or(0.0));
        for segment in segments {
            let to = from + segment.length;
            let is_own = |i: &usize| (from - slack..=to + slack).contains(&nodes[*i]);
            let own: Vec<usize> = (0..nodes.len()).filter(is_own).collect();
            for (_, node) in own.iter().enumerate().filter(|(i, _)| i % every == 0 || i + 1 == own.len()) {
                let rim = |diameter: f64| (Some(*node as u32), [0.0; 3], 0.5 * diameter);
                outside.push(rim(segment.section.diameter));
                inside.push(rim(segment.section.bore));
            }
            from = to;
        }
        if hollow {
            outside.extend(inside.into_iter().rev());
        }
        Self::round(&outside, [1.0, 0.0, 0.0], if hollow { Ends::Joined } else { Ends::Capped })
    }

    /// A round body along `axis`, a unit vector, through rims: the point of the grid on its axis, the offset of the
    /// rim's middle from that, and its radius (m).
    pub fn round(rims: &[(Option<u32>, [f64; 3], f64)], axis: [f64; 3], ends: Ends) -> Self {
        Self::around(rims, axis, ends, AROUND)
    }

    /// The same with so many points around.
    pub fn around(rims: &[(Option<u32>, [f64; 3], f64)], axis: [f64; 3], ends: Ends, count: usize) -> Self {
        let [u, v] = across(axis);
        let ring = |(node, middle, radius): &(Option<u32>, [f64; 3], f64)| {
            let point = |i: usize| {
                let (sine, cosine) = (TAU * i as f64 / count as f64).sin_cos();
                let offset = [0, 1, 2].map(|c| middle[c] + radius * (cosine * u[c] + sine * v[c]));
                SkinPoint { node: *node, offset }
            };
            (0..count).map(point).collect()
        };
        Self::lofted(&rims.iter().map(ring).collect::<Vec<_>>(), ends)
    }

    /// A round body with a straight axis from `from` on, that moves with one point: (distance along, radius), m.
    pub fn turned(node: Option<u32>, from: [f64; 3], axis: [f64; 3], meridian: &[(f64, f64)]) -> Self {
        let rim = |(along, radius): &(f64, f64)| (node, [0, 1, 2].map(|c| from[c] + along * axis[c]), *radius);
        Self::round(&meridian.iter().map(rim).collect::<Vec<_>>(), axis, Ends::Capped)
    }

    /// A square bar or pyramid in the same way: (distance along, half its side), m.
    pub fn square(node: Option<u32>, from: [f64; 3], axis: [f64; 3], meridian: &[(f64, f64)]) -> Self {
        let rim = |(along, half): &(f64, f64)| {
            (node, [0, 1, 2].map(|c| from[c] + along * axis[c]), *half * std::f64::consts::SQRT_2)
        };
        let mut skin = Self::around(&meridian.iter().map(rim).collect::<Vec<_>>(), axis, Ends::Capped, 4);
        skin.turn(axis, from);
        skin
    }

    /// Turns a body with corners by 45° about its axis, so that its sides face along the coordinates.
    fn turn(&mut self, axis: [f64; 3], from: [f64; 3]) {
        let h = std::f64::consts::FRAC_1_SQRT_2;
        for point in &mut self.points {
            let d = [0, 1, 2].map(|c| point.offset[c] - from[c]);
            let along = d[0] * axis[0] + d[1] * axis[1] + d[2] * axis[2];
            let across = [0, 1, 2].map(|c| d[c] - along * axis[c]);
            let turned = cross(axis, across);
            point.offset = [0, 1, 2].map(|c| from[c] + along * axis[c] + h * (across[c] + turned[c]));
        }
    }

    /// A box with sides along the coordinates, that moves with one point.
    pub fn block(node: Option<u32>, middle: [f64; 3], half: [f64; 3]) -> Self {
        let ring = |z: f64| {
            let corner = |(x, y): (f64, f64)| SkinPoint {
                node,
                offset: [middle[0] + x * half[0], middle[1] + y * half[1], middle[2] + z * half[2]],
            };
            [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(corner).to_vec()
        };
        Self::lofted(&[ring(-1.0), ring(1.0)], Ends::Capped)
    }

    /// The plane cells of a grid with a thickness (m), half of it on either side, by their corners.
    pub fn thickened(grid: &Grid, thickness: f64) -> Self {
        let mut corners: Vec<&[u32]> = Vec::new();
        let mut rest = &grid.connectivity[..];
        for cell in &grid.cells {
            let (own, more) = rest.split_at(cell.nodes());
            rest = more;
            match cell {
                Cell::Triangle | Cell::QuadraticTriangle => corners.push(&own[..3]),
                Cell::Quad | Cell::QuadraticQuad | Cell::BiquadraticQuad => corners.push(&own[..4]),
                Cell::Vertex | Cell::Line | Cell::QuadraticLine => {}
            }
        }
        let used: BTreeSet<u32> = corners.iter().flat_map(|own| own.iter().copied()).collect();
        let number: BTreeMap<u32, u32> = used.iter().copied().zip(0..).collect();
        let behind = used.len() as u32;
        let at = |z: f64| used.iter().map(move |node| SkinPoint { node: Some(*node), offset: [0.0, 0.0, z] });
        let mut skin = Self { points: at(0.5 * thickness).chain(at(-0.5 * thickness)).collect(), ..Self::default() };
        let sides = |own: &[u32]| -> Vec<(u32, u32)> {
            (0..own.len()).map(|i| (number[&own[i]], number[&own[(i + 1) % own.len()]])).collect()
        };
        let all: BTreeSet<(u32, u32)> = corners.iter().flat_map(|own| sides(own)).collect();
        for own in corners {
            match own.iter().map(|node| number[node]).collect::<Vec<u32>>()[..] {
                [a, b, c] => skin.triangles.extend([[a, b, c], [c + behind, b + behind, a + behind]]),
                [a, b, c, d] => skin.quads.extend([[a, b, c, d], [d, c, b, a].map(|p| p + behind)]),
                _ => {}
            }
            // A side that no other cell has is on the edge.
            let edges = sides(own).into_iter().filter(|(a, b)| !all.contains(&(*b, *a)));
            skin.quads.extend(edges.map(|(a, b)| [b, a, a + behind, b + behind]));
        }
        skin
    }

    /// Both surfaces as one.
    #[must_use]
    pub fn and(mut self, other: &Self) -> Self {
        let first = self.points.len() as u32;
        self.points.extend(&other.points);
        self.triangles.extend(other.triangles.iter().map(|t| t.map(|p| p + first)));
        self.quads.extend(other.quads.iter().map(|q| q.map(|p| p + first)));
        self
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Two unit vectors across a third, right-handed with it.
fn across(axis: [f64; 3]) -> [[f64; 3]; 2] {
    let least = (0..3).min_by(|a, b| axis[*a].abs().total_cmp(&axis[*b].abs())).unwrap_or(0);
    let mut other = [0.0; 3];
    other[least] = 1.0;
    let u = cross(other, axis);
    let length = u.iter().map(|c| c * c).sum::<f64>().sqrt();
    let u = u.map(|c| c / length);
    [u, cross(axis, u)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The volume inside, m³, by the divergence theorem, and whether every side is shared by two faces.
    fn volume(skin: &Skin) -> (f64, bool) {
        let at = |i: u32| skin.points[i as usize].offset;
        let quads = skin.quads.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]);
        let sum = skin.triangles.iter().copied().chain(quads).map(|[a, b, c]| {
            let n = cross(at(b), at(c));
            at(a).iter().zip(n).map(|(p, n)| p * n).sum::<f64>() / 6.0
        });
        let volume = sum.sum();
        let faces = skin.triangles.iter().map(|f| f.to_vec()).chain(skin.quads.iter().map(|f| f.to_vec()));
        let sides: Vec<(u32, u32)> =
            faces.flat_map(|f| (0..f.len()).map(|i| (f[i], f[(i + 1) % f.len()])).collect::<Vec<_>>()).collect();
        let set: BTreeSet<(u32, u32)> = sides.iter().copied().collect();
        (volume, set.len() == sides.len() && sides.iter().all(|(a, b)| set.contains(&(*b, *a))))
    }

    #[test]
    fn bodies_are_closed_and_face_outwards() {
        // Of a polygon of 24 sides the area is 12·sin 15°·r².
        let area = 12.0 * 15f64.to_radians().sin();
        let axis = [0.6, 0.0, 0.8];
        let rod = Skin::turned(None, [0.3, -0.2, 0.1], axis, &[(0.0, 0.5), (2.0, 0.5)]);
        let tube = {
            let rim = |x: f64, r: f64| (None, [x, 0.0, 0.0], r);
            let rims = [rim(0.0, 0.5), rim(2.0, 0.5), rim(2.0, 0.3), rim(0.0, 0.3)];
            Skin::round(&rims, [1.0, 0.0, 0.0], Ends::Joined)
        };
        let bar = Skin::square(None, [1.0, 2.0, 3.0], [0.0, -1.0, 0.0], &[(0.0, 0.25), (3.0, 0.25)]);
        let cuboid = Skin::block(None, [1.0, 0.0, -1.0], [0.5, 1.0, 0.25]);
        let expected = [
            (&rod, area * 0.25 * 2.0),
            (&tube, area * (0.25 - 0.09) * 2.0),
            (&bar, 0.75),
            (&cuboid, 1.0),
            (&cuboid.clone().and(&bar), 1.75),
        ];
        for (i, (skin, expected)) in expected.into_iter().enumerate() {
            let (volume, is_closed) = volume(skin);
            assert!(is_closed, "{i}");
            assert!((volume - expected).abs() < 1e-12, "{i}: {volume} {expected}");
        }
        // The sides of a bar face along the coordinates.
        assert!(bar.points.iter().all(|p| (p.offset[0] - 1.0).abs() < 0.25 + 1e-12));
    }

    #[test]
    fn a_plane_body_gets_its_thickness() {
        let mut grid = Grid { points: vec![[0.0; 3]; 5], ..Grid::default() };
        grid.push(Cell::Quad, &[0, 1, 2, 3]);
        grid.push(Cell::Triangle, &[1, 4, 2]);
        grid.push(Cell::Line, &[0, 4]);
        let mut skin = Skin::thickened(&grid, 0.5);
        assert_eq!((skin.triangles.len(), skin.quads.len()), (2, 2 + 5));
        let places = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [2.0, 0.0]];
        for point in &mut skin.points {
            let [x, y] = places[point.node.unwrap_or(0) as usize];
            point.offset = [x, y, point.offset[2]];
        }
        let (volume, is_closed) = volume(&skin);
        assert!(is_closed && (volume - 0.75).abs() < 1e-12, "{volume}");
    }
}
