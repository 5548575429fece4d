//! The tables of a cam model.

use super::profile::{self, Drawn, Profile, Segment};
use super::program::{Guide, Program, wheel_rate};
use crate::input::Reader;
use crate::units::{ANGLE, FEED_RATE, FORCE_PER_RATE, LENGTH, MICRO, SPINDLE_SPEED, TIME};

/// Most blocks of a programme: some a second of arc.
const MOST_BLOCKS: usize = 1_000_000;

/// By what blocks are chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// Equal lengths of profile.
    Step,
    /// Equal turns of the cam.
    Angle,
    /// So many in all, of equal turns of the cam.
    Blocks,
    /// As long as a tolerance allows.
    Tolerance,
}

/// How a profile is divided into blocks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Division {
    /// By what.
    pub by: By,
    /// Step (m), angle (rad), number or tolerance (m).
    pub size: f64,
    /// Whether a block ends at every joint of the profile.
    pub at_joints: bool,
}

/// How fast the programme runs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pace {
    /// The cam turns at one speed, rad/s.
    CamSpeed(f64),
    /// Every block takes the time of its length of profile at one feed, m/s.
    Feed(f64),
}

/// Everything a cam model says but its effects. SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// What the cam is to be.
    pub profile: Profile,
    /// Of what it is drawn.
    pub segments: Vec<Segment>,
    /// Of the wheel, as it is programmed, m.
    pub wheel_radius: f64,
    /// Thickness of the layer that a turn takes off, m.
    pub stock: Option<f64>,
    /// Normal force per removal rate and unit width, N/(m²/s).
    pub force_per_rate: Option<f64>,
    /// How blocks are chosen.
    pub division: Division,
    /// The programme.
    pub program: Program,
    /// Points of the prediction in each block.
    pub points: usize,
}

const BREAKS: &[(&str, bool)] = &[("break", true), ("pass", false)];

impl Setup {
    /// Reads every table of a cam model but `[effects]`; `None`, with the problems noted, where there is no profile or no programme.
    pub fn read(model: &Reader) -> Option<Self> {
        let setup = Self::read_tables(model);
        if setup.is_none() && model.is_sound() && !model.is_described() {
            let help = "give it a value, `+-` how well it is known; what a wheel has lost is the effect wheel-wear";
            model.problem("", "a profile, a wheel or a programme that is unknown (`?`) makes no cam", help);
        }
        setup
    }

    fn read_tables(model: &Reader) -> Option<Self> {
        let drawn = model.table("profile", "what the cam is to be, about its axis at (0, 0)", |t| {
            let table = profile::read_lift(t);
            if t.is_described() || table.is_none() {
                return profile::read_chain(t);
            }
            for key in ["start", "segments"].into_iter().filter(|key| t.has(key)) {
                t.problem(key, format!("`{key}` and `table` both draw the profile"), "keep one of them");
            }
            table.flatten()
        });
        let wheel_radius = model.table("wheel", "the grinding wheel", |t| {
            t.quantity("radius", LENGTH, "its radius, for which the programme is made").positive().required()
        });
        let cut = model.optional_table("cut", "what is ground", |t| {
            let stock =
                t.quantity("stock", MICRO, "thickness of the layer that a turn takes off").positive().optional();
            let about =
                "normal force per removal rate, which grinding-deflection needs; for the whole width of the cam";
            (stock, t.quantity("force_per_rate", FORCE_PER_RATE, about).positive().optional())
        });
        let (stock, force_per_rate) = cut.unwrap_or_default();
        let points = model.optional_table("measurement", "where the cam is predicted", |t| {
            t.count("points", "points in each block").between(1, 1000).optional()
        });
        let points = points.flatten();
        let (division, pace, problem) = model.table("program", "how the cam is programmed", |t| {
            let pace = Pace::read(t);
            let division = Division::read(t, pace);
            let problem = match (&drawn, division, pace) {
                (Some(drawn), Some(division), Some(_)) if wheel_radius.is_finite() => {
                    division.refuse(&drawn.profile, &drawn.segments, wheel_radius)
                }
                _ => None,
            };
            if let Some((key, message, help)) = &problem {
                t.problem(key, message, *help);
            }
            (division, pace, problem.is_some())
        });
        let Drawn { profile, segments } = drawn?;
        let (division, pace) = (division?, pace?);
        if problem || !wheel_radius.is_finite() || wheel_radius <= 0.0 {
            return None;
        }
        let own: Vec<Option<usize>> = segments.iter().map(|s| s.blocks).collect();
        let program = Program::new(&profile, wheel_radius, &division, &own, pace);
        // So many that each block shows its error, and no more than a picture holds.
        let usual = (7200 / program.blocks()).clamp(2, 10);
        let points = points.filter(|points| *points > 0).unwrap_or(usual);
        Some(Self { profile, segments, wheel_radius, stock, force_per_rate, division, program, points })
    }

