//! Nested dissection from the geometry of a mesh.
//!
//! ```text
//!   +-------+-+-------+     A set of nodes is cut at the median of its longer direction; the nodes of one
//!   |   A   |S|   B   |     side that have neighbours on the other side are the separator S, taken from the
//!   |       | |       |     side that gives fewer. A and B are eliminated first, each cut in the same way,
//!   +-------+-+-------+     then S: nothing fills in between A and B.
//! ```
//!
//! A mesh around a hole is unrolled first (angle times mean radius, radius), so that cuts run across the
//! ring; its first cut opens it at two places. George (1973); Heath and Raghavan (1995) for cuts by
//! coordinates.

use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

use super::Graph;

/// Sets of so few nodes are not cut further.
const LEAF: usize = 12;
/// Sets of at least so many nodes are worth a task of their own.
const TASK: usize = 4000;

/// Order of elimination of all nodes of `graph`, which stand at `nodes` (m).
pub(super) fn dissect(graph: &Graph, nodes: &[[f64; 2]]) -> Vec<u32> {
    let chart = chart(nodes);
    let mut order: Vec<u32> = (0..).take(nodes.len()).collect();
    let regions: Vec<AtomicU32> = nodes.iter().map(|_| AtomicU32::new(1)).collect();
    let dissection = Dissection { graph, chart: &chart, regions: &regions };
    dissection.order(&mut order, 1);
    order
}

/// Coordinates in which to cut: as they are, or unrolled where the nodes leave a hole around their centre.
fn chart(nodes: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let bounds = bounds(nodes.iter().copied());
    let centre = bounds.map(|[low, high]| 0.5 * (low + high));
    let polar = |&[x, y]: &[f64; 2]| [(y - centre[1]).atan2(x - centre[0]), (x - centre[0]).hypot(y - centre[1])];
    let turned: Vec<[f64; 2]> = nodes.iter().map(polar).collect();
    let (inner, outer) = turned.iter().fold((f64::INFINITY, 0.0_f64), |(i, o), at| (i.min(at[1]), o.max(at[1])));
    let mut quarters = [false; 4];
    for [x, y] in nodes {
        quarters[usize::from(*x > centre[0]) + 2 * usize::from(*y > centre[1])] = true;
    }
    if inner < 0.3 * outer || quarters != [true; 4] {
        return nodes.to_vec();
    }
    let mean = 0.5 * (inner + outer);
    turned.iter().map(|[angle, radius]| [angle * mean, *radius]).collect()
}

/// (Lowest, highest) of each coordinate.
fn bounds(points: impl Iterator<Item = [f64; 2]>) -> [[f64; 2]; 2] {
    points.fold([[f64::INFINITY, f64::NEG_INFINITY]; 2], |bounds, point| {
        [0, 1].map(|axis| [bounds[axis][0].min(point[axis]), bounds[axis][1].max(point[axis])])
    })
}

struct Dissection<'a> {
    graph: &'a Graph,
    chart: &'a [[f64; 2]],
    /// Region of every node: a set that is being cut has its own number; 0 is a separator. Tasks on different
    /// regions never look at each other's nodes, for those have no common edge.
    regions: &'a [AtomicU32],
}

impl Dissection<'_> {
    /// Puts the nodes of `set`, which make up `region`, in their order of elimination.
    fn order(&self, set: &mut [u32], region: u32) {
        if set.len() <= LEAF || region >= 1 << 30 {
            return;
        }
        let Some([first, second]) = self.cut(set, region) else { return };
        let large = set.len() >= TASK;
        let (a, rest) = set.split_at_mut(first);
        let b = &mut rest[..second];
        if large {
            rayon::join(|| self.order(a, 2 * region), || self.order(b, 2 * region + 1));
        } else {
            self.order(a, 2 * region);
            self.order(b, 2 * region + 1);
        }
    }

    /// Cuts `set` into A, B and the separator, in this order; the sizes of A and B. None where the nodes
    /// coincide.
    fn cut(&self, set: &mut [u32], region: u32) -> Option<[usize; 2]> {
        let bounds = bounds(set.iter().map(|&node| self.chart[node as usize]));
        let extent = bounds.map(|[low, high]| high - low);
        let axis = usize::from(extent[1] > extent[0]);
        let place = |node: &u32| self.chart[*node as usize][axis];
        let middle = set.len() / 2;
        let (_, &mut median, _) = set.select_nth_unstable_by(middle, |a, b| place(a).total_cmp(&place(b)));
        // nodes of one line of the mesh stay together
        let mut threshold = place(&median) - 1e-7 * extent[axis];
        if threshold <= bounds[axis][0] {
            threshold = place(&median) + 1e-7 * extent[axis];
        }
        let mut above = 0;
        for &node in set.iter() {
            let upper = self.chart[node as usize][axis] > threshold;
            above += usize::from(upper);
            self.regions[node as usize].store(2 * region + u32::from(upper), Relaxed);
        }
        if above == 0 || above == set.len() {
            return None;
        }
        self.separate(set, [2 * region, 2 * region + 1]);
        let rank = |node: &u32| match self.regions[*node as usize].load(Relaxed) {
            0 => 2,
            own => own & 1,
        };
        let sizes = [0, 1].map(|rank_of| set.iter().filter(|node| rank(node) == rank_of).count());
        partition(set, sizes, rank);
        Some(sizes)
    }

    /// Marks the separator between the `sides` of `set`: of the nodes next to the other side, those of the
    /// side that has fewer.
    fn separate(&self, set: &[u32], sides: [u32; 2]) {
        let mut borders = [Vec::new(), Vec::new()];
        for &node in set {
            let own = self.regions[node as usize].load(Relaxed);
            let side = usize::from(own == sides[1]);
            let other = sides[1 - side];
            if self.graph.neighbours(node).iter().any(|&next| self.regions[next as usize].load(Relaxed) == other) {
                borders[side].push(node);
            }
        }
        let fewer = usize::from(borders[1].len() <= borders[0].len());
        for &node in &borders[fewer] {
            self.regions[node as usize].store(0, Relaxed);
        }
    }
}

/// Sorts `set` by rank (0, 1, 2), of which `sizes` gives the first two counts.
fn partition(set: &mut [u32], sizes: [usize; 2], rank: impl Fn(&u32) -> u32) {
    let sorted = {
        let mut next = [0, sizes[0], sizes[0] + sizes[1]];
        let mut sorted = vec![0; set.len()];
        for node in set.iter() {
            let slot = &mut next[rank(node) as usize];
            sorted[*slot] = *node;
            *slot += 1;
        }
        sorted
    };
    set.copy_from_slice(&sorted);
}
