//! A rotary axis: errors of its wheels add; neither the way in which it is turned, nor its zero, nor the unit of its torques is
//! another's.

use std::f64::consts::PI;

use proptest::prelude::*;

use super::{ROUND_OFF, alike, model, observed, sum, times};

/// A table on a worm with what errs round it.
#[derive(Clone, Debug)]
pub(super) struct Table {
    /// Where the range begins and its size, deg.
    from: f64,
    range: f64,
    /// Teeth of the wheel, and the gears before the worm.
    teeth: u32,
    pair: [u32; 2],
    /// Pitch radius, and radius of the scale, mm; both off the axis, um.
    wheel: f64,
    ring: f64,
    off: [f64; 2],
    /// Stiffness of the drive, N·m/arcsec; friction, what is out of balance, and a torque from outside, N·m.
    stiffness: f64,
    friction: f64,
    moment: f64,
    torque: f64,
    /// Amplitude of the error of the worm, play, and half of what it varies by, arcsec.
    worm: f64,
    play: f64,
    change: f64,
    /// Phases of worm, wheel, ring, weight and play, deg.
    phases: [f64; 5],
}

pub(super) fn table() -> impl Strategy<Value = Table> {
    let sizes = (-200.0..200.0, 90.0..500.0, 40u32..200, 12u32..60, 30.0..200.0, 20.0..150.0);
    let errors = (1.0..40.0, 0.5..20.0, 0.5..20.0, 1.0..40.0, 0.5..10.0);
    let torques = (0.5..10.0, 1.0..40.0, 1.0..80.0, -80.0..80.0);
    (sizes, errors, torques, prop::array::uniform5(-180.0..180.0)).prop_map(
        |(
            (from, range, teeth, large, wheel, ring),
            (of_wheel, of_ring, worm, play, change),
            (stiffness, friction, moment, torque),
            phases,
        )| Table {
            from,
            range,
            teeth,
            pair: [12, large],
            wheel,
            ring,
            off: [of_wheel, of_ring],
            stiffness,
            friction,
            moment,
            torque,
            worm,
            play,
            change,
            phases,
        },
    )
}

impl Table {
    /// The model with errors of wheels and rings, and with torques and play.
    pub(super) fn text(&self, plays: bool) -> String {
        let Self { from, range, teeth, pair: [small, large], wheel, ring, off, stiffness, friction, moment, .. } = self;
        let Self { torque, worm, play, change, phases, .. } = self;
        let mut text = format!(
            "process = \"rotary\"\n\
             axis = {{ from = \"{from} deg\", range = \"{range} deg\", orientation = \"horizontal\" }}\n\
             drive = {{ type = \"worm\", teeth = {teeth}, stages = [{{ driving = {small}, driven = {large} }}], \
             pitch_radius = \"{wheel} mm\", stiffness = \"{stiffness} N*m/arcsec\" }}\n\
             scale = {{ radius = \"{ring} mm\" }}\ntest = {{ torque = \"{torque} N*m\" }}\n\
             [effects.worm-error]\namplitude = \"{worm} arcsec\"\nphase = \"{} deg\"\n\
             [effects.wheel-eccentricity]\neccentricity = \"{} um\"\nphase = \"{} deg\"\n\
             [effects.scale-eccentricity]\neccentricity = \"{} um\"\nphase = \"{} deg\"\n",
            phases[0], off[0], phases[1], off[1], phases[2]
        );
        if plays {
            text += &format!(
                "[effects.elastic-wind-up]\nfriction = \"{friction} N*m\"\n\
                 [effects.unbalance]\nmoment = \"{moment} N*m\"\nphase = \"{} deg\"\n\
                 [effects.backlash]\ngap = \"{play} arcsec\"\n\
                 [effects.uneven-backlash]\nchange = \"{change} arcsec\"\nphase = \"{} deg\"\n",
                phases[3], phases[4]
            );
        }
        text
    }

    /// Deviations at parts of the range from a side.
    fn deviations(&self, plays: bool, parts: &[f64], backward: bool) -> Vec<f64> {
        let angle: Vec<f64> = parts.iter().map(|part| (self.from + part * self.range) * PI / 180.0).collect();
        let direction = vec![f64::from(u8::from(backward)); parts.len()];
        let given: [(&str, &[f64]); 2] = [("angle", &angle), ("direction", &direction)];
        observed(&model(&self.text(plays)), "deviation", &given)
    }

    /// Seen from behind: what turns towards + there turns towards - here. Sines of the angle turn their phase by half a
    /// turn and back, cosines just back.
    fn mirrored(&self) -> Self {
        let [worm, wheel, ring, weight, play] = self.phases;
        Self {
            from: -(self.from + self.range),
            torque: -self.torque,
            // -sin(-x + p) = sin(x - p); a weight that turns the other way about: -cos(-x + p) = cos(x - p + 180).
            phases: [-worm, -wheel, -ring, 180.0 - weight, -play],
            ..self.clone()
        }
    }
}

const PARTS: [f64; 7] = [0.02, 0.13, 0.34, 0.5, 0.61, 0.87, 0.98];

