//! Compensation tables: corrections that a controller adds to the commanded position.

use super::{Approach, Direction, Evaluation, Reversal};

/// The way in which a controller goes from one entry to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Law {
    /// Linear between the points.
    Points,
    /// Constant in segments: each entry holds from midway to midway.
    Segments,
}

/// The correction at a position. m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// Commanded position.
    pub position: f64,
    /// Correction on the way forwards.
    pub forward: f64,
    /// Correction on the way backwards.
    pub backward: f64,
}

/// A compensation table. Beyond its ends the last entry holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Law between the entries.
    pub law: Law,
    /// Entries in rising order.
    pub nodes: Vec<Node>,
}

/// Points of equal distance, counted from a controller's reference point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steps {
    /// Position of the reference point, m.
    pub reference: f64,
    /// Distance from one point to the next, m.
    pub interval: f64,
    /// Worth of one count of an increment: the controller's detection unit times its magnification, m; 0 where
    /// increments are not counted.
    pub unit: f64,
    /// Factor by which the controller multiplies every count; part of `unit`.
    pub magnification: i64,
    /// Number that the controller gives to the reference point; `None` where nobody has said.
    pub number: Option<i64>,
}

impl Steps {
    /// The controller's detection unit, m; 0 where it is not told.
    pub fn detection_unit(&self) -> f64 {
        self.unit / self.magnification as f64
    }
}

/// Increment of a controller's correction from one point to the next, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Increment {
    /// Number of the point, 0 at the reference point.
    pub number: i64,
    /// Position of the point.
    pub position: f64,
    /// Correction there less that at the reference point.
    pub from_reference: f64,
    /// Correction there less that at the point before.
    pub increment: f64,
    /// The same in counts, rounded so that their sum from the reference point is off by half a count at most; `None`
    /// where increments are not counted.
    pub counts: Option<i64>,
}

impl Table {
    /// Adds another table that a controller has beside this one: the sum, at the points of either. Segments keep their
    /// own.
    #[must_use]
    pub fn and(&self, other: &Self) -> Self {
        let mut places: Vec<f64> = self.nodes.iter().map(|n| n.position).collect();
        if self.law == Law::Points {
            places.extend(other.nodes.iter().map(|n| n.position));
            places.sort_by(f64::total_cmp);
            places.dedup();
        }
        let sum = |at, direction| self.correction(at, direction) + other.correction(at, direction);
        let node = |position| Node {
            position,
            forward: sum(position, Direction::Forward),
            backward: sum(position, Direction::Backward),
        };
        Self { law: self.law, nodes: places.into_iter().map(node).collect() }
    }

    /// The table as increments forwards at points of equal distance over its length [seed 001: each from the
    /// point before, entered by the number of the reference point].
    pub fn increments(&self, Steps { reference, interval, unit, .. }: Steps) -> Vec<Increment> {
        let Some((first, last)) = self.nodes.first().zip(self.nodes.last()) else { return Vec::new() };
        // A point that a rounding has put beyond the end stands at it.
        let number = |position: f64| (position - reference) / interval;
        let numbers = (number(first.position) - 1e-9).ceil() as i64..=(number(last.position) + 1e-9).floor() as i64;
        let at = |number: i64| reference + number as f64 * interval;
        let added = |number: i64| self.correction(at(number), Direction::Forward);
        let from_reference = |number: i64| added(number) - self.correction(reference, Direction::Forward);
        let counted = |number: i64| (from_reference(number) / unit).round() as i64;
        let step = |number| Increment {
            number,
            position: at(number),
            from_reference: from_reference(number),
            increment: added(number) - added(number - 1),
            counts: (unit > 0.0).then(|| counted(number) - counted(number - 1)),
        };
        numbers.map(step).collect()
    }

    /// One pitch table for both directions and one value for backlash: at each target the mean error of both
    /// sides is taken out, and what its reversal differs from the backlash value by stays, half on either
    /// side. Entries are rounded to the controller's resolution (m; 0 for none).
    pub fn with_backlash(evaluation: &Evaluation, law: Law, resolution: f64) -> Self {
        let backlash = rounded(Reversal::of(evaluation).map_or(0.0, |r| r.value), resolution);
        let node = |target: &super::Target| {
            let forward = target.forward.map(|s| s.mean);
            let backward = target.backward.map(|s| s.mean - backlash);
            let error = match (forward, backward) {
                (Some(forward), Some(backward)) => 0.5 * (forward + backward),
                (one, other) => one.or(other).unwrap_or(0.0),
            };
            let forward = rounded(-error, resolution);
            Node { position: target.position, forward, backward: forward - backlash }
        };
        Self { law, nodes: evaluation.targets.iter().map(node).collect() }
    }

    /// A table for each direction: at each target the mean error of either side is taken out whole.
    pub fn both_directions(evaluation: &Evaluation, law: Law, resolution: f64) -> Self {
        let node = |target: &super::Target| {
            let mean = |direction| target.side(direction).map(|s| s.mean);
            let (forward, backward) = (mean(Direction::Forward), mean(Direction::Backward));
            let entry = |own: Option<f64>, other: Option<f64>| rounded(-own.or(other).unwrap_or(0.0), resolution);
            Node { position: target.position, forward: entry(forward, backward), backward: entry(backward, forward) }
        };
        Self { law, nodes: evaluation.targets.iter().map(node).collect() }
    }

