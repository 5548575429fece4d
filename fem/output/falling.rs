//! The error falling, effect by effect, as SVG: one bar a model, on a logarithmic scale down to the noise.

use std::fmt::Write;

use super::svg::escaped;

/// The error of a model and of what was added to it step by step.
pub struct Falling {
    /// In a few words.
    pub title: String,
    /// A label and the root mean square error of each step.
    pub steps: Vec<(String, f64)>,
    /// Standard uncertainty of the measurements.
    pub noise: f64,
    /// Unit of both.
    pub unit: &'static str,
}

/// Width of the page, of the labels and of the bars at their longest, in pixels.
const WIDTH: f64 = 760.0;
const LABELS: f64 = 210.0;
const LONGEST: f64 = 460.0;
/// Heights of the title, of one step and of its bar, in pixels.
const TITLE: f64 = 48.0;
const STEP: f64 = 38.0;
const BAR: f64 = 22.0;
/// Bars begin at this part of what is smallest.
const BELOW: f64 = 0.5;

impl Falling {
    /// The drawing as an `<svg>` element that stands for itself.
    pub fn svg(&self) -> String {
        let sizes = || self.steps.iter().map(|s| s.1).chain([self.noise]).filter(|v| v.is_finite() && *v > 0.0);
        let (low, high) = (BELOW * sizes().fold(f64::INFINITY, f64::min), sizes().fold(0.0, f64::max));
        let span = (high / low).ln();
        let length = |value: f64| if value > low { LONGEST * (value / low).ln() / span } else { 0.0 };
        let foot = TITLE + STEP * self.steps.len() as f64;
        let height = foot + 40.0;
        // Writing to a String does not fail, here and below.
        let mut text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" width=\"{WIDTH}\" \
             height=\"{height}\" role=\"img\">\n<title>{title}</title>\n{STYLE}\
             <text class=\"t\" x=\"16\" y=\"28\">{title}</text>\n",
            title = escaped(&self.title),
        );
        for (i, (label, error)) in self.steps.iter().enumerate() {
            let (y, end) = (TITLE + STEP * i as f64, LABELS + length(*error));
            let class = if i == 0 { "b first" } else { "b" };
            let middle = y + 0.5 * BAR + 4.5;
            let _ = writeln!(
                text,
                "<text x=\"{:.1}\" y=\"{middle:.1}\" text-anchor=\"end\">{}</text>\
                 <rect class=\"{class}\" x=\"{LABELS}\" y=\"{y:.1}\" width=\"{:.1}\" height=\"{BAR}\"/>\
                 <text x=\"{:.1}\" y=\"{middle:.1}\">{error:.3} {}</text>",
                LABELS - 10.0,
                escaped(label),
                end - LABELS,
                end + 8.0,
                self.unit,
            );
        }
        let noise = LABELS + length(self.noise);
        let _ = writeln!(
            text,
            "<path class=\"n\" d=\"M{noise:.1} {:.1}V{:.1}\"/>\
             <text class=\"s\" x=\"{noise:.1}\" y=\"{:.1}\" text-anchor=\"middle\">noise {:.3} {}</text>",
            TITLE - 6.0,
            foot + 2.0,
            foot + 18.0,
            self.noise,
            self.unit,
        );
        text.push_str("</svg>\n");
        text
    }
}

/// Legible on light and dark grounds, and to people who see few colours (Okabe and Ito).
const STYLE: &str = "<style>text{font:13px system-ui,sans-serif;fill:#4d4d4d}.t{font-size:16px}.s{font-size:12px}\
    .b{fill:#0072b2}.first{fill:#d55e00}.n{stroke:#00805c;stroke-width:2;stroke-dasharray:5 4;fill:none}\
    @media (prefers-color-scheme:dark){text{fill:#c8c8c8}.b{fill:#56b4e9}.first{fill:#f0a04b}.n{stroke:#2fc79a}}</style>\n";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_ratios_are_equal_lengths() {
        let steps = [("a < b", 8.0), ("+ c", 4.0), ("+ d", 2.0)].map(|(l, v)| (l.to_string(), v));
        let falling = Falling { title: "R & D".into(), steps: steps.into(), noise: 1.0, unit: "um" };
        let text = falling.svg();
        let width = |part: &str| part.split('"').next().unwrap().parse::<f64>().unwrap();
        let bars: Vec<f64> = text.split("<rect").skip(1).map(|r| width(r.split("width=\"").nth(1).unwrap())).collect();
        // From half of 1 on: 8 is four doublings away, 4 three, 2 two.
        let expected = [LONGEST, 0.75 * LONGEST, 0.5 * LONGEST];
        assert!(bars.iter().zip(expected).all(|(b, e)| (b - e).abs() <= 0.05), "{bars:?}");
        assert!(text.contains("a &lt; b") && text.contains("R &amp; D"));
    }

    #[test]
    fn a_perfect_model_is_drawn_too() {
        let falling = Falling { title: String::new(), steps: vec![("a".into(), 0.0)], noise: 0.0, unit: "um" };
        assert!(!falling.svg().contains("NaN") && !falling.svg().contains("inf"), "{}", falling.svg());
    }
}