    /// Why an effect cannot act on this cam, if it cannot.
    ///
    /// # Errors
    /// The reason, as a sentence.
    pub fn admits(&self, effect: &str) -> Result<(), String> {
        match effect {
            "grinding-deflection" if self.stock.is_none() => {
                Err("`grinding-deflection` needs the layer that is taken off: stock = \"20 um\" in [cut]".into())
            }
            "grinding-deflection" if self.force_per_rate.is_none() => {
                Err("`grinding-deflection` needs the force of the cut: force_per_rate = \"10 N/(mm^2/s)\" in [cut]"
                    .into())
            }
            _ => Ok(()),
        }
    }

    /// Places of the profile at which the cam is predicted: within each block evenly, m.
    pub fn places(&self) -> Vec<f64> {
        let within = |w: &[f64]| {
            let (from, length) = (w[0], w[1] - w[0]);
            (0..self.points).map(move |k| from + length * (k as f64 + 0.5) / self.points as f64).collect::<Vec<_>>()
        };
        self.program.places.windows(2).flat_map(within).collect()
    }

    /// How fast the grinding point goes along the profile at s when the programme runs at its own speed, m/s.
    pub fn feed(&self, s: f64) -> f64 {
        let axes = &self.program.axes;
        let block = self.program.block_at(s);
        let time = axes.times[block + 1] - axes.times[block];
        ((axes.turns[block + 1] - axes.turns[block]) / time).abs() / wheel_rate(&self.profile, self.wheel_radius, s)
    }
}

impl Division {
    fn read(t: &Reader, pace: Option<Pace>) -> Option<Self> {
        let step = t.quantity("step", LENGTH, "blocks of equal length of profile").positive().optional();
        let angle = t.quantity("angle", ANGLE, "blocks of equal turn of the cam").positive().optional();
        let about = "blocks of equal time: of equal turn at one cam_speed, of equal length at one feed";
        let time = t.quantity("time", TIME, about).positive().optional();
        let blocks = t.count("blocks", "so many blocks of equal turn in all").between(1, MOST_BLOCKS).optional();
        let about = "the fewest blocks that keep the profile within this on either side";
        let tolerance = t.quantity("tolerance", MICRO, about).positive().optional();
        let about = "whether a block ends at every joint of the profile's segments or may pass over them";
        let at_joints = t.choice("joints", about, BREAKS).or_first(true);
        let (by_time, rate) = match pace {
            Some(Pace::CamSpeed(speed)) => (By::Angle, speed),
            Some(Pace::Feed(feed)) => (By::Step, feed),
            None => (By::Step, f64::NAN),
        };
        let count = blocks.map(|blocks| blocks as f64);
        let ways = [
            (By::Step, step),
            (By::Angle, angle),
            (by_time, time.map(|time| time * rate)),
            (By::Blocks, count),
            (By::Tolerance, tolerance),
        ];
        let given: Vec<(By, f64)> = ways.into_iter().filter_map(|(by, size)| size.map(|size| (by, size))).collect();
        match given[..] {
            [(by, size)] => size.is_finite().then_some(Self { by, size, at_joints }),
            [] if t.is_described() => None,
            [] => {
                t.problem(
                    "",
                    "the programme does not say how blocks are chosen",
                    "add step = \"0.5 mm\", angle, time, blocks or tolerance",
                );
                None
            }
            _ => {
                t.problem(
                    "",
                    "the programme says in more than one way how blocks are chosen",
                    "keep one of step, angle, time, blocks, tolerance",
                );
                None
            }
        }
    }

