//! Shapes: functions of one variable of which laws are made, each of a pure number and without unit.

use std::f64::consts::{PI, TAU};

/// A function of one variable v; what it is shaped by (places c, widths w, scales s in the unit of v) stands beside it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// v/s.
    Proportional,
    /// v/s and 1: a straight line of any zero.
    Line,
    /// (v/s)^p, of this exponent.
    Power(f64),
    /// (v/s)^c, of any exponent.
    Exponent,
    /// (v/s)², v/s and 1.
    Parabola,
    /// ((v − c)/s)⁴.
    Fourth,
    /// exp(−v/w).
    Decay,
    /// exp(−v/w) and 1.
    Relaxation,
    /// ln(1 + v/w).
    Logarithm,
    /// 1/(1 + v/w).
    Saturation,
    /// v/w·exp(−v/w).
    Hump,
    /// tanh((v − c)/w) and 1.
    Transition,
    /// exp(−((v − c)/w)²).
    Bell,
    /// max(0, v − c)/s.
    Hinge,
    /// max(0, c − v)/s.
    Fall,
    /// max(0, v − c·u)/s, u another variable of the same unit.
    Excess,
    /// 1 from c on, 0 before.
    Step,
    /// max(0, 1 − |v − c|/w).
    Tent,
    /// √(1 + ((v − c)/w)²).
    Bowl,
    /// 1/√((1 − (v/c)²)² + (2·w·v/c)²), w a pure number.
    Resonance,
    /// 1/(1 − (v/c)²).
    Pole,
    /// (v/c)/(1 − v/c).
    Softening,
    /// sin and cos of 2π·v/w.
    Wave,
    /// |sin(π·v/w)|.
    Arch,
    /// exp(−v/w)·(sin and cos of 2π·v/c).
    Ringing,
    /// sin and cos of k·v, of an angle.
    Harmonic(f64),
    /// |cos(k·v)|, of an angle.
    Lobe(f64),
    /// 2·v − 1, of one of two words.
    Sign,
    /// 1 for one of several words, c, 0 for the others.
    Word,
}

impl Shape {
    /// How many functions it is, each with an amplitude of its own.
    pub fn functions(self) -> usize {
        match self {
            Self::Parabola => 3,
            Self::Line | Self::Relaxation | Self::Transition | Self::Wave | Self::Ringing | Self::Harmonic(_) => 2,
            _ => 1,
        }
    }

    /// Whether anybody would draw it first: a line, a power, a word, a harmonic.
    pub fn is_plain(self) -> bool {
        matches!(
            self,
            Self::Proportional
                | Self::Line
                | Self::Power(_)
                | Self::Parabola
                | Self::Sign
                | Self::Word
                | Self::Harmonic(_)
        )
    }

    /// The values of its functions at v, with a scale s and constants.
    pub fn at(self, v: f64, s: f64, constants: &[f64]) -> [f64; 3] {
        let c = constants.first().copied().unwrap_or(1.0);
        let w = constants.get(1).copied().unwrap_or(c);
        let one = |value: f64| [value, 0.0, 0.0];
        match self {
            Self::Proportional => one(v / s),
            Self::Line => [v / s, 1.0, 0.0],
            Self::Power(p) => one((v / s).powf(p)),
            Self::Exponent => one((v / s).powf(c)),
            Self::Parabola => [(v / s).powi(2), v / s, 1.0],
            Self::Fourth => one(((v - c) / s).powi(4)),
            Self::Decay => one((-v / c).exp()),
            Self::Relaxation => [(-v / c).exp(), 1.0, 0.0],
            Self::Logarithm => one((1.0 + v / c).ln()),
            Self::Saturation => one(1.0 / (1.0 + v / c)),
            Self::Hump => one(v / c * (-v / c).exp()),
            Self::Transition => [((v - c) / w).tanh(), 1.0, 0.0],
            Self::Bell => one((-((v - c) / w).powi(2)).exp()),
            // Of the other variable `columns` takes its part beforehand.
            Self::Excess => one(v.max(0.0) / s),
            Self::Hinge => one((v - c).max(0.0) / s),
            Self::Fall => one((c - v).max(0.0) / s),
            Self::Step => one(f64::from(u8::from(v >= c))),
            Self::Tent => one((1.0 - (v - c).abs() / w).max(0.0)),
            Self::Bowl => one((1.0 + ((v - c) / w).powi(2)).sqrt()),
            Self::Resonance => {
                let r = v / c;
                one(1.0 / ((1.0 - r * r).powi(2) + (2.0 * w * r).powi(2)).sqrt())
            }
            Self::Pole => one(1.0 / (1.0 - (v / c).powi(2))),
            Self::Softening => one((v / c) / (1.0 - v / c)),
            Self::Wave => [(TAU * v / c).sin(), (TAU * v / c).cos(), 0.0],
            Self::Arch => one((PI * v / c).sin().abs()),
            Self::Ringing => {
                let (fade, turn) = ((-v / w).exp(), TAU * v / c);
                [fade * turn.sin(), fade * turn.cos(), 0.0]
            }
            Self::Harmonic(k) => [(k * v).sin(), (k * v).cos(), 0.0],
            Self::Lobe(k) => one((k * v).cos().abs()),
            Self::Sign => one(2.0 * v - 1.0),
            Self::Word => one(f64::from(u8::from(v == c))),
        }
    }

    /// The shape that it is without its constant, or with any exponent.
    pub fn family(self) -> Self {
        match self {
            Self::Relaxation => Self::Decay,
            Self::Proportional => Self::Line,
            Self::Power(_) => Self::Exponent,
            other => other,
        }
    }

    /// Whether it goes up and down.
    pub fn is_wave(self) -> bool {
        matches!(self, Self::Wave | Self::Arch | Self::Harmonic(_) | Self::Lobe(_))
    }

    /// Whether a wave may grow or fade so.
    pub fn is_envelope(self) -> bool {
        matches!(self, Self::Proportional | Self::Line | Self::Power(_) | Self::Exponent | Self::Decay)
    }

    /// Whether its first constant is a place along the variable, and not a size.
    pub fn is_placed(self) -> bool {
        matches!(
            self,
            Self::Fourth
                | Self::Transition
                | Self::Bell
                | Self::Hinge
                | Self::Fall
                | Self::Step
                | Self::Tent
                | Self::Bowl
        )
    }
}
