//! Figures and charts of a positioning test by ISO 230-2, of axes that travel and of axes that turn.

use super::{Datum, Figure, Plot, first_extreme};
use crate::positioning::{Approach, Direction, EDITION, Evaluation, Measures, Quantity, Target};
use crate::units::{ANGLE, LENGTH};

/// Quantities with a figure of their own: letter, key and label.
const LETTERS: [(&str, &str, &str); 5] = [
    ("A", "accuracy", "  A accuracy"),
    ("E", "systematic", "  E systematic error"),
    ("M", "mean_bidirectional", "  M mean of both ways"),
    ("R", "repeatability", "  R repeatability"),
    ("B", "reversal", "  B reversal error"),
];

/// A predicted positioning test: its approaches and the deviation of each, SI.
pub struct Tested<'a> {
    /// Approaches, in the order of the rows.
    pub approaches: &'a [Approach],
    /// Deviation of each.
    pub deviations: &'a [f64],
    /// In what they are told.
    pub measures: Measures,
}

impl Tested<'_> {
    /// Its largest and its smallest deviation, then the quantities of ISO 230-2.
    pub fn figures(&self, evaluation: &Evaluation) -> Vec<Figure> {
        let quantities = evaluation.quantities();
        let mut figures = vec![
            self.extreme("largest", "largest deviation", f64::gt),
            self.extreme("smallest", "smallest deviation", f64::lt),
            self.standard(&quantities),
        ];
        figures.extend(LETTERS.iter().filter_map(|letter| self.quantity(&quantities, *letter)));
        figures
    }

    /// The mean deviation of a direction.
    pub fn plot(&self, evaluation: &Evaluation, direction: Direction) -> Plot {
        let Measures { position: place, deviation: small } = self.measures;
        let point = |t: &Target| Some((place.from_si(t.position), small.from_si(t.side(direction)?.mean)));
        let (named, x_unit): (&str, &'static str) =
            if self.measures.is_rotary() { ("angle", &ANGLE.unit) } else { ("position", &LENGTH.unit) };
        let unit = small.unit;
        Plot {
            title: format!("mean deviation [{unit}] over {named} [{x_unit}], approached in {}", direction.sign()),
            x_unit,
            points: evaluation.targets.iter().filter_map(point).collect(),
        }
    }

    fn extreme(&self, key: &'static str, label: &'static str, beats: fn(&f64, &f64) -> bool) -> Figure {
        let Measures { position: place, deviation: small } = self.measures;
        let row = first_extreme(self.deviations, beats);
        let (value, at) = (self.deviations[row], self.approaches[row]);
        let (shown, position, sign) = (small.shown(value), place.shown(at.position), at.direction.sign());
        Figure::new(key, label)
            .quantity("value", small, value)
            .quantity(if self.measures.is_rotary() { "angle" } else { "position" }, place, at.position)
            .entry("direction", sign)
            .entry("run", at.run as usize)
            .line(format!("{shown:+.3} at {position:.1} approached in {sign}, run {}", at.run))
    }

    /// All quantities of ISO 230-2.
    fn standard(&self, quantities: &[Quantity]) -> Figure {
        let record = |q: &Quantity| {
            let [symbol, name, formula] = [q.symbol, q.name, q.formula].map(Datum::from);
            Datum::record([("symbol", symbol), ("name", name), ("formula", formula), ("value", self.known(q.value))])
        };
        Figure::new("iso230", EDITION)
            .line("of this prediction, which has no scatter: s is what drifts from run to run")
            .entry("edition", EDITION)
            .entry("quantities", Datum::List(quantities.iter().map(record).collect()))
    }

    fn quantity(&self, all: &[Quantity], (letter, key, label): (&str, &'static str, &'static str)) -> Option<Figure> {
        let Measures { position: place, deviation: small } = self.measures;
        let found = all.iter().find(|q| q.symbol == letter)?;
        let at = found.at.map_or(String::new(), |at| format!(" at {:.1}", place.shown(at)));
        let text = found.value.map_or("needs two runs".into(), |v| format!("{:.3}{at}", small.shown(v)));
        Some(Figure::new(key, label).entry("value", self.known(found.value)).line(text))
    }

    /// Datum of a quantity of ISO 230-2, NaN where the test does not give it.
    fn known(&self, value: Option<f64>) -> Datum {
        Datum::of(self.measures.deviation, value.unwrap_or(f64::NAN))
    }
}