    /// What forbids this division: the key, the reason and the remedy.
    fn refuse(
        &self,
        profile: &Profile,
        segments: &[Segment],
        radius: f64,
    ) -> Option<(&'static str, String, &'static str)> {
        let guide = Guide::new(profile, radius);
        let asked: usize = segments.iter().filter_map(|s| s.blocks).sum();
        let open = segments.iter().filter(|s| s.blocks.is_none()).count();
        let most = MOST_BLOCKS as f64;
        let (key, count) = match self.by {
            By::Step => ("step", profile.length() / self.size),
            By::Angle => ("angle", guide.turn(profile.length()).1 / self.size),
            // The error goes with the square of the length, and the whole profile in one block errs by about its size.
            By::Tolerance => ("tolerance", (profile.size() / self.size).sqrt()),
            By::Blocks => {
                let least = if self.at_joints { asked + open } else { 1 };
                let message = || format!("{} blocks are too few: {least} are needed to end at every joint", self.size);
                return (self.size < least as f64).then(|| ("blocks", message(), "take more, or joints = \"pass\""));
            }
        };
        (count > most).then(|| (key, format!("these are more than {most} blocks"), "take longer ones"))
    }

    /// Number of blocks in each range, where that follows from the ranges alone; `own` are those that say it themselves.
    pub fn shares(&self, guide: &Guide, ranges: &[(f64, f64)], own: &dyn Fn(usize) -> Option<usize>) -> Vec<usize> {
        let turn = |(from, to): &(f64, f64)| guide.turn(*to).1 - guide.turn(*from).1;
        // What divides without a rest must not become one more by round-off.
        let parts = |whole: f64| (whole / self.size - 1e-9).ceil().max(1.0) as usize;
        match self.by {
            By::Step => ranges.iter().map(|(from, to)| parts(to - from)).collect(),
            By::Angle => ranges.iter().map(|r| parts(turn(r))).collect(),
            By::Tolerance => Vec::new(),
            By::Blocks => {
                let mut shares: Vec<usize> = (0..ranges.len()).map(|i| own(i).unwrap_or(1)).collect();
                let turns: Vec<f64> = ranges.iter().map(turn).collect();
                // Each further block where blocks are longest.
                for _ in shares.iter().sum::<usize>()..self.size as usize {
                    let length = |i: &usize| turns[*i] / shares[*i] as f64;
                    let open = (0..ranges.len()).filter(|i| own(*i).is_none());
                    match open.max_by(|a, b| length(a).total_cmp(&length(b))) {
                        Some(longest) => shares[longest] += 1,
                        None => break,
                    }
                }
                shares
            }
        }
    }

    /// Divides a range into `count` blocks, equal in length of profile or in turn of the cam: the places with the last and without the first.
    pub fn spread(&self, guide: &Guide, from: f64, to: f64, count: usize) -> Vec<f64> {
        let (start, end) = (guide.turn(from).1, guide.turn(to).1);
        let place = |k: usize| match self.by {
            _ if k == count => to,
            By::Step | By::Tolerance => from + (to - from) * k as f64 / count as f64,
            By::Angle | By::Blocks => guide.place(start + (end - start) * k as f64 / count as f64),
        };
        (1..=count).map(place).collect()
    }
}

impl Pace {
    fn read(t: &Reader) -> Option<Self> {
        let speed = t.quantity("cam_speed", SPINDLE_SPEED, "the cam turns at this speed").positive().optional();
        let about = "every block takes the time of its length of profile at this feed, and the cam turns as that needs";
        let feed = t.quantity("feed", FEED_RATE, about).positive().optional();
        match (speed, feed) {
            (Some(speed), None) => Some(Self::CamSpeed(speed)),
            (None, Some(feed)) => Some(Self::Feed(feed)),
            _ if t.is_described() => None,
            (None, None) => {
                t.problem("", "the programme does not say how fast it runs", "add cam_speed = \"20 rpm\", or feed");
                None
            }
            (Some(_), Some(_)) => {
                t.problem("feed", "`cam_speed` and `feed` both say how fast the programme runs", "keep one of them");
                None
            }
        }
    }
}
