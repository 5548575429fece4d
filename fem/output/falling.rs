//! The error falling, effect by effect, as SVG: one bar a model, on a logarithmic scale down to the noise; and beneath it what
//! is left on parts.

use super::chart::{Axis, Svg};
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

/// Width of the page, of the labels and of the bars at their longest, in pixels.
const WIDTH: f64 = 760.0;
const LABELS: f64 = 210.0;
const LONGEST: f64 = 460.0;
/// Heights of the title, of one step and of its bar, in pixels.
const TITLE: f64 = 48.0;
const STEP: f64 = 38.0;
const BAR: f64 = 22.0;
/// Width of a number with its unit, in pixels.
const NUMBER: f64 = 80.0;
/// Bars begin at this part of what is smallest.
const BELOW: f64 = 0.5;

impl Falling {
    /// Draws it.
    pub fn svg(&self) -> Svg {
        let beneath = self.apart.iter().flat_map(|(_, bars)| bars);
        let all: Vec<&(String, f64)> = self.steps.iter().chain(beneath).collect();
        let sizes = || all.iter().map(|s| s.1).chain([self.noise]).filter(|v| v.is_finite() && *v > 0.0);
        let (low, high) = (BELOW * sizes().fold(f64::INFINITY, f64::min), sizes().fold(0.0, f64::max));
        let span = (high / low).ln();
        let length = |value: f64| if value > low { LONGEST * (value / low).ln() / span } else { 0.0 };
        let gap = self.apart.as_ref().map_or(0.0, |_| STEP);
        let foot = TITLE + STEP * all.len() as f64 + gap;
        let words: Vec<String> = all.iter().map(|(l, e)| format!("{l}: {e:.3} {}", self.unit)).collect();
        let mut svg = Svg::new([WIDTH, foot + 40.0], &self.title, &words.join("; "));
        svg.text("t", [16.0, 28.0], "start", &self.title);
        let noise = LABELS + length(self.noise);
        svg.axes = vec![Axis::new("root mean square error", self.unit)];
        for (i, (label, error)) in all.into_iter().enumerate() {
            let is_apart = i >= self.steps.len();
            let (y, long) = (TITLE + STEP * i as f64 + if is_apart { gap } else { 0.0 }, length(*error));
            let class = match i {
                0 => "b first",
                _ if is_apart => "b d3",
                _ => "b",
            };
            let middle = y + 0.5 * BAR + 4.5;
            svg.text("x", [LABELS - 10.0, middle], "end", label);
            svg.push(format!(
                "<rect class=\"{class}\" x=\"{LABELS}\" y=\"{y:.1}\" width=\"{long:.1}\" height=\"{BAR}\"/>"
            ));
            // Beyond the line of the noise, where the number would stand on it.
            let end = LABELS + long + 8.0;
            let end = if (end - 10.0..end + NUMBER).contains(&noise) { noise + 8.0 } else { end };
            svg.text("x", [end, middle], "start", &format!("{error:.3} {}", self.unit));
            svg.mark([LABELS + long, y + 0.5 * BAR], label, &[*error]);
        }
        // Not through the words.
        let above = TITLE + STEP * self.steps.len() as f64;
        let broken = self
            .apart
            .as_ref()
            .map_or(String::new(), |_| format!("V{:.1}M{noise:.1} {:.1}", above, above + STEP - 6.0));
        svg.push(format!("<path class=\"y\" d=\"M{noise:.1} {:.1}{broken}V{:.1}\"/>", TITLE - 6.0, foot + 2.0));
        if let Some((of, _)) = &self.apart {
            svg.text("t", [16.0, above + 0.5 * STEP + 5.0], "start", of);
        }
        svg.text("s", [noise, foot + 18.0], "middle", &format!("noise {:.3} {}", self.noise, self.unit));
        svg
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_ratios_are_equal_lengths() {
        let steps = [("a < b", 8.0), ("+ c", 4.0), ("+ d", 2.0)].map(|(l, v)| (l.to_string(), v));
        let falling = Falling {
            title: "R & D".into(),
            steps: steps.into(),
            apart: None,
            noise: 1.0,
            unit: UnitSymbol::new("um"),
        };
        let text = falling.svg().file();
        let width = |part: &str| part.split('"').next().unwrap().parse::<f64>().unwrap();
        let bars: Vec<f64> = text.split("<rect").skip(1).map(|r| width(r.split("width=\"").nth(1).unwrap())).collect();
        // From half of 1 on: 8 is four doublings away, 4 three, 2 two.
        let expected = [LONGEST, 0.75 * LONGEST, 0.5 * LONGEST];
        assert!(bars.iter().zip(expected).all(|(b, e)| (b - e).abs() <= 0.05), "{bars:?}");
        assert!(text.contains("a &lt; b") && text.contains("R &amp; D"));
    }

    #[test]
    fn what_is_left_on_parts_stands_apart_on_the_same_scale() {
        let steps = vec![("a".to_string(), 8.0), ("+ b".to_string(), 1.0)];
        let apart = Some(("of the parts".to_string(), vec![("made again".to_string(), 2.0)]));
        let text = Falling { title: "a".into(), steps, apart, noise: 1.0, unit: UnitSymbol::new("um") }.svg().file();
        let bar = |number: usize, key: &str| {
            let bar = text.split("<rect").nth(number).unwrap();
            bar.split(&format!(" {key}=\"")).nth(1).unwrap().split('"').next().unwrap().parse::<f64>().unwrap()
        };
        assert_eq!([bar(2, "y") - bar(1, "y"), bar(3, "y") - bar(2, "y")], [STEP, 2.0 * STEP]);
        // From half of 1 on: 8 is four doublings away, 1 one and 2 two.
        assert!((bar(3, "width") - 0.5 * LONGEST).abs() <= 0.05 && (bar(2, "width") - 0.25 * LONGEST).abs() <= 0.05);
        assert!(text.contains("of the parts") && text.contains("class=\"b d3\""), "{text}");
    }

    #[test]
    fn a_perfect_model_is_drawn_too() {
        let falling = Falling {
            title: String::new(),
            steps: vec![("a".into(), 0.0)],
            apart: None,
            noise: 0.0,
            unit: UnitSymbol::new("um"),
        };
        assert!(
            !falling.svg().file().contains("NaN") && !falling.svg().file().contains("inf"),
            "{}",
            falling.svg().file()
        );
    }
}
