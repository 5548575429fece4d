//! A ground cam: geometry, which knows neither size nor side.

use std::f64::consts::TAU;

use proptest::prelude::*;

use super::{alike, model, observed, times};

/// A circle of a radius beside the axis, in blocks; the wheel, by how much it is worn, and the lag of its slide.
#[derive(Clone, Debug)]
pub(super) struct Cam {
    /// mm.
    radius: f64,
    beside: f64,
    wheel: f64,
    /// um.
    worn: f64,
    /// ms.
    lag: f64,
    blocks: usize,
    /// Where the profile and its programme begin, deg.
    turned: f64,
    /// rpm.
    speed: f64,
}

pub(super) fn cam() -> impl Strategy<Value = Cam> {
    (10.0..40.0, 0.02..0.4, 60.0..250.0, 0.0..40.0, -3.0..3.0, 12usize..90).prop_map(
        |(radius, beside, wheel, worn, lag, half)| Cam {
            beside: beside * radius,
            blocks: 2 * half,
            radius,
            wheel,
            worn,
            lag,
            turned: 0.0,
            speed: 20.0,
        },
    )
}

impl Cam {
    pub(super) fn text(&self) -> String {
        let Self { radius, beside, wheel, worn, lag, blocks, turned, speed } = self;
        let (sin, cos) = turned.to_radians().sin_cos();
        let at = |radius: f64| format!("[\"{} mm\", \"{} mm\"]", radius * cos, radius * sin);
        format!(
            "process = \"cam\"\n\
             profile = {{ start = {}, segments = [{{ arc = {{ centre = {}, sweep = \"360 deg\" }} }}] }}\n\
             wheel = {{ radius = \"{wheel} mm\" }}\nprogram = {{ blocks = {blocks}, cam_speed = \"{speed} rpm\" }}\n\
             [effects.wheel-wear]\nloss = \"{worn} um\"\n[effects.servo-lag]\ntime = \"{lag} ms\"\n",
            at(radius + beside),
            at(*beside),
        )
    }

    /// Deviations at polar angles (rad), the programme from its beginning or from its end.
    fn deviations(&self, angles: &[f64], reversed: bool) -> Vec<f64> {
        let direction = vec![f64::from(u8::from(reversed)); angles.len()];
        observed(&model(&self.text()), "deviation", &[("angle", angles), ("direction", &direction)])
    }
}

fn angles() -> Vec<f64> {
    (0..48).map(|i| 0.011 + f64::from(i) * TAU / 48.0).collect()
}

/// Deviations of some micrometres are differences of radii of some 100 mm: the last of their digits are round-off.
const OF_RADII: f64 = 1e-7;

proptest! {
    #![proptest_config(super::random(100))]

    /// The cam is its own image in the x axis, and so is its programme when it is run backwards.
    #[test]
    fn a_programme_run_backwards_grinds_the_image(cam in cam()) {
        let mirrored: Vec<f64> = angles().iter().map(|angle| TAU - angle).collect();
        alike(&cam.deviations(&angles(), false), &cam.deviations(&mirrored, true), OF_RADII)?;
    }

    /// No place around the cam is before another.
    #[test]
    fn a_turned_cam_deviates_alike(cam in cam(), turned in 5.0..355.0) {
        let turned = Cam { turned, ..cam.clone() };
        let there: Vec<f64> = angles().iter().map(|angle| (angle + turned.turned.to_radians()).rem_euclid(TAU)).collect();
        alike(&cam.deviations(&angles(), false), &turned.deviations(&there, false), OF_RADII)?;
    }

    /// A lag is felt by the angle that the cam turns meanwhile.
    #[test]
    fn half_the_lag_at_twice_the_speed_is_the_same(cam in cam(), s in 0.3..3.0) {
        let faster = Cam { speed: s * cam.speed, lag: cam.lag / s, ..cam.clone() };
        alike(&cam.deviations(&angles(), false), &faster.deviations(&angles(), false), OF_RADII)?;
    }

    #[test]
    fn larger_cams_deviate_in_proportion(cam in cam(), s in 0.5..2.0) {
        let Cam { radius, beside, wheel, worn, .. } = cam;
        let larger = Cam { radius: s * radius, beside: s * beside, wheel: s * wheel, worn: s * worn, ..cam.clone() };
        alike(&times(s, &cam.deviations(&angles(), false)), &larger.deviations(&angles(), false), OF_RADII)?;
    }
}
