//! The chuck and the cut as effects shape them.

use std::sync::Arc;

use super::grip::Grip;
use super::jaws::{self, Group, Jaw, parts};
use super::membrane::Grasp;
use super::setup::Setup;
use crate::process::{self, Command, Failure};

/// An effect on this machine, with `N` parameters.
pub type Effect<const N: usize> = process::Effect<Setup, Machine, N>;

/// A point of the cut surface of a ring in a set-up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BorePoint {
    /// Angle from jaw 1, rad.
    pub angle: f64,
    /// Angle of the ring's mark from jaw 1, rad.
    pub orientation: f64,
    /// Radial deviation of the surface before it is cut, m.
    pub blank: f64,
}

/// A radial movement or deviation that does not depend on the jaws, m.
type Mark = Box<dyn Fn(&BorePoint) -> f64 + Send + Sync>;

/// A chuck and a cut with their effects. Effects act by moving jaws, by spreading their force, sharing it
/// out otherwise or taking it away, by setting the chuck aside, by warming the ring, by moving the tool's nose, by letting it yield, or by what
/// is set free in the bored ring.
pub struct Machine {
    /// The tables of the model.
    pub setup: Arc<Setup>,
    /// Angles at which the jaws stand, rad.
    pub jaw_angles: Vec<f64>,
    /// Full angle over which each jaw presses, rad; 0 for a line load.
    pub arc: f64,
    /// Force of the first, third … jaw less that of the others at standstill, in parts of their mean.
    pub difference: f64,
    /// Σ m·r of a jaw, which the spindle's turning pulls outwards, kg·m.
    pub jaw_moment: f64,
    /// Where the chuck's axis stands off the spindle's, towards jaw 1 and a quarter turn on, m.
    pub eccentricity: [f64; 2],
    /// How much larger the cut radius is while the ring is warm, m.
    pub warmth: f64,
    /// How far tool and spindle part under the force of the cut beside what the drawn machine gives way, m/N.
    pub yielding: f64,
    /// Movements of the nose outwards while it cuts.
    moves: Vec<Mark>,
    /// Deviations set free when the ring is cut.
    released: Vec<Mark>,
    /// What is added to the command, if it is corrected.
    pub command: Option<Arc<Command>>,
}

impl Machine {
    /// The ideal machine: jaws where the model has them, evenly spaced and each pressing along a line unless
    /// a mesh says otherwise; the spindle true and cold.
    pub fn ideal(setup: Arc<Setup>) -> Self {
        let (jaw_angles, arc) = (setup.jaw_angles.clone(), setup.arc);
        Self {
            setup,
            jaw_angles,
            arc,
            difference: 0.0,
            jaw_moment: 0.0,
            eccentricity: [0.0; 2],
            warmth: 0.0,
            yielding: 0.0,
            moves: Vec::new(),
            released: Vec::new(),
            command: None,
        }
    }

    /// Moves the nose outwards while it cuts, m.
    pub fn add_move(&mut self, by: impl Fn(&BorePoint) -> f64 + Send + Sync + 'static) {
        self.moves.push(Box::new(by));
    }

    /// Adds what is set free when the ring is cut, m outwards.
    pub fn add_released(&mut self, by: impl Fn(&BorePoint) -> f64 + Send + Sync + 'static) {
        self.released.push(Box::new(by));
    }

    /// Deviation of a point of the cut, released and cold ring, where the jaws move it outwards by `squeeze` (m)
    /// while it is cut.
    ///
    /// The nose goes round the spindle's axis. It finds the surface where the blank, the squeeze, the warmth and the
    /// chuck that stands aside have it, b, and is itself moved to s; the tool yields by k·(s − b), so that s − k·(s −
    /// b) is left. Then the ring is let go, cools down, and is measured about its own axis.
    ///
    /// # Errors
    /// The joints of the drawn machine found no equilibrium.
    pub fn deviation(&self, point: &BorePoint, squeeze: f64) -> Result<f64, Failure> {
        let all = |marks: &[Mark]| marks.iter().map(|mark| mark(point)).sum::<f64>();
        let [x, y] = self.eccentricity;
        let away = squeeze + self.warmth + x * point.angle.cos() + y * point.angle.sin();
        let commanded = self.command.as_ref().map_or(0.0, |command| command.at(point.angle, &[]));
        let (nose, found) = (commanded + all(&self.moves), point.blank + away);
        // A bore is cut outwards, and what is held by its bore inwards.
        let inwards = self.setup.grip.inwards();
        let given_way = inwards * self.given_way(inwards * (nose - found))?;
        Ok(nose - given_way - away + all(&self.released))
    }

