//! Bodies of revolution: sleeves, discs, rings, stepped spindles.

use crate::element::plane::Quad8;
use crate::input::Reader;
use crate::mesh::{BORE, LEFT, OUTSIDE, RIGHT, RevolvedMesh, Wall};
use crate::process::Segment;
use crate::units::LENGTH;

/// Reads `revolved`: the lengths of a body of revolution, from its left end on.
pub fn read(t: &Reader) -> Vec<Segment> {
    let about = "a body of revolution: uniform lengths from its left end at x = 0";
    let walls = t.list("revolved", about, Segment::read);
    if !t.is_described() {
        for (i, pair) in walls.windows(2).enumerate() {
            let [[inner, outer], [other_inner, other_outer]] = [radii_of(&pair[0]), radii_of(&pair[1])];
            if inner >= other_outer || other_inner >= outer {
                let message = format!("lengths {} and {} of the body do not touch", i + 1, i + 2);
                let smaller = LENGTH.format(2.0 * outer.min(other_outer));
                let help = format!("the bore of the wider one must be below {smaller}, the diameter of the other");
                t.problem("revolved", message, help);
            }
        }
    }
    walls
}

/// Inner and outer radius, m.
fn radii_of(wall: &Segment) -> [f64; 2] {
    [0.5 * wall.section.bore, 0.5 * wall.section.diameter]
}

/// Smallest inner and largest outer radius, m.
pub fn radii(walls: &[Segment]) -> [f64; 2] {
    let both = |[low, high]: [f64; 2], wall: &Segment| {
        let [inner, outer] = radii_of(wall);
        [low.min(inner), high.max(outer)]
    };
    walls.iter().fold([f64::INFINITY, 0.0], both)
}

/// From the smallest to the largest radius, m.
pub fn height(walls: &[Segment]) -> f64 {
    let [inner, outer] = radii(walls);
    outer - inner
}

/// Inner and outer radius (m) at some x; where two lengths meet those of the one towards the left.
pub fn radii_at(walls: &[Segment], x: f64) -> [f64; 2] {
    let mut end = 0.0;
    let reaches = |wall: &&Segment| {
        end += wall.length;
        x <= end * (1.0 + 1e-12)
    };
    walls.iter().find(reaches).or(walls.last()).map_or([f64::NAN; 2], radii_of)
}

/// Where the bore begins and ends, m: from end to end of the body where both have one, and nothing where none does.
pub fn bored(walls: &[Segment]) -> [f64; 2] {
    let mut start = 0.0;
    let mut ends = [f64::INFINITY, 0.0];
    for wall in walls {
        let end = start + wall.length;
        if wall.section.bore > 0.0 {
            ends = [f64::min(ends[0], start), end];
        }
        start = end;
    }
    ends
}

/// Where a length of the body that has no bore lies between two places (m), if there is one: its own length, m.
pub fn solid(walls: &[Segment], [from, to]: [f64; 2]) -> Option<f64> {
    let mut start = 0.0;
    let is_solid = |wall: &&Segment| {
        let own = [start, start + wall.length];
        start = own[1];
        wall.section.bore == 0.0 && own[0].max(from) < own[1].min(to) * (1.0 - 1e-9)
    };
    walls.iter().find(is_solid).map(|wall| wall.length)
}

/// Names of its edges.
pub fn edges(walls: &[Segment]) -> Vec<String> {
    let bore = walls.iter().any(|wall| wall.section.bore > 0.0).then_some(BORE);
    [LEFT, RIGHT, OUTSIDE].into_iter().chain(bore).map(str::to_string).collect()
}

/// Its half section in 8-node quadrilaterals no longer than `size` (m), with borders at these sections (m).
pub fn mesh(walls: &[Segment], size: f64, sections: &[f64]) -> RevolvedMesh {
    let wall = |wall: &Segment| Wall { length: wall.length, radii: radii_of(wall) };
    RevolvedMesh { walls: walls.iter().map(wall).collect(), size, sections: sections.to_vec(), element: &Quad8 }
}
