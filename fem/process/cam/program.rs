//! The programme: where the wheel's centre is to be when blocks begin, and how fast the cam turns.

use std::f64::consts::TAU;

use super::motion::{Axes, Leg};
use super::profile::Profile;
use super::{fewest, model::Division, model::Pace};

/// A programme of one turn.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// Places of the profile at which blocks begin, and the whole length, m.
    pub places: Vec<f64>,
    /// What is commanded.
    pub axes: Axes,
    /// Of the cam over the turn, rad/s.
    pub mean_speed: f64,
}

/// The centre of a wheel as it follows a profile.
pub struct Guide<'a> {
    profile: &'a Profile,
    /// Of the wheel as it is programmed, m.
    radius: f64,
    /// s of each stretch, with the angle of the centre there and the angle turned through so far, either way, rad; the end last.
    turns: Vec<(f64, f64, f64)>,
}

impl<'a> Guide<'a> {
    /// A wheel of `radius` on a profile.
    pub fn new(profile: &'a Profile, radius: f64) -> Self {
        let first = profile.at(0.0);
        let centre = first.point + first.normal * radius;
        let (mut angle, mut through) = (centre.y.atan2(centre.x), 0.0);
        let mut turns = Vec::new();
        for (start, turn) in profile.wheel_turns(radius) {
            turns.push((start, angle, through));
            angle += turn;
            through += turn.abs();
        }
        turns.push((profile.length(), angle, through));
        Self { profile, radius, turns }
    }

    /// Polar angle of the wheel's centre that touches the profile at s, counted on from the start, and how far it has turned until there, either way, rad.
    /// Between 0 and the length of the profile.
    pub fn turn(&self, s: f64) -> (f64, f64) {
        let (start, turn) = self.profile.wheel_turn_in_stretch(s, true, self.radius);
        let i = self.turns.partition_point(|t| t.0 <= start).max(1) - 1;
        (self.turns[i].1 + turn, self.turns[i].2 + turn.abs())
    }

    /// Distance of the wheel's centre from the axis, m.
    pub fn slide(&self, s: f64) -> f64 {
        let place = self.profile.at(s);
        (place.point + place.normal * self.radius).norm()
    }

    /// The place until which the wheel has turned through an angle, either way: the inverse of [`Guide::turn`].
    pub fn place(&self, through: f64) -> f64 {
        let i = self.turns.partition_point(|t| t.2 <= through).clamp(1, self.turns.len() - 1);
        let (mut low, mut high) = (self.turns[i - 1].0, self.turns[i].0);
        let (from, to) = (self.turns[i - 1].2, self.turns[i].2);
        let mut s = low + (high - low) * ((through - from) / (to - from)).clamp(0.0, 1.0);
        for _ in 0..60 {
            let off = through - self.turn(s).1;
            *(if off > 0.0 { &mut low } else { &mut high }) = s;
            let step = off / wheel_rate(self.profile, self.radius, s);
            if step.abs() <= 1e-15 * self.profile.length() {
                break;
            }
            s = if s + step > low && s + step < high { s + step } else { 0.5 * (low + high) };
        }
        s
    }

    /// Radius of the wheel as it is programmed, m.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The leg of a block between two places, the wheel at the height of the axis.
    pub fn block(&self, from: f64, to: f64) -> Leg {
        let (turn, slide) = (self.turn(from).0, self.slide(from));
        Leg::new((turn, self.turn(to).0 - turn), (slide, self.slide(to) - slide), 0.0, 0, (0.0, 1.0))
    }
}

/// Angle through which the centre of a wheel of `radius` turns about the axis per length of profile at s, rad/m: |1 + κR|·(W·n)/|W|².
pub fn wheel_rate(profile: &Profile, radius: f64, s: f64) -> f64 {
    let place = profile.at(s);
    let centre = place.point + place.normal * radius;
    (1.0 + place.curvature * radius).abs() * centre.dot(&place.normal) / centre.norm_squared()
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

    /// Number of blocks.
    pub fn blocks(&self) -> usize {
        self.places.len() - 1
    }

    /// Number of the block whose part of the profile holds s.
    pub fn block_at(&self, s: f64) -> usize {
        self.places.partition_point(|p| *p <= s).clamp(1, self.blocks()) - 1
    }
}

/// Where blocks begin, and the end.
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
