//! The tolerance of an axis.

use super::Evaluation;

/// Limits of a machining centre by seed 001: ±0.01 mm on any 300 mm, 0.04 mm over the whole travel, ±0.005 mm
/// of repeatability. m.
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
}

/// One tolerance, held against a test. m.
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
    fn default() -> Self {
        Self { per_length: 10e-6, length: 0.3, travel: 40e-6, repeatability: 5e-6 }
    }
}

impl Check {
    /// Whether the limit is kept; what is not known does not pass.
    pub fn passed(&self) -> bool {
        self.value.is_some_and(|v| v <= self.limit)
    }
}

impl Tolerance {
    /// Accuracy on any `length`, accuracy over the whole, and repeatability, by ISO 230-2's A and R against
    /// the whole width of each band. What is wider apart than a `length` counts as on a straight line: the
    /// widest such stretch begins or ends at a target.
    pub fn checks(&self, evaluation: &Evaluation) -> Vec<Check> {
        let (first, last) = evaluation.ends();
        let places = evaluation.targets.iter().map(|t| t.position);
        let stretches = places.flat_map(|at| [(at, (at + self.length).min(last)), ((at - self.length).max(first), at)]);
        let widest = stretches.filter_map(|(from, to)| evaluation.stretch(from, to).accuracy()).reduce(f64::max);
        let mm = |m: f64| ((m * 1e9).round() / 1e6).to_string();
        let check = |key, name, limit, value| Check { key, name, limit, value };
        vec![
            check("per_length", format!("accuracy A on any {} mm", mm(self.length)), 2.0 * self.per_length, widest),
            check("travel", "accuracy A over all targets".into(), self.travel, evaluation.accuracy()),
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
}
