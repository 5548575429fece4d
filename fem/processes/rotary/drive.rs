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

/// A worm and its wheel on the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Worm {
    /// Teeth of the wheel.
    pub teeth: usize,
    /// Starts of the worm.
    pub starts: usize,
}

/// The drive, from the motor to the table. SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Drive {
    /// Pairs of gears: up to the table, or up to the worm; none where the motor turns that itself.
    pub stages: Vec<Stage>,
    /// The worm behind them, if there is one.
    pub worm: Option<Worm>,
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

/// Keys that not every type has, with those that have them.
const OWN: &[(&str, &[Kind])] = &[
    ("teeth", &[Kind::Worm]),
    ("starts", &[Kind::Worm]),
    ("stages", &[Kind::Gears, Kind::Worm]),
    ("pitch_radius", &[Kind::Worm, Kind::Gears]),
];

impl Drive {
    /// Reads `[drive]`.
    pub fn read(t: &Reader) -> Self {
        let kind = t.choice("type", "what turns the table", KINDS).required(Kind::Direct);
        let teeth = t.count("teeth", "of the worm wheel").between(1, MOST_TEETH).optional();
        let starts = t.count("starts", "of the worm").between(1, MOST_STARTS).or(1);
        let about = "pairs of gears from the motor to the table, or to the worm";
        let stages = t.list("stages", about, |t, _| Stage {
            driving: t.count("driving", "teeth of the gear towards the motor").between(1, MOST_TEETH).required(),
            driven: t.count("driven", "teeth of the gear towards the table").between(1, MOST_TEETH).required(),
        });
        let about = "pitch radius of the wheel on the table, for its eccentricity";
        let pitch_radius = t.quantity("pitch_radius", LENGTH, about).positive().optional();
        let about = "torsional stiffness of the drive at the table, the motor held; rigid if left out";
        let stiffness = t.quantity("stiffness", TORSIONAL_STIFFNESS, about).estimated(estimates::STIFFNESS);
        let stiffness = stiffness.positive().or(f64::INFINITY);
        for (key, owners) in OWN.iter().filter(|(key, owners)| t.has(key) && !owners.contains(&kind)) {
            let word = |kind: &Kind| KINDS.iter().find(|(_, own)| own == kind).map_or("", |(word, _)| *word);
            let help = format!("leave it out, or write type = \"{}\"", word(&owners[0]));
            t.problem(key, format!("a drive of the type `{}` has none", word(&kind)), help);
        }
        if kind == Kind::Worm && teeth.is_none() && !t.is_described() {
            t.problem("", "the worm wheel has no teeth", "add teeth = 180, those of the wheel");
        }
        if kind == Kind::Gears && stages.is_empty() && !t.is_described() {
            let help = "add stages = [{ driving = 20, driven = 100 }], from the motor to the table";
            t.problem("", "the train has no gears", help);
        }
        if stages.len() > MOST_STAGES {
            let message = format!("{} stages are more than {MOST_STAGES}", stages.len());
            t.problem("stages", message, "give those from the motor to the table, each once");
        }
        let worm = (kind == Kind::Worm).then_some(Worm { teeth: teeth.unwrap_or(1), starts });
        Self { stages, worm, pitch_radius, stiffness }
    }

    /// Turns of the motor in a turn of the table.
    pub fn ratio(&self) -> f64 {
        self.behind() * self.stages.iter().map(Stage::ratio).product::<f64>()
    }

    /// Turns of the worm in a turn of the table, if there is a worm.
    pub fn turns_of_worm(&self) -> Option<f64> {
        self.worm.map(|worm| worm.teeth as f64 / worm.starts as f64)
    }

    /// Meshes of the last pair of gears in a turn of the table, if there are gears.
    pub fn meshes(&self) -> Option<f64> {
        self.stages.last().map(|last| last.driven as f64 * self.behind())
    }

    /// Turns of the pinion of the last pair of gears in a turn of the table, if there are gears.
    pub fn turns_of_pinion(&self) -> Option<f64> {
        self.stages.last().map(|last| last.ratio() * self.behind())
    }

    /// Turns of the last gear in a turn of the table, which it is fixed to unless a worm follows.
    fn behind(&self) -> f64 {
        self.turns_of_worm().unwrap_or(1.0)
    }

    /// Whether the motor is on the table.
    pub fn is_direct(&self) -> bool {
        self.worm.is_none() && self.stages.is_empty()
    }

    /// Whether nothing in it yields.
    pub fn is_rigid(&self) -> bool {
        self.stiffness == f64::INFINITY
    }

    /// The angle of the table (rad) after which the fastest error comes back of what meets the table: a turn of the worm, or
    /// a tooth of the last gear; none of a direct drive.
    pub fn shortest_period(&self) -> Option<f64> {
        self.turns_of_worm().or_else(|| self.meshes()).map(|times| TAU / times)
    }

    /// The angles of the table (rad) after which errors of what meets the table come back, and what they are: turns and half
    /// turns of the worm, teeth of gears. None of a direct drive.
    pub fn periods(&self) -> Vec<(f64, &'static str)> {
        let worm = self.turns_of_worm().into_iter().flat_map(|turns| {
            [
                (turns, "a turn of the worm"),
                (2.0 * turns, "half a turn of the worm, at which its second harmonic comes back"),
            ]
        });
        let last = if self.worm.is_some() { "a tooth of the gears before the worm" } else { "a tooth of the wheel" };
        worm.chain(self.meshes().map(|meshes| (meshes, last))).map(|(times, what)| (TAU / times, what)).collect()
    }
}

impl Stage {
    /// Turns of the driving gear in a turn of the driven one.
    fn ratio(&self) -> f64 {
        self.driven as f64 / self.driving as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_train_multiplies_its_stages() {
        let stages = vec![Stage { driving: 18, driven: 72 }, Stage { driving: 20, driven: 100 }];
        let train = Drive { stages, worm: None, pitch_radius: None, stiffness: f64::INFINITY };
        assert_eq!((train.ratio(), train.meshes(), train.turns_of_pinion()), (20.0, Some(100.0), Some(5.0)));
        assert_eq!(train.shortest_period(), Some(TAU / 100.0));
        assert_eq!(train.periods(), [(TAU / 100.0, "a tooth of the wheel")]);
        // Two starts on 180 teeth: 90 to one behind the train.
        let behind = Drive { worm: Some(Worm { teeth: 180, starts: 2 }), ..train };
        assert_eq!((behind.ratio(), behind.meshes(), behind.turns_of_pinion()), (1800.0, Some(9000.0), Some(450.0)));
        assert_eq!(behind.shortest_period(), Some(TAU / 90.0));
        assert_eq!(
            behind.periods().iter().map(|own| own.0).collect::<Vec<_>>(),
            [90.0, 180.0, 9000.0].map(|n| TAU / n)
        );
    }
}
