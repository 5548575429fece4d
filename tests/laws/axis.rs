//! A feed axis: its errors are small, and add.

use proptest::prelude::*;

use super::{ROUND_OFF, alike, model, observed, sum, times};

const POSITIONS: [f64; 9] = [0.0, 0.0123, 0.0781, 0.15, 0.1502, 0.283, 0.31, 0.444, 0.5];

/// The effects of an axis in proportion to two numbers.
fn effects([a, b]: [f64; 2]) -> Vec<String> {
    vec![
        format!("[effects.scale-error]\nslope = \"{} um/m\"\n", 20.0 * a),
        format!("[effects.periodic-error]\namplitude = \"{} um\"\nphase = \"37 deg\"\n", 2.0 * b.abs()),
        format!("[effects.backlash]\ngap = \"{} um\"\n", 8.0 * b),
        format!("[effects.uneven-backlash]\nchange = \"{} um\"\n", 10.0 * a),
        format!("[effects.reference-shift]\noffset = \"{} um\"\n", 5.0 * a),
    ]
}

/// Deviations in both directions.
fn deviations(effects: &[String]) -> Vec<f64> {
    let start = fem::process::ALL.iter().find(|p| p.name() == "axis").unwrap().starting_model();
    let own = start.split("[effects.").next().unwrap();
    let position = [POSITIONS, POSITIONS].concat();
    let direction: Vec<f64> = (0..position.len()).map(|row| f64::from(u8::from(row >= POSITIONS.len()))).collect();
    observed(
        &model(&format!("{own}{}", effects.concat())),
        "deviation",
        &[("position", &position), ("direction", &direction)],
    )
}

proptest! {
    #![proptest_config(super::random(160))]

    #[test]
    fn effects_superpose(drawn in [-1.0..1.0, -1.0..1.0], some in prop::collection::vec(prop::bool::ANY, 5)) {
        let chosen: Vec<String> = effects(drawn).into_iter().zip(&some).filter(|(_, own)| **own).map(|(e, _)| e).collect();
        let nothing = vec![0.0; 2 * POSITIONS.len()];
        let one_by_one = chosen.iter().fold(nothing, |all, effect| sum(&all, &deviations(std::slice::from_ref(effect))));
        alike(&one_by_one, &deviations(&chosen), ROUND_OFF)?;
    }

    #[test]
    fn an_effect_twice_as_large_is_felt_twice(a in 0.05..0.5) {
        for (once, twice) in effects([a, a]).into_iter().zip(effects([2.0 * a, 2.0 * a])) {
            alike(&times(2.0, &deviations(&[once])), &deviations(&[twice]), ROUND_OFF)?;
        }
    }
}