    /// How far tool and spindle part where the depth of cut is larger by some (m) than in the mean, m.
    ///
    /// # Errors
    /// The joints of the drawn machine found no equilibrium.
    fn given_way(&self, deeper: f64) -> Result<f64, Failure> {
        let per_depth = self.setup.force_per_depth.unwrap_or(0.0);
        let linear = |yielding: f64| deeper * per_depth * yielding / (1.0 + per_depth * yielding);
        let Some(base) = &self.setup.base else { return Ok(linear(self.yielding)) };
        let Some(mean) = base.mean_force() else { return Ok(linear(self.yielding + base.compliance())) };
        let parted = |force: f64| -> Result<[f64; 2], Failure> {
            let [farther, rate] = base.farther(force)?;
            Ok([farther + self.yielding * (force - mean), rate + self.yielding])
        };
        // Where less than nothing would be cut the tool does not touch, and the blank is left, which lies before the cut of
        // the mean by the depth of the mean.
        if per_depth * (deeper - parted(0.0)?[0]) <= -mean {
            return Ok(deeper + mean / per_depth);
        }
        balanced(deeper, linear(self.yielding + base.compliance()), |left| {
            let [parted, rate] = parted((mean + per_depth * left).max(0.0))?;
            Ok([parted, rate * per_depth])
        })
    }

    /// The jaws with their forces in equilibrium, those together that press alike.
    ///
    /// # Errors
    /// The jaws stand where they cannot hold a ring, or press on each other's place.
    pub fn groups(&self) -> Result<Vec<Group>, Failure> {
        jaws::in_equilibrium(&self.jaw_angles, self.arc, self.difference)
    }

    /// All jaws around the ring, their shares those at standstill.
    ///
    /// # Errors
    /// The jaws stand where they cannot hold a ring, or press on each other's place.
    pub fn jaws(&self) -> Result<Vec<Jaw>, Failure> {
        self.pressing(|part| part)
    }

    /// All jaws around the ring, where `force_of` gives the force of jaws of a part of that at standstill; their shares are over its
    /// unit.
    ///
    /// # Errors
    /// The jaws stand where they cannot hold a ring, or press on each other's place.
    pub fn pressing(&self, force_of: impl Fn(f64) -> f64) -> Result<Vec<Jaw>, Failure> {
        let groups = self.groups()?;
        let of = |group: &Group| {
            let force = force_of(group.part);
            group.jaws.iter().map(|jaw| Jaw { share: force * jaw.share, ..*jaw }).collect::<Vec<Jaw>>()
        };
        let by_group: Vec<Vec<Jaw>> = groups.iter().map(of).collect();
        let count = self.jaw_angles.len();
        Ok((0..count).map(|k| by_group[k % groups.len()][k / groups.len()]).collect())
    }

    /// Σ m·r of a jaw as the ring feels it, kg·m: all of it, unless the jaw stands on a membrane.
    pub fn thrown_moment(&self) -> f64 {
        self.jaw_moment * self.setup.grasp.as_ref().map_or(1.0, Grasp::felt)
    }

    /// Force of a jaw while the spindle turns at `speed` (rad/s), from its `force` at standstill (N):
    /// F = max(0, F₀ − m·r·ω²), and F₀ + m·r·ω² of jaws that hold the ring from inside.
    pub fn force_at(&self, force: f64, speed: f64) -> f64 {
        (force - self.setup.grip.inwards() * self.thrown_moment() * speed * speed).max(0.0)
    }

    /// Forces of the first, third … jaw and of the others at standstill, N.
    pub fn standing_forces(&self) -> [f64; 2] {
        parts(self.difference).map(|part| part * self.setup.jaw_force)
    }

    /// The same while the model's ring is cut, N.
    pub fn cutting_forces(&self) -> [f64; 2] {
        self.standing_forces().map(|force| self.force_at(force, self.setup.speed()))
    }

    /// Speed above which a jaw lets the ring go, rad/s; infinite where the jaws do not lighten.
    pub fn let_go(&self) -> f64 {
        let can = self.jaw_moment > 0.0 && self.setup.grip == Grip::Outside;
        let [one, other] = self.standing_forces();
        if can { (one.min(other) / self.thrown_moment()).sqrt() } else { f64::INFINITY }
    }
}

/// The part y of a depth (m) by which what cuts gives way, y = of(depth − y), where `of` rises with what is left of the depth, and
/// tells how fast; found from a guess by Newton's steps, halved where these leave the bracket.
fn balanced(depth: f64, guess: f64, of: impl Fn(f64) -> Result<[f64; 2], Failure>) -> Result<f64, Failure> {
    let (mut low, mut high) = (depth.min(0.0), depth.max(0.0));
    let mut y = guess;
    for _ in 0..MOST_STEPS {
        let [given, rate] = of(depth - y)?;
        let excess = y - given;
        if excess > 0.0 {
            high = y
        } else {
            low = y
        }
        let newton = y - excess / (1.0 + rate);
        let next = if (low..=high).contains(&newton) { newton } else { 0.5 * (low + high) };
        if (next - y).abs() <= ROUND_OFF * depth.abs() {
            return Ok(next);
        }
        y = next;
    }
    Ok(y)
}

/// Steps in which a bracket is halved down to round-off.
const MOST_STEPS: usize = 60;
/// What the balance of the joints leaves open of a depth.
const ROUND_OFF: f64 = 1e-12;
