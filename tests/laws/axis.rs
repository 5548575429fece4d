//! A feed axis: its errors are small, and add; neither its direction, nor its zero, nor its size is
//! another's.

use proptest::prelude::*;

use super::{ROUND_OFF, alike, model, observed, sum, times};

const POSITIONS: [f64; 9] = [0.0, 0.0123, 0.0781, 0.15, 0.1502, 0.283, 0.31, 0.444, 0.5];

/// An axis on a ball screw with what errs along it.
#[derive(Clone, Debug)]
pub(super) struct Axis {
    /// Where the travel begins, its length, and where the fixed bearing stands, mm.
    from: f64,
    travel: f64,
    fixed_at: f64,
    /// Diameter and lead of the screw, mm.
    diameter: f64,
    lead: f64,
    /// Friction, N, and stiffness of nut and bearing, N/um.
    friction: f64,
    stiffness: f64,
    /// Slope of growth, um/m; height of the pitching, um; phase of the error of a turn, deg, and its
    /// amplitude, um.
    growth: f64,
    pitching: f64,
    phase: f64,
    cyclic: f64,
    /// Play, its change along the travel and its excess in the middle, um.
    play: f64,
    change: f64,
    worn: f64,
}

pub(super) fn axis() -> impl Strategy<Value = Axis> {
    let lengths = (-500.0..500.0, 200.0..1500.0, -50.0..50.0, 16.0..60.0, 5.0..20.0);
    let errors = (20.0..200.0, -40.0..40.0, 0.0..360.0, 0.5..5.0);
    let plays = (1.0..20.0, -10.0..10.0, 1.0..15.0);
    (lengths, (50.0..2000.0, 40.0..500.0), errors, plays).prop_map(
        |((from, travel, beside, diameter, lead), (friction, stiffness), (growth, pitching, phase, cyclic), plays)| {
            let (play, change, worn) = plays;
            let fixed_at = from + beside;
            Axis {
                from,
                travel,
                fixed_at,
                diameter,
                lead,
                friction,
                stiffness,
                growth,
                pitching,
                phase,
                cyclic,
                play,
                change,
                worn,
            }
        },
    )
}

impl Axis {
    /// The model with errors that are the same from either side and elastic clearance, with play, and with
    /// all.
    pub(super) fn text(&self, errs: bool, plays: bool) -> String {
        let Self {
            from, travel, fixed_at, diameter, lead, friction, stiffness, growth, pitching, phase, cyclic, ..
        } = self;
        let Self { play, change, worn, .. } = self;
        let mut text = format!(
            "process = \"axis\"\naxis = {{ from = \"{from} mm\", travel = \"{travel} mm\" }}\n\
             screw = {{ material = \"steel\", diameter = \"{diameter} mm\", lead = \"{lead} mm\", fixed_at = \"{fixed_at} mm\" }}\n"
        );
        if errs {
            text += &format!(
                "[effects.elastic-lost-motion]\nfriction = \"{friction} N\"\nstiffness = \"{stiffness} N/um\"\n\
                 [effects.thermal-growth]\nslope = \"{growth} um/m\"\ntime_constant = \"20 min\"\n\
                 [effects.abbe-error]\nheight = \"{pitching} um\"\n\
                 [effects.periodic-error]\namplitude = \"{cyclic} um\"\nphase = \"{phase} deg\"\n"
            );
        }
        if plays {
            text += &format!(
                "[effects.backlash]\ngap = \"{play} um\"\n[effects.uneven-backlash]\nchange = \"{change} um\"\n\
                 [effects.worn-screw]\ndepth = \"{worn} um\"\n"
            );
        }
        text
    }

    /// Deviations at parts of the travel in a direction, warm.
    fn deviations(&self, (errs, plays): (bool, bool), parts: &[f64], backward: bool) -> Vec<f64> {
        let position: Vec<f64> = parts.iter().map(|part| 1e-3 * (self.from + part * self.travel)).collect();
        let [direction, time] = [f64::from(u8::from(backward)), 1500.0].map(|value| vec![value; parts.len()]);
        let given: [(&str, &[f64]); 3] = [("position", &position), ("direction", &direction), ("time", &time)];
        observed(&model(&self.text(errs, plays)), "deviation", &given)
    }

    /// Seen from its other end.
    fn mirrored(&self) -> Self {
        Self {
            from: -(self.from + self.travel),
            fixed_at: -self.fixed_at,
            pitching: -self.pitching,
            phase: 360.0 - self.phase,
            change: -self.change,
            ..self.clone()
        }
    }
}

const PARTS: [f64; 7] = [0.02, 0.13, 0.34, 0.5, 0.61, 0.87, 0.98];

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
    let own = super::starting("axis").split("[effects.").next().unwrap();
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

    /// Seen from the other end, forwards is backwards, and what was too far is too short.
    #[test]
    fn a_mirrored_axis_errs_as_the_image(axis in axis(), backward in prop::bool::ANY) {
        let mirrored = PARTS.map(|part| 1.0 - part);
        let image = axis.mirrored().deviations((true, false), &mirrored, !backward);
        alike(&axis.deviations((true, false), &PARTS, backward), &times(-1.0, &image), ROUND_OFF)?;
    }

    /// Play is counted on the way back, from whichever end one looks: it is the difference of both
    /// directions that has no side.
    #[test]
    fn a_mirrored_axis_has_the_same_play(axis in axis()) {
        let reversal = |axis: &Axis, parts: &[f64]| {
            let [there, back] = [false, true].map(|backward| axis.deviations((true, true), parts, backward));
            sum(&back, &times(-1.0, &there))
        };
        let mirrored = PARTS.map(|part| 1.0 - part);
        alike(&reversal(&axis, &PARTS), &reversal(&axis.mirrored(), &mirrored), ROUND_OFF)?;
    }

    /// Where the machine counts its zero does not matter, to whole turns of the screw.
    #[test]
    fn an_axis_errs_alike_from_any_zero(axis in axis(), turns in -20i32..20, backward in prop::bool::ANY) {
        let by = f64::from(turns) * axis.lead;
        let moved = Axis { from: axis.from + by, fixed_at: axis.fixed_at + by, ..axis.clone() };
        let [own, other] = [&axis, &moved].map(|axis| axis.deviations((true, true), &PARTS, backward));
        alike(&own, &other, ROUND_OFF)?;
    }

    /// All lengths by s, friction by s², stiffness by s: deviations by s.
    #[test]
    fn larger_axes_err_in_proportion(axis in axis(), s in 0.5..2.0, backward in prop::bool::ANY) {
        let larger = Axis {
            from: s * axis.from,
            travel: s * axis.travel,
            fixed_at: s * axis.fixed_at,
            diameter: s * axis.diameter,
            lead: s * axis.lead,
            friction: s * s * axis.friction,
            stiffness: s * axis.stiffness,
            growth: axis.growth,
            pitching: s * axis.pitching,
            phase: axis.phase,
            cyclic: s * axis.cyclic,
            play: s * axis.play,
            change: s * axis.change,
            worn: s * axis.worn,
        };
        let own = axis.deviations((true, true), &PARTS, backward);
        alike(&times(s, &own), &larger.deviations((true, true), &PARTS, backward), ROUND_OFF)?;
    }
}
