//! Every pair of effects of every process, in two of the scenes that admit it, and another pair in others.

use generator::{AXIS, CAM, CONTOUR, FIXTURE, Process, RING, ROTARY, STIFFNESS, THERMAL, TURNING};

const ALL: &[&Process] = &[&TURNING, &RING, &STIFFNESS, &AXIS, &ROTARY, &CONTOUR, &FIXTURE, &THERMAL, &CAM];

/// Effects that show nothing in a scene though they are admitted, of all scenes in which they are alone.
#[test]
fn every_effect_shows_in_some_scene() {
    for process in ALL {
        for (effect, _) in process.catalogue {
            let shows = (0..process.scenes.len())
                .filter_map(|scene| process.meeting(&[effect], scene, 1))
                .any(|met| met.exact.iter().zip(&met.without).any(|(with, without)| (with - without).abs() > 1e-3));
            assert!(shows, "{} {effect}", process.name);
        }
    }
}

#[test]
fn every_pair_meets_somewhere() {
    for process in ALL {
        let (mut count, mut largest) = (0, 0.0_f64);
        for (number, pair) in process.pairs().into_iter().enumerate() {
            let begun = (0..process.scenes.len()).map(|scene| (number + scene) % process.scenes.len());
            let meetings = begun.filter_map(|scene| process.meeting(&pair, scene, 1)).take(2);
            let before = count;
            for met in meetings {
                count += 1;
                assert!(met.exact.iter().all(|value| value.is_finite()), "{} {pair:?} {}", process.name, met.scene);
                assert!(pair.iter().all(|effect| met.model.contains(&format!("[effects.{effect}]"))));
                assert_eq!(met.data.lines().count(), met.exact.len() + 1);
                assert!((20..=70).contains(&met.exact.len()), "{}", met.exact.len());
                let change = met.exact.iter().zip(&met.without).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                largest = largest.max(change);
            }
            assert!(count > before, "{} {pair:?}", process.name);
        }
        println!("{:12} {count} meetings, the largest change {largest:.1}", process.name);
    }
}
