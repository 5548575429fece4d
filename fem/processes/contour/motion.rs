//! One axis behind its servo 1/(1 + s/K), in the steady state of a closed path: where it is over time, and
//! where it turns round. Exact: a sine stays a sine, and what a ramp leaves dies away exponentially.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::path::{Direction, Path, Side};

/// A periodic motion of one axis.
#[derive(Clone, Debug, PartialEq)]
pub enum Motion {
    /// amplitude·cos(ωt − lag).
    Wave {
        /// m.
        amplitude: f64,
        /// rad/s.
        frequency: f64,
        /// rad.
        lag: f64,
    },
    /// Straight commands, one after the other.
    Ramps {
        /// K, 1/s.
        gain: f64,
        /// At least one.
        ramps: Vec<Ramp>,
        /// s.
        period: f64,
    },
}

/// A straight command and the axis behind it: u(τ) = from + velocity·(τ − 1/K) + excess·e^(−Kτ), τ from
/// `begin`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ramp {
    /// s from the beginning of the lap.
    pub begin: f64,
    /// s.
    pub duration: f64,
    /// Command at the beginning, m.
    pub from: f64,
    /// m/s.
    pub velocity: f64,
    /// Departure of the axis from its steady lag at the beginning, m.
    pub excess: f64,
}

/// Where an axis turns round.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    /// s from the beginning of the lap.
    pub time: f64,
    /// m.
    pub position: f64,
}

impl Motion {
    /// Axis number `axis` behind a servo of gain `gain` (1/s) on a path at a feed (m/s).
    pub fn of(path: &Path, axis: usize, gain: f64, feed: f64, direction: Direction) -> Self {
        match *path {
            Path::Circle { radius } => {
                let frequency = feed / radius;
                let ratio = frequency / gain;
                // y = ±R sin ωt = R cos(ωt ∓ π/2).
                let quarter = if axis == 0 { 0.0 } else { direction.sign() * FRAC_PI_2 };
                Self::Wave { amplitude: radius / ratio.hypot(1.0), frequency, lag: ratio.atan() + quarter }
            }
            Path::Rectangle { .. } | Path::Polygon { .. } => Self::ramps(&in_order(path, direction), axis, gain, feed),
        }
    }

    fn ramps(sides: &[Side], axis: usize, gain: f64, feed: f64) -> Self {
        let mut begin = 0.0;
        let mut ramps: Vec<Ramp> = Vec::with_capacity(sides.len());
        for side in sides {
            let duration = side.length / feed;
            ramps.push(Ramp { begin, duration, from: side.from[axis], velocity: feed * side.along[axis], excess: 0.0 });
            begin += duration;
        }
        // The lag changes from side to side, and position does not jump: E' = E·e^(−KT) + (v' − v)/K. Once
        // round from nothing, and the lap that comes back to where it began is that over 1 − e^(−K·period).
        let mut excess = 0.0;
        for lap in 0..2 {
            let mut before = ramps.last().copied();
            for ramp in &mut ramps {
                if let Some(b) = before {
                    excess = excess * (-gain * b.duration).exp() + (ramp.velocity - b.velocity) / gain;
                }
                ramp.excess = excess;
                before = Some(*ramp);
            }
            if lap == 0 {
                excess /= -(-gain * begin).exp_m1();
            }
        }
        Self::Ramps { gain, ramps, period: begin }
    }

    /// One lap, s.
    pub fn period(&self) -> f64 {
        match self {
            Self::Wave { frequency, .. } => TAU / frequency,
            Self::Ramps { period, .. } => *period,
        }
    }

    /// Where the axis is at a time within the lap, m.
    pub fn position(&self, time: f64) -> f64 {
        match self {
            Self::Wave { amplitude, frequency, lag } => amplitude * (frequency * time - lag).cos(),
            Self::Ramps { gain, ramps, .. } => {
                let ramp = ramp_at(ramps, time);
                ramp.position(*gain, time - ramp.begin)
            }
        }
    }

    /// How fast the axis is commanded to go where it is at a time within the lap, m/s: on straight sides
    /// without what their corners leave.
    pub fn speed(&self, time: f64) -> f64 {
        match self {
            Self::Wave { amplitude, frequency, lag } => -amplitude * frequency * (frequency * time - lag).sin(),
            Self::Ramps { ramps, .. } => ramp_at(ramps, time).velocity,
        }
    }

    /// Where it turns round, in the order of time within the lap.
    pub fn turns(&self) -> Vec<Turn> {
        match self {
            Self::Wave { amplitude, frequency, lag } => {
                let turn = |k: f64| Turn {
                    time: (lag + k * PI).rem_euclid(TAU) / frequency,
                    position: amplitude * (k * PI).cos(),
                };
                let mut turns = vec![turn(0.0), turn(1.0)];
                turns.sort_by(|a, b| a.time.total_cmp(&b.time));
                turns
            }
            Self::Ramps { gain, ramps, .. } => turns(*gain, ramps),
        }
    }
}

impl Ramp {
    fn position(&self, gain: f64, since: f64) -> f64 {
        self.from + self.velocity * (since - 1.0 / gain) + self.excess * (-gain * since).exp()
    }
}

