//! The course of time within a block.
//!
//! Cam and slide go linearly with each other, whatever the speed. Where their accelerations are limited
//! they start from rest, run at the speed of the programme, and come to rest at the end: a trapezoid over
//! time, or a triangle where the block is too short to reach the speed [kinematics of an exact stop]. A
//! controller that looks ahead and does not stop is left out.

/// Time over way within a block.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Course {
    /// Part of the block's time that speeding up takes, and as long braking: from 0 to 1/2.
    ramp: f64,
}

/// Largest accelerations of the axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accelerations {
    /// Of the cam, rad/s²; infinite where it does not limit.
    pub cam: f64,
    /// Of the slide, m/s²; infinite where it does not limit.
    pub slide: f64,
}

impl Accelerations {
    /// Whether nothing limits them, and blocks pass without rest.
    pub fn are_unlimited(&self) -> bool {
        self.cam.is_infinite() && self.slide.is_infinite()
    }

    /// The greatest acceleration of a block in which the axes go so far (rad, m), in parts of it, 1/s².
    pub fn of_block(&self, turned: f64, slid: f64) -> f64 {
        (self.cam / turned.abs()).min(self.slide / slid.abs())
    }
}

impl Course {
    /// At one speed all over the block.
    pub const STEADY: Self = Self { ramp: 0.0 };

    /// The time (s) of a block with its course, where at the speed of the programme it would take `time`
    /// (s), and the acceleration is `acceleration` (parts of the block, 1/s²).
    pub fn limited(time: f64, acceleration: f64) -> (f64, Self) {
        // Speed 1/time, reached after 1/(time·acceleration).
        let ramp = 1.0 / (time * acceleration);
        if ramp < time {
            (time + ramp, Self { ramp: ramp / (time + ramp) })
        } else {
            (2.0 / acceleration.sqrt(), Self { ramp: 0.5 })
        }
    }

    /// Part of the block's time that its two ramps take.
    pub fn ramps(&self) -> f64 {
        2.0 * self.ramp
    }

    /// The part of the way behind at a part of the time.
    pub fn way(&self, time: f64) -> f64 {
        let left = 1.0 - time;
        if time < self.ramp {
            0.5 * time * time / (self.ramp * (1.0 - self.ramp))
        } else if left < self.ramp {
            1.0 - 0.5 * left * left / (self.ramp * (1.0 - self.ramp))
        } else {
            (time - 0.5 * self.ramp) / (1.0 - self.ramp)
        }
    }

    /// The part of the time at which a part of the way is behind: the inverse of [`Course::way`].
    pub fn time(&self, way: f64) -> f64 {
        let on_ramp = 0.5 * self.ramp / (1.0 - self.ramp);
        let start = |way: f64| (2.0 * way.max(0.0) * self.ramp * (1.0 - self.ramp)).sqrt();
        if way < on_ramp {
            start(way)
        } else if 1.0 - way < on_ramp {
            1.0 - start(1.0 - way)
        } else {
            way * (1.0 - self.ramp) + 0.5 * self.ramp
        }
    }

    /// Speed at a part of the way over the mean of the block.
    pub fn speed(&self, way: f64) -> f64 {
        let time = self.time(way);
        let from_rest = time.min(1.0 - time);
        if from_rest < self.ramp { from_rest / (self.ramp * (1.0 - self.ramp)) } else { 1.0 / (1.0 - self.ramp) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_trapezoid_takes_one_ramp_longer_and_a_short_block_is_a_triangle() {
        // 1 s at one speed, reached after 0.25 s: 1.25 s. At 0.8 of the way: way = ∫speed.
        let (time, course) = Course::limited(1.0, 4.0);
        assert!((time - 1.25).abs() < 1e-15 && (course.ramps() - 0.4).abs() < 1e-15);
        // Half of the acceleration over 0.1 s, half of 4/s².
        assert!((course.way(0.1 / 1.25) - 0.02).abs() < 1e-15 && (course.way(1.0 - 0.1 / 1.25) - 0.98).abs() < 1e-15);
        assert!((course.speed(0.5) - 1.25).abs() < 1e-15 && (course.speed(0.02) - 4.0 * 0.1 * 1.25).abs() < 1e-14);
        // Too short: s = a·t²/4.
        let (time, course) = Course::limited(1.0, 0.5);
        assert!((0.25 * 0.5 * time * time - 1.0).abs() < 1e-15 && course.ramps() == 1.0);
        for course in [course, Course::STEADY, Course { ramp: 0.2 }] {
            for i in 0..=20 {
                let part = f64::from(i) / 20.0;
                assert!((course.time(course.way(part)) - part).abs() < 1e-12, "{course:?} {part}");
            }
        }
    }
}
