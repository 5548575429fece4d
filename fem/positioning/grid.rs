//! Points of equal distance, as most controls take their tables.

use super::{Direction, Law, Node, Table};

/// How near to equal the distances of a table's entries are that count as equal, m.
const EQUAL: f64 = 1e-9;

/// Most points of a grid: more than any control takes.
const MOST: f64 = 1e5;

/// Points of equal distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Position of the first, m.
    pub first: f64,
    /// Distance from one to the next, m.
    pub interval: f64,
    /// How many there are; at least two.
    pub points: usize,
}

impl Grid {
    /// The points of a table whose entries stand at equal distances already.
    pub fn of(table: &Table) -> Option<Self> {
        let (first, last) = ends(table)?;
        let points = table.nodes.len();
        let grid = Self { first, interval: (last - first) / (points - 1) as f64, points };
        let is_at = |(i, node): (usize, &Node)| (node.position - grid.position(i)).abs() <= EQUAL;
        table.nodes.iter().enumerate().all(is_at).then_some(grid)
    }

    /// Points counted from a reference, from the last before a table's first entry, or at it, to the first beyond
    /// its last. `None` where those are more than any control takes.
    pub fn through(table: &Table, reference: f64, interval: f64) -> Option<Self> {
        let (first, last) = ends(table)?;
        // A point that a rounding has put beyond an end stands at it.
        let below = ((first - reference) / interval + 1e-9).floor();
        let above = ((last - reference) / interval - 1e-9).ceil();
        let grid = Self { first: reference + below * interval, interval, points: (above - below) as usize + 1 };
        (above - below < MOST).then_some(grid)
    }

    /// The fewest points from a table's first entry on, `most` of them at most, that meet every entry to `near`; those that
    /// come nearest where none do. Their distance is whole in `step`.
    pub fn fitted(table: &Table, most: usize, near: f64, step: f64) -> Option<Self> {
        let (first, last) = ends(table)?;
        let mut best: Option<(f64, Self)> = None;
        for points in table.nodes.len().min(most).max(2)..=most.max(2) {
            let interval = ((last - first) / (points - 1) as f64 / step - 1e-3).ceil() * step;
            let grid = Self { first, interval, points };
            let missed = table.missed_by(&table.on(grid));
            if best.is_none_or(|(least, _)| missed < least) {
                best = Some((missed, grid));
            }
            if missed <= near {
                break;
            }
        }
        best.map(|(_, grid)| grid)
    }

    /// Position of a point, counted from 0, m.
    pub fn position(&self, point: usize) -> f64 {
        self.first + point as f64 * self.interval
    }

    /// Position of the last point, m.
    pub fn last(&self) -> f64 {
        self.position(self.points - 1)
    }
}

impl Table {
    /// The table at points of equal distance, linear between them.
    #[must_use]
    pub fn on(&self, grid: Grid) -> Self {
        let node = |point| {
            let position = grid.position(point);
            let [forward, backward] = Direction::BOTH.map(|direction| self.correction(position, direction));
            Node { position, forward, backward }
        };
        Self { law: Law::Points, nodes: (0..grid.points).map(node).collect() }
    }

    /// By how much another table misses the entries of this one at most, m.
    pub fn missed_by(&self, other: &Self) -> f64 {
        let at = |node: &Node| {
            let by = |entry: f64, direction| (entry - other.correction(node.position, direction)).abs();
            by(node.forward, Direction::Forward).max(by(node.backward, Direction::Backward))
        };
        self.nodes.iter().map(at).fold(0.0, f64::max)
    }

    /// The table with every entry changed; `f` takes what is added and its direction.
    #[must_use]
    pub fn map(&self, f: impl Fn(f64, Direction) -> f64) -> Self {
        let node = |n: &Node| Node {
            position: n.position,
            forward: f(n.forward, Direction::Forward),
            backward: f(n.backward, Direction::Backward),
        };
        Self { law: self.law, nodes: self.nodes.iter().map(node).collect() }
    }
}

/// Positions of the first and the last entry; `None` where there are not two.
fn ends(table: &Table) -> Option<(f64, f64)> {
    let (first, last) = table.nodes.first().zip(table.nodes.last())?;
    (last.position > first.position).then_some((first.position, last.position))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(points: &[(f64, f64)]) -> Table {
        let node =
            |(mm, um): &(f64, f64)| Node { position: 1e-3 * mm, forward: 1e-6 * um, backward: 1e-6 * (um - 2.0) };
        Table { law: Law::Points, nodes: points.iter().map(node).collect() }
    }

    #[test]
    fn equal_distances_are_seen() {
        let grid = Grid::of(&table(&[(-30.0, 1.0), (-10.0, 2.0), (10.0, 0.0)])).unwrap();
        assert!((grid.first + 0.03).abs() < 1e-15 && (grid.interval - 0.02).abs() < 1e-15 && grid.points == 3);
        assert!((grid.last() - 0.01).abs() < 1e-15);
        assert_eq!(Grid::of(&table(&[(-30.0, 1.0), (-10.0, 2.0), (11.0, 0.0)])), None);
        assert_eq!(Grid::of(&table(&[(1.0, 1.0)])), None);
    }

    #[test]
    fn points_are_counted_from_the_reference() {
        let uneven = table(&[(-30.0, 1.0), (-10.0, 2.0), (11.0, 0.0)]);
        let grid = Grid::through(&uneven, 0.005, 0.01).unwrap();
        assert!((grid.first + 0.035).abs() < 1e-15 && (grid.last() - 0.015).abs() < 1e-15, "{grid:?}");
    }

    #[test]
    fn entries_at_uneven_distances_are_met() {
        // Distances of 20 and 30 mm are multiples of 10 mm.
        let uneven = table(&[(0.0, 1.0), (20.0, 5.0), (50.0, -3.0)]);
        let grid = Grid::fitted(&uneven, 100, 1e-9, 1e-6).unwrap();
        assert_eq!((grid.points, (grid.interval * 1e6).round()), (6, 10_000.0));
        assert!(uneven.missed_by(&uneven.on(grid)) < 1e-12);
        // Four points, at 0, 16.667, …, cut the corner at 20 mm off: 5 less what is between 13/3 and 13/9 there.
        let few = Grid::fitted(&uneven, 4, 1e-9, 1e-6).unwrap();
        let expected = 5e-6 - (13.0 / 3.0 + 0.2 * (13.0 / 9.0 - 13.0 / 3.0)) * 1e-6;
        assert!((uneven.missed_by(&uneven.on(few)) - expected).abs() < 1e-9, "{few:?}");
    }
}
