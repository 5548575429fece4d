//! Draws contours with magnified deviations as SVG: one file that any browser opens, legible on light and
//! dark backgrounds.

use std::fmt::Write;

use crate::process::{Drawing, Spot, round_below};

/// Side of the square that the drawing fills, and heights of title and one line of the legend, in pixels.
const SIDE: f64 = 640.0;
const TITLE: f64 = 44.0;
const LINE: f64 = 22.0;
/// Margin from the edge to the outermost line, in pixels.
const MARGIN: f64 = 34.0;
/// Largest drawn deviation, as a part of the contour's size.
const REACH: f64 = 0.42;
/// How near the outermost line may come to where the contour folds back.
const UNFOLDED: f64 = 0.7;
/// Size below which deviations count as none, m.
const NONE: f64 = 1e-9;
/// Colours of the families, which colour-blind people can tell apart too (Okabe and Ito), darkened or
/// lightened with the background.
const COLOURS: [(&str, &str); 4] =
    [("#0072b2", "#56b4e9"), ("#d55e00", "#f0a04b"), ("#00805c", "#2fc79a"), ("#a8437f", "#e29ac4")];

/// Makes the drawing as an `<svg>` element that stands for itself.
pub fn drawing(drawing: &Drawing) -> String {
    let frame = Frame::of(drawing);
    let families = 1 + drawing.curves.iter().map(|c| c.family).max().unwrap_or(0);
    let height = TITLE + SIDE + LINE * (drawing.curves.len() as f64 + 3.0);
    // Writing to a String does not fail, here and below.
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {SIDE} {height}\" width=\"{SIDE}\" height=\"{height}\" role=\"img\">\n\
         <title>{title}</title>\n{}\
         <text class=\"t\" x=\"{}\" y=\"28\" text-anchor=\"middle\">{title}</text>\n",
        style(families),
        SIDE / 2.0,
        title = escaped(&drawing.title),
    );
    frame.axes(&mut text);
    frame.grid(&mut text, &drawing.nominal);
    for curve in &drawing.curves {
        let colour = curve.family % COLOURS.len();
        for piece in &curve.pieces {
            let at = |spot: &Spot| frame.place(spot.magnified(frame.magnification));
            match curve.is_measured {
                true => dots(&mut text, piece.iter().map(at), colour),
                false => line(&mut text, piece.iter().map(at), &format!("c c{colour}")),
            }
        }
    }
    legend(&mut text, drawing, &frame);
    text.push_str("</svg>\n");
    text
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
        let magnification = round_below((REACH * half / largest).min(UNFOLDED * drawing.folds_at()));
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

    fn axes(&self, text: &mut String) {
        let reach = 0.5 * SIDE - MARGIN + 8.0;
        let [x, y] = self.place(self.middle);
        let _ = writeln!(
            text,
            "<path class=\"a\" d=\"M{:.1} {y:.1}H{:.1}M{x:.1} {:.1}V{:.1}\"/>",
            x - reach,
            x + reach,
            y - reach,
            y + reach
        );
        let _ = writeln!(
            text,
            "<text class=\"n\" x=\"{:.1}\" y=\"{:.1}\" text-anchor=\"middle\">x</text>",
            x + reach + 10.0,
            y + 4.0
        );
        let _ = writeln!(
            text,
            "<text class=\"n\" x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"middle\">y</text>",
            y - reach - 6.0
        );
    }

    /// Draws the contour, and lines of equal deviation beside it, labelled where they cross the diagonal.
    fn grid(&self, text: &mut String, nominal: &[Vec<Spot>]) {
        // The letters of the axes have their places already.
        let [x, y] = self.place(self.middle);
        let reach = 0.5 * SIDE - MARGIN + 8.0;
        let mut taken = vec![Room::of([x + reach + 7.0, y + 4.0], 1), Room::of([x - 3.0, y - reach - 6.0], 1)];
        // The lines next to the contour first: where labels would overlap, theirs stay.
        for i in std::iter::once(0).chain((1..=self.lines).flat_map(|i| [i, -i])) {
            let off = f64::from(i) * self.division;
            // A grid that is magnified further than the contour is wide has no inside.
            if self.half + self.magnification * off <= 0.02 * self.half {
                continue;
            }
            let class = if i == 0 { "o" } else { "g" };
            let mut label = None;
            for piece in nominal {
                let places = piece.iter().map(|spot| self.place(spot.off_by(off).magnified(self.magnification)));
                line(text, places.clone(), class);
                let diagonal = |[x, y]: [f64; 2]| {
                    let [x, y] = [x - 0.5 * SIDE, TITLE + 0.5 * SIDE - y];
                    // The label stands nearest to 22.5° above the x axis, where curves of two axes seldom
                    // have their crests.
                    (y.atan2(x) - std::f64::consts::FRAC_PI_8).abs()
                };
                label = places.chain(label).min_by(|a, b| diagonal(*a).total_cmp(&diagonal(*b)));
            }
            let Some([x, y]) = label else { continue };
            let shown = if i == 0 { "0".to_string() } else { format!("{:+}", micrometres(off)) };
            let room = Room::of([x + 3.0, y - 3.0], shown.len());
            if taken.iter().all(|other| room.is_apart(other)) {
                taken.push(room);
                let _ = writeln!(text, "<text class=\"n\" x=\"{:.1}\" y=\"{:.1}\">{shown}</text>", x + 3.0, y - 3.0);
            }
        }
    }
}

