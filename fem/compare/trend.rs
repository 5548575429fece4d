//! Trend of a residual along one coordinate, in words that a machinist understands.

/// Simplest curve that follows the residual along a coordinate. Values are in the units of the residual and
/// the coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Trend {
    /// A straight line.
    Linear {
        /// Change per unit of the coordinate.
        slope: f64,
    },
    /// A parabola.
    Quadratic {
        /// Height above the chord between the ends, positive upward.
        height: f64,
        /// Turning point.
        at: f64,
    },
    /// A step.
    Step {
        /// Value above the step less value below it.
        height: f64,
        /// Middle of the two values between which it steps.
        at: f64,
    },
    /// A wave.
    Periodic {
        /// Number of periods over the measured range.
        periods: f64,
    },
    /// None of these.
    Irregular,
}

/// Height of a bow, as a part of what the line rises from end to end, below which it is slight: a parabola that turns
/// at an end has twice as much.
const SLIGHT: f64 = 0.125;

/// Part of the scatter of a curve that a line follows at least, to be told as one.
const LINE: f64 = 0.1;

impl Trend {
    /// Whether it is a line that says next to nothing of a curve (x, mean).
    pub fn is_flat(&self, curve: &[(f64, f64)]) -> bool {
        let Self::Linear { slope } = *self else { return false };
        let scatter = |of: fn(&(f64, f64)) -> f64| {
            let mean = curve.iter().map(of).sum::<f64>() / curve.len() as f64;
            curve.iter().map(|p| (of(p) - mean).powi(2)).sum::<f64>()
        };
        slope * slope * scatter(|p| p.0) < LINE * scatter(|p| p.1)
    }

    /// Word in JSON.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Linear { .. } => "linear",
            Self::Quadratic { .. } => "quadratic",
            Self::Step { .. } => "step",
            Self::Periodic { .. } => "periodic",
            Self::Irregular => "irregular",
        }
    }

    /// Selects the trend of the points (x, mean, weight) by Schwarz's criterion (BIC). `variance` is that of
    /// a point of weight 1.
    pub fn of(points: &[(f64, f64, f64)], variance: f64) -> Self {
        let line = polynomial(points, 1);
        let bow = polynomial(points, 2);
        let step = step(points);
        let bic = |left: f64, parameters: f64| left / variance + parameters * (points.len() as f64).ln();
        let mut best = (bic(line.1, 2.0), Self::Linear { slope: line.0[1] });
        if points.len() > 3 {
            let all = line.0[1] * (points[points.len() - 1].0 - points[0].0);
            // A line that bends a little is a line to whoever reads of it.
            let bowed = match bowed(points, &bow.0) {
                Self::Quadratic { height, .. } if height.abs() < SLIGHT * all.abs() => best.1,
                bowed => bowed,
            };
            let quadratic = (bic(bow.1, 3.0), bowed);
            let stepped = (bic(step.1, 3.0), Self::Step { height: step.0.0, at: step.0.1 });
            for candidate in [quadratic, stepped] {
                if candidate.0 < best.0 {
                    best = candidate;
                }
            }
            // One free value per point always fits; it wins only where every trend leaves much.
            if bic(0.0, points.len() as f64) < best.0 {
                best.1 = Self::Irregular;
            }
        }
        best.1
    }
}

fn bowed(points: &[(f64, f64, f64)], c: &[f64; 3]) -> Trend {
    let (low, high) = (points[0].0, points[points.len() - 1].0);
    let half = 0.5 * (high - low);
    Trend::Quadratic { height: -c[2] * half * half, at: (-0.5 * c[1] / c[2]).clamp(low, high) }
}

/// Weighted least squares of degree ≤ 2: coefficients and weighted sum of squared residuals.
fn polynomial(points: &[(f64, f64, f64)], degree: usize) -> ([f64; 3], f64) {
    let (low, high) = (points[0].0, points[points.len() - 1].0);
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
    let size = degree + 1;
    let basis = |x: f64| nalgebra::Vector3::new(1.0, (x - middle) / half, ((x - middle) / half).powi(2));
    let (mut a, mut b) = (nalgebra::Matrix3::zeros(), nalgebra::Vector3::zeros());
    for &(x, y, w) in points {
        let mut p = basis(x);
        p.iter_mut().skip(size).for_each(|v| *v = 0.0);
        a += w * p * p.transpose();
        b += w * y * p;
    }
    (size..3).for_each(|i| a[(i, i)] = 1.0);
    let c = a.cholesky().map_or(nalgebra::Vector3::zeros(), |l| l.solve(&b));
    let left = points.iter().map(|&(x, y, w)| w * (y - c.dot(&basis(x))).powi(2)).sum();
    // Coefficients over (x − m)/h become coefficients over x.
    let (c1, c2) = (c[1] / half, c[2] / (half * half));
    ([c[0] - c1 * middle + c2 * middle * middle, c1 - 2.0 * c2 * middle, c2], left)
}

/// Best single step: (height, place) and weighted sum of squared residuals.
fn step(points: &[(f64, f64, f64)]) -> ((f64, f64), f64) {
    let mut best = ((0.0, points[0].0), f64::INFINITY);
    for i in 1..points.len() {
        let mean = |part: &[(f64, f64, f64)]| {
            let weight: f64 = part.iter().map(|p| p.2).sum();
            part.iter().map(|p| p.1 * p.2).sum::<f64>() / weight
        };
        let (below, above) = (mean(&points[..i]), mean(&points[i..]));
        let left =
            points.iter().enumerate().map(|(j, p)| p.2 * (p.1 - if j < i { below } else { above }).powi(2)).sum();
        if left < best.1 {
            best = ((above - below, 0.5 * (points[i - 1].0 + points[i].0)), left);
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(law: impl Fn(f64) -> f64) -> Vec<(f64, f64, f64)> {
        (0..10).map(|i| (f64::from(i), law(f64::from(i)), 4.0)).collect()
    }

    #[test]
    fn shapes_are_recognised_with_their_numbers() {
        let Trend::Linear { slope } = Trend::of(&points(|x| 3.0 - 2.0 * x), 1e-3) else { panic!("a line") };
        assert!((slope + 2.0).abs() < 1e-12);
        let Trend::Quadratic { height, at } = Trend::of(&points(|x| -(x - 4.5).powi(2)), 1e-3) else { panic!("a bow") };
        assert!((height - 20.25).abs() < 1e-9 && (at - 4.5).abs() < 1e-9);
        let Trend::Step { height, at } = Trend::of(&points(|x| if x < 6.0 { 1.0 } else { 4.0 }), 1e-3) else {
            panic!("a step")
        };
        assert!((height - 3.0).abs() < 1e-12 && (at - 5.5).abs() < 1e-12);
        assert_eq!(Trend::of(&points(|x| (7.0 * x * x).sin()), 1e-3), Trend::Irregular);
    }

    #[test]
    fn a_line_through_ups_and_downs_is_flat() {
        let curve = |slope: f64| -> Vec<(f64, f64)> {
            (0..20).map(|i| (f64::from(i), slope * f64::from(i) + f64::from(i).cos())).collect()
        };
        for (slope, is_flat) in [(0.0, true), (0.01, true), (-0.5, false)] {
            assert_eq!(Trend::Linear { slope }.is_flat(&curve(slope)), is_flat, "{slope}");
        }
    }
}