/// The effects of a worm-driven table in proportion to two numbers.
fn effects([a, b]: [f64; 2]) -> Vec<String> {
    let wave = |name: &str, size: f64| format!("[effects.{name}]\namplitude = \"{size} arcsec\"\nphase = \"37 deg\"\n");
    vec![
        wave("worm-error", 6.0 * a.abs()),
        wave("worm-second-harmonic", 2.0 * b.abs()),
        format!("[effects.wheel-eccentricity]\neccentricity = \"{} um\"\nphase = \"-70 deg\"\n", 8.0 * a.abs()),
        format!("[effects.backlash]\ngap = \"{} arcsec\"\n", 20.0 * b),
        format!("[effects.uneven-backlash]\nchange = \"{} arcsec\"\nphase = \"11 deg\"\n", 10.0 * a.abs()),
        format!("[effects.reference-shift]\noffset = \"{} arcsec\"\n", 12.0 * a),
    ]
}

/// Deviations from both sides.
fn deviations(effects: &[String]) -> Vec<f64> {
    const ANGLES: [f64; 8] = [0.0, 0.1, 0.77, 1.5, 1.502, 2.83, 4.44, 6.2];
    let own = super::starting("rotary").split("[effects.").next().unwrap();
    let angle = [ANGLES, ANGLES].concat();
    let direction: Vec<f64> = (0..angle.len()).map(|row| f64::from(u8::from(row >= ANGLES.len()))).collect();
    let text = format!("{own}{}", effects.concat());
    observed(&model(&text), "deviation", &[("angle", &angle), ("direction", &direction)])
}

proptest! {
    #![proptest_config(super::random(160))]

    #[test]
    fn effects_superpose(drawn in [-1.0..1.0, -1.0..1.0], some in prop::collection::vec(prop::bool::ANY, 6)) {
        let chosen: Vec<String> = effects(drawn).into_iter().zip(&some).filter(|(_, own)| **own).map(|(e, _)| e).collect();
        let nothing = vec![0.0; deviations(&[]).len()];
        let one_by_one = chosen.iter().fold(nothing, |all, effect| sum(&all, &deviations(std::slice::from_ref(effect))));
        alike(&one_by_one, &deviations(&chosen), ROUND_OFF)?;
    }

    #[test]
    fn an_effect_twice_as_large_is_felt_twice(a in 0.05..0.5) {
        for (once, twice) in effects([a, a]).into_iter().zip(effects([2.0 * a, 2.0 * a])) {
            alike(&times(2.0, &deviations(&[once])), &deviations(&[twice]), ROUND_OFF)?;
        }
    }

    /// Seen from behind, forwards is backwards and what stood too far stands too short.
    #[test]
    fn a_mirrored_axis_errs_as_the_image(table in table(), backward in prop::bool::ANY) {
        let mirrored = PARTS.map(|part| 1.0 - part);
        let image = table.mirrored().deviations(false, &mirrored, !backward);
        alike(&table.deviations(false, &PARTS, backward), &times(-1.0, &image), ROUND_OFF)?;
    }

    /// Play is counted from the flank that drives forwards, whichever way that is: what is lost at a reversal has no side.
    #[test]
    fn a_mirrored_axis_loses_as_much(table in table()) {
        let reversal = |table: &Table, parts: &[f64]| {
            let [there, back] = [false, true].map(|backward| table.deviations(true, parts, backward));
            sum(&back, &times(-1.0, &there))
        };
        let mirrored = PARTS.map(|part| 1.0 - part);
        alike(&reversal(&table, &PARTS), &reversal(&table.mirrored(), &mirrored), ROUND_OFF)?;
    }

    /// After a turn of the table everything is where it was.
    #[test]
    fn an_axis_errs_alike_a_turn_on(table in table(), turns in -3i32..4, backward in prop::bool::ANY) {
        let moved = Table { from: table.from + 360.0 * f64::from(turns), ..table.clone() };
        let [own, other] = [&table, &moved].map(|table| table.deviations(true, &PARTS, backward));
        alike(&own, &other, ROUND_OFF)?;
    }

    /// All torques and the stiffness by one factor: nothing moves.
    #[test]
    fn only_torques_over_the_stiffness_count(table in table(), s in 0.2..5.0, backward in prop::bool::ANY) {
        let stronger = Table {
            stiffness: s * table.stiffness,
            friction: s * table.friction,
            moment: s * table.moment,
            torque: s * table.torque,
            ..table.clone()
        };
        let [own, other] = [&table, &stronger].map(|table| table.deviations(true, &PARTS, backward));
        alike(&own, &other, ROUND_OFF)?;
    }

    /// Of a table twice as large whose wheels are off twice as far nothing changes.
    #[test]
    fn only_eccentricity_over_the_radius_counts(table in table(), s in 0.2..5.0, backward in prop::bool::ANY) {
        let larger =
            Table { wheel: s * table.wheel, ring: s * table.ring, off: table.off.map(|e| s * e), ..table.clone() };
        let [own, other] = [&table, &larger].map(|table| table.deviations(true, &PARTS, backward));
        alike(&own, &other, ROUND_OFF)?;
    }
}
