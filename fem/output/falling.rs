//! The error falling, effect by effect, as SVG: one bar a model from zero on, with the noise as a line; and beneath it what is
//! left on parts.

use super::chart::{Axis, Svg};
use super::text::micro;
use crate::units::UnitSymbol;

/// The error of a model and of what was added to it step by step.
pub struct Falling {
    /// In a few words.
    pub title: String,
    /// A label and the root mean square error of each step.
    pub steps: Vec<(String, f64)>,
    /// Errors of another kind on the same scale, beneath a line that says of which: of parts against their drawing.
    pub apart: Option<(String, Vec<(String, f64)>)>,
    /// Standard uncertainty of the measurements.
    pub noise: f64,
    /// Unit of both.
    pub unit: UnitSymbol,
}

/// Width of the figure and of the bars at their longest, and where they begin, in pixels: labels stand above them, so that
/// all of it is legible on a phone.
const WIDTH: f64 = 680.0;
const LONGEST: f64 = 540.0;
const LEFT: f64 = 16.0;
/// Heights of the title, of one step and of its bar, and of a label above its bar, in pixels.
const TITLE: f64 = 44.0;
const STEP: f64 = 42.0;
const BAR: f64 = 16.0;
const LABEL: f64 = 18.0;
/// Width of a number with its unit, in pixels.
const NUMBER: f64 = 80.0;
/// Bars are on a logarithmic scale where the smallest is below this part of the largest, and say so.
const LEAST: f64 = 0.01;
/// Bars on such a scale begin at this part of what is smallest.
const BELOW: f64 = 0.5;

impl Falling {
    /// Draws it.
    pub fn svg(&self) -> Svg {
        let beneath = self.apart.iter().flat_map(|(_, bars)| bars);
        let all: Vec<&(String, f64)> = self.steps.iter().chain(beneath).collect();
        let sizes = || all.iter().map(|s| s.1).chain([self.noise]).filter(|v| v.is_finite() && *v > 0.0);
        let (low, high) = (sizes().fold(f64::INFINITY, f64::min), sizes().fold(0.0, f64::max));
        let is_logarithmic = low < LEAST * high;
        let length = |value: f64| match is_logarithmic {
            true if value > BELOW * low => LONGEST * (value / (BELOW * low)).ln() / (high / (BELOW * low)).ln(),
            false if value > 0.0 => LONGEST * value / high,
            _ => 0.0,
        };
        let gap = self.apart.as_ref().map_or(0.0, |_| STEP);
        let foot = TITLE + STEP * all.len() as f64 + gap;
        let words: Vec<String> = all.iter().map(|(l, e)| format!("{l}: {}", self.shown(*e))).collect();
        let scale = if is_logarithmic { "; logarithmic scale" } else { "" };
        let mut svg = Svg::new([WIDTH, foot + 30.0], &self.title, &words.join("; "));
        svg.text("t", [LEFT, 28.0], "start", &self.title);
        let noise = LEFT + length(self.noise);
        svg.axes = vec![Axis::new("root mean square error", self.unit)];
        for (i, (label, error)) in all.into_iter().enumerate() {
            let is_apart = i >= self.steps.len();
            let (y, long) = (TITLE + STEP * i as f64 + if is_apart { gap } else { 0.0 }, length(*error));
            let class = match i {
                0 => "b first",
                _ if is_apart => "b d3",
                _ => "b",
            };
            svg.text("x", [LEFT, y + LABEL - 5.0], "start", label);
            let top = y + LABEL;
            svg.push(format!(
                "<rect class=\"{class}\" x=\"{LEFT}\" y=\"{top:.1}\" width=\"{long:.1}\" height=\"{BAR}\"/>"
            ));
            // Beyond the line of the noise, where the number would stand on it.
            let end = LEFT + long + 8.0;
            let end = if (end - 10.0..end + NUMBER).contains(&noise) { noise + 8.0 } else { end };
            svg.text("x", [end, top + 0.5 * BAR + 4.5], "start", &self.shown(*error));
            svg.mark([LEFT + long, top + 0.5 * BAR], label, &[*error]);
            // Beside the bars alone: labels stand between them.
            svg.push(format!("<path class=\"y\" d=\"M{noise:.1} {:.1}v{:.1}\"/>", top, BAR + 4.0));
        }
        if let Some((of, _)) = &self.apart {
            let above = TITLE + STEP * self.steps.len() as f64;
            svg.text("t", [LEFT, above + 0.5 * STEP + 7.0], "start", of);
        }
        svg.text("s", [LEFT, foot + 18.0], "start", &format!("broken line: noise {}{scale}", self.shown(self.noise)));
        svg
    }

    /// An error with its unit as people read it.
    fn shown(&self, error: f64) -> String {
        micro(&format!("{error:.3} {}", self.unit))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(steps: &[(&str, f64)], apart: &[(&str, f64)], noise: f64) -> String {
        let owned = |all: &[(&str, f64)]| all.iter().map(|(label, error)| (label.to_string(), *error)).collect();
        let apart = (!apart.is_empty()).then(|| ("of the parts".to_string(), owned(apart)));
        let unit = UnitSymbol::new("um");
        Falling { title: "R & D".into(), steps: owned(steps), apart, noise, unit }.svg().file()
    }

    fn bars(text: &str, key: &str) -> Vec<f64> {
        let bar = |bar: &str| {
            let value = bar.split(&format!(" {key}=\"")).nth(1).unwrap();
            value.split('"').next().unwrap().parse().unwrap()
        };
        text.split("<rect").skip(1).map(bar).collect()
    }

    #[test]
    fn bars_are_as_long_as_the_error_is_large() {
        let text = drawn(&[("a < b", 8.0), ("+ c", 4.0), ("+ d", 2.0)], &[], 1.0);
        let expected = [LONGEST, 0.5 * LONGEST, 0.25 * LONGEST];
        assert!(bars(&text, "width").iter().zip(expected).all(|(b, e)| (b - e).abs() <= 0.05), "{text}");
        assert!(text.contains("a &lt; b") && text.contains("R &amp; D") && text.contains("8.000 \u{b5}m"), "{text}");
        assert!(!text.contains("logarithmic"), "{text}");
    }

    #[test]
    fn equal_ratios_are_equal_lengths_where_errors_are_far_apart_and_that_is_said() {
        let text = drawn(&[("a", 2048.0), ("+ b", 64.0), ("+ c", 2.0)], &[], 1.0);
        // From half of 1 on: 2048 is twelve doublings away, 64 seven, 2 two.
        let expected = [12.0, 7.0, 2.0].map(|doublings| doublings / 12.0 * LONGEST);
        assert!(bars(&text, "width").iter().zip(expected).all(|(b, e)| (b - e).abs() <= 0.05), "{text}");
        assert!(text.contains("logarithmic scale"), "{text}");
    }

    #[test]
    fn what_is_left_on_parts_stands_apart_on_the_same_scale() {
        let text = drawn(&[("a", 8.0), ("+ b", 1.0)], &[("made again", 2.0)], 1.0);
        let places = bars(&text, "y");
        assert_eq!([places[1] - places[0], places[2] - places[1]], [STEP, 2.0 * STEP]);
        let long = bars(&text, "width");
        assert!((long[2] - 0.25 * LONGEST).abs() <= 0.05 && (long[1] - 0.125 * LONGEST).abs() <= 0.05);
        assert!(text.contains("of the parts") && text.contains("class=\"b d3\""), "{text}");
    }

    #[test]
    fn a_perfect_model_is_drawn_too() {
        let text = drawn(&[("a", 0.0)], &[], 0.0);
        assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
    }
}
