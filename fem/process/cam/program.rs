//! The programme: where the wheel's centre is to be when blocks begin, and how fast the cam turns.

use std::f64::consts::TAU;

use super::division::{Division, Pace};
use super::fewest;
use super::guide::Guide;
use super::motion::Axes;
use super::profile::Profile;

/// A programme of one turn.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// Places of the profile at which blocks begin, and the whole length, m.
    pub places: Vec<f64>,
    /// The commands of the axes.
    pub axes: Axes,
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
    pub fn new(profile: &Profile, radius: f64, division: &Division, own: &[Option<usize>], pace: Pace) -> Self {
        let guide = Guide::new(profile, radius);
        let places = places(&guide, profile, division, own);
        let (turns, through): (Vec<f64>, Vec<f64>) = places.iter().map(|s| guide.turn(*s)).unzip();
        let slides: Vec<f64> = places.iter().map(|s| guide.slide(*s)).collect();
        let times: Vec<f64> = match pace {
            Pace::CamSpeed(speed) => through.iter().map(|angle| angle / speed).collect(),
            Pace::Feed(feed) => places.iter().map(|s| s / feed).collect(),
        };
        let mean_speed = TAU / times.last().copied().unwrap_or(f64::NAN);
        Self { places, axes: Axes { times, turns, slides }, mean_speed }
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

/// Places at which blocks begin, and the end, m.
fn places(guide: &Guide, profile: &Profile, division: &Division, own: &[Option<usize>]) -> Vec<f64> {
    let joints = profile.joints();
    let whole = [0.0, profile.length()];
    let joints: &[f64] = if division.at_joints { joints } else { &whole };
    let ranges: Vec<(f64, f64)> = joints.windows(2).map(|w| (w[0], w[1])).collect();
    let own = |i: usize| if division.at_joints { own.get(i).copied().flatten() } else { None };
    let shares = division.shares(guide, &ranges, &own);
    let mut places = vec![0.0];
    for (i, (from, to)) in ranges.into_iter().enumerate() {
        match (own(i), shares.get(i)) {
            (Some(count), _) => places.extend(division.spread(guide, from, to, count)),
            (None, Some(count)) => places.extend(division.spread(guide, from, to, *count)),
            (None, None) => places.extend(fewest::places(guide, profile, from, to, division.size)),
        }
    }
    places
}
