//! Quantities over time, and the power of what is switched on and off.

use std::f64::consts::FRAC_PI_2;
use std::fmt;
use std::sync::Arc;

use crate::input::{Record, Varying};

/// A quantity over time (s).
#[derive(Clone)]
pub enum History {
    /// Always the same.
    Constant(f64),
    /// A swing from zero at t = 0.
    Swing(Swing),
    /// Any continuous function of time.
    Function(Arc<dyn Fn(f64) -> f64 + Send + Sync>),
    /// Straight between measured points.
    Record(Arc<Record>),
    /// All of these together.
    Sum(Vec<History>),
}

/// size·[sin(ωt + phase) − sin phase].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swing {
    /// Half of the swing.
    pub size: f64,
    /// Angular frequency ω, rad/s.
    pub omega: f64,
    /// Phase at the start, rad.
    pub phase: f64,
}

impl Swing {
    fn at(self, time: f64) -> f64 {
        self.size * ((self.omega * time + self.phase).sin() - self.phase.sin())
    }
}

impl History {
    /// Value at a time (s).
    pub fn at(&self, time: f64) -> f64 {
        self.within(time, [time; 2])
    }

    /// Value at a time (s) as a time step from one time to another takes it.
    ///
    /// A scheme looks at one or two times of a step, and a record has kinks between them. The step sees the
    /// straight line with the record's mean and first moment over it, which a scheme of second order
    /// integrates exactly: no heat is lost however dense the points are. What differs from the line has
    /// neither mean nor moment, so that it reaches the end of the step in the second power of rate times
    /// step only: a kink costs no order, and steps need not end at it. The rest falls with the step, and is
    /// in what halving the step changes, by which steps are chosen and their error is told.
    pub fn within(&self, time: f64, step: [f64; 2]) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Swing(swing) => swing.at(time),
            Self::Function(function) => function(time),
            Self::Record(record) => record.straightened(time, step),
            Self::Sum(parts) => parts.iter().map(|part| part.within(time, step)).sum(),
        }
    }

    /// Last time (s) at which it is known: infinite but for records.
    pub fn known_until(&self) -> f64 {
        match self {
            Self::Constant(_) | Self::Swing(_) | Self::Function(_) => f64::INFINITY,
            Self::Record(record) => record.span()[1],
            Self::Sum(parts) => parts.iter().map(Self::known_until).fold(f64::INFINITY, f64::min),
        }
    }

    /// Histories of unit size with factors: the sum of them is this one. What differs from another history in
    /// level, size and phase alone has the same units.
    pub(in crate::solve) fn terms(&self) -> Vec<(f64, History)> {
        let mut terms = match self {
            Self::Constant(value) => vec![(*value, Self::Constant(1.0))],
            Self::Swing(Swing { size, omega, phase }) => {
                let unit = |phase| Self::Swing(Swing { size: 1.0, omega: *omega, phase });
                vec![(size * phase.cos(), unit(0.0)), (size * phase.sin(), unit(FRAC_PI_2))]
            }
            Self::Function(_) | Self::Record(_) => vec![(1.0, self.clone())],
            Self::Sum(parts) => {
                let mut all: Vec<(f64, History)> = Vec::new();
                for (factor, unit) in parts.iter().flat_map(Self::terms) {
                    match all.iter_mut().find(|(_, known)| *known == unit) {
                        Some((known, _)) => *known += factor,
                        None => all.push((factor, unit)),
                    }
                }
                all
            }
        };
        terms.retain(|(factor, _)| *factor != 0.0);
        terms
    }
}

/// Functions and records are equal if they are the same one.
impl PartialEq for History {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Constant(a), Self::Constant(b)) => a == b,
            (Self::Swing(a), Self::Swing(b)) => a == b,
            (Self::Function(a), Self::Function(b)) => Arc::ptr_eq(a, b),
            (Self::Record(a), Self::Record(b)) => Arc::ptr_eq(a, b),
            (Self::Sum(a), Self::Sum(b)) => a == b,
            _ => false,
        }
    }
}

impl From<Varying> for History {
    fn from(varying: Varying) -> Self {
        match varying {
            Varying::Constant(value) => Self::Constant(value),
            Varying::Record(record) => Self::Record(record),
        }
    }
}

impl fmt::Debug for History {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Constant(value) => write!(f, "{value}"),
            Self::Swing(swing) => write!(f, "{swing:?}"),
            Self::Function(_) => f.write_str("a function of time"),
            Self::Record(record) => write!(f, "a record from {:?} s", record.span()),
            Self::Sum(parts) => f.debug_list().entries(parts).finish(),
        }
    }
}

/// A stretch of time in which something is on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pulse {
    /// When it is switched on, s.
    pub from: f64,
    /// When it is switched off, s.
    pub to: f64,
    /// Part of the level that it gives meanwhile.
    pub factor: f64,
}

/// Power of a source over time: its level while it is on.
#[derive(Clone, Debug, PartialEq)]
pub struct Power {
    /// Level, W (of a flux W/m²).
    pub level: History,
    /// Stretches in which it is on; none means always.
    pub on: Vec<Pulse>,
}

impl Power {
    /// The same level in all intervals (s); none means always.
    pub fn switched(level: f64, on: &[[f64; 2]]) -> Self {
        let on = on.iter().map(|&[from, to]| Pulse { from, to, factor: 1.0 }).collect();
        Self { level: History::Constant(level), on }
    }

    /// Value at a time (s) as a step between two times takes it. Whether it is on is asked for the middle of
    /// the step, so that both ends see the same side of a switch.
    pub fn within(&self, time: f64, step: [f64; 2]) -> f64 {
        match self.factor(step) {
            0.0 => 0.0,
            factor => factor * self.level.within(time, step),
        }
    }

    /// Part of the level that it gives in a step between two times.
    pub(in crate::solve) fn factor(&self, step: [f64; 2]) -> f64 {
        let middle = 0.5 * (step[0] + step[1]);
        let now = self.on.iter().find(|pulse| (pulse.from..pulse.to).contains(&middle));
        match now {
            Some(pulse) => pulse.factor,
            None if self.on.is_empty() => 1.0,
            None => 0.0,
        }
    }

    /// Times (s) at which it jumps.
    pub fn switches(&self) -> impl Iterator<Item = f64> + '_ {
        self.on.iter().flat_map(|pulse| [pulse.from, pulse.to])
    }

    /// A number of it that is not finite.
    pub(in crate::solve) fn infinite(&self) -> Option<f64> {
        let level = if let History::Constant(level) = self.level { level } else { 0.0 };
        self.on.iter().map(|pulse| pulse.factor).chain([level]).find(|number| !number.is_finite())
    }
}
