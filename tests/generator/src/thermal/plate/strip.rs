//! A strip of heat that moves along an edge, or stands.

use super::course::Piece;
use super::direction::Wave;

/// On an edge that begins at 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strip {
    /// Of its middle at the start, m.
    pub middle: f64,
    /// m/s.
    pub speed: f64,
    /// m.
    pub width: f64,
}

impl Strip {
    /// ∫X dx of a wave under the strip, as it enters an edge of this length (m), passes and leaves.
    pub fn meets(&self, wave: &Wave, length: f64) -> Vec<Piece> {
        let [front, rear] = [0.5, -0.5].map(|half| self.middle + half * self.width);
        let passes = [front, rear].into_iter().flat_map(|end| [-end / self.speed, (length - end) / self.speed]);
        let mut times: Vec<f64> = passes.filter(|time| time.is_finite() && *time > 0.0).collect();
        times.extend([0.0, f64::INFINITY]);
        times.sort_by(f64::total_cmp);
        let ends = |lasts: &[f64]| {
            let (from, to) = (lasts[0], lasts[1]);
            [self.up_to(front, wave, length, from, to), self.up_to(rear, wave, length, from, to).times(-1.0)]
        };
        times.windows(2).filter(|lasts| lasts[1] > lasts[0]).flat_map(ends).collect()
    }

    /// The antiderivative of the wave at an end of the strip, which between two times passes no end of the edge.
    fn up_to(&self, end: f64, wave: &Wave, length: f64, from: f64, to: f64) -> Piece {
        let between = if to.is_finite() { 0.5 * (from + to) } else { from + 1.0 };
        let there = end + self.speed * between;
        if self.speed == 0.0 || there <= 0.0 || there >= length {
            return Piece::constant(wave.up_to(there.clamp(0.0, length)), from, to);
        }
        if wave.number == 0.0 {
            return Piece { from, to, constant: end, slope: self.speed, ..Piece::default() };
        }
        // sin(μ(end + vt) − φ)/μ.
        let (sine, cosine) = (wave.number * end - wave.phase).sin_cos();
        let [cosine, sine] = [sine / wave.number, cosine / wave.number];
        Piece { from, to, cosine, sine, frequency: wave.number * self.speed, ..Piece::default() }
    }
}
