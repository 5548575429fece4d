//! Draws a machine to scale, its deflection magnified by a round number.

use super::chart::{Axis, Svg, grouped};
use crate::process::{Part, Sketch, round_below};

/// Width of the picture, its largest and smallest height, and its margins, pixels.
const WIDTH: f64 = 760.0;
const TALLEST: f64 = 560.0;
const LOWEST: f64 = 250.0;
const SIDES: f64 = 110.0;
const TOP: f64 = 130.0;
const FOOT: f64 = 96.0;
/// Length of the longest arrow, of a spring, and largest drawn deflection, pixels.
const ARROW: f64 = 52.0;
const SPRING: f64 = 40.0;
const REACH: f64 = 34.0;
/// Deflections below this count as none, m.
const NONE: f64 = 1e-12;

/// Makes the drawing.
pub fn sketch(sketch: &Sketch) -> Svg {
    let places = || sketch.parts.iter().flat_map(places);
    let end = |i: usize, pick: fn(f64, f64) -> f64| places().map(|p| p[i]).reduce(pick).unwrap_or(0.0);
    let (low, high) = ([0, 1].map(|i| end(i, f64::min)), [0, 1].map(|i| end(i, f64::max)));
    let size = [0, 1].map(|i| (high[i] - low[i]).max(1e-9));
    let scale = ((WIDTH - 2.0 * SIDES) / size[0]).min((TALLEST - TOP - FOOT) / size[1]);
    let height = (scale * size[1] + TOP + FOOT).max(LOWEST);
    let middle = [0.5 * WIDTH, 0.5 * (height + TOP - FOOT)];
    let at = |p: [f64; 2]| {
        [middle[0] + scale * (p[0] - 0.5 * (low[0] + high[0])), middle[1] - scale * (p[1] - 0.5 * (low[1] + high[1]))]
    };
    let moved = sketch.parts.iter().flat_map(|part| match part {
        Part::Bent(line) => line.iter().map(|(_, d)| d[0].hypot(d[1])).collect(),
        _ => Vec::new(),
    });
    let largest = moved.fold(0.0, f64::max);
    let magnification = if largest > NONE { round_below(REACH / scale / largest) } else { 1.0 };
    let forces = sketch.parts.iter().map(|part| match part {
        Part::Force { force, .. } => force[0].hypot(force[1]),
        _ => 0.0,
    });
    let strongest = forces.fold(f64::MIN_POSITIVE, f64::max);
    let note = match largest > NONE {
        true => format!(
            "to scale; the deflection is magnified {} times, {:.3} um at most",
            grouped(magnification),
            1e6 * largest
        ),
        false => "to scale".to_string(),
    };
    let mut svg = Svg::new([WIDTH, height], &sketch.title, &note);
    svg.text("t", [14.0, 24.0], "start", &sketch.title);
    svg.text("s", [14.0, 43.0], "start", &note);
    svg.axes = vec![Axis::new("x", "mm"), Axis::new("displacement", "um")];
    for part in &sketch.parts {
        match part {
            Part::Body(lines) => {
                let line = |l: &Vec<[f64; 2]>| {
                    let corners: Vec<String> = l.iter().map(|p| format!("{:.1} {:.1}", at(*p)[0], at(*p)[1])).collect();
                    format!("M{}Z", corners.join("L"))
                };
                let path: String = lines.iter().map(line).collect();
                svg.push(format!("<path class=\"body\" fill-rule=\"evenodd\" d=\"{path}\"/>"));
            }
            Part::Bent(line) => {
                let drawn = |(p, d): &([f64; 2], [f64; 2])| at([0, 1].map(|i| p[i] + magnification * d[i]));
                svg.line("z", line.iter().map(|(p, _)| at(*p)));
                svg.line("c c1", line.iter().map(drawn));
                for one in line {
                    let [dx, dy] = one.1;
                    let size = if dx.abs() > dy.abs() { dx } else { dy };
                    svg.mark(drawn(one), "", &[1e3 * one.0[0], 1e6 * size]);
                }
            }
            Part::Spring { at: p, away, label } => spring(&mut svg, at(*p), [away[0], -away[1]], label),
            Part::Support { at: p, away, label } => support(&mut svg, at(*p), [away[0], -away[1]], label),
            Part::Force { at: p, force, label } => {
                let along = [force[0] / strongest, -force[1] / strongest].map(|c| ARROW * c);
                arrow(&mut svg, at(*p), along, label);
            }
        }
    }
    svg
}

/// Every place of a part.
fn places(part: &Part) -> Vec<[f64; 2]> {
    match part {
        Part::Body(lines) => lines.iter().flatten().copied().collect(),
        Part::Bent(line) => line.iter().map(|(p, _)| *p).collect(),
        Part::Spring { at, .. } | Part::Support { at, .. } | Part::Force { at, .. } => vec![*at],
    }
}

