//! What turns the table: a worm and its wheel, a train of gears, or a motor on the table itself.

use std::f64::consts::TAU;

use crate::input::Reader;
use crate::process::estimates;
use crate::units::{LENGTH, TORSIONAL_STIFFNESS};

/// Most teeth of a wheel that are believed.
const MOST_TEETH: usize = 100_000;
/// Most starts of a worm that are believed.
const MOST_STARTS: usize = 24;
/// Most stages of a train.
const MOST_STAGES: usize = 12;

/// Two gears of a train.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stage {
    /// Teeth of the gear on the side of the motor.
    pub driving: usize,
    /// Teeth of the gear on the side of the table.
    pub driven: usize,
}

/// How the motor turns the table.
#[derive(Clone, Debug, PartialEq)]
pub enum Gearing {
    /// A worm with some starts, and a wheel on the table.
    Worm {
        /// Teeth of the wheel.
        teeth: usize,
        /// Starts of the worm.
        starts: usize,
    },
    /// Gears, from the motor to the table; at least one stage.
    Gears(Vec<Stage>),
    /// The motor is on the table.
    Direct,
}

/// The drive. SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Drive {
    /// Its gearing.
    pub gearing: Gearing,
    /// Pitch radius of the wheel on the table, m, if it is told.
    pub pitch_radius: Option<f64>,
    /// Torsional stiffness of all of it at the table, N·m/rad; infinite where it is rigid.
    pub stiffness: f64,
}

/// A word of `type`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Worm,
    Gears,
    Direct,
}

const KINDS: &[(&str, Kind)] = &[("worm", Kind::Worm), ("gears", Kind::Gears), ("direct", Kind::Direct)];

/// The keys of each type, for what a file gives of another.
const OWN: &[(&str, Kind)] = &[("teeth", Kind::Worm), ("starts", Kind::Worm), ("stages", Kind::Gears)];

impl Drive {
    /// Reads `[drive]`.
    pub fn read(t: &Reader) -> Self {
        let kind = t.choice("type", "what turns the table", KINDS).required(Kind::Direct);
        let teeth = t.count("teeth", "of the worm wheel").between(1, MOST_TEETH).optional();
        let starts = t.count("starts", "of the worm").between(1, MOST_STARTS).or(1);
        let about = "gears from the motor to the table";
        let stages = t.list("stages", about, |t, _| Stage {
            driving: t.count("driving", "teeth of the gear towards the motor").between(1, MOST_TEETH).required(),
            driven: t.count("driven", "teeth of the gear towards the table").between(1, MOST_TEETH).required(),
        });
        let about = "pitch radius of the wheel on the table, for its eccentricity";
        let pitch_radius = t.quantity("pitch_radius", LENGTH, about).positive().optional();
        let about = "torsional stiffness of the drive at the table, the motor held; rigid if left out";
        let stiffness = t.quantity("stiffness", TORSIONAL_STIFFNESS, about).estimated(estimates::STIFFNESS);
        let stiffness = stiffness.positive().or(f64::INFINITY);
        for (key, owner) in OWN {
            if t.has(key) && *owner != kind {
                let word = |kind: Kind| KINDS.iter().find(|(_, own)| *own == kind).map_or("", |(word, _)| *word);
                let help = format!("leave it out, or write type = \"{}\"", word(*owner));
                t.problem(key, format!("`{key}` is of a drive of the type `{}`", word(*owner)), help);
            }
        }
        if pitch_radius.is_some() && kind == Kind::Direct {
            t.problem("pitch_radius", "a direct drive has no wheel", "leave it out");
        }
        let gearing = match kind {
            Kind::Worm => Gearing::Worm { teeth: read_teeth(t, teeth), starts },
            Kind::Gears => Gearing::Gears(read_stages(t, stages)),
            Kind::Direct => Gearing::Direct,
        };
        Self { gearing, pitch_radius, stiffness }
    }

    /// Turns of the motor in a turn of the table.
    pub fn ratio(&self) -> f64 {
        match &self.gearing {
            Gearing::Worm { teeth, starts } => *teeth as f64 / *starts as f64,
            Gearing::Gears(stages) => stages.iter().map(Stage::ratio).product(),
            Gearing::Direct => 1.0,
        }
    }

    /// Turns of the worm in a turn of the table, if there is a worm.
    pub fn worm(&self) -> Option<f64> {
        match self.gearing {
            Gearing::Worm { .. } => Some(self.ratio()),
            Gearing::Gears(_) | Gearing::Direct => None,
        }
    }

    /// The pair of gears whose wheel is on the table, if there are gears.
    pub fn last(&self) -> Option<Stage> {
        match &self.gearing {
            Gearing::Gears(stages) => stages.last().copied(),
            Gearing::Worm { .. } | Gearing::Direct => None,
        }
    }

    /// Number of stages of gears.
    pub fn stages(&self) -> usize {
        match &self.gearing {
            Gearing::Gears(stages) => stages.len(),
            Gearing::Worm { .. } | Gearing::Direct => 0,
        }
    }

    /// Whether nothing in it yields.
    pub fn is_rigid(&self) -> bool {
        self.stiffness == f64::INFINITY
    }

    /// The angle (rad) of the table after which the fastest error of the gearing comes back: a turn of the worm, a mesh of
    /// the last pair of gears; none of a direct drive.
    pub fn shortest_period(&self) -> Option<f64> {
        self.worm().or_else(|| self.last().map(|stage| stage.driven as f64)).map(|times| TAU / times)
    }
}

impl Stage {
    /// Turns of the driving gear in a turn of the driven one.
    pub fn ratio(&self) -> f64 {
        self.driven as f64 / self.driving as f64
    }
}

fn read_teeth(t: &Reader, teeth: Option<usize>) -> usize {
    if teeth.is_none() && !t.is_described() {
        t.problem("", "the worm wheel has no teeth", "add teeth = 180, those of the wheel");
    }
    teeth.unwrap_or(1)
}

fn read_stages(t: &Reader, stages: Vec<Stage>) -> Vec<Stage> {
    if stages.is_empty() && !t.is_described() {
        let help = "add stages = [{ driving = 20, driven = 100 }], from the motor to the table";
        t.problem("", "the train has no gears", help);
    }
    if stages.len() > MOST_STAGES {
        let message = format!("{} stages are more than {MOST_STAGES}", stages.len());
        t.problem("stages", message, "give those from the motor to the table, each once");
    }
    stages
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_train_multiplies_its_stages() {
        let stages = vec![Stage { driving: 18, driven: 72 }, Stage { driving: 20, driven: 100 }];
        let drive = Drive { gearing: Gearing::Gears(stages), pitch_radius: None, stiffness: f64::INFINITY };
        assert_eq!((drive.ratio(), drive.last().unwrap().ratio()), (20.0, 5.0));
        assert_eq!(drive.shortest_period(), Some(TAU / 100.0));
        let gearing = Gearing::Worm { teeth: 180, starts: 2 };
        assert_eq!(Drive { gearing, ..drive }.ratio(), 90.0);
    }
}
