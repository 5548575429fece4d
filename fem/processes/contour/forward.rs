//! Predicts every row: a lap of the machine, from the command through servo, play, cyclic error, scale, squareness and
//! centre to the deviation, and spikes.

use std::f64::consts::TAU;

use super::followed::{Followed, STEPS};
use super::machine::{Cyclic, Machine, Spike};
use super::motion::{Motion, Turn};
use super::path::{AXES, Direction, Path, Point, dot};
use super::play::Play;
use super::rows::{ANGLE_OF_ROW, way};
use crate::process::{Command, Failure, Rows};

/// The deviation of every row, m.
///
/// # Errors
/// A servo does not follow.
pub fn observe(machine: &Machine, rows: &Rows) -> Result<Vec<f64>, Failure> {
    let setup = &machine.setup;
    let greatest = (0..rows.len()).map(|row| way(setup, rows, row).1).fold(setup.feed, f64::max);
    check(machine, greatest)?;
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

/// Refuses servos that do not follow, at the greatest feed (m/s) too.
fn check(machine: &Machine, feed: f64) -> Result<(), Failure> {
    let gain = |axis: usize| machine.gain_at(axis, feed).min(machine.gains[axis]);
    match (0..2).find(|axis| gain(*axis) <= 0.0) {
        None => Ok(()),
        Some(axis) => Err(Failure {
            message: format!("the gain of {} is {:.3} /s: it does not follow its command", AXES[axis], gain(axis)),
            help: "the mismatch of the gains must lie between -2 and 2, and no gain may fall to nothing at its feed"
                .into(),
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
    /// What a corrected path adds.
    followed: Option<Followed>,
}

/// An axis on its lap: behind the servo and with its play.
pub struct Axis {
    /// Motion behind the servo, before the play.
    pub motion: Motion,
    play: Play,
    /// Where it turns round, and where the slide stands behind the play then.
    turns: Vec<(Turn, f64)>,
}

impl Axis {
    fn new(motion: Motion, play: Play) -> Self {
        let turns = motion.turns();
        // From the middle of the play: once round takes it up wherever it is taken up at all.
        let mut slide = 0.0;
        let mut held = Vec::new();
        for _ in 0..2 {
            held = turns
                .iter()
                .map(|turn| {
                    slide = play.carry(slide, turn.position);
                    (*turn, slide)
                })
                .collect();
        }
        Self { motion, play, turns: held }
    }

    /// Place of the slide at a time within the lap (m) whose drive is `late` by so much more (m), and the time since the
    /// axis last turned round (s). Where it turns round it is not late.
    fn at(&self, time: f64, late: f64) -> (f64, f64) {
        let drive = self.motion.position(time) - late;
        let last = self.turns.iter().rev().find(|(turn, _)| turn.time <= time);
        let Some((turn, held)) = last.or(self.turns.last()) else { return (drive, f64::INFINITY) };
        let since = (time - turn.time).rem_euclid(self.motion.period());
        (self.play.carry(*held, drive), since)
    }

    /// Whether the axis moves far enough to take up its play.
    pub fn follows(&self) -> bool {
        let positions = || self.turns.iter().map(|(turn, _)| turn.position);
        let [low, high] = [positions().fold(f64::INFINITY, f64::min), positions().fold(f64::NEG_INFINITY, f64::max)];
        high - low > 0.5 * (self.play.width(low) + self.play.width(high))
    }

    /// Where it turns round.
    pub fn reversals(&self) -> impl Iterator<Item = &Turn> {
        self.turns.iter().map(|(turn, _)| turn)
    }

    /// Widths of its lost motion where it turns round, and the elastic parts of them, m.
    pub fn widths(&self) -> impl Iterator<Item = (f64, f64)> {
        self.reversals().map(|turn| (self.play.width(turn.position), self.play.elastic(turn.position)))
    }

    /// Time for which the slide rests while the drive crosses the play after it has turned round on a
    /// circle, s.
    pub fn rest(&self, turn: &Turn) -> f64 {
        match self.motion {
            Motion::Wave { amplitude, frequency, .. } => {
                (1.0 - self.play.width(turn.position) / amplitude).clamp(-1.0, 1.0).acos() / frequency
            }
            Motion::Ramps { .. } => 0.0,
        }
    }
}

impl<'m> Lap<'m> {
    /// The lap of a machine.
    pub fn new(machine: &'m Machine, direction: Direction, feed: f64) -> Self {
        let motion = |axis| Motion::of(&machine.setup.path, axis, machine.gains[axis], feed, direction);
        let axes = [0, 1].map(|axis| Axis::new(motion(axis), machine.plays[axis].clone()));
        let mut lap = Self { machine, direction, feed, axes, followed: None };
        lap.followed = machine.command.as_ref().map(|command| lap.following(command));
        lap
    }

    /// Where the slides go by a corrected path.
    fn following(&self, command: &Command) -> Followed {
        let apart = [f64::from(self.direction as u8)];
        let one = |i: usize| {
            let angle = TAU * i as f64 / STEPS as f64;
            let point = self.machine.setup.path.at(angle);
            let change = command.at(angle, &apart);
            (self.time(&point), point.outward.map(|outward| change * outward))
        };
        let mut commanded: Vec<(f64, [f64; 2])> = (0..STEPS).map(one).collect();
        commanded.sort_by(|a, b| a.0.total_cmp(&b.0));
        let Machine { gains, plays, .. } = self.machine;
        Followed::new(
            &commanded,
            self.axes[0].motion.period(),
            [0, 1].map(|axis| (gains[axis], &plays[axis])),
            |axis, time| self.axes[axis].motion.position(time),
            |axis, time| self.further_lag(axis, time),
        )
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
        let mut reached = [0, 1].map(|axis| self.axes[axis].at(time, self.further_lag(axis, time)));
        if let Some(followed) = &self.followed {
            let off = followed.at(time);
            (0..2).for_each(|axis| reached[axis].0 = self.axes[axis].motion.position(time) + off[axis]);
        }
        let [x, y] = [0, 1].map(|axis| {
            let (at, Cyclic { amplitude, phase }) = (reached[axis].0, machine.cyclic[axis]);
            let lead = machine.setup.drives[axis].lead.unwrap_or(f64::INFINITY);
            let wave = if amplitude == 0.0 { 0.0 } else { amplitude * (TAU * at / lead + phase).sin() };
            (at + wave + self.jerks(axis, time)) * machine.scales[axis]
        });
        ([x + machine.squareness * y + machine.centre[0], y + machine.centre[1]], [0, 1].map(|axis| reached[axis].1))
    }

    /// Place of an axis on its wave of stick-slip, m.
    fn jerks(&self, axis: usize, time: f64) -> f64 {
        let Cyclic { amplitude, phase } = self.machine.stick_slip[axis];
        let turned = TAU * self.machine.setup.frequency.unwrap_or(0.0) * time;
        if amplitude == 0.0 { 0.0 } else { amplitude * (turned + phase).sin() }
    }

    /// Lag of an axis whose gain follows its speed, beyond that at a gain which does not, m.
    fn further_lag(&self, axis: usize, time: f64) -> f64 {
        let machine = self.machine;
        if machine.gain_changes[axis] == 0.0 {
            return 0.0;
        }
        let speed = self.axes[axis].motion.speed(time);
        speed * (1.0 / machine.gain_at(axis, speed) - 1.0 / machine.gains[axis])
    }

    /// Deviation of the tool from the path when a point is commanded, spikes apart, m.
    pub fn offset(&self, point: &Point) -> f64 {
        self.off(point, self.position(self.time(point)).0)
    }

    fn off(&self, point: &Point, at: [f64; 2]) -> f64 {
        let given_way = self.given_way(point);
        let at = [0, 1].map(|axis| at[axis] + given_way[axis]);
        match self.machine.setup.path {
            Path::Circle { radius } => at[0].hypot(at[1]) - radius,
            Path::Rectangle { .. } | Path::Polygon { .. } => dot(point.outward, at) - dot(point.outward, point.at),
        }
    }

    /// How far the machine gives way to the force of the cut, m.
    fn given_way(&self, point: &Point) -> [f64; 2] {
        let [normal, tangential] = self.machine.setup.force;
        let [x, y] = point.outward;
        let along = [-y, x].map(|c| self.direction.sign() * c);
        [0, 1].map(|i| self.machine.compliances[i] * (normal * point.outward[i] - tangential * along[i]))
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
