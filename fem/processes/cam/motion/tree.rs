//! The legs of a motion in a binary tree, so that few need be looked at.

use super::leg::Leg;
use super::reach::{Ray, lowest_of_capsule};
use crate::processes::cam::profile::Vector;

/// Consecutive legs: all of the wheel's centre lies within `bow` of the chord between the ends.
#[derive(Clone, Debug)]
struct Node {
    ends: [Vector; 2],
    bow: f64,
    /// The two halves, or the leg.
    inside: Inside,
}

#[derive(Clone, Copy, Debug)]
enum Inside {
    Leg(usize),
    Halves(usize, usize),
}

/// The tree; its root is the last node.
#[derive(Clone, Debug)]
pub struct Tree(Vec<Node>);

impl Tree {
    /// A tree over legs that follow each other.
    pub fn new(legs: &[Leg]) -> Self {
        let mut nodes = Vec::with_capacity(2 * legs.len());
        grow(legs, 0, legs.len(), &mut nodes);
        Self(nodes)
    }

    /// Visits every leg that may leave less than `limit` along the ray, likely ones first; the visit gives
    /// the limit from then on.
    pub fn search(&self, ray: &Ray, radius: f64, mut limit: f64, mut visit: impl FnMut(usize) -> f64) {
        let lowest = |i: usize| lowest_of_capsule(ray, &self.0[i].ends, radius, self.0[i].bow);
        let root = self.0.len() - 1;
        // Deeper than any tree over legs that fit in memory.
        let mut waiting: Vec<(f64, usize)> = Vec::with_capacity(64);
        waiting.push((lowest(root), root));
        while let Some((bound, node)) = waiting.pop() {
            if bound >= limit {
                continue;
            }
            match self.0[node].inside {
                Inside::Leg(leg) => limit = visit(leg),
                Inside::Halves(a, b) => {
                    let (a, b) = ((lowest(a), a), (lowest(b), b));
                    waiting.extend(if a.0 < b.0 { [b, a] } else { [a, b] });
                }
            }
        }
    }
}

/// Adds the node over legs `from` to `to` after those of its halves, and gives its number.
fn grow(legs: &[Leg], from: usize, to: usize, nodes: &mut Vec<Node>) -> usize {
    if to - from == 1 {
        nodes.push(Node { ends: legs[from].ends, bow: legs[from].bow, inside: Inside::Leg(from) });
        return nodes.len() - 1;
    }
    let middle = from + (to - from) / 2;
    let (a, b) = (grow(legs, from, middle, nodes), grow(legs, middle, to, nodes));
    let ends = [legs[from].ends[0], legs[to - 1].ends[1]];
    // The distance from a chord is convex: along a straight piece it is greatest at an end.
    let off = |i: usize| nodes[i].bow + nodes[i].ends.iter().map(|p| distance(p, &ends)).fold(0.0, f64::max);
    let bow = off(a).max(off(b));
    nodes.push(Node { ends, bow, inside: Inside::Halves(a, b) });
    nodes.len() - 1
}

/// Distance of a point from a straight piece.
fn distance(point: &Vector, [a, b]: &[Vector; 2]) -> f64 {
    let chord = b - a;
    let square = chord.norm_squared();
    let part = if square > 0.0 { ((point - a).dot(&chord) / square).clamp(0.0, 1.0) } else { 0.0 };
    (point - (a + chord * part)).norm()
}
