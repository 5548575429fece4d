//! The way of the wheel's centre along a profile, as it is programmed.

use super::motion::Leg;
use super::profile::{Profile, turn};
use super::search::root;

/// The centre of a wheel as it follows a profile.
pub struct Guide<'a> {
    profile: &'a Profile,
    /// Radius of the wheel as it is programmed, m.
    radius: f64,
    /// s of each stretch, with the angle of the centre there and the angle turned through so far, either way,
    /// rad; the end last.
    turns: Vec<(f64, f64, f64)>,
}

impl<'a> Guide<'a> {
    /// A wheel of `radius` on a profile.
    pub fn new(profile: &'a Profile, radius: f64) -> Self {
        let centre = profile.at(0.0).outside(radius);
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

    /// Polar angle of the wheel's centre that touches the profile at s, counted on from the start, and how
    /// far it has turned until there, either way, rad. Between 0 and the length of the profile.
    pub fn turn(&self, s: f64) -> (f64, f64) {
        let (start, turn) = self.profile.wheel_turn(s, self.radius);
        let i = self.turns.partition_point(|t| t.0 <= start).max(1) - 1;
        (self.turns[i].1 + turn, self.turns[i].2 + turn.abs())
    }

    /// The place until which the wheel has turned through an angle, either way: the inverse of
    /// [`Guide::turn`].
    pub fn place(&self, through: f64) -> f64 {
        let i = self.turns.partition_point(|t| t.2 <= through).clamp(1, self.turns.len() - 1);
        let ((low, _, from), (high, _, to)) = (self.turns[i - 1], self.turns[i]);
        let first = low + (high - low) * ((through - from) / (to - from)).clamp(0.0, 1.0);
        let step = |s: f64| (through - self.turn(s).1) / wheel_rate(self.profile, self.radius, s);
        root(step, first, (low, high), 1e-15 * self.profile.length())
    }

    /// Radius of the wheel as it is programmed, m.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The wheel's centre when it touches the profile at s, or stands `shift` (m) farther out along the
    /// normal there: its polar angle counted on from the start, how far it has turned until there, either
    /// way (rad), and its distance from the axis (m).
    pub fn point(&self, s: f64, shift: f64) -> (f64, f64, f64) {
        let (angle, through) = self.turn(s);
        let place = self.profile.at(s);
        let shifted = place.outside(self.radius + shift);
        let further = turn(&place.outside(self.radius), &shifted);
        (angle + further, through + self.profile.sense() * further, shifted.norm())
    }

    /// The leg of a block between two places, each with its shift outwards (m), the wheel at the height of
    /// the axis.
    pub fn block(&self, from: (f64, f64), to: (f64, f64)) -> Leg {
        let ((turn, _, slide), (next, _, next_slide)) = (self.point(from.0, from.1), self.point(to.0, to.1));
        Leg::new((turn, next - turn), (slide, next_slide - slide), 0.0, 0, (0.0, 1.0))
    }
}

/// Angle through which the centre of a wheel of `radius` turns about the axis per length of profile at s,
/// rad/m: |1 + κR|·(W·n)/|W|².
pub fn wheel_rate(profile: &Profile, radius: f64, s: f64) -> f64 {
    let place = profile.at(s);
    let centre = place.outside(radius);
    (1.0 + place.curvature * radius).abs() * centre.dot(&place.normal) / centre.norm_squared()
}
