//! Whole machines: what is drawn, how visible it is, and that the ideal model shows none of it.

use generator::typical::{WEIGHTS, weight};
use generator::{AXIS, CAM, CONTOUR, FIXTURE, NoiseKind, Process, RING, ROTARY, STIFFNESS, THERMAL, TURNING};

const ALL: &[&Process] = &[&TURNING, &RING, &STIFFNESS, &AXIS, &ROTARY, &CONTOUR, &FIXTURE, &THERMAL, &CAM];

#[test]
fn every_effect_has_one_weight() {
    for (effect, _) in ALL.iter().flat_map(|process| process.catalogue) {
        assert_eq!(WEIGHTS.iter().filter(|own| own.0 == *effect).count(), 1, "{effect}");
        assert!(weight(effect) > 0.0, "{effect}");
    }
    let is_known = |name: &str| ALL.iter().any(|process| process.catalogue.iter().any(|law| law.0 == name));
    assert!(WEIGHTS.iter().all(|own| is_known(own.0)));
}

#[test]
fn what_is_hidden_is_visible_and_not_shown() {
    for process in ALL {
        for seed in 0..5 {
            let case = process.whole_machine(seed).case;
            let truth = &case.truth;
            assert!((3..=6).contains(&truth.hidden.len()), "{} {seed}", process.name);
            assert!(truth.lambda.iter().all(|lambda| (9.9..=1000.0).contains(lambda)), "{:?}", truth.lambda);
            assert_ne!(truth.noise, NoiseKind::Neither);
            assert!(!case.model.contains("[effects"), "{}", case.model);
            for hidden in &truth.hidden {
                assert!(case.revealed.contains(&format!("[effects.{}]", hidden.effect)), "{}", case.revealed);
            }
        }
    }
}

/// Springs of units are drawn sixteen times as often as a worn dip: over forty lathes the counts show it.
#[test]
fn what_is_typical_is_drawn_more_often() {
    let mut counts = [0, 0];
    for seed in 0..40 {
        let case = TURNING.whole_machine(seed).case;
        for (count, effect) in counts.iter_mut().zip(["carriage-compliance", "guideway-wear"]) {
            *count += usize::from(case.truth.hidden.iter().any(|hidden| hidden.effect == effect));
        }
    }
    assert!(counts[0] >= 3 * counts[1].max(1), "{counts:?}");
}
