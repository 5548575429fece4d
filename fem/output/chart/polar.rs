//! Deviations from a circle, magnified, with circles of equal deviation.

use super::data::{Axis, Chart, Form, Point, Series};
use super::scale::Scale;
use super::style::COLOURS;
use super::svg::Svg;
use super::thin::{Drawn, FROM};

/// Size of the picture, pixels.
const SIZE: [f64; 2] = [680.0, 520.0];
const MIDDLE: [f64; 2] = [270.0, 288.0];
/// Radii of the innermost and the outermost circle.
const RADII: [f64; 2] = [60.0, 200.0];

pub fn draw(chart: &Chart, y: &Axis, series: &[Series]) -> Svg {
    let mut svg = Svg::new(SIZE, &chart.title, &chart.note);
    svg.text("t", [14.0, 24.0], "start", &chart.title);
    svg.text("s", [14.0, 43.0], "start", &chart.note);
    let values = series.iter().flat_map(|s| s.points.iter().flat_map(Point::ends));
    let radius = Scale::of(y, values.chain([0.0]), RADII);
    let at = |degrees: f64, r: f64| {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        [MIDDLE[0] + r * cosine, MIDDLE[1] - r * sine]
    };
    for spoke in (0..12).map(|i| 30.0 * f64::from(i)) {
        svg.line("g", [at(spoke, RADII[0]), at(spoke, RADII[1] + 6.0)]);
        let [x, top] = at(spoke, RADII[1] + 22.0);
        svg.text("n", [x, top + 4.0], "middle", &format!("{spoke}\u{b0}"));
    }
    for (value, text) in radius.ticks(y, 4.0) {
        let class = if value == 0.0 { "o" } else { "g" };
        let r = radius.at(value);
        svg.push(format!("<circle class=\"{class}\" cx=\"{}\" cy=\"{}\" r=\"{r:.1}\"/>", MIDDLE[0], MIDDLE[1]));
        let [x, top] = at(75.0, r);
        svg.text("n", [x + 2.0, top - 2.0], "start", &text);
    }
    svg.axes = vec![Axis::new("angle", "\u{b0}"), y.clone()];
    for one in series {
        let colour = one.colour % COLOURS.len();
        let places: Vec<[f64; 2]> = one.points.iter().map(|p| at(p.x, radius.at(p.y))).collect();
        match one.form {
            Form::Dots | Form::Band => {
                let mut drawn = Drawn::default();
                let seen = places.iter().filter(|at| places.len() <= FROM || drawn.is_new(*at));
                let caps: String = seen.map(|[x, y]| format!("M{x:.1} {y:.1}h0")).collect();
                svg.push(format!("<path class=\"c c{colour}\" style=\"stroke-width:5\" d=\"{caps}\"/>"));
            }
            form => {
                let class = match form {
                    Form::Dashed => "c h",
                    Form::Faint => "c f",
                    _ => "c",
                };
                // Points all around are joined to a ring.
                let gap = one.points.windows(2).map(|w| w[1].x - w[0].x).fold(0.0, f64::max);
                let is_closed = match (one.points.first(), one.points.last()) {
                    (Some(a), Some(b)) => a.x + 360.0 - b.x <= 1.5 * gap,
                    _ => false,
                };
                let again = places.first().copied().filter(|_| is_closed);
                svg.line(&format!("{class} c{colour}"), places.iter().copied().chain(again));
            }
        }
        let marks = one.points.iter().zip(&places).map(|(point, place)| (*place, vec![point.x, point.y]));
        svg.mark_all(&one.label, marks, one.points.len());
    }
    let mut top = 92.0;
    for one in series.iter().filter(|s| !s.label.is_empty()) {
        let colour = one.colour % COLOURS.len();
        let drawn = if one.form == Form::Dots { "stroke-width:5;stroke-dasharray:0 9" } else { "stroke-width:2" };
        svg.push(format!("<path class=\"c c{colour}\" style=\"{drawn}\" d=\"M525 {top:.1}h20\"/>"));
        svg.text(&format!("d{colour}"), [552.0, top + 4.5], "start", &one.label);
        top += 22.0;
    }
    svg.text("x", [524.0, top + 10.0], "start", &y.label());
    svg
}
