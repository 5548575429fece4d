//! What instruments show of a round surface: contacts on which it rests, and filters of the waves around it.
//!
//! A reading is a sum of the profile r at angles beside its own, r(θ + φ₁)·w₁ + r(θ + φ₂)·w₂ + …, so that of n waves around it
//! shows the part |F(n)| (ISO 4292; D. J. Whitehouse, Handbook of Surface and Nanometrology, 2011, ch. 2):
//!
//! ```text
//!   two contacts that face each other     F = 1 + cos nπ, of the diameter: no odd number of waves shows
//!   three contacts a third apart          F = 2 for n = 3, 6, 9 …, else 0, of the diameter
//!   on a V-block, the dial opposite       F = 1 + cos n(90° + α/2)/sin(α/2), α between the flanks
//!   V-block that rides, the dial in it    F = 1 − cos n(90° − α/2)/sin(α/2)
//!   Gauss filter (ISO 16610-21)           F = 2^(−(n/n_c)²)
//! ```

use std::f64::consts::{FRAC_PI_2, LN_2, PI, TAU};

/// Angle (rad) beside that of a reading, and weight, of each place of the profile of which the reading is the sum.
pub type Places = Vec<(f64, f64)>;

/// Contacts of an instrument on a round surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Contacts {
    /// Two that face each other: a micrometer, a bore gauge. It shows a diameter.
    TwoPoint,
    /// Three a third of a turn apart that centre themselves: a three-point bore gauge. It shows a diameter.
    ThreePoint,
    /// A dial over a V-block on whose flanks, at this included angle (rad), the part rests.
    VBlock(f64),
    /// A V-block at this included angle (rad) that rides on the part, with the dial between its flanks.
    Rider(f64),
}

impl Contacts {
    /// The places whose sum is a reading.
    pub fn places(self) -> Places {
        let pair = |at: f64, weight: f64| vec![(0.0, 1.0), (at, weight), (-at, weight)];
        match self {
            Self::TwoPoint => vec![(0.0, 1.0), (PI, 1.0)],
            Self::ThreePoint => [0.0, TAU / 3.0, -TAU / 3.0].map(|at| (at, 2.0 / 3.0)).into(),
            // The flanks lift the part by the mean of the radii on them over sin(α/2).
            Self::VBlock(angle) => pair(FRAC_PI_2 + 0.5 * angle, 0.5 / (0.5 * angle).sin()),
            Self::Rider(angle) => pair(FRAC_PI_2 - 0.5 * angle, -0.5 / (0.5 * angle).sin()),
        }
    }

    /// F(n): what it shows of n waves around, over their amplitude.
    pub fn factor(self, n: usize) -> f64 {
        factor(&self.places(), n)
    }
}

/// F(n) of places that lie evenly on both sides of a reading.
pub fn factor(places: &[(f64, f64)], n: usize) -> f64 {
    places.iter().map(|(at, weight)| weight * (n as f64 * at).cos()).sum()
}

/// Places of each wave that a filter halves at which its weighting function is told: so many that gauges with two and three
/// contacts have theirs among those of a trace. ISO 12181-2 asks for seven; but of p places a filter lets through again what has
/// p − 1 to p + 1 times as many waves, and seven times as many may be on a part.
pub const PER_WAVE: usize = 18;

/// The places of a Gauss filter that lets half of `cutoff` waves around through: its weighting function over a wave on
/// either side, beyond which it is below 1e-6 of its middle, as closely as it shows waves up to nine times as many.
pub fn gauss(cutoff: usize) -> Places {
    const SIDE: i32 = PER_WAVE as i32;
    let wave = TAU / cutoff as f64;
    let step = wave / f64::from(SIDE);
    // exp(−π(x/(α·λ))²) with α² = ln 2/π, and so 2^(−(n/n_c)²) over n.
    let weight = |i: i32| (-PI * PI / LN_2 * (f64::from(i) * step / wave).powi(2)).exp();
    let sum: f64 = (-SIDE..=SIDE).map(weight).sum();
    (-SIDE..=SIDE).map(|i| (f64::from(i) * step, weight(i) / sum)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Factors of ISO 4292 and of tables of V-blocks, which give two decimals.
    #[test]
    fn factors_are_those_of_the_tables() {
        let v = |degrees: f64| Contacts::VBlock(degrees.to_radians());
        let rider = |degrees: f64| Contacts::Rider(degrees.to_radians());
        let cases = [
            // One wave is a part off its centre, which no contact shows.
            (v(90.0), 1, 0.0),
            (v(60.0), 3, 3.0),
            (v(90.0), 2, 1.0),
            (v(90.0), 3, 2.0),
            (v(90.0), 5, 2.0),
            (v(90.0), 8, 2.414),
            (v(120.0), 2, 1.577),
            (v(120.0), 3, 1.0),
            (v(120.0), 5, 2.0),
            (rider(60.0), 3, 3.0),
            (rider(60.0), 6, -1.0),
            (Contacts::TwoPoint, 2, 2.0),
            (Contacts::TwoPoint, 3, 0.0),
            (Contacts::ThreePoint, 2, 0.0),
            (Contacts::ThreePoint, 3, 2.0),
        ];
        for (contacts, n, expected) in cases {
            assert!((contacts.factor(n) - expected).abs() < 6e-4, "{contacts:?} {n}: {}", contacts.factor(n));
        }
    }

    #[test]
    fn a_filter_halves_the_waves_of_its_cutoff() {
        for cutoff in [15, 50, 150] {
            let places = gauss(cutoff);
            for n in [0, 1, cutoff / 2, cutoff, 2 * cutoff, 3 * cutoff, 7 * cutoff, 9 * cutoff, 12 * cutoff] {
                let exact = 0.5f64.powf((n as f64 / cutoff as f64).powi(2));
                // It ends where it is 6.5e-7 of its middle.
                assert!((factor(&places, n) - exact).abs() < 6.5e-7, "{cutoff} {n}: {}", factor(&places, n));
            }
        }
    }
}
