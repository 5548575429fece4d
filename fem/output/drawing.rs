//! Draws contours with magnified deviations as SVG: one file that any browser opens, legible on light and
//! dark backgrounds.

use super::chart::{Axis, COLOURS, Svg, grouped};
use crate::process::{Drawing, Spot, round_below};

/// Side of the square that the drawing fills, and heights of title and one line of the legend, in pixels.
const SIDE: f64 = 640.0;
const TITLE: f64 = 44.0;
const LINE: f64 = 22.0;
/// Margin from the edge to the outermost line, in pixels.
const MARGIN: f64 = 34.0;
/// Largest drawn deviation, as a part of the contour's size.
const REACH: f64 = 0.42;
/// Largest drawn deviation, as a part of the radius of curvature on that side: beyond its centre lines would cross.
const CURVED: f64 = 0.8;
/// Size below which deviations count as none, m.
const NONE: f64 = 1e-9;
/// Most spots of a curve at which values can be asked for.
const MOST_MARKS: usize = 400;

/// Makes the drawing.
pub fn drawing(drawing: &Drawing) -> Svg {
    let frame = Frame::of(drawing);
    let height = TITLE + SIDE + LINE * (drawing.curves.len() as f64 + 3.0);
    let mut svg = Svg::new([SIDE, height], &drawing.title, &frame.caption());
    svg.text("t", [SIDE / 2.0, 28.0], "middle", &drawing.title);
    svg.axes = vec![Axis::new("x", "mm"), Axis::new("y", "mm"), Axis::new("deviation", "um")];
    let mut labels = frame.axes(&mut svg);
    frame.grid(&mut svg, &drawing.nominal, &mut labels);
    for curve in &drawing.curves {
        let colour = curve.family % COLOURS.len();
        for piece in &curve.pieces {
            let at = |spot: &Spot| frame.place(spot.magnified(frame.magnification));
            match curve.is_measured {
                true => dots(&mut svg, piece.iter().map(at), colour),
                false => svg.line(&format!("c c{colour}"), piece.iter().map(at)),
            }
            for spot in piece.iter().step_by(piece.len().div_ceil(MOST_MARKS).max(1)) {
                svg.mark(at(spot), &curve.label, &[1e3 * spot.at[0], 1e3 * spot.at[1], 1e6 * spot.deviation]);
            }
        }
    }
    legend(&mut svg, drawing, &frame);
    svg
}

/// Position and scale of the plane on the page, and magnification of deviations.
struct Frame {
    /// Pixels per metre of the contour.
    scale: f64,
    /// Middle of the contour, m.
    middle: [f64; 2],
    /// Half of the size of the contour, m.
    half: f64,
    /// Magnification: metres drawn, on the contour's own scale, per metre of deviation.
    magnification: f64,
    /// Distance between lines of the grid, m of deviation.
    division: f64,
    /// Number of lines on either side of the contour.
    lines: i32,
}