/// Writes a label beyond the end of what stands away from a body.
fn beyond(svg: &mut Svg, [x, y]: [f64; 2], [u, v]: [f64; 2], label: &str) {
    let anchor = match u {
        u if u > 0.5 => "start",
        u if u < -0.5 => "end",
        _ => "middle",
    };
    let down = if v > 0.5 {
        15.0
    } else if v < -0.5 {
        -6.0
    } else {
        4.0
    };
    svg.text("n", [x + 6.0 * u, y + down], anchor, label);
}

/// A zigzag from a body to the ground.
fn spring(svg: &mut Svg, [x, y]: [f64; 2], [u, v]: [f64; 2], label: &str) {
    let along = |part: f64, beside: f64| [x + SPRING * part * u - beside * v, y + SPRING * part * v + beside * u];
    let teeth = (0..6).map(|i| along(0.2 + 0.1 * f64::from(i) + 0.05, if i % 2 == 0 { 7.0 } else { -7.0 }));
    let line = [along(0.0, 0.0), along(0.2, 0.0)].into_iter().chain(teeth).chain([along(0.8, 0.0), along(1.0, 0.0)]);
    svg.line("c c0", line.collect::<Vec<_>>());
    ground(svg, along(1.0, 0.0), [u, v]);
    beyond(svg, along(1.2, 0.0), [u, v], label);
}

/// A wedge on the ground.
fn support(svg: &mut Svg, [x, y]: [f64; 2], [u, v]: [f64; 2], label: &str) {
    let along = |far: f64, beside: f64| [x + far * u - beside * v, y + far * v + beside * u];
    let [a, b, c] = [along(0.0, 0.0), along(16.0, 10.0), along(16.0, -10.0)];
    svg.push(format!(
        "<path class=\"held\" d=\"M{:.1} {:.1}L{:.1} {:.1}L{:.1} {:.1}Z\"/>",
        a[0], a[1], b[0], b[1], c[0], c[1]
    ));
    ground(svg, along(16.0, 0.0), [u, v]);
    beyond(svg, along(24.0, 0.0), [u, v], label);
}

/// Draws the ground: a line with hatches.
fn ground(svg: &mut Svg, [x, y]: [f64; 2], [u, v]: [f64; 2]) {
    let along = |far: f64, beside: f64| [x + far * u - beside * v, y + far * v + beside * u];
    svg.line("o", [along(0.0, -14.0), along(0.0, 14.0)]);
    for i in 0..5 {
        let beside = -12.0 + 6.0 * f64::from(i);
        svg.line("k", [along(0.0, beside), along(6.0, beside - 4.0)]);
    }
}

/// An arrow that ends where the force acts.
fn arrow(svg: &mut Svg, [x, y]: [f64; 2], [dx, dy]: [f64; 2], label: &str) {
    let length = dx.hypot(dy);
    if length < 1.0 {
        return;
    }
    let [u, v] = [dx / length, dy / length];
    svg.line("c c3", [[x - dx, y - dy], [x - 6.0 * u, y - 6.0 * v]]);
    let wing = |side: f64| [x - 11.0 * u - side * v, y - 11.0 * v + side * u];
    let [a, b] = [wing(5.0), wing(-5.0)];
    svg.push(format!("<path class=\"d d3\" d=\"M{x:.1} {y:.1}L{:.1} {:.1}L{:.1} {:.1}Z\"/>", a[0], a[1], b[0], b[1]));
    beyond(svg, [x - dx, y - dy], [-u, -v], label);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_are_to_scale_and_deflections_magnified_by_a_round_number() {
        let line = (0..=10).map(|i| ([0.06 * f64::from(i), 0.0], [0.0, 40e-6])).collect();
        let parts = vec![
            Part::rectangle([0.0, -0.02], [0.6, 0.02]),
            Part::Bent(line),
            Part::Spring { at: [0.0, 0.0], away: [0.0, -1.0], label: "60 N/um & more".into() },
            Part::Force { at: [0.3, -0.02], force: [0.0, 450.0], label: "450 N".into() },
        ];
        let svg = sketch(&Sketch { title: "Shaft".into(), parts });
        // 540 pixels for 600 mm; 34 pixels over 40 um are 944 times: 500 of 1, 2 and 5.
        assert!(svg.about.contains("magnified 500 times, 40.000 um"), "{}", svg.about);
        let text = svg.file();
        assert!(text.contains("M110.0 ") && text.contains("L650.0 ") && text.contains("60 N/um &amp; more"), "{text}");
        // 36 pixels of body between the margins above and below.
        let up = svg.marks[0].at[1] - 0.5 * (36.0 + TOP + FOOT + TOP - FOOT);
        assert!((up + 500.0 * 40e-6 * 540.0 / 0.6).abs() < 1e-9, "{up}");
    }

    #[test]
    fn nothing_is_drawn_too() {
        assert!(!sketch(&Sketch::default()).file().contains("NaN"));
    }
}
