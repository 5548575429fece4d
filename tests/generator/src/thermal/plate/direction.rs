//! One direction of a rectangle: a slab that loses heat at either end, by its own waves, and the answer of the whole
//! of it in closed form.
//!
//! ```text
//!   X'' + μ² X = 0,  k X'(0) = h₀ X(0),  −k X'(L) = h₁ X(L):
//!   X = cos(μx − φ),  tan φ = h₀/(kμ),  μL = mπ + atan(h₀/(kμ)) + atan(h₁/(kμ))
//! ```

use std::f64::consts::PI;

use crate::dense::root;

/// Where heat comes in along a direction, or where a temperature is read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Spread {
    /// At one place, m.
    At(f64),
    /// Everywhere, one per metre: of what is read, the integral.
    Even,
}

/// cos(μx − φ).
#[derive(Debug, Clone, Copy)]
pub struct Wave {
    /// μ, 1/m.
    pub number: f64,
    /// φ.
    pub phase: f64,
    /// ∫X² dx, m.
    pub square: f64,
}

/// A slab.
#[derive(Debug)]
pub struct Direction {
    /// L, m.
    pub length: f64,
    /// k, W/(m K).
    conductivity: f64,
    /// h at either end, W/(m² K).
    films: [f64; 2],
    /// The longest first.
    pub waves: Vec<Wave>,
}

impl Wave {
    /// An antiderivative of the wave.
    pub fn up_to(&self, x: f64) -> f64 {
        if self.number == 0.0 { x } else { (self.number * x - self.phase).sin() / self.number }
    }

    /// ∫X·spread dx.
    pub fn meets(&self, spread: Spread, length: f64) -> f64 {
        match spread {
            Spread::At(x) => (self.number * x - self.phase).cos(),
            Spread::Even => self.up_to(length) - self.up_to(0.0),
        }
    }
}

impl Direction {
    /// With so many waves.
    pub fn of(length: f64, conductivity: f64, films: [f64; 2], count: usize) -> Self {
        let [first, last] = films.map(|film| film / conductivity);
        let wave = |m: usize| {
            let turns = m as f64 * PI;
            let lies = |number: f64| number * length - turns - first.atan2(number) - last.atan2(number);
            let number = match first + last {
                0.0 => turns / length,
                _ => root(turns / length, (turns + PI) / length, lies),
            };
            let phase = first.atan2(number);
            let ends = (2.0 * (number * length - phase)).sin() + (2.0 * phase).sin();
            let square = if number == 0.0 { length } else { 0.5 * length + 0.25 * ends / number };
            Wave { number, phase, square }
        };
        Self { length, conductivity, films, waves: (0..count).map(wave).collect() }
    }

    /// What is read of g with −k g'' + k γ² g = heat and the losses at the ends, γ > 0 (1/m).
    pub fn answer(&self, heat: Spread, read: Spread, gamma: f64) -> f64 {
        match (heat, read) {
            (Spread::At(from), Spread::At(to)) => self.influence(from, to, gamma),
            (Spread::At(x), Spread::Even) | (Spread::Even, Spread::At(x)) => self.even(x, gamma),
            (Spread::Even, Spread::Even) => {
                self.balance(self.length, [0.0, self.length].map(|end| self.even(end, gamma)), gamma)
            }
        }
    }

    /// Heat that comes in everywhere: a body at one is kept so by kγ² inside and by h at the ends.
    fn even(&self, x: f64, gamma: f64) -> f64 {
        self.balance(1.0, [0.0, self.length].map(|end| self.influence(end, x, gamma)), gamma)
    }

    fn balance(&self, whole: f64, ends: [f64; 2], gamma: f64) -> f64 {
        (whole - self.films[0] * ends[0] - self.films[1] * ends[1]) / (self.conductivity * gamma * gamma)
    }

    /// Green's function: what satisfies the left end up to the one, times what satisfies the right end from the
    /// other on, over their Wronskian; growing exponentials are taken out.
    fn influence(&self, from: f64, to: f64, gamma: f64) -> f64 {
        let [first, last] = self.films.map(|film| film / (self.conductivity * gamma));
        let (low, high) = (from.min(to), from.max(to));
        let side = |film: f64, away: f64| {
            let (decay, fallen) = ((-2.0 * gamma * away).exp(), -(-2.0 * gamma * away).exp_m1());
            1.0 + decay + film * fallen
        };
        let (decay, fallen) = ((-2.0 * gamma * self.length).exp(), -(-2.0 * gamma * self.length).exp_m1());
        let wronskian = (1.0 + first * last) * fallen + (first + last) * (1.0 + decay);
        let between = (-gamma * (high - low)).exp();
        between * side(first, low) * side(last, self.length - high) / (2.0 * self.conductivity * gamma * wronskian)
    }
}