impl Frame {
    fn of(drawing: &Drawing) -> Self {
        let spots =
            || drawing.nominal.iter().flatten().chain(drawing.curves.iter().flat_map(|c| c.pieces.iter().flatten()));
        let end = |i: usize, pick: fn(f64, f64) -> f64| spots().map(|s| s.at[i]).reduce(pick).unwrap_or(0.0);
        let (low, high) = ([0, 1].map(|i| end(i, f64::min)), [0, 1].map(|i| end(i, f64::max)));
        let half = [0, 1].map(|i| 0.5 * (high[i] - low[i])).into_iter().fold(1e-9, f64::max);
        let largest = spots().fold(NONE, |size, s| size.max(s.deviation.abs()));
        let most = (REACH * half / largest)
            .min(CURVED * drawing.nominal.iter().map(|p| bend(p, largest)).fold(f64::INFINITY, f64::min));
        let magnification = round_below(most);
        let division = round_below(largest / 2.0);
        let lines = (largest / division).ceil() as i32;
        let middle = [0, 1].map(|i| 0.5 * (low[i] + high[i]));
        // The outermost line of the grid, which at corners reaches farther than deviations are large.
        let off = division * f64::from(lines);
        let reach = |s: &Spot| {
            let [x, y] = s.off_by(off).magnified(magnification);
            (x - middle[0]).abs().max((y - middle[1]).abs())
        };
        let outermost = drawing.nominal.iter().flatten().map(reach).fold(half + magnification * off, f64::max);
        let scale = (0.5 * SIDE - MARGIN) / outermost;
        Self { scale, middle, half, magnification, division, lines }
    }

    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [x, y] = [x - self.middle[0], y - self.middle[1]];
        [0.5 * SIDE + self.scale * x, TITLE + 0.5 * SIDE - self.scale * y]
    }

    /// Draws the axes, and gives the places of their letters.
    fn axes(&self, svg: &mut Svg) -> Vec<[f64; 2]> {
        let reach = 0.5 * SIDE - MARGIN + 8.0;
        let [x, y] = self.place(self.middle);
        svg.line("g", [[x - reach, y], [x + reach, y]]);
        svg.line("g", [[x, y - reach], [x, y + reach]]);
        let letters = [[x + reach + 10.0, y + 4.0], [x, y - reach - 6.0]];
        svg.text("n", letters[0], "middle", "x");
        svg.text("n", letters[1], "middle", "y");
        letters.into()
    }

    /// Draws the contour, and lines of equal deviation beside it, labelled near the diagonal where no other label
    /// stands.
    fn grid(&self, svg: &mut Svg, nominal: &[Vec<Spot>], labels: &mut Vec<[f64; 2]>) {
        // Zero is labelled first, then what lies farthest from it.
        let mut order: Vec<i32> = (-self.lines..=self.lines).collect();
        order.sort_by_key(|i| if *i == 0 { i32::MIN } else { -i.abs() });
        for i in order {
            let off = f64::from(i) * self.division;
            // A grid that is magnified further than the contour is wide has no inside.
            if self.half + self.magnification * off <= 0.02 * self.half {
                continue;
            }
            let class = if i == 0 { "o" } else { "g" };
            let mut label = None;
            for piece in nominal {
                let places = piece.iter().map(|spot| self.place(spot.off_by(off).magnified(self.magnification)));
                svg.line(class, places.clone());
                let diagonal = |[x, y]: [f64; 2]| {
                    let [x, y] = [x - 0.5 * SIDE, TITLE + 0.5 * SIDE - y];
                    // The label stands nearest to 22.5° above the x axis, where curves of two axes seldom
                    // have their crests.
                    (y.atan2(x) - std::f64::consts::FRAC_PI_8).abs()
                };
                label = places.chain(label).min_by(|a, b| diagonal(*a).total_cmp(&diagonal(*b)));
            }
            let is_free = |[x, y]: &[f64; 2]| labels.iter().all(|[a, b]| (x - a).abs() > 34.0 || (y - b).abs() > 13.0);
            if let Some([x, y]) = label.map(|[x, y]| [x + 3.0, y - 3.0]).filter(is_free) {
                let shown = if i == 0 { "0".to_string() } else { format!("{:+}", micrometres(off)) };
                svg.text("n", [x, y], "start", &shown);
                labels.push([x, y]);
            }
        }
    }

    /// Scale of the drawing, in words.
    fn caption(&self) -> String {
        format!(
            "deviations magnified {} times, {} um from line to line, outwards positive",
            grouped(self.magnification),
            micrometres(self.division)
        )
    }
}

/// Magnification at which a line at the largest deviation beside a piece would reach the nearest centre of curvature.
fn bend(piece: &[Spot], largest: f64) -> f64 {
    let radius = |w: &[Spot]| {
        let [dx, dy] = [w[1].at[0] - w[0].at[0], w[1].at[1] - w[0].at[1]];
        let turned = w[0].outward[0] * w[1].outward[1] - w[0].outward[1] * w[1].outward[0];
        // A corner has no centre: both of its sides are moved in parallel.
        if turned.abs() > 0.3 { f64::INFINITY } else { dx.hypot(dy) / turned.abs().max(1e-12) }
    };
    piece.windows(2).map(radius).filter(|r| *r > 0.0).fold(f64::INFINITY, f64::min) / largest
}

fn dots(svg: &mut Svg, places: impl Iterator<Item = [f64; 2]>, colour: usize) {
    let caps: String = places.map(|[x, y]| format!("M{x:.1} {y:.1}h0")).collect();
    svg.push(format!("<path class=\"c c{colour}\" style=\"stroke-width:3.8\" d=\"{caps}\"/>"));
}

fn legend(svg: &mut Svg, drawing: &Drawing, frame: &Frame) {
    let mut y = TITLE + SIDE + 8.0;
    for curve in &drawing.curves {
        let colour = curve.family % COLOURS.len();
        match curve.is_measured {
            true => dots(svg, [40.0, 52.0, 64.0].into_iter().map(|x| [x, y]), colour),
            false => svg.line(&format!("c c{colour}"), [[36.0, y], [68.0, y]]),
        }
        svg.text("x", [80.0, y + 4.5], "start", &curve.label);
        y += LINE;
    }
    svg.line("o", [[36.0, y], [68.0, y]]);
    svg.text("x", [80.0, y + 4.5], "start", "as it should be, to scale");
    svg.text("x", [80.0, y + LINE + 4.5], "start", &frame.caption());
}

