//! The tolerance of an axis.

use std::f64::consts::{FRAC_PI_2, PI};

use super::{Evaluation, Measures};

/// One second of arc, rad.
const ARCSEC: f64 = PI / 648_000.0;

/// Limits of an axis, linear or rotary. SI: m or rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerance {
    /// Band of ± this on any `length`.
    pub per_length: f64,
    /// Length over which `per_length` holds.
    pub length: f64,
    /// Band over the whole travel, from end to end.
    pub travel: f64,
    /// Repeatability of ± this, both directions together.
    pub repeatability: f64,
    /// In what they are told.
    pub measures: Measures,
}

/// One tolerance, held against a test. SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// Key for programs.
    pub key: &'static str,
    /// Name for people.
    pub name: String,
    /// Width of the band that is allowed.
    pub limit: f64,
    /// Width that was found; `None` where the test does not give it.
    pub value: Option<f64>,
}

impl Default for Tolerance {
    /// Limits of a machining centre by seed 001: ±0.01 mm on any 300 mm, 0.04 mm over the whole travel, ±0.005 mm of
    /// repeatability.
    fn default() -> Self {
        Self { per_length: 10e-6, length: 0.3, travel: 40e-6, repeatability: 5e-6, measures: Measures::LINEAR }
    }
}

impl Check {
    /// Whether the limit is kept; what is not known does not pass.
    pub fn passed(&self) -> bool {
        self.value.is_some_and(|v| v <= self.limit)
    }
}

impl Tolerance {
    /// Limits of a rotary axis where a model says none: ±10 arcsec on any 90 deg, 30 arcsec over the whole range, ±8 arcsec
    /// of repeatability. They are those of no standard, and about what makers of worm tables promise.
    pub fn of_rotary_axes() -> Self {
        Self {
            per_length: 10.0 * ARCSEC,
            length: FRAC_PI_2,
            travel: 30.0 * ARCSEC,
            repeatability: 8.0 * ARCSEC,
            measures: Measures::ROTARY,
        }
    }

    /// Accuracy on any `length`, accuracy over the whole, and repeatability, by ISO 230-2's A and R against
    /// the whole width of each band. What is wider apart than a `length` counts as on a straight line: the
    /// widest such stretch begins or ends at a target.
    pub fn checks(&self, evaluation: &Evaluation) -> Vec<Check> {
        // A turn has no end at which a stretch would.
        let around = self.measures.is_rotary().then(|| evaluation.around(self.length));
        let course = around.as_ref().unwrap_or(evaluation);
        let (first, last) = course.ends();
        let places = course.targets.iter().map(|t| t.position);
        let stretches = places.flat_map(|at| [(at, (at + self.length).min(last)), ((at - self.length).max(first), at)]);
        let widest = stretches.filter_map(|(from, to)| course.stretch(from, to).accuracy()).reduce(f64::max);
        let [on, over] = if self.measures.is_rotary() { ["per_angle", "range"] } else { ["per_length", "travel"] };
        let unit = self.measures.position_unit();
        let length = (self.measures.position.from_si(self.length) * 1e6).round() / 1e6;
        let check = |key, name, limit, value| Check { key, name, limit, value };
        vec![
            check(on, format!("accuracy A on any {length} {unit}"), 2.0 * self.per_length, widest),
            check(over, "accuracy A over all targets".into(), self.travel, evaluation.accuracy()),
            check("repeatability", "repeatability R".into(), 2.0 * self.repeatability, evaluation.repeatability()),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::positioning::{Approach, Direction};

    /// 95 um on a metre, seen every 250 mm, are 28.5 um on any 300 mm.
    #[test]
    fn targets_wider_apart_than_the_length_hide_nothing() {
        let places = (0..5).flat_map(|i| Direction::BOTH.map(|d| (0.25 * f64::from(i), d)));
        let approaches: Vec<Approach> = places
            .flat_map(|(position, direction)| [1.0, 2.0].map(|run| Approach { position, direction, run }))
            .collect();
        let deviations: Vec<f64> = approaches.iter().map(|a| 95e-6 * a.position).collect();
        let checks = Tolerance::default().checks(&Evaluation::of(&approaches, &deviations));
        assert!((checks[0].value.unwrap() - 28.5e-6).abs() < 1e-12, "{checks:?}");
        assert!(!checks[0].passed());
    }

    /// Two neighbours of twelve that stand 20 arcsec apart do so wherever on the turn they are, whether the turn is measured up
    /// to its end or not.
    #[test]
    fn a_stretch_goes_on_where_a_turn_ends() {
        let arcsec = std::f64::consts::PI / 180.0 / 3600.0;
        for (targets, high) in [(12, 4), (12, 11), (13, 11)] {
            let places = (0..targets).flat_map(|i| Direction::BOTH.map(|d| (i, d)));
            let (mut approaches, mut deviations) = (Vec::new(), Vec::new());
            for (i, direction) in places {
                for run in [1.0, 2.0] {
                    approaches.push(Approach { position: f64::from(i) * std::f64::consts::PI / 6.0, direction, run });
                    let off = [(high, 10.0), ((high + 1) % 12, -10.0)]
                        .iter()
                        .find(|own| own.0 == i % 12)
                        .map_or(0.0, |own| own.1);
                    deviations.push(off * arcsec);
                }
            }
            let tolerance = Tolerance::of_rotary_axes();
            let found = tolerance.checks(&Evaluation::of(&approaches, &deviations))[0].value.unwrap();
            assert!((found / arcsec - 20.0).abs() < 1e-6, "{targets} {high}: {}", found / arcsec);
        }
    }
}
