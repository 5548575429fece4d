//! The motion against brute force: every position of the wheel in turn, and no other code.

use super::*;
use crate::processes::cam::profile::direction;

/// Legs at random: turns of up to half a radian, slides that rise and fall, wheels above the axis.
fn motion(seed: u64) -> Motion {
    let mut state = seed;
    let mut random = |low: f64, high: f64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let (mut turn, mut slide) = (0.0, 0.19);
    let height = random(-1e-3, 1e-3);
    let legs = (0..24).map(|block| {
        let (over, rise) = (random(0.01, 0.5), random(-4e-3, 4e-3));
        let leg = Leg::new((turn, over), (slide, rise), height, block, (0.0, 1.0));
        (turn, slide) = (turn + over, slide + rise);
        leg
    });
    let legs = legs.collect();
    Motion::new(legs, random(0.02, 0.175))
}

#[test]
fn nothing_is_left_that_any_position_would_cut() {
    const STEPS: u32 = 4000;
    for seed in 0..12 {
        let motion = motion(seed);
        for i in 0..40 {
            // Rays from points near the envelope, leaning to both sides.
            let angle = 0.1 + f64::from(i) * 0.07;
            let lean = 0.3 * f64::from(i % 5 - 2);
            let ray = Ray { point: direction(angle) * (0.185 - motion.radius()), normal: direction(angle + lean) };
            let mut brute = f64::INFINITY;
            for leg in motion.legs() {
                for k in 0..=STEPS {
                    brute = brute.min(ray.left_by(&leg.centre(f64::from(k) / f64::from(STEPS)), motion.radius()));
                }
            }
            for guess in [0, 7, 23] {
                let found = motion.left_along(&ray, guess).map_or(f64::INFINITY, |reach| reach.left);
                // Between neighbouring positions, 25 um apart at most, what is left dips by less than 25²
                // um²/8R/cos².
                assert!(found <= brute && (brute - found < 2e-8 || brute == found), "{seed} {i}: {found} and {brute}");
            }
        }
    }
}

#[test]
fn the_bow_holds_the_whole_leg() {
    for leg in motion(3).legs() {
        let [a, b] = leg.ends;
        for k in 0..=100 {
            let t = f64::from(k) / 100.0;
            assert!((leg.centre(t) - (a + (b - a) * t)).norm() <= leg.bow * (1.0 + 1e-12));
        }
    }
}

#[test]
fn derivatives_are_those_of_the_centre() {
    let leg = Leg::new((0.4, 0.3), (0.19, 0.01), 2e-3, 0, (0.0, 1.0));
    let h = 1e-5;
    for t in [0.1, 0.6] {
        let velocity = (leg.centre(t + h) - leg.centre(t - h)) / (2.0 * h);
        let acceleration = (leg.velocity(t + h) - leg.velocity(t - h)) / (2.0 * h);
        assert!((velocity - leg.velocity(t)).norm() < 1e-11 && (acceleration - leg.motion(t)[2]).norm() < 1e-11);
    }
}
