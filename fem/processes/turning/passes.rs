//! Several passes: each copies, smaller, the error that the one before has left [seed 000; seed 002
//! (17)-(28)].
//!
//! `[[pass]]` are the passes before that of `[cut]`, in their order. A pass is set to a depth t; where the
//! work is too large by e (of the diameter) it is set to t + e/2, and leaves e' = 2y, y the deflection under
//! the force of the depth that is really cut. What moves the tool alike in every pass (a guideway, a
//! setting) copies nothing. The shaft is the finished one throughout, and stiffer than that while it is
//! still thick. A blank that is oval or lobed around gives a depth of its own at every angle, to which the
//! deflection settles at once: t_rest(θ) = C·(t_n(θ) − t_rest)^e/j [seed 002 (22), (24)].

use super::cut::{Conditions, Cut, Force};
use super::schedule::Pass;
use crate::input::{Reader, Varying};
use crate::process::estimates::CUTTING_FORCE;
use crate::process::{BlankProfile, BlankWords, Wave};
use crate::units::{ANGLE, FEED, FORCE, LENGTH, SPINDLE_SPEED};

/// Most passes: more than any shaft gets.
const MOST: usize = 100;
/// Most lobes around a blank: beyond them it is rough, and not out of round.
const MOST_LOBES: usize = 500;

/// A pass before the last.
#[derive(Clone, Debug, PartialEq)]
pub struct EarlierPass {
    /// Set depth t, m.
    pub depth: f64,
    /// m per radian of the spindle.
    pub feed: f64,
    /// rad/s.
    pub spindle_speed: f64,
    /// A force (N) and the depth that it belongs to (m).
    pub force: (Varying, f64),
}

/// The error of the blank: of its diameter along the shaft, and of its radius around.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Blank {
    along: BlankProfile,
    lobes: Vec<Wave>,
}

const WORDS: BlankWords = BlankWords {
    waves: "waves of the blank's diameter along the shaft, which force-feedback copies",
    along: "waves along the whole shaft",
    amplitude: "half of peak to valley of the diameter",
    phase: "of the crest from the headstock, in the wave",
    points: "the blank's diameter error at places, linear between",
    at: "distance from the headstock",
    error: "how much larger the diameter is than set",
    part: "shaft",
    beginning: "the headstock",
};

impl EarlierPass {
    /// Reads `[[pass]]`. Without a force of its own a pass has that of `[cut]`, by its force law or at the
    /// same feed.
    pub fn read_all(model: &Reader, cut: &Cut, last: &Pass) -> Vec<Self> {
        let all =
            model.list("pass", "the passes before that of [cut], in their order", |t, _| Self::read(t, cut, last));
        if all.len() > MOST {
            model.problem(
                "pass",
                format!("{} passes are more than {MOST}", all.len()),
                "leave out what is cut away again",
            );
        }
        all
    }

    fn read(t: &Reader, cut: &Cut, last: &Pass) -> Self {
        let depth = t.quantity("depth", LENGTH, "set depth of cut").positive().required();
        let feed = t.quantity("feed", FEED, "feed per revolution; that of [cut] if left out").positive().or(last.feed);
        let speed = t.quantity("spindle_speed", SPINDLE_SPEED, "spindle speed; that of [cut] if left out").positive();
        let spindle_speed = speed.or(last.spindle_speed);
        let given = t
            .quantity("radial_force", FORCE, "radial force at that depth; by [cut] if left out")
            .estimated(CUTTING_FORCE);
        let given = given.not_negative();
        let force = match (given.optional(), &cut.force) {
            (Some(force), _) => (Varying::Constant(force), depth),
            (None, Force::Law(law)) => (Varying::Constant(law.force(depth, feed)), depth),
            (None, Force::Given(force)) => {
                if feed != last.feed {
                    let help = "add radial_force = \"800 N\" to this pass, or a force law to [cut]";
                    t.problem("feed", "what the force is at another feed is not known", help);
                }
                (force.clone(), cut.depth)
            }
        };
        Self { depth, feed, spindle_speed, force }
    }

    /// How long it takes over a length (m), s.
    pub fn duration(&self, length: f64) -> f64 {
        length / (self.feed * self.spindle_speed)
    }

    /// Conditions of the cut at a place (m) where the work is too large by `error` of the diameter.
    pub fn conditions(&self, x: f64, error: f64) -> Conditions {
        let (nominal, nominal_depth) = (self.force.0.at(x), self.force.1);
        Conditions { force: nominal, nominal, nominal_depth, set_depth: self.depth + 0.5 * error }
    }
}

impl Blank {
    /// Reads the blank's error from `[workpiece]`.
    pub fn read(t: &Reader, length: f64) -> Self {
        let along = BlankProfile::read(t, length, &WORDS);
        let lobes =
            t.list("lobes", "lobes of the blank's radius around it, which force-feedback copies", |t, _| Wave {
                waves: t.count("lobes", "lobes in a turn: 2 of an oval").between(1, MOST_LOBES).required() as f64,
                amplitude: t.quantity("amplitude", LENGTH, "half of peak to valley of the radius").required(),
                phase: t.quantity("phase", ANGLE, "angle of a crest, from the mark on the part").or(0.0),
            });
        Self { along, lobes }
    }

    /// Whether it is round.
    pub fn is_round(&self) -> bool {
        self.lobes.is_empty()
    }

    /// Error of the radius at an angle (rad) around it, m.
    pub fn around(&self, angle: f64) -> f64 {
        self.lobes.iter().map(|w| w.amplitude * (w.waves * (angle - w.phase)).cos()).sum()
    }

    /// Most lobes in a turn; 0 where it is round.
    pub fn most_lobes(&self) -> usize {
        self.lobes.iter().map(|w| w.waves as usize).max().unwrap_or(0)
    }

    /// Whether there is none.
    pub fn is_true(&self) -> bool {
        self.along.is_true() && self.lobes.is_empty()
    }

    /// Diameter error at x on a shaft of `length`, m.
    pub fn error(&self, x: f64, length: f64) -> f64 {
        self.along.error(x, length)
    }
}
