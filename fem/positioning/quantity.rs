//! The quantities of ISO 230-2, with their names and formulas.

use super::{Direction, Evaluation, Side, Target};

/// A quantity of an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    /// The standard's letter; + and − stand for ↑ and ↓.
    pub symbol: &'static str,
    /// Name of the quantity.
    pub name: &'static str,
    /// Formula of the quantity.
    pub formula: &'static str,
    /// Value, m; `None` where the test does not give it: a direction is missing, or there is a single run.
    pub value: Option<f64>,
    /// The target that decides it, m, where it is one.
    pub at: Option<f64>,
}

impl Quantity {
    /// The value of a quantity in a list.
    pub fn find(all: &[Self], symbol: &str) -> Option<f64> {
        all.iter().find(|q| q.symbol == symbol).and_then(|q| q.value)
    }
}

/// (value, where)
type Found = (Option<f64>, Option<f64>);

impl Evaluation {
    /// A = max(x̄_i + 2s_i) − min(x̄_i − 2s_i) over both directions, m.
    pub fn accuracy(&self) -> Option<f64> {
        Quantity::find(&self.quantities(), "A")
    }

    /// R = max R_i, m.
    pub fn repeatability(&self) -> Option<f64> {
        Quantity::find(&self.quantities(), "R")
    }

    /// All quantities, the whole axis first.
    pub fn quantities(&self) -> Vec<Quantity> {
        let both = &Direction::BOTH[..];
        let (forward, backward) = (&[Direction::Forward][..], &[Direction::Backward][..]);
        let rows: [(&str, &str, &str, Found); 12] = [
            ("A", "positioning accuracy", "max(mean + 2s) - min(mean - 2s), both directions", self.spread(both, true)),
            ("A+", "positioning accuracy, forward", "max(mean + 2s) - min(mean - 2s)", self.spread(forward, true)),
            ("A-", "positioning accuracy, backward", "max(mean + 2s) - min(mean - 2s)", self.spread(backward, true)),
            ("E", "systematic positioning error", "max(mean) - min(mean), both directions", self.spread(both, false)),
            ("E+", "systematic positioning error, forward", "max(mean) - min(mean)", self.spread(forward, false)),
            ("E-", "systematic positioning error, backward", "max(mean) - min(mean)", self.spread(backward, false)),
            ("M", "mean bidirectional positioning error", "max(mean of both) - min(mean of both)", self.mean_spread()),
            ("R", "repeatability", "max(2s+ + 2s- + |B_i|, 4s+, 4s-)", self.largest(Target::repeatability)),
            ("R+", "repeatability, forward", "max(4s)", self.largest_of(Direction::Forward)),
            ("R-", "repeatability, backward", "max(4s)", self.largest_of(Direction::Backward)),
            ("B", "reversal error", "max |mean+ - mean-|", self.largest(|t| t.reversal().map(f64::abs))),
            ("B_mean", "mean reversal error", "mean of mean+ - mean-", self.mean_reversal()),
        ];
        rows.map(|(symbol, name, formula, (value, at))| Quantity { symbol, name, formula, value, at }).into()
    }

    /// Largest upper less smallest lower end of the means, or of the bands of 2s about them.
    fn spread(&self, directions: &[Direction], with_scatter: bool) -> Found {
        let mut range = (f64::INFINITY, f64::NEG_INFINITY);
        let mut complete = true;
        for direction in directions {
            let sides: Vec<&Side> = self.targets.iter().filter_map(|t| t.side(*direction)).collect();
            complete &= !sides.is_empty();
            for side in sides {
                let Some((low, high)) = (if with_scatter { side.band() } else { Some((side.mean, side.mean)) }) else {
                    complete = false;
                    continue;
                };
                range = (range.0.min(low), range.1.max(high));
            }
        }
        (complete.then_some(range.1 - range.0), None)
    }

    fn mean_spread(&self) -> Found {
        let means: Vec<f64> = self.targets.iter().filter_map(Target::mean).collect();
        let high = means.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let low = means.iter().copied().fold(f64::INFINITY, f64::min);
        ((!means.is_empty()).then_some(high - low), None)
    }

    fn mean_reversal(&self) -> Found {
        let all: Vec<f64> = self.targets.iter().filter_map(Target::reversal).collect();
        ((!all.is_empty()).then(|| all.iter().sum::<f64>() / all.len() as f64), None)
    }

    fn largest_of(&self, direction: Direction) -> Found {
        self.largest(|t| t.side(direction).and_then(Side::repeatability))
    }

    fn largest(&self, of: impl Fn(&Target) -> Option<f64>) -> Found {
        let all = self.targets.iter().filter_map(|t| Some((of(t)?, t.position)));
        let found = all.fold(None, |best: Option<(f64, f64)>, one| best.filter(|b| b.0 >= one.0).or(Some(one)));
        (found.map(|f| f.0), found.map(|f| f.1))
    }
}
