//! How the friction of the slide goes along the travel: gibs that are tighter at one end, a guideway that is dry or
//! worn in places.

use crate::input::{Along, Reader, Record, Varying};
use crate::units::{FORCE, LENGTH};

/// Friction along the travel as a multiple of its mean. Its shape is measured; how large it is an effect says.
#[derive(Clone, Debug, PartialEq)]
pub struct Drag {
    measured: Varying,
    /// Mean over the travel, N.
    mean: f64,
}

impl Drag {
    /// Reads `drag` or `drag_points` of an axis that travels from `from` to `to` (m); `None` without either.
    pub fn read(t: &Reader, [from, to]: [f64; 2]) -> Option<Self> {
        let along = Along { name: "position", kind: LENGTH, needed: [from, to] };
        let about = "friction of the slide along the travel; `friction` of elastic-lost-motion is its mean";
        let recorded = t.quantity("drag", FORCE, about).not_negative().optional_varying(along);
        let points = t.list("drag_points", "the same at places, linear between", |t, _| {
            let at = t.quantity("at", LENGTH, "position").required();
            [at, t.quantity("drag", FORCE, "friction there").not_negative().required()]
        });
        if recorded.is_some() && !points.is_empty() {
            t.problem("drag_points", "`drag` says it already", "leave one of them out");
        }
        if points.windows(2).any(|pair| pair[1][0] <= pair[0][0]) {
            t.problem("drag_points", "the places do not rise", "give them from the smallest position on, each once");
        }
        let ends = points.first().zip(points.last());
        let slack = 1e-9 * (to - from).abs();
        if ends.is_some_and(|(first, last)| first[0] > from + slack || last[0] < to - slack) {
            let [from, to] = [from, to].map(|x| LENGTH.format(x));
            let help = format!("the axis travels from {from} to {to}: begin and end there, or beyond");
            t.problem("drag_points", "they do not reach over the travel", help);
        }
        let measured = recorded.or_else(|| Some(Varying::Record(Record::new(points)?.into())))?;
        let mean = match &measured {
            Varying::Constant(value) => *value,
            Varying::Record(record) => record.straightened(0.5 * (from + to), [from, to]),
        };
        if mean == 0.0 {
            t.problem(
                "drag",
                "nothing drags anywhere on the travel",
                "leave it out, or record it where the slide goes",
            );
        }
        Some(Self { measured, mean })
    }

    /// Friction at a position (m) over its mean.
    pub fn at(&self, position: f64) -> f64 {
        self.measured.at(position) / self.mean
    }
}
