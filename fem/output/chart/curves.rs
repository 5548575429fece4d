//! Curves over an axis, labelled at their ends.

use super::data::{Axis, Chart, Form, Point, Series};
use super::scale::{Frame, Scale};
use super::style::COLOURS;
use super::svg::Svg;
use super::thin::{Drawn, FROM, thinned};

/// Size of the picture, pixels.
const SIZE: [f64; 2] = [680.0, 380.0];
/// Edges of the plane; on the right follow the labels.
const LEFT: f64 = 64.0;
const TOP: f64 = 78.0;
const BOTTOM: f64 = SIZE[1] - 52.0;
/// Width of a letter of a label, and most pixels that labels take.
const LETTER: f64 = 7.4;
const WIDEST: f64 = 190.0;
/// Least distance between labels, pixels.
const APART: f64 = 15.0;

pub fn draw(chart: &Chart, x: &Axis, y: &Axis, series: &[Series]) -> Svg {
    let mut svg = Svg::new(SIZE, &chart.title, &chart.note);
    svg.text("t", [14.0, 24.0], "start", &chart.title);
    svg.text("s", [14.0, 43.0], "start", &chart.note);
    let longest = series.iter().map(|s| s.label.chars().count()).max().unwrap_or(0);
    let right = SIZE[0] - (LETTER * longest as f64 + 18.0).clamp(20.0, WIDEST);
    let frame = Frame { left: LEFT, right, top: TOP, bottom: BOTTOM };
    let points = || series.iter().flat_map(|s| &s.points);
    let xs = Scale::of(x, points().map(|p| p.x), [LEFT, right]);
    let ys = Scale::of(y, points().filter(|p| p.x.is_finite()).flat_map(Point::ends), [BOTTOM, TOP]);
    frame.axes(&mut svg, (x, &xs), (y, &ys));
    if y.words.is_empty() && ys.holds(0.0) {
        svg.line("z", [[LEFT, ys.at(0.0)], [right, ys.at(0.0)]]);
    }
    svg.axes = vec![x.clone(), y.clone(), Axis::new("\u{b1}", y.unit.clone())];
    for one in series {
        plot(&mut svg, one, &xs, &ys);
        if !matches!(one.form, Form::Band) {
            mark(&mut svg, one, &xs, &ys);
        }
    }
    labels(&mut svg, series, &ys, right);
    svg
}

fn plot(svg: &mut Svg, series: &Series, xs: &Scale, ys: &Scale) {
    let colour = series.colour % COLOURS.len();
    let at = |p: &Point| [xs.at(p.x), ys.at(p.y)];
    let class = match series.form {
        Form::Line => format!("c c{colour}"),
        Form::Dashed => format!("c h c{colour}"),
        Form::Faint => format!("c f c{colour}"),
        Form::Band => return band(svg, series, xs, ys, colour),
        Form::Dots => return dots(svg, series, xs, ys, colour),
    };
    svg.line(&class, series.points.iter().map(at));
}

fn band(svg: &mut Svg, series: &Series, xs: &Scale, ys: &Scale, colour: usize) {
    let there = || series.points.iter().filter(|p| p.x.is_finite() && p.y.is_finite());
    let edge = |end: usize| thinned(there().map(|p| [xs.at(p.x), ys.at(p.ends()[end])]).collect());
    let corners: Vec<String> =
        edge(1).into_iter().chain(edge(0).into_iter().rev()).map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
    svg.push(format!("<polygon class=\"w d{colour}\" points=\"{}\"/>", corners.join(" ")));
}

fn dots(svg: &mut Svg, series: &Series, xs: &Scale, ys: &Scale, colour: usize) {
    let size = if series.points.len() > 400 { 2.0 } else { 2.8 };
    let there = || series.points.iter().filter(|p| p.x.is_finite() && p.y.is_finite() && ys.holds(p.y));
    let is_many = series.points.len() > FROM;
    let (mut of_bars, mut of_dots) = (Drawn::default(), Drawn::default());
    let bars: String = there()
        .filter(|p| p.u.is_finite())
        .map(|p| {
            let [low, high] = p.ends().map(|v| ys.at(v));
            let x = xs.at(p.x);
            // Bars that hide behind their dots, or others, are not drawn.
            let is_seen = low - high > 2.0 * size && (!is_many || of_bars.is_new(&[x, low, high]));
            if is_seen { format!("M{x:.1} {low:.1}V{high:.1}") } else { String::new() }
        })
        .collect();
    if !bars.is_empty() {
        svg.push(format!("<path class=\"e c{colour}\" d=\"{bars}\"/>"));
    }
    // One path of round caps: a tenth of the bytes of so many circles.
    let places = there().map(|p| [xs.at(p.x), ys.at(p.y)]).filter(|at| !is_many || of_dots.is_new(at));
    let caps: String = places.map(|[x, y]| format!("M{x:.1} {y:.1}h0")).collect();
    svg.push(format!("<path class=\"c c{colour}\" style=\"stroke-width:{:.1}\" d=\"{caps}\"/>", 2.0 * size));
}

fn mark(svg: &mut Svg, series: &Series, xs: &Scale, ys: &Scale) {
    let there = series.points.iter().filter(|p| ys.holds(p.y));
    let marks = there.map(|p| ([xs.at(p.x), ys.at(p.y)], vec![p.x, p.y, p.u]));
    svg.mark_all(&series.label, marks, series.points.len());
}

/// Writes each label beside the rightmost point of its series, as near as others allow.
fn labels(svg: &mut Svg, series: &[Series], ys: &Scale, right: f64) {
    let end = |s: &Series| {
        let last = s
            .points
            .iter()
            .filter(|p| p.x.is_finite() && p.y.is_finite())
            .reduce(|a, b| if b.x >= a.x { b } else { a })?;
        Some(ys.at(last.y))
    };
    let mut places: Vec<(f64, &Series)> =
        series.iter().filter(|s| !s.label.is_empty()).filter_map(|s| Some((end(s)?, s))).collect();
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut free = TOP;
    for place in &mut places {
        place.0 = place.0.clamp(free, f64::INFINITY);
        free = place.0 + APART;
    }
    // What was pushed below the plane is pushed back up.
    let mut floor = BOTTOM + 4.0;
    for place in places.iter_mut().rev() {
        place.0 = place.0.min(floor);
        floor = place.0 - APART;
    }
    for (y, one) in places {
        let colour = one.colour % COLOURS.len();
        svg.text(&format!("d{colour}"), [right + 8.0, y + 4.0], "start", &one.label);
    }
}
