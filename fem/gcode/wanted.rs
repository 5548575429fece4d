//! The change of the contour that is wanted, along the part.

use super::steps::Cut;
use super::workpiece::Stretch;

/// A change that is wanted along a line of the part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Course<'a> {
    /// Distance of the line from the middle of the part's breadth, m; 0 where it has none.
    pub y: f64,
    /// Places along it, rising, m.
    pub places: &'a [f64],
    /// The change of the level at each, m.
    pub changes: &'a [f64],
}

/// The change that is wanted all over the part.
#[derive(Clone, Debug, PartialEq)]
pub struct Wanted {
    /// Lines by their distance from the middle, m, all with the same places.
    lines: Vec<(f64, Line)>,
}

/// A change along the part, straight between places; where two stretches meet it may jump.
#[derive(Clone, Debug, PartialEq)]
struct Line {
    /// Places and changes, m, rising; two of one place are a jump.
    nodes: Vec<(f64, f64)>,
}

/// Places of a way across the part over which a change is looked at.
const ACROSS: usize = 64;

/// Places nearer than this are one, m.
pub const SAME: f64 = 1e-9;

impl Wanted {
    /// The change that is wanted along some lines of a part of these stretches.
    pub fn new(courses: &[Course], stretches: &[Stretch]) -> Self {
        let line = |own: &Course| (own.y, Line::new(own.places, own.changes, stretches));
        Self { lines: courses.iter().map(line).collect() }
    }

    /// The change at a place, m: across the part on the parabola through the lines (of two the straight line, one as it
    /// is), beyond the outermost as on these.
    pub fn at(&self, x: f64, y: f64) -> f64 {
        self.shares(y).zip(&self.lines).map(|(share, (_, line))| share * line.at(x)).sum()
    }

    /// Of each line its share in what is wanted at a distance from the middle (Lagrange).
    fn shares(&self, y: f64) -> impl Iterator<Item = f64> + use<'_> {
        let all = || self.lines.iter().map(|line| line.0);
        let y = y.max(all().fold(f64::INFINITY, f64::min)).min(all().fold(f64::NEG_INFINITY, f64::max));
        all().map(move |own| all().filter(|other| *other != own).map(|other| (y - other) / (own - other)).product())
    }

    /// The changes that are wanted along a straight cut: of one that runs along the part with its places on the part,
    /// rising, of any other with the distances from its start, m.
    pub fn along(&self, cut: &Cut) -> Vec<(f64, f64)> {
        if (cut.to.y - cut.from.y).abs() < SAME {
            return self.between(cut.from.x.min(cut.to.x), cut.from.x.max(cut.to.x), cut.from.y);
        }
        let one = |i: usize| {
            let share = i as f64 / ACROSS as f64;
            let spot = cut.at(share);
            (share * cut.way(), self.at(spot.x, spot.y))
        };
        (0..=ACROSS).map(one).collect()
    }

    /// Places and changes at a distance from the middle on the way from one place to another that lies beyond it, both
    /// among them, rising.
    pub fn between(&self, low: f64, high: f64, y: f64) -> Vec<(f64, f64)> {
        let mut sum: Vec<(f64, f64)> = Vec::new();
        for (share, (_, line)) in self.shares(y).zip(&self.lines) {
            let own = line.between(low, high);
            if sum.is_empty() {
                sum = own.iter().map(|(x, _)| (*x, 0.0)).collect();
            }
            sum.iter_mut().zip(own).for_each(|(sum, (_, change))| sum.1 += share * change);
        }
        sum
    }

    /// Smallest and largest place at which it is known, m.
    pub fn ends(&self) -> Option<(f64, f64)> {
        let nodes = &self.lines.first()?.1.nodes;
        Some((nodes.first()?.0, nodes.last()?.0))
    }
}

impl Line {
    /// The change that has these values at these places (rising); on a step a place belongs to the stretch toward the
    /// end of the part. What no place of a stretch tells lies on its next straight line.
    fn new(places: &[f64], changes: &[f64], stretches: &[Stretch]) -> Self {
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
    fn at(&self, x: f64) -> f64 {
        let next = self.nodes.partition_point(|node| node.0 <= x);
        match (next.checked_sub(1).map(|before| self.nodes[before]), self.nodes.get(next)) {
            (None, None) => 0.0,
            (None, Some(only)) => only.1,
            (Some(only), None) => only.1,
            (Some(before), Some(after)) => on_line(&[before, *after], x),
        }
    }

    /// Places and changes on the way from one place to another that lies beyond it, both among them, rising.
    fn between(&self, low: f64, high: f64) -> Vec<(f64, f64)> {
        let first = self.nodes.partition_point(|node| node.0 <= low + SAME);
        let inside = self.nodes[first..].iter().copied().take_while(|node| node.0 < high - SAME);
        let ends = [low + SAME, high - SAME].map(|x| self.at(x));
        std::iter::once((low, ends[0])).chain(inside).chain([(high, ends[1])]).collect()
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
        let stretches = [(0.0, 2.0), (2.0, 4.0)].map(|(from, to)| Stretch { from, to, level: 1.0 });
        let wanted = Line::new(&[0.0, 1.0, 2.0, 3.0, 4.0], &[0.0, 1.0, 9.0, 9.0, 9.0], &stretches);
        for (x, change) in [(-1.0, 0.0), (0.5, 0.5), (1.9, 1.9), (2.0, 9.0), (3.5, 9.0), (5.0, 9.0)] {
            assert!((wanted.at(x) - change).abs() < 1e-12, "{x} {}", wanted.at(x));
        }
        let between = wanted.between(1.5, 2.0);
        assert!(between.len() == 2 && (between[1].1 - 2.0).abs() < 1e-6, "{between:?}");
    }

    #[test]
    fn across_it_is_the_parabola_through_its_lines_and_holds_beyond_them() {
        let stretches = [Stretch { from: 0.0, to: 4.0, level: 0.0 }];
        let changes = [[4.0, 0.0], [1.0, 1.0], [0.0, 4.0]];
        let of = |lines: &[usize]| {
            let course = |line: &usize| Course { y: *line as f64 - 1.0, places: &[0.0, 4.0], changes: &changes[*line] };
            Wanted::new(&lines.iter().map(course).collect::<Vec<_>>(), &stretches)
        };
        let whole = of(&[0, 1, 2]);
        // Through 4, 1, 0 at the one end: (1 - y)²; (1 + y)² at the other.
        for (x, y, change) in [(0.0, 0.5, 0.25), (0.0, -0.5, 2.25), (4.0, 0.5, 2.25), (2.0, 0.0, 1.0), (0.0, 9.0, 0.0)]
        {
            assert!((whole.at(x, y) - change).abs() < 1e-12, "{x} {y} {}", whole.at(x, y));
        }
        assert_eq!((of(&[1]).at(0.0, 7.0), of(&[0, 2]).at(0.0, 0.0)), (1.0, 2.0));
        assert_eq!(whole.between(0.0, 4.0, -1.0), whole.lines[0].1.between(0.0, 4.0));
    }
}