/// Converts to micrometres, without the digits that conversion leaves.
fn micrometres(si: f64) -> f64 {
    format!("{:.6e}", 1e6 * si).parse().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::process::Curve;

    /// A circle of 100 mm that stands out by 7 um at 90 deg.
    fn circle() -> Drawing {
        let spot = |i: i32| {
            let (sine, cosine) = f64::from(5 * i).to_radians().sin_cos();
            Spot { at: [0.1 * cosine, 0.1 * sine], outward: [cosine, sine], deviation: 0.0 }
        };
        let nominal: Vec<Spot> = (0..=72).map(spot).collect();
        let off = nominal.iter().map(|s| s.off_by(7e-6 * s.outward[1])).collect();
        let curve = |is_measured, pieces| Curve { label: "a < b".into(), family: 0, is_measured, pieces };
        Drawing {
            name: "circle",
            title: "R & D".into(),
            curves: vec![curve(false, vec![off]), curve(true, vec![nominal.clone()])],
            nominal: vec![nominal],
        }
    }

    #[test]
    fn deviations_are_drawn_to_the_stated_scale() {
        let drawing = circle();
        let frame = Frame::of(&drawing);
        // 0.42·100 mm over 7 um is 6000: of 1, 2 and 5, 5000 is the largest below. Lines at 2 um, four of
        // them.
        assert!((frame.magnification - 5000.0).abs() < 1e-6 && (frame.division - 2e-6).abs() < 1e-15);
        assert_eq!(frame.lines, 4);
        let top = drawing.curves[0].pieces[0][18];
        let [x, y] = frame.place(top.magnified(frame.magnification));
        let [_, middle] = frame.place([0.0, 0.0]);
        assert!((x - SIDE / 2.0).abs() < 1e-9);
        assert!(((middle - y) / frame.scale - (0.1 + 5000.0 * 7e-6)).abs() < 1e-12);
        let text = super::drawing(&drawing).file();
        assert!(text.contains("magnified 5\u{202f}000 times, 2 um from line to line"), "{text}");
        // A title is text and no element.
        assert!(text.contains("R &amp; D") && text.contains("a &lt; b"));
        assert!(!text.contains("NaN") && !text.contains("inf"));
    }

    #[test]
    fn labels_do_not_overlap() {
        // So flat that the lines stand close together above each other.
        let mut drawing = circle();
        let squeezed = |s: &Spot| Spot { at: [s.at[0], 0.05 * s.at[1]], ..*s };
        drawing.nominal.iter_mut().flatten().for_each(|s| *s = squeezed(s));
        drawing.curves.iter_mut().flat_map(|c| &mut c.pieces).flatten().for_each(|s| *s = squeezed(s));
        // Of the flat one the letters of the axes and the contour itself at least.
        for (drawing, least) in [(circle(), 5), (drawing, 3)] {
            let text = super::drawing(&drawing).file();
            // Left and right end, and base line; a character is some seven pixels wide.
            let labels: Vec<[f64; 3]> = text
                .lines()
                .filter(|l| l.starts_with("<text class=\"n\""))
                .map(|l| {
                    let number =
                        |key: &str| l.split(key).nth(1).unwrap().split('"').next().unwrap().parse::<f64>().unwrap();
                    let shown = l.split('>').nth(1).unwrap().split('<').next().unwrap();
                    let left = number(" x=\"") - if l.contains("middle") { 3.0 } else { 0.0 };
                    [left, left + 6.8 * shown.chars().count() as f64, number(" y=\"")]
                })
                .collect();
            assert!(labels.len() >= least, "{text}");
            let is_apart = |a: &[f64; 3], b: &[f64; 3]| a[1] < b[0] || b[1] < a[0] || (a[2] - b[2]).abs() > 10.0;
            for (i, own) in labels.iter().enumerate() {
                assert!(labels[..i].iter().all(|other| is_apart(own, other)), "{text}");
            }
        }
    }

    #[test]
    fn a_contour_without_deviation_is_drawn_too() {
        let mut drawing = circle();
        drawing.curves.truncate(0);
        assert!(!super::drawing(&drawing).file().contains("NaN"));
        assert!(!super::drawing(&Drawing::default()).file().contains("NaN"));
    }

    #[test]
    fn lines_stay_outside_of_the_centres_of_curvature() {
        // A nose of 2 mm on a body of 100 mm: 0.1 mm of deviation may be drawn 16 times, and is drawn 10 times.
        let mut drawing = circle();
        let nose = |i: i32| {
            let (sine, cosine) = f64::from(5 * i).to_radians().sin_cos();
            Spot { at: [0.102 + 0.002 * cosine, 0.002 * sine], outward: [cosine, sine], deviation: 0.0 }
        };
        drawing.nominal.push((-18..=18).map(nose).collect());
        drawing.curves[0].pieces[0][0].deviation = -1e-4;
        let magnification = Frame::of(&drawing).magnification;
        assert!((magnification - 10.0).abs() < 1e-9, "{magnification}");
    }
}
