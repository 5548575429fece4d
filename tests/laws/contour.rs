//! Two axes on a circle: neither is before the other, and larger circles at larger feeds are the same in proportion.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use proptest::prelude::*;

use super::{ROUND_OFF, alike, model, observed, times};

#[derive(Clone, Debug)]
pub(super) struct Circle {
    /// Radius, mm; feed, mm/min; velocity gain, 1/s.
    radius: f64,
    feed: f64,
    gain: f64,
    /// Play, amplitude of the cyclic error and offset of the centre, um, of x and of y.
    play: [f64; 2],
    cyclic: [f64; 2],
    centre: [f64; 2],
    /// Out of square, um/m.
    squareness: f64,
}

pub(super) fn circle() -> impl Strategy<Value = Circle> {
    let pair = |most: f64| [-most..most, -most..most];
    (40.0..300.0, 200.0..4000.0, 20.0..120.0, pair(10.0), pair(3.0), pair(5.0), -50.0..50.0).prop_map(
        |(radius, feed, gain, play, cyclic, centre, squareness)| Circle {
            play: play.map(f64::abs),
            cyclic: cyclic.map(f64::abs),
            radius,
            feed,
            gain,
            centre,
            squareness,
        },
    )
}

impl Circle {
    pub(super) fn text(&self) -> String {
        let Self { radius, feed, gain, play, cyclic, centre, squareness } = self;
        format!(
            "process = \"contour\"\npath = {{ shape = \"circle\", radius = \"{radius} mm\", feed = \"{feed} mm/min\" }}\n\
             drives = {{ gain = \"{gain} /s\", lead = \"{} mm\" }}\n\
             [effects.backlash-x]\ngap = \"{} um\"\n[effects.backlash-y]\ngap = \"{} um\"\n\
             [effects.cyclic-error-x]\namplitude = \"{} um\"\nphase = \"30 deg\"\n\
             [effects.cyclic-error-y]\namplitude = \"{} um\"\nphase = \"30 deg\"\n\
             [effects.centre-offset]\nx = \"{} um\"\ny = \"{} um\"\n[effects.squareness]\nangle = \"{squareness} um/m\"\n",
            radius / 15.0,
            play[0],
            play[1],
            cyclic[0],
            cyclic[1],
            centre[0],
            centre[1],
        )
    }

    /// Deviations at angles (rad), counter-clockwise or clockwise.
    fn deviations(&self, angles: &[f64], clockwise: bool) -> Vec<f64> {
        let direction = vec![f64::from(u8::from(clockwise)); angles.len()];
        observed(&model(&self.text()), "deviation", &[("angle", angles), ("direction", &direction)])
    }
}

fn angles() -> Vec<f64> {
    (0..36).map(|i| 0.017 + f64::from(i) * TAU / 36.0).collect()
}

proptest! {
    #![proptest_config(super::random(160))]

    /// Seen in the mirror x = y, each axis is the other, and the circle runs the other way. Square they must be: it is
    /// y that leans towards x, and to the second order x is not the same.
    #[test]
    fn axes_are_alike(circle in circle(), clockwise in prop::bool::ANY) {
        let circle = Circle { squareness: 0.0, ..circle };
        let swapped = |[x, y]: [f64; 2]| [y, x];
        let image = Circle {
            play: swapped(circle.play),
            cyclic: swapped(circle.cyclic),
            centre: swapped(circle.centre),
            ..circle.clone()
        };
        let mirrored: Vec<f64> = angles().iter().map(|angle| (FRAC_PI_2 - angle).rem_euclid(TAU)).collect();
        alike(&circle.deviations(&angles(), clockwise), &image.deviations(&mirrored, !clockwise), ROUND_OFF)?;
    }

    /// Seen in the mirror x = 0, the circle runs the other way, its centre lies on the other side, and the y axis leans
    /// the other way. (A cyclic error of x is left out: its phase turns over too.)
    #[test]
    fn the_other_side_is_the_image(circle in circle(), clockwise in prop::bool::ANY) {
        let circle = Circle { cyclic: [0.0, circle.cyclic[1]], ..circle };
        let image = Circle {
            centre: [-circle.centre[0], circle.centre[1]],
            squareness: -circle.squareness,
            ..circle.clone()
        };
        let mirrored: Vec<f64> = angles().iter().map(|angle| (PI - angle).rem_euclid(TAU)).collect();
        alike(&circle.deviations(&angles(), clockwise), &image.deviations(&mirrored, !clockwise), ROUND_OFF)?;
    }

    /// Of the servos only the lag feed/gain is felt.
    #[test]
    fn faster_drives_follow_faster_feeds_alike(circle in circle(), s in 0.3..3.0) {
        let faster = Circle { feed: s * circle.feed, gain: s * circle.gain, ..circle.clone() };
        alike(&circle.deviations(&angles(), false), &faster.deviations(&angles(), false), ROUND_OFF)?;
    }

    /// In the mirror x = y a rectangle at an angle is one at 90 deg less that angle, its height along its
    /// width, and the axes are each other, whether it is travelled one way round or the other.
    #[test]
    fn a_mirrored_rectangle_is_travelled_alike(
        circle in circle(), sides in (60.0..200.0, 60.0..200.0), angle in 5.0..40.0, clockwise in prop::bool::ANY,
    ) {
        let swapped = |[x, y]: [f64; 2]| [y, x];
        let own = Circle { squareness: 0.0, feed: circle.feed.min(600.0), cyclic: [0.0; 2], ..circle };
        let image = Circle { play: swapped(own.play), centre: swapped(own.centre), ..own.clone() };
        let (width, height) = sides;
        let at = |circle: &Circle, width: f64, height: f64, degrees: f64, angles: &[f64], clockwise: bool| {
            let path = format!("shape = \"rectangle\", width = \"{width} mm\", height = \"{height} mm\", angle = \"{degrees} deg\"");
            let circled = format!("shape = \"circle\", radius = \"{} mm\"", circle.radius);
            let text = circle.text().replacen(&circled, &path, 1);
            let direction = vec![f64::from(u8::from(clockwise)); angles.len()];
            observed(&model(&text), "deviation", &[("angle", angles), ("direction", &direction)])
        };
        // The middle of every side, and a place beside it that no corner reaches.
        let turn = f64::to_radians(angle);
        let middles: Vec<f64> = (0..8).map(|i| turn + f64::from(i / 2) * FRAC_PI_2 + f64::from(i % 2) * 0.05).collect();
        let mirrored: Vec<f64> = middles.iter().map(|angle| (FRAC_PI_2 - angle).rem_euclid(TAU)).collect();
        let own = at(&own, width, height, angle, &middles, clockwise);
        alike(&own, &at(&image, width, height, 90.0 - angle, &mirrored, !clockwise), ROUND_OFF)?;
    }

    /// All lengths and the feed by s: every time is the same, and deviations are s times as large.
    #[test]
    fn larger_circles_deviate_in_proportion(circle in circle(), s in 0.4..2.5) {
        let by = |pair: [f64; 2]| pair.map(|length| s * length);
        let larger = Circle {
            radius: s * circle.radius,
            feed: s * circle.feed,
            play: by(circle.play),
            cyclic: by(circle.cyclic),
            centre: by(circle.centre),
            ..circle.clone()
        };
        alike(&times(s, &circle.deviations(&angles(), false)), &larger.deviations(&angles(), false), ROUND_OFF)?;
    }
}