    /// The backlash value, where it is one: what is taken off on the way backwards at every entry.
    pub fn backlash(&self) -> f64 {
        self.nodes.first().map_or(0.0, |n| n.forward - n.backward)
    }

    /// The correction of the commanded position, m.
    pub fn correction(&self, position: f64, direction: Direction) -> f64 {
        let entry = |i: usize| match direction {
            Direction::Forward => self.nodes[i].forward,
            Direction::Backward => self.nodes[i].backward,
        };
        let last = match self.nodes.len() {
            0 => return 0.0,
            count => count - 1,
        };
        let next = self.nodes.partition_point(|n| n.position <= position);
        if next == 0 || next > last {
            return entry(next.min(last));
        }
        let (a, b) = (self.nodes[next - 1].position, self.nodes[next].position);
        let part = (position - a) / (b - a);
        match self.law {
            Law::Points => entry(next - 1) + part * (entry(next) - entry(next - 1)),
            Law::Segments => entry(if part < 0.5 { next - 1 } else { next }),
        }
    }

    /// Deviations as they would have been without the table in the controller.
    pub fn removed(&self, approaches: &[Approach], deviations: &[f64]) -> Vec<f64> {
        let of = |(a, d): (&Approach, &f64)| d - self.correction(a.position, a.direction);
        approaches.iter().zip(deviations).map(of).collect()
    }

    /// Deviations as they would be with the table in the controller.
    pub fn applied(&self, approaches: &[Approach], deviations: &[f64]) -> Vec<f64> {
        let of = |(a, d): (&Approach, &f64)| d + self.correction(a.position, a.direction);
        approaches.iter().zip(deviations).map(of).collect()
    }

    /// Deviations as they would be if the table had been made without the target of each: what it may leave
    /// between its points. The ends keep their entries.
    pub fn applied_without_own(&self, approaches: &[Approach], deviations: &[f64]) -> Vec<f64> {
        let others = |left_out: usize| {
            let mut nodes = self.nodes.clone();
            nodes.remove(left_out);
            Self { nodes, ..*self }
        };
        let inner = 1..self.nodes.len().saturating_sub(1).max(1);
        let without: Vec<Self> = inner.clone().map(others).collect();
        let of = |(a, d): (&Approach, &f64)| {
            let own = inner.clone().position(|i| self.nodes[i].position == a.position);
            d + own.map_or(self, |i| &without[i]).correction(a.position, a.direction)
        };
        approaches.iter().zip(deviations).map(of).collect()
    }
}

fn rounded(value: f64, resolution: f64) -> f64 {
    if resolution > 0.0 { (value / resolution).round() * resolution } else { value }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(backlash: f64, points: &[(f64, f64)]) -> Table {
        let node =
            |(mm, um): &(f64, f64)| Node { position: 1e-3 * mm, forward: 1e-6 * um, backward: 1e-6 * (um - backlash) };
        Table { law: Law::Points, nodes: points.iter().map(node).collect() }
    }

    #[test]
    fn what_is_entered_is_the_sum_at_the_points_of_either() {
        let active = table(5.0, &[(0.0, 0.0), (200.0, 8.0)]);
        let sum = table(3.0, &[(0.0, 1.0), (100.0, 2.0), (300.0, -2.0)]).and(&active);
        // 8 um hold beyond 200 mm.
        let expected = table(8.0, &[(0.0, 1.0), (100.0, 6.0), (200.0, 8.0), (300.0, 6.0)]);
        assert_eq!(sum.nodes.len(), 4);
        for (found, expected) in sum.nodes.iter().zip(&expected.nodes) {
            let near = |a: f64, b: f64| (a - b).abs() < 1e-15;
            assert!(near(found.position, expected.position) && near(found.forward, expected.forward), "{found:?}");
            assert!(near(found.backward, expected.backward), "{found:?}");
        }
    }

    #[test]
    fn increments_are_counted_from_the_reference_point() {
        let table = table(0.0, &[(0.0, 1.0), (100.0, 6.0), (300.0, -2.0)]);
        let steps =
            table.increments(Steps { reference: 0.2, interval: 0.1, unit: 0.0, magnification: 1, number: None });
        let told: Vec<(i64, f64, f64)> =
            steps.iter().map(|s| (s.number, (1e6 * s.from_reference).round(), (1e6 * s.increment).round())).collect();
        assert_eq!(told, [(-2, -1.0, 0.0), (-1, 4.0, 5.0), (0, 0.0, -4.0), (1, -4.0, -4.0)]);
        assert!(steps.iter().all(|s| s.counts.is_none()));
    }

    #[test]
    fn counts_do_not_drift_from_what_they_stand_for() {
        // 1 um from point to point in counts of 3 um: every third point takes one.
        let nodes: Vec<(f64, f64)> = (0..10).map(|i| (100.0 * f64::from(i), f64::from(i))).collect();
        let steps = Steps { reference: 0.0, interval: 0.1, unit: 3e-6, magnification: 1, number: None };
        let steps = table(0.0, &nodes).increments(steps);
        let counts: Vec<i64> = steps.iter().filter_map(|s| s.counts).collect();
        assert_eq!(counts, [0, 0, 1, 0, 0, 1, 0, 0, 1, 0]);
        let mut sum = 0;
        for step in steps {
            sum += step.counts.unwrap_or(0);
            assert!((sum as f64 * 3e-6 - step.from_reference).abs() <= 1.5e-6 + 1e-12, "{step:?}");
        }
    }
}