/// What a label takes up on the page, in pixels.
struct Room {
    low: [f64; 2],
    high: [f64; 2],
}

impl Room {
    /// A label of so many characters that begins at a place of its base line.
    fn of([x, y]: [f64; 2], characters: usize) -> Self {
        Self { low: [x - 1.0, y - 10.0], high: [x + 6.8 * characters as f64 + 1.0, y + 3.0] }
    }

    fn is_apart(&self, other: &Self) -> bool {
        (0..2).any(|c| self.high[c] < other.low[c] || other.high[c] < self.low[c])
    }
}

fn line(text: &mut String, places: impl Iterator<Item = [f64; 2]>, class: &str) {
    let _ = write!(text, "<polyline class=\"{class}\" points=\"");
    places.for_each(|[x, y]| {
        let _ = write!(text, "{x:.1},{y:.1} ");
    });
    text.truncate(text.trim_end().len());
    text.push_str("\"/>\n");
}

fn dots(text: &mut String, places: impl Iterator<Item = [f64; 2]>, colour: usize) {
    for [x, y] in places {
        let _ = writeln!(text, "<circle class=\"d d{colour}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"1.8\"/>");
    }
}

fn legend(text: &mut String, drawing: &Drawing, frame: &Frame) {
    let mut y = TITLE + SIDE + 8.0;
    for curve in &drawing.curves {
        let colour = curve.family % COLOURS.len();
        match curve.is_measured {
            true => dots(text, [40.0, 52.0, 64.0].into_iter().map(|x| [x, y]), colour),
            false => line(text, [[36.0, y], [68.0, y]].into_iter(), &format!("c c{colour}")),
        }
        let _ = writeln!(text, "<text x=\"80\" y=\"{:.1}\">{}</text>", y + 4.5, escaped(&curve.label));
        y += LINE;
    }
    line(text, [[36.0, y], [68.0, y]].into_iter(), "o");
    let _ = writeln!(text, "<text x=\"80\" y=\"{:.1}\">as it should be, to scale</text>", y + 4.5);
    let told = format!(
        "deviations magnified {} times, {} um from line to line, outwards positive",
        grouped(frame.magnification),
        micrometres(frame.division)
    );
    let _ = writeln!(text, "<text x=\"80\" y=\"{:.1}\">{told}</text>", y + LINE + 4.5);
}

fn style(families: usize) -> String {
    let colours = |pick: fn(&(&'static str, &'static str)) -> &'static str| {
        let one =
            |(i, c): (usize, &(&'static str, &'static str))| format!(".c{i}{{stroke:{0}}}.d{i}{{fill:{0}}}", pick(c));
        COLOURS.iter().take(families).enumerate().map(one).collect::<String>()
    };
    format!(
        "<style>text{{font:13px system-ui,sans-serif;fill:#4d4d4d}}.t{{font-size:17px}}.n{{font-size:11px;fill:#808080}}\
         .a,.g,.o,.c{{fill:none}}.a{{stroke:#808080;stroke-width:.5;stroke-dasharray:1 3}}.g{{stroke:#808080;stroke-width:.5;stroke-opacity:.45}}\
         .o{{stroke:#808080;stroke-width:1.4}}.c{{stroke-width:1.8;stroke-linejoin:round}}.d{{fill-opacity:.75}}{}\
         @media (prefers-color-scheme:dark){{text{{fill:#c8c8c8}}.n{{fill:#909090}}{}}}</style>\n",
        colours(|c| c.0),
        colours(|c| c.1)
    )
}

/// Converts to micrometres, without the digits that conversion leaves.
fn micrometres(si: f64) -> f64 {
    format!("{:.6e}", 1e6 * si).parse().unwrap_or(f64::NAN)
}

/// Writes a round number with its thousands apart.
fn grouped(value: f64) -> String {
    if value < 1.0 {
        return format!("{value}");
    }
    let digits = format!("{value:.0}");
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i) % 3 == 0 {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

pub(super) fn escaped(text: &str) -> String {
    text.chars().filter(|c| !c.is_control()).collect::<String>().replace('&', "&amp;").replace('<', "&lt;")
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
        let text = super::drawing(&drawing);
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
        for drawing in [circle(), drawing] {
            let text = super::drawing(&drawing);
            let labels: Vec<Room> = text
                .lines()
                .filter(|l| l.starts_with("<text class=\"n\""))
                .map(|l| {
                    let number =
                        |key: &str| l.split(key).nth(1).unwrap().split('"').next().unwrap().parse::<f64>().unwrap();
                    let shown = l.split('>').nth(1).unwrap().split('<').next().unwrap();
                    let middle = if l.contains("middle") { 3.0 } else { 0.0 };
                    Room::of([number(" x=\"") - middle, number(" y=\"")], shown.len())
                })
                .collect();
            assert!(labels.len() > 4, "{text}");
            for (i, own) in labels.iter().enumerate() {
                assert!(labels[..i].iter().all(|other| own.is_apart(other)), "{text}");
            }
        }
    }

    #[test]
    fn a_contour_without_deviation_is_drawn_too() {
        let mut drawing = circle();
        drawing.curves.truncate(0);
        assert!(!super::drawing(&drawing).contains("NaN"));
        assert!(!super::drawing(&Drawing::default()).contains("NaN"));
    }
}
