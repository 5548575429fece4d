//! The change of the contour that is wanted, along the part.

use super::workpiece::Stretch;

/// A change along the part, straight between places; where two stretches meet it may jump.
#[derive(Clone, Debug, PartialEq)]
pub struct Wanted {
    /// Places and changes, m, rising; two of one place are a jump.
    nodes: Vec<(f64, f64)>,
}

/// Places nearer than this are one, m.
pub const SAME: f64 = 1e-9;

impl Wanted {
    /// The change that has these values at these places (rising); on a step a place belongs to the stretch toward the end of the
    /// part. What no place of a stretch tells lies on its next straight line.
    pub fn new(places: &[f64], changes: &[f64], stretches: &[Stretch]) -> Self {
        let all: Vec<(f64, f64)> = places.iter().copied().zip(changes.iter().copied()).collect();
        let (Some(first), Some(last)) = (all.first(), all.last()) else { return Self { nodes: Vec::new() } };
        let mut nodes: Vec<(f64, f64)> = Vec::new();
        for (number, stretch) in stretches.iter().enumerate() {
            let is_last = number + 1 == stretches.len();
            let is_own = |x: f64| x >= stretch.from - SAME && (x < stretch.to - SAME || is_last);
            let own: Vec<(f64, f64)> = all.iter().copied().filter(|(x, _)| is_own(*x)).collect();
            let own = if own.is_empty() { continue } else { own };
            let [low, high] = [stretch.from.max(first.0), stretch.to.min(last.0)];
            nodes.extend((low < own[0].0 - SAME).then(|| (low, on_line(&own[..own.len().min(2)], low))));
            let end = own[own.len() - 1].0;
            nodes.extend(own.iter().copied());
            nodes.extend((high > end + SAME).then(|| (high, on_line(&own[own.len().saturating_sub(2)..], high))));
        }
        Self { nodes }
    }

    /// The change at a place, m; beyond the ends that of the end, on a jump that beyond it.
    pub fn at(&self, x: f64) -> f64 {
        let next = self.nodes.partition_point(|node| node.0 <= x);
        match (next.checked_sub(1).map(|before| self.nodes[before]), self.nodes.get(next)) {
            (None, None) => 0.0,
            (None, Some(only)) => only.1,
            (Some(only), None) => only.1,
            (Some(before), Some(after)) => on_line(&[before, *after], x),
        }
    }

    /// Places and changes on the way from one place to another that lies beyond it, both among them, rising.
    pub fn between(&self, low: f64, high: f64) -> Vec<(f64, f64)> {
        let first = self.nodes.partition_point(|node| node.0 <= low + SAME);
        let inside = self.nodes[first..].iter().copied().take_while(|node| node.0 < high - SAME);
        let ends = [low + SAME, high - SAME].map(|x| self.at(x));
        std::iter::once((low, ends[0])).chain(inside).chain([(high, ends[1])]).collect()
    }

    /// Smallest and largest place at which it is known, m.
    pub fn ends(&self) -> Option<(f64, f64)> {
        Some((self.nodes.first()?.0, self.nodes.last()?.0))
    }
}

/// The value on the straight line through the first and the last of some points, or that of the only one.
fn on_line(points: &[(f64, f64)], x: f64) -> f64 {
    match (points.first(), points.last()) {
        (Some(a), Some(b)) if b.0 > a.0 => a.1 + (b.1 - a.1) * (x - a.0) / (b.0 - a.0),
        (Some(a), _) => a.1,
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_jumps_between_stretches_and_is_straight_within() {
        let stretches = [(0.0, 2.0), (2.0, 4.0)].map(|(from, to)| Stretch { from, to, radius: 1.0 });
        let wanted = Wanted::new(&[0.0, 1.0, 2.0, 3.0, 4.0], &[0.0, 1.0, 9.0, 9.0, 9.0], &stretches);
        for (x, change) in [(-1.0, 0.0), (0.5, 0.5), (1.9, 1.9), (2.0, 9.0), (3.5, 9.0), (5.0, 9.0)] {
            assert!((wanted.at(x) - change).abs() < 1e-12, "{x} {}", wanted.at(x));
        }
        let between = wanted.between(1.5, 2.0);
        assert!(between.len() == 2 && (between[1].1 - 2.0).abs() < 1e-6, "{between:?}");
    }
}
