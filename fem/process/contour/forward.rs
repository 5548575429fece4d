//! What every row would show: a lap of the machine, from the command through servo, play, cyclic error,
//! scale, squareness and centre to the deviation, and spikes.

use std::f64::consts::TAU;

use super::machine::{Cyclic, Machine, Spike};
use super::motion::{Motion, Turn};
use super::path::{Direction, Path, Point, dot};
use super::rows::{ANGLE_OF_ROW, way};
use super::setup::AXES;
use crate::process::{Failure, Rows};

/// The deviation of every row, m.
///
/// # Errors
/// A servo does not follow.
pub fn observe(machine: &Machine, rows: &Rows) -> Result<Vec<f64>, Failure> {
    check(machine)?;
    let setup = &machine.setup;
    let mut laps: Vec<((Direction, f64), Lap)> = Vec::new();
    let one = |row: usize| {
        let way = way(setup, rows, row);
        // Rows of a lap stand together, as a rule.
        let known = laps.iter().rposition(|(other, _)| *other == way);
        let lap = known.unwrap_or_else(|| {
            laps.push((way, Lap::new(machine, way.0, way.1)));
            laps.len() - 1
        });
        laps[lap].1.deviation(&setup.path.at(rows.get(ANGLE_OF_ROW, row).unwrap_or(0.0)))
    };
    Ok((0..rows.len()).map(one).collect())
}

/// Refuses servos that do not follow.
fn check(machine: &Machine) -> Result<(), Failure> {
    match (0..2).find(|axis| machine.gains[*axis] <= 0.0) {
        None => Ok(()),
        Some(axis) => Err(Failure {
            message: format!(
                "the gain of {} is {:.3} /s: it does not follow its command",
                AXES[axis], machine.gains[axis]
            ),
            help: "the mismatch of the gains must lie between -2 and 2".into(),
        }),
    }
}

/// A lap at a feed in a direction, after laps before it.
pub struct Lap<'m> {
    machine: &'m Machine,
    direction: Direction,
    /// m/s.
    feed: f64,
    /// x, y.
    pub axes: [Axis; 2],
}

/// An axis on its lap: behind the servo and with its play.
pub struct Axis {
    /// Motion behind the servo, before the play.
    pub motion: Motion,
    gap: f64,
    /// Where it turns round, and where the slide stands behind the play then.
    turns: Vec<(Turn, f64)>,
}

impl Axis {
    fn new(motion: Motion, gap: f64) -> Self {
        let turns = motion.turns();
        // From the middle of the play: once round takes it up wherever it is taken up at all.
        let mut slide = 0.0;
        let mut held = Vec::new();
        for _ in 0..2 {
            held = turns
                .iter()
                .map(|turn| {
                    slide = play(slide, turn.position, gap);
                    (*turn, slide)
                })
                .collect();
        }
        Self { motion, gap, turns: held }
    }

    /// Place of the slide at a time within the lap (m), and the time since the axis last turned round (s).
    fn at(&self, time: f64) -> (f64, f64) {
        let last = self.turns.iter().rev().find(|(turn, _)| turn.time <= time);
        let Some((turn, held)) = last.or(self.turns.last()) else { return (self.motion.position(time), f64::INFINITY) };
        let since = (time - turn.time).rem_euclid(self.motion.period());
        (play(*held, self.motion.position(time), self.gap), since)
    }

    /// Whether the axis moves far enough to take up its play.
    pub fn follows(&self) -> bool {
        let positions = || self.turns.iter().map(|(turn, _)| turn.position);
        positions().fold(f64::NEG_INFINITY, f64::max) - positions().fold(f64::INFINITY, f64::min) > self.gap
    }

    /// Times at which it turns round, s within the lap.
    pub fn reversals(&self) -> impl Iterator<Item = f64> {
        self.turns.iter().map(|(turn, _)| turn.time)
    }

    /// Time for which the slide rests while the drive crosses the play after it has turned round on a
    /// circle, s.
    pub fn rest(&self) -> f64 {
        match self.motion {
            Motion::Wave { amplitude, frequency, .. } => {
                (1.0 - self.gap / amplitude).clamp(-1.0, 1.0).acos() / frequency
            }
            Motion::Ramps { .. } => 0.0,
        }
    }
}

/// The play operator of width `gap`: the slide stays until the drive has crossed its play, and is then
/// carried along.
fn play(slide: f64, drive: f64, gap: f64) -> f64 {
    slide.max(drive - 0.5 * gap).min(drive + 0.5 * gap)
}

impl<'m> Lap<'m> {
    /// The lap of a machine.
    pub fn new(machine: &'m Machine, direction: Direction, feed: f64) -> Self {
        let motion = |axis| Motion::of(&machine.setup.path, axis, machine.gains[axis], feed, direction);
        Self { machine, direction, feed, axes: [0, 1].map(|axis| Axis::new(motion(axis), machine.gaps[axis])) }
    }

    /// s within the lap at which a point is commanded.
    pub fn time(&self, point: &Point) -> f64 {
        let length = self.machine.setup.path.length();
        let travelled = match self.direction {
            Direction::CounterClockwise => point.travelled,
            Direction::Clockwise => (length - point.travelled).rem_euclid(length),
        };
        travelled / self.feed
    }

    /// The polar angle of what is commanded at a time within the lap, rad, of a circle.
    pub fn angle(&self, time: f64) -> f64 {
        let turned = TAU * time / self.axes[0].motion.period();
        (self.direction.sign() * turned).rem_euclid(TAU)
    }

    /// Place of the tool at a time within the lap (m), and the time since each axis turned round (s).
    pub fn position(&self, time: f64) -> ([f64; 2], [f64; 2]) {
        let machine = self.machine;
        let reached = [0, 1].map(|axis| self.axes[axis].at(time));
        let lead = machine.setup.lead.unwrap_or(f64::INFINITY);
        let [x, y] = [0, 1].map(|axis| {
            let (at, Cyclic { amplitude, phase }) = (reached[axis].0, machine.cyclic[axis]);
            let wave = if amplitude == 0.0 { 0.0 } else { amplitude * (TAU * at / lead + phase).sin() };
            (at + wave) * machine.scales[axis]
        });
        ([x + machine.squareness * y + machine.centre[0], y + machine.centre[1]], [0, 1].map(|axis| reached[axis].1))
    }

    /// Deviation of the tool from the path when a point is commanded, spikes apart, m.
    pub fn offset(&self, point: &Point) -> f64 {
        self.off(point, self.position(self.time(point)).0)
    }

    fn off(&self, point: &Point, at: [f64; 2]) -> f64 {
        match self.machine.setup.path {
            Path::Circle { radius } => at[0].hypot(at[1]) - radius,
            Path::Rectangle { .. } => dot(point.outward, at) - dot(point.outward, point.at),
        }
    }

    /// Deviation of the tool from the path when a point is commanded, m.
    pub fn deviation(&self, point: &Point) -> f64 {
        let (at, since) = self.position(self.time(point));
        let spike = |axis: usize| {
            let Spike { height, time_constant } = self.machine.spikes[axis];
            if height == 0.0 { 0.0 } else { height * (-since[axis] / time_constant).exp() * point.outward[axis].abs() }
        };
        self.off(point, at) + spike(0) + spike(1)
    }
}