/// The ramp of a time within the lap.
fn ramp_at(ramps: &[Ramp], time: f64) -> &Ramp {
    &ramps[ramps.partition_point(|r| r.begin <= time).saturating_sub(1)]
}

/// On a ramp that goes the other way than the last one that went anywhere, the axis turns round when v =
/// K·E·e^(−Kτ).
fn turns(gain: f64, ramps: &[Ramp]) -> Vec<Turn> {
    let mut heading = ramps.iter().rev().map(|r| r.velocity).find(|v| *v != 0.0).unwrap_or(0.0);
    let mut turns = Vec::new();
    for ramp in ramps.iter().filter(|r| r.velocity != 0.0) {
        if ramp.velocity * heading < 0.0 {
            let since = (gain * ramp.excess / ramp.velocity).max(1.0).ln() / gain;
            let since = since.min(ramp.duration);
            turns.push(Turn { time: ramp.begin + since, position: ramp.position(gain, since) });
        }
        heading = ramp.velocity;
    }
    turns
}

/// The sides in the order and the direction in which they are travelled.
pub fn in_order(path: &Path, direction: Direction) -> Vec<Side> {
    let sides = path.sides();
    match direction {
        Direction::CounterClockwise => sides,
        Direction::Clockwise => {
            let back = |s: Side| Side { from: s.to, to: s.from, along: s.along.map(|c| -c), ..s };
            sides.into_iter().rev().map(back).collect()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One of each kind, the polygon with acute corners.
    fn paths() -> [Path; 3] {
        let corners = [[-0.03, -0.02], [0.06, -0.015], [-0.01, 0.03]].into();
        [
            Path::Circle { radius: 0.05 },
            Path::Rectangle { width: 0.06, height: 0.04, angle: 0.6 },
            Path::Polygon { corners },
        ]
    }

    /// Steps of the exact solution between samples of the command, from rest in the centre, for two laps.
    fn stepped(path: &Path, axis: usize, gain: f64, feed: f64, direction: Direction, at: f64) -> f64 {
        let (sides, steps) = (in_order(path, direction), 40_000);
        let period = path.length() / feed;
        let command = |time: f64| match *path {
            Path::Circle { radius } => {
                let angle = direction.sign() * feed * time / radius;
                radius * if axis == 0 { angle.cos() } else { angle.sin() }
            }
            Path::Rectangle { .. } | Path::Polygon { .. } => {
                let mut left = (feed * time).rem_euclid(path.length());
                for side in &sides {
                    if left <= side.length {
                        return side.from[axis] + left * side.along[axis];
                    }
                    left -= side.length;
                }
                sides[0].from[axis]
            }
        };
        let step = (period + at) / f64::from(steps);
        let (keep, mut u) = ((-gain * step).exp(), 0.0);
        for i in 0..steps {
            // The command is taken as straight within a step.
            let (a, b) = (command(f64::from(i) * step), command(f64::from(i + 1) * step));
            let slope = (b - a) / step;
            u = b - slope / gain + (u - a + slope / gain) * keep;
        }
        u
    }

    #[test]
    fn the_steady_lap_is_what_stepping_comes_to() {
        let paths = paths();
        for path in paths {
            for direction in [Direction::CounterClockwise, Direction::Clockwise] {
                for axis in [0, 1] {
                    let motion = Motion::of(&path, axis, 20.0, 0.05, direction);
                    for part in [0.03, 0.26, 0.6, 0.97] {
                        let at = part * motion.period();
                        let expected = stepped(&path, axis, 20.0, 0.05, direction, at);
                        // A corner inside a step is cut: at most v·step/4 of it, and then dies away.
                        assert!((motion.position(at) - expected).abs() < 2e-6, "{path:?} {axis} {part}");
                    }
                }
            }
        }
    }

    #[test]
    fn turns_are_where_the_motion_is_largest_and_smallest() {
        for path in paths() {
            for axis in [0, 1] {
                let motion = Motion::of(&path, axis, 20.0, 0.05, Direction::CounterClockwise);
                let samples: Vec<f64> =
                    (0..100_000).map(|i| motion.position(motion.period() * f64::from(i) / 1e5)).collect();
                let turns = motion.turns();
                assert_eq!(turns.len(), 2);
                for turn in &turns {
                    assert!((motion.position(turn.time) - turn.position).abs() < 1e-15);
                }
                let ends = [f64::min as fn(f64, f64) -> f64, f64::max];
                for (end, sampled) in ends.iter().map(|e| (e, samples.iter().copied().reduce(e).unwrap())) {
                    let turned = turns.iter().map(|t| t.position).reduce(end).unwrap();
                    assert!((turned - sampled).abs() < 1e-9, "{turned} {sampled}");
                }
            }
        }
    }

    #[test]
    fn an_axis_that_stands_still_does_not_turn() {
        let path = Path::Rectangle { width: 0.06, height: 0.04, angle: 0.0 };
        for (axis, along) in [(0, 0.06), (1, 0.04)] {
            let turns = Motion::of(&path, axis, 20.0, 0.05, Direction::CounterClockwise).turns();
            assert_eq!(turns.len(), 2);
            let stroke = (turns[0].position - turns[1].position).abs();
            assert!((stroke - along).abs() < 1e-9, "{stroke}");
        }
    }
}
