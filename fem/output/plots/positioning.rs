//! A positioning test as ISO 230-2 draws it: means of both directions, twice their scatter, and the readings.

use crate::output::chart::{Axis, Chart, Form, Plane, Point, Series};
use crate::positioning::{Direction, EDITION, Evaluation, Quantity, Side};
use crate::process::{Positioning, Rows};

/// The chart of readings (SI) of the rows of a test; beside them those that a model predicts.
pub fn chart(
    (test, rows): (&dyn Positioning, &Rows),
    readings: &[f64],
    what: &str,
    predicted: Option<&[f64]>,
) -> Chart {
    let (approaches, measures) = (&test.approaches(rows), test.measures());
    let (place, small) = (measures.position, measures.deviation);
    let evaluation = Evaluation::of(approaches, readings);
    let foretold = predicted.map(|values| Evaluation::of(approaches, values));
    let mut series = Vec::new();
    for (colour, direction) in Direction::BOTH.into_iter().enumerate() {
        let of = |evaluation: &Evaluation, value: &dyn Fn(&Side) -> Option<f64>| -> Vec<Point> {
            let point = |t: &crate::positioning::Target| {
                let y = t.side(direction).and_then(value)?;
                Some(Point::new(place.from_si(t.position), small.from_si(y)))
            };
            evaluation.targets.iter().filter_map(point).collect()
        };
        let named = |label: &str, form, points| Series::new(label, colour, form, points);
        let own = approaches.iter().zip(readings).filter(|(a, _)| a.direction == direction);
        let dots = own.map(|(a, y)| Point::new(place.from_si(a.position), small.from_si(*y))).collect();
        series.push(named("", Form::Dots, dots));
        for end in [|s: &Side| s.band().map(|b| b.1), |s: &Side| s.band().map(|b| b.0)] {
            series.push(named("", Form::Dashed, of(&evaluation, &end)));
        }
        let sign = direction.sign().replace('-', "\u{2212}");
        series.push(named(&format!("mean {sign}"), Form::Line, of(&evaluation, &|s| Some(s.mean))));
        if let Some(foretold) = &foretold {
            series.push(named("", Form::Faint, of(foretold, &|s| Some(s.mean))));
        }
    }
    let quantities = evaluation.quantities();
    let told = |symbol: &str| Some(format!("{symbol} {:.2}", small.from_si(Quantity::find(&quantities, symbol)?)));
    let told: Vec<String> = ["A", "E", "M", "R", "B"].into_iter().filter_map(told).collect();
    let beside = if foretold.is_some() { "; pale: predicted means" } else { "" };
    Chart {
        name: "positioning".into(),
        title: format!("{what} positioning test ({EDITION})"),
        note: format!("{} {}; broken: mean \u{b1} 2s{beside}", told.join(", "), small.unit),
        plane: Plane::Curves {
            x: Axis::new(if measures.is_rotary() { "angle" } else { "position" }, place.unit),
            y: Axis::new("deviation", small.unit),
            series: series.into_iter().filter(|s: &Series| !s.points.is_empty()).collect(),
        },
    }
}
