//! One axis on a lap. Behind its servo it moves as A·cos ψ, and play and what friction winds up are told in
//! closed form from the end at which it last turned round.

use std::f64::consts::PI;

/// An axis on its lap in the steady state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    /// Of the commanded wave, mm.
    pub radius: f64,
    /// Turns of the command, rad/s.
    pub speed: f64,
    /// Kv, 1/s.
    pub gain: f64,
    /// Lost motion.
    pub lost: Lost,
}

/// Half of the lost motion where the slide stands at s, mm: `half` + `growth`·|s − `bearing`|.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Lost {
    /// Half of the play, and what friction winds up beside the screw, mm.
    pub half: f64,
    /// Friction over EA of the screw.
    pub growth: f64,
    /// Place of the fixed bearing, beyond either end of the travel, mm.
    pub bearing: f64,
}

/// Where an axis is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Of the slide behind its play, mm.
    pub place: f64,
    /// Of the drive, mm/s.
    pub velocity: f64,
    /// Since the drive turned round, s.
    pub since: f64,
}

impl Axis {
    /// Where it is when its command stands at radius·cos(`phase`), the phase rising.
    pub fn at(&self, phase: f64) -> State {
        // The steady state of 1/(1 + s/Kv).
        let ratio = self.speed / self.gain;
        let (most, behind) = (self.radius / ratio.hypot(1.0), phase - ratio.atan());
        let drive = most * behind.cos();
        let place = if behind.sin() > 0.0 {
            self.lost.slide(most, 1.0).min(self.lost.slide(drive, -1.0))
        } else {
            self.lost.slide(-most, -1.0).max(self.lost.slide(drive, 1.0))
        };
        let since = behind.rem_euclid(PI) / self.speed;
        State { place, velocity: -most * self.speed * behind.sin(), since }
    }
}

impl Lost {
    /// Place of a slide that the drive at `drive` pushes the way of `way`: s + way·(half + growth·|s − bearing|)
    /// = drive, straight in s as the bearing lies beyond the travel.
    fn slide(&self, drive: f64, way: f64) -> f64 {
        let side = if self.bearing < drive { way } else { -way };
        (drive - way * self.half + side * self.growth * self.bearing) / (1.0 + side * self.growth)
    }
}
