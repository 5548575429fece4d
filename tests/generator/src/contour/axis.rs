//! One axis on a lap, in the steady state. Its drive follows the command through the servo; the slide is dragged
//! by the drive step by step, as far as play and what friction winds up leave it behind.

use std::f64::consts::PI;

/// Steps from one turn of the drive to the next. The drive goes one way between them, so that few would do.
const STEPS: usize = 48;
/// How often a step looks anew how wide the lost motion is where the slide then stands: 1e-5 of what is off is
/// left each time.
const LOOKS: usize = 4;

/// An axis on its lap in the steady state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    /// Of the commanded wave, mm.
    pub radius: f64,
    /// Turns of the command, rad/s.
    pub speed: f64,
    /// Kv, 1/s.
    pub gain: f64,
    /// By what part the gain grows with the speed of the axis, s/mm.
    pub change: f64,
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
    /// Place of the fixed bearing, mm.
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
        let behind = phase - (self.speed / self.gain).atan();
        let turned = (behind / PI).floor() * PI;
        // Over the half turn before the last turn the slide has come to lie behind its drive.
        let mut slide = self.drive(turned - PI).0;
        let way = |from: f64, to: f64| (1..=STEPS).map(move |k| from + (to - from) * k as f64 / STEPS as f64);
        for angle in way(turned - PI, turned).chain(way(turned, behind)) {
            slide = self.lost.dragged(slide, self.drive(angle).0);
        }
        State { place: slide, velocity: self.drive(behind).1, since: (behind - turned) / self.speed }
    }

    /// Place of the drive when its command stands at radius·cos(`phase`), mm.
    pub fn drive_at(&self, phase: f64) -> f64 {
        self.drive(phase - (self.speed / self.gain).atan()).0
    }

    /// Place (mm) and speed (mm/s) of a drive that lags by `behind`. A gain that changes with the speed v changes
    /// the lag v/Kv.
    fn drive(&self, behind: f64) -> (f64, f64) {
        let most = self.radius / (self.speed / self.gain).hypot(1.0);
        let velocity = -most * self.speed * behind.sin();
        let less = velocity / self.gain * (1.0 / (1.0 + self.change * velocity.abs()) - 1.0);
        (most * behind.cos() - less, velocity)
    }
}

impl Lost {
    /// Where a slide comes to stand from where it stood when the drive goes to `drive`.
    pub fn dragged(&self, slide: f64, drive: f64) -> f64 {
        let mut stands = slide;
        for _ in 0..LOOKS {
            let reach = self.half + self.growth * (stands - self.bearing).abs();
            stands = slide.clamp(drive - reach, drive + reach);
        }
        stands
    }
}
