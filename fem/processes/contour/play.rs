//! Lost motion between the drive of an axis and its slide: clearance, and friction that winds the drive up.
//!
//! The slide stands until the drive is off by half of the clearance and winds its spring up to the
//! friction, and is then carried along: the play operator with the half width h = δ/2 + F/C(x), 1/C(x) =
//! 1/C_n + |x − x_b|/(EA) at the place x of the slide [seed 000, fig. 2, both in series].

use crate::joint::lost_motion;
use crate::process::Winding;

/// The lost motion of an axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Play {
    /// Kinematic clearance δ, m.
    pub gap: f64,
    /// Drive that friction winds up.
    pub winding: Option<Winding>,
}

impl Play {
    /// Elastic part 2F/C of the width where the slide stands at x (m), m.
    pub fn elastic(&self, x: f64) -> f64 {
        self.winding.as_ref().map_or(0.0, |winding| 2.0 * winding.displacement(x))
    }

    /// Width where the slide stands at x (m), m.
    pub fn width(&self, x: f64) -> f64 {
        lost_motion(self.gap, 0.5 * self.elastic(x))
    }

    /// Whether motion is lost at all.
    pub fn is_any(&self) -> bool {
        self.gap > 0.0 || self.winding.as_ref().is_some_and(|w| w.friction > 0.0)
    }

    /// Place of a slide that stood at `slide` when its drive comes to `drive`, m: it stays, or is carried
    /// along.
    pub fn carry(&self, slide: f64, drive: f64) -> f64 {
        slide.max(self.behind(drive, 1.0)).min(self.behind(drive, -1.0))
    }

    /// Place of the slide that the drive pushes the way of `sign`: x + sign·h(x) = drive.
    fn behind(&self, drive: f64, sign: f64) -> f64 {
        let mut x = drive - sign * 0.5 * self.gap;
        if self.winding.is_some() {
            // h changes by F/(EA) of x, some 1e-5: four steps leave round-off.
            for _ in 0..4 {
                x = drive - sign * 0.5 * self.width(x);
            }
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::solve::Bar;

    #[test]
    fn the_slide_is_carried_where_the_spring_is_wound_up_to_the_friction() {
        let screw = Bar { axial_rigidity: 1.6e8, held: vec![-0.4] };
        let play = Play { gap: 6e-6, winding: Some(Winding::new(800.0, 2e8, screw, None)) };
        for sign in [1.0, -1.0] {
            let slide = play.carry(-sign, 0.1);
            // The spring carries what is left of the way behind the clearance.
            let wound = sign * (0.1 - slide) - 3e-6;
            let force = wound / (1.0 / 2e8 + (slide + 0.4) / 1.6e8);
            assert!((force - 800.0).abs() < 1e-6, "{force}");
        }
        let standing = play.carry(0.1, 0.1 + 0.49 * play.width(0.1));
        assert_eq!(standing, 0.1);
        assert!((play.width(0.1) - 6e-6 - 1600.0 * (5e-9 + 0.5 / 1.6e8)).abs() < 1e-18);
    }
}
