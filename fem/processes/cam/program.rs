//! The programme: where the wheel's centre is to be when blocks begin, and how fast the cam turns.

use std::f64::consts::TAU;

use super::course::{Accelerations, Course};
use super::division::{Division, Ends, Pace, Speed};
use super::fewest;
use super::guide::Guide;
use super::motion::Axes;
use super::profile::Profile;
use super::shifted;

/// A programme of one turn.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// Places of the profile at which blocks begin, and the whole length, m.
    pub places: Vec<f64>,
    /// How far outwards along the normal the wheel's centre is shifted at each of them, m.
    pub shifts: Vec<f64>,
    /// The commands of the axes.
    pub axes: Axes,
    /// Time of a turn if blocks passed without rest, s.
    pub steady_time: f64,
    /// The course of each block.
    pub courses: Vec<Course>,
    /// Mean speed of the cam over the turn, rad/s.
    pub mean_speed: f64,
}

/// One turn by the programme.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pass {
    /// Mean speed of the cam, rad/s.
    pub speed: f64,
    /// Whether the programme runs from its end to its beginning.
    pub is_reversed: bool,
}

impl Program {
    /// Divides a profile for a wheel of `radius`. `own` are the blocks that segments ask for themselves.
    pub fn new(profile: &Profile, radius: f64, division: &Division, own: &[Option<usize>], speed: &Speed) -> Self {
        let guide = Guide::new(profile, radius);
        let (places, shifts): (Vec<f64>, Vec<f64>) = points(&guide, profile, division, own).into_iter().unzip();
        let points: Vec<(f64, f64, f64)> =
            places.iter().zip(&shifts).map(|(s, shift)| guide.point(*s, *shift)).collect();
        let through: Vec<f64> = points.iter().map(|p| p.1).collect();
        let (turns, slides): (Vec<f64>, Vec<f64>) = points.iter().map(|p| (p.0, p.2)).unzip();
        let steady: Vec<f64> = match speed.pace {
            Pace::CamSpeed(speed) => through.iter().map(|angle| angle / speed).collect(),
            Pace::Feed(feed) => places.iter().map(|s| s / feed).collect(),
        };
        let end = |times: &[f64]| times.last().copied().unwrap_or(f64::NAN);
        let steady_time = end(&steady);
        let (times, courses) = match speed.accelerations.are_unlimited() {
            true => (steady, vec![Course::STEADY; places.len() - 1]),
            false => limited(&steady, [&turns, &slides], &speed.accelerations),
        };
        let mean_speed = TAU / end(&times);
        Self { places, shifts, axes: Axes { times, turns, slides }, steady_time, courses, mean_speed }
    }

    /// The programme as it runs when nothing else is said.
    pub fn usual(&self) -> Pass {
        Pass { speed: self.mean_speed, is_reversed: false }
    }

    /// Number of blocks.
    pub fn blocks(&self) -> usize {
        self.places.len() - 1
    }

    /// The place of the profile at a part of a block, m.
    pub fn place(&self, block: usize, part: f64) -> f64 {
        self.places[block] + part * (self.places[block + 1] - self.places[block])
    }

    /// Places in the middle of so many equal parts of a block, m.
    pub fn middles(&self, block: usize, count: usize) -> impl Iterator<Item = f64> {
        (0..count).map(move |k| self.place(block, (k as f64 + 0.5) / count as f64))
    }

    /// Length of profile of a block, m.
    pub fn length(&self, block: usize) -> f64 {
        self.places[block + 1] - self.places[block]
    }

    /// Time of a block, s.
    pub fn time(&self, block: usize) -> f64 {
        self.axes.times[block + 1] - self.axes.times[block]
    }

    /// Number of places looked at in a block: fewer where there are many blocks, and more where its
    /// neighbours are much shorter and may reach into it.
    pub fn samples(&self, block: usize) -> usize {
        let count = self.blocks();
        let usual = (17_280 / count).clamp(6, 24) as f64;
        let beside = [(block + count - 1) % count, block, (block + 1) % count];
        let shortest = beside.map(|block| self.length(block)).into_iter().fold(f64::INFINITY, f64::min);
        (usual * self.length(block) / shortest).ceil().min(400.0) as usize
    }

    /// Number of the block whose part of the profile holds s.
    pub fn block_at(&self, s: f64) -> usize {
        self.places.partition_point(|p| *p <= s).clamp(1, self.blocks()) - 1
    }
}

/// Times stretched to what the accelerations allow in every block, and its course.
fn limited(steady: &[f64], axes: [&[f64]; 2], accelerations: &Accelerations) -> (Vec<f64>, Vec<Course>) {
    let (mut times, mut courses, mut end) = (vec![0.0], Vec::new(), 0.0);
    for (block, ends) in steady.windows(2).enumerate() {
        let [turned, slid] = axes.map(|axis| axis[block + 1] - axis[block]);
        let (time, course) = Course::limited(ends[1] - ends[0], accelerations.of_block(turned, slid));
        end += time;
        times.push(end);
        courses.push(course);
    }
    (times, courses)
}

/// Places at which blocks begin, and the end, each with its shift, m.
pub fn points(guide: &Guide, profile: &Profile, division: &Division, own: &[Option<usize>]) -> Vec<(f64, f64)> {
    let joints = profile.joints();
    let whole = [0.0, profile.length()];
    let joints: &[f64] = if division.at_joints { joints } else { &whole };
    let ranges: Vec<(f64, f64)> = joints.windows(2).map(|w| (w[0], w[1])).collect();
    let own = |i: usize| if division.at_joints { own.get(i).copied().flatten() } else { None };
    let shares = division.shares(guide, &ranges, &own);
    let mut points = vec![(0.0, 0.0)];
    for (i, (from, to)) in ranges.into_iter().enumerate() {
        let count = own(i).or_else(|| shares.get(i).copied());
        match (count, division.ends) {
            (Some(count), ends) => {
                let places: Vec<f64> = [from].into_iter().chain(division.spread(guide, from, to, count)).collect();
                let shifts = match ends {
                    Ends::OnProfile => vec![0.0; places.len()],
                    Ends::HalfError => shifted::shifts(guide, profile, &places),
                };
                points.extend(places.into_iter().zip(shifts).skip(1));
            }
            (None, Ends::OnProfile) => {
                let error = |from: f64, to: f64| fewest::error(profile, guide, (from, 0.0), (to, 0.0));
                points.extend(fewest::places(profile, (from, to), division.size, error).into_iter().map(|s| (s, 0.0)));
            }
            (None, Ends::HalfError) => points.extend(shifted::fewest(guide, profile, (from, to), division.size)),
        }
    }
    points
}
