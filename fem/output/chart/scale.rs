//! Scales: from values to pixels, with round divisions.

use super::data::Axis;
use super::number::minus;
use super::svg::Svg;

/// A straight scale from values to pixels.
#[derive(Clone, Copy, Debug)]
pub struct Scale {
    /// Ends of the values.
    low: f64,
    high: f64,
    /// Pixels of both ends.
    from: f64,
    to: f64,
}

impl Scale {
    /// Spans finite values, a little wider, between two pixels; the ends are those of the axis if it has any.
    pub fn of(axis: &Axis, values: impl Iterator<Item = f64>, [from, to]: [f64; 2]) -> Self {
        let (mut low, mut high) =
            values.filter(|v| v.is_finite()).fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)));
        if !axis.words.is_empty() {
            (low, high) = (-0.5, axis.words.len() as f64 - 0.5);
        } else if low > high {
            (low, high) = (0.0, 1.0);
        } else if high - low <= 1e-12 * low.abs().max(high.abs()) {
            let half = if low == 0.0 { 1.0 } else { 0.1 * low.abs() };
            (low, high) = (low - half, high + half);
        } else {
            let margin = 0.04 * (high - low);
            (low, high) = (low - margin, high + margin);
        }
        (low, high) = axis.limits.filter(|(a, b)| a < b).unwrap_or((low, high));
        Self { low, high, from, to }
    }

    /// The same without the margin: a map ends where its cells do.
    pub fn exact(low: f64, high: f64, [from, to]: [f64; 2]) -> Self {
        Self { low, high, from, to }
    }

    /// Pixel of a value.
    pub fn at(&self, value: f64) -> f64 {
        self.from + (value - self.low) / (self.high - self.low) * (self.to - self.from)
    }

    /// Whether a value lies on the scale.
    pub fn holds(&self, value: f64) -> bool {
        let slack = 1e-9 * (self.high - self.low);
        (self.low - slack..=self.high + slack).contains(&value)
    }

    /// Round values, about so many, with their texts.
    pub fn ticks(&self, axis: &Axis, about: f64) -> Vec<(f64, String)> {
        if !axis.words.is_empty() {
            return axis.words.iter().enumerate().map(|(i, word)| (i as f64, word.clone())).collect();
        }
        let step = round_above((self.high - self.low) / about);
        let decimals = (-step.log10().floor()).clamp(0.0, 9.0) as usize;
        let first = (self.low / step - 1e-9).ceil() as i64;
        let last = (self.high / step + 1e-9).floor() as i64;
        let tick = |i: i64| (i as f64 * step, minus(format!("{:.decimals$}", i as f64 * step)));
        (first..=last.min(first + 50)).map(tick).collect()
    }
}

/// Least of 1, 2 and 5 times a power of ten that is not below `value`.
fn round_above(value: f64) -> f64 {
    let power = 10f64.powf(value.log10().floor());
    let digit = value / power;
    power * [1.0, 2.0, 5.0].into_iter().find(|d| digit <= d * (1.0 + 1e-12)).unwrap_or(10.0)
}

/// The frame of a plane: its edges in pixels.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    pub left: f64,
    pub right: f64,
    pub top: f64,
    pub bottom: f64,
}

impl Frame {
    /// Draws lines of the grid with their numbers, and the names of the axes.
    pub fn axes(&self, svg: &mut Svg, (x, xs): (&Axis, &Scale), (y, ys): (&Axis, &Scale)) {
        let Self { left, right, top, bottom } = *self;
        let about = ((right - left) / 75.0).max(2.0);
        for (value, text) in xs.ticks(x, about) {
            let at = xs.at(value);
            svg.push(format!("<path class=\"g\" d=\"M{at:.1} {top:.1}V{bottom:.1}\"/>"));
            svg.text("n", [at, bottom + 16.0], "middle", &text);
        }
        let words = if y.words.is_empty() { ((bottom - top) / 48.0).max(2.0) } else { 0.0 };
        for (value, text) in ys.ticks(y, words) {
            let at = ys.at(value);
            svg.push(format!("<path class=\"g\" d=\"M{left:.1} {at:.1}H{right:.1}\"/>"));
            svg.text("n", [left - 7.0, at + 4.0], "end", &text);
        }
        svg.push(format!("<path class=\"a\" d=\"M{left:.1} {top:.1}V{bottom:.1}H{right:.1}\"/>"));
        svg.text("x", [0.5 * (left + right), bottom + 36.0], "middle", &x.label());
        svg.text("x", [left - 50.0, top - 12.0], "start", &y.label());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn divisions_are_round_and_lie_inside() {
        let axis = Axis::new("x", "mm");
        let scale = Scale::of(&axis, [0.0, 600.0].into_iter(), [0.0, 100.0]);
        // 648 over 6 is 108: of 1, 2 and 5 times ten the next is 200.
        let texts: Vec<String> = scale.ticks(&axis, 6.0).into_iter().map(|t| t.1).collect();
        assert_eq!(texts, ["0", "200", "400", "600"]);
        // A margin of 4 % on either side: 0 stands at 24/648 of the way.
        assert!((scale.at(0.0) - 100.0 * 24.0 / 648.0).abs() < 1e-12);
        let small = Scale::of(&axis, [-0.011, 0.012].into_iter(), [0.0, 1.0]);
        let texts: Vec<String> = small.ticks(&axis, 5.0).into_iter().map(|t| t.1).collect();
        assert_eq!(texts, ["\u{2212}0.010", "\u{2212}0.005", "0.000", "0.005", "0.010"]);
    }

    #[test]
    fn what_is_constant_or_nothing_has_a_scale_too() {
        let axis = Axis::new("x", "");
        for values in [vec![], vec![0.0], vec![7.0, 7.0], vec![f64::NAN], vec![-1e-30]] {
            let scale = Scale::of(&axis, values.iter().copied(), [0.0, 1.0]);
            assert!(scale.at(7.0).is_finite() && !scale.ticks(&axis, 5.0).is_empty(), "{values:?}");
        }
    }
}
