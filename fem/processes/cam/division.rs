//! The division of a profile into blocks, and the pace of the programme.

use super::course::Accelerations;
use super::guide::Guide;
use super::profile::{MOST_BLOCKS, Profile};
use crate::input::Reader;
use crate::units::{ACCELERATION, ANGLE, ANGULAR_ACCELERATION, FEED_RATE, LENGTH, MICRO, SPINDLE_SPEED, TIME};

const ENDS: &[(&str, Ends)] = &[("on-profile", Ends::OnProfile), ("half-error", Ends::HalfError)];
const BREAKS: &[(&str, bool)] = &[("break", true), ("pass", false)];

/// The ways in which blocks are chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum By {
    /// Equal lengths of profile.
    Step,
    /// Equal turns of the cam.
    Angle,
    /// A number in all, of equal turns of the cam.
    Blocks,
    /// Blocks as long as a tolerance allows.
    Tolerance,
}

/// The division of a profile into blocks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Division {
    /// The choice of blocks.
    pub by: By,
    /// Step (m), angle (rad), number or tolerance (m).
    pub size: f64,
    /// Whether a block ends at every joint of the profile.
    pub at_joints: bool,
    /// Where the ends of blocks lie.
    pub ends: Ends,
}

/// The ends of blocks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// The wheel touches the profile where a block ends.
    OnProfile,
    /// It stands off by half of the block's error to the other side.
    HalfError,
}

/// The pace of the programme.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pace {
    /// The cam turns at one speed, rad/s.
    CamSpeed(f64),
    /// Every block takes the time of its length of profile at one feed, m/s.
    Feed(f64),
}

/// The pace and what limits it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Speed {
    /// The pace of the programme.
    pub pace: Pace,
    /// The accelerations that the axes allow.
    pub accelerations: Accelerations,
}

impl Speed {
    /// Reads how fast the programme runs from its table; `None` where it does not say.
    pub fn read(t: &Reader) -> Option<Self> {
        let pace = Pace::read(t);
        let about = "of the cam: every block then begins and ends at rest";
        let cam = t.quantity("cam_acceleration", ANGULAR_ACCELERATION, about).positive().optional();
        let about = "of the slide: every block then begins and ends at rest";
        let slide = t.quantity("slide_acceleration", ACCELERATION, about).positive().optional();
        let [cam, slide] = [cam, slide].map(|limit| limit.unwrap_or(f64::INFINITY));
        pace.map(|pace| Self { pace, accelerations: Accelerations { cam, slide } })
    }
}

impl Division {
    /// Reads how blocks are chosen from the table of the programme.
    pub fn read(t: &Reader, pace: Option<Pace>) -> Option<Self> {
        let step = t.quantity("step", LENGTH, "blocks of equal length of profile").chosen().positive().optional();
        let angle = t.quantity("angle", ANGLE, "blocks of equal turn of the cam").chosen().positive().optional();
        let about = "blocks of equal time: of equal turn at one cam_speed, of equal length at one feed";
        let time = t.quantity("time", TIME, about).chosen().positive().optional();
        let blocks = t.count("blocks", "so many blocks of equal turn in all").between(1, MOST_BLOCKS).optional();
        let about = "the fewest blocks that keep the profile within this on either side";
        let tolerance = t.quantity("tolerance", MICRO, about).chosen().positive().optional();
        let about = "whether a block ends at every joint of the profile's segments or may pass over them";
        let at_joints = t.choice("joints", about, BREAKS).or_first(true);
        let about =
            "whether blocks end on the profile or are shifted by half of their error, which then lies on both sides";
        let ends = t.choice("ends", about, ENDS).or_first(Ends::OnProfile);
        let (by_time, rate) = match pace {
            Some(Pace::CamSpeed(speed)) => (By::Angle, speed),
            Some(Pace::Feed(feed)) => (By::Step, feed),
            None => (By::Step, f64::NAN),
        };
        let ways = [
            (By::Step, step),
            (By::Angle, angle),
            (by_time, time.map(|time| time * rate)),
            (By::Blocks, blocks.map(|blocks| blocks as f64)),
            (By::Tolerance, tolerance),
        ];
        let given: Vec<(By, f64)> = ways.into_iter().filter_map(|(by, size)| size.map(|size| (by, size))).collect();
        let refuse = |message: &str, help: &str| {
            t.problem("", message, help);
            None
        };
        match given[..] {
            [(by, size)] => size.is_finite().then_some(Self { by, size, at_joints, ends }),
            [] => refuse(
                "the programme does not say how blocks are chosen",
                "add step = \"0.5 mm\", angle, time, blocks or tolerance",
            ),
            _ => refuse(
                "the programme says in more than one way how blocks are chosen",
                "keep one of step, angle, time, blocks, tolerance",
            ),
        }
    }

    /// Whether a profile can be divided so, for a wheel of `radius`; else a problem is noted, save where the
    /// radius is not known. `own` are the blocks that segments ask for themselves.
    pub fn check(&self, t: &Reader, profile: &Profile, own: &[Option<usize>], radius: f64) -> bool {
        if !(radius.is_finite() && radius > 0.0) {
            return false;
        }
        let most = MOST_BLOCKS as f64;
        let (key, count) = match self.by {
            By::Step => ("step", profile.length() / self.size),
            By::Angle => ("angle", Guide::new(profile, radius).turn(profile.length()).1 / self.size),
            // The error goes with the square of the length, and the whole profile in one block errs by about
            // its size.
            By::Tolerance => ("tolerance", (profile.size() / self.size).sqrt()),
            By::Blocks => {
                let least: usize = if self.at_joints { own.iter().map(|blocks| blocks.unwrap_or(1)).sum() } else { 1 };
                let is_enough = self.size >= least as f64;
                if !is_enough {
                    let message = format!("{} blocks are too few: {least} are needed to end at every joint", self.size);
                    t.problem("blocks", message, "take more, or joints = \"pass\"");
                }
                return is_enough;
            }
        };
        let asked: usize = own.iter().flatten().sum();
        let count = count.max(asked as f64);
        if count > most {
            t.problem(key, format!("these are more than {most} blocks"), "take longer ones");
        }
        count <= most
    }

    /// Number of blocks in each range, where that follows from the ranges alone; `own` are those that say it
    /// themselves.
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

    /// Divides a range into `count` blocks, equal in length of profile or in turn of the cam: the places with
    /// the last and without the first.
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
    /// Reads the pace from the table of the programme.
    fn read(t: &Reader) -> Option<Self> {
        let speed = t.quantity("cam_speed", SPINDLE_SPEED, "the cam turns at this speed").positive().optional();
        let about = "every block takes the time of its length of profile at this feed, and the cam turns as that needs";
        let feed = t.quantity("feed", FEED_RATE, about).positive().optional();
        match (speed, feed) {
            (Some(speed), None) => return Some(Self::CamSpeed(speed)),
            (None, Some(feed)) => return Some(Self::Feed(feed)),
            (None, None) => {
                t.problem("", "the programme does not say how fast it runs", "add cam_speed = \"20 rpm\", or feed");
            }
            (Some(_), Some(_)) => {
                t.problem("feed", "`cam_speed` and `feed` both say how fast the programme runs", "keep one of them");
            }
        }
        None
    }
}
