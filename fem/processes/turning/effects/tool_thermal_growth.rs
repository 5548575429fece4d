//! The tool grows while it cuts and shrinks while it rests.
//!
//! τ·dξ/dt = elongation·\[cutting\] − ξ, ξ(0) = 0, ΔD −= 2ξ [seed 002, thermal deformation of the tool].
//! Cutting is the time of each pass by the model's schedule; cycles of uneven length scatter the parts. A
//! row with a time of its own is turned then, in a pass that began when the tool had yet to travel to it.
//! elongation is what ξ tends to in a cut without end, m; τ in s.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::{MICRO, TIME};

/// Parts beyond the batch, for which an experiment may ask.
const FURTHER: usize = 32;

/// `tool-thermal-growth`.
pub static TOOL_THERMAL_GROWTH: Effect<2> = Effect {
    name: "tool-thermal-growth",
    about: "the tool grows while it cuts and shrinks in pauses",
    law: "dD -= 2*xi, time_constant*dxi/dt = elongation*[cutting] - xi",
    source: "seed 002, thermal deformation of the cutting tool",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "every tool warms, some under coolant by little"),
    parameters: [
        Parameter::amplitude("elongation", MICRO, "growth in a cut without end", (1.0, 60.0)),
        Parameter::shape("time_constant", TIME, "time constant of the tool", (1.0, 60.0)),
    ],
    look_alikes: &[("tool-wear", "a pause: growth goes back, wear stays")],
    needs: nothing,
    act: |[elongation, time_constant], machine| {
        let schedule = &machine.setup.schedule;
        let parts = schedule.parts;
        let (cutting, speed, from) = (schedule.pass.duration(), schedule.pass.speed(), schedule.pass.from);
        // ξ at the start of each part.
        let mut starts: Vec<(f64, f64)> = Vec::with_capacity(parts + FURTHER);
        for start in (1..=parts + FURTHER).map(|part| schedule.start(part)) {
            let growth = starts.last().map_or(0.0, |&last| growth(last, start, cutting, elongation, time_constant));
            starts.push((start, growth));
        }
        machine.add_shift(move |at| {
            // What has a time of its own is turned then, in a pass that begins so much earlier.
            let travelled = (at.x - from).abs() / speed;
            let begun = at.time - travelled;
            let earlier = starts.partition_point(|s| s.0 <= begun).min(parts.max(at.part.saturating_sub(1)));
            let earlier = earlier.checked_sub(1).map(|part| starts[part]);
            let before = earlier.map_or(0.0, |last| growth(last, begun, cutting, elongation, time_constant));
            -2.0 * growth((0.0, before), travelled, travelled, elongation, time_constant)
        });
    },
};

/// ξ at `time`, given (start of the part, ξ there): toward the elongation while cutting, then back.
fn growth((start, xi): (f64, f64), time: f64, cutting: f64, elongation: f64, time_constant: f64) -> f64 {
    let hot = (time - start).clamp(0.0, cutting);
    let cold = (time - start - cutting).max(0.0);
    (elongation + (xi - elongation) * (-hot / time_constant).exp()) * (-cold / time_constant).exp()
}

#[cfg(test)]
mod tests {
    use super::super::super::machine::Moment;
    use super::super::bench::*;

    #[test]
    fn a_part_that_is_turned_after_a_rest_begins_cold() {
        // Five hours after the batch, 3.75 min into a cut.
        let rested = Moment { part: 3, time: 5.0 * 3600.0, ..moment() };
        let shift = shift("tool-thermal-growth", &[10.0, 5.0], rested);
        assert!((shift + 2.0 * 10.0 * (1.0 - (-0.75f64).exp())).abs() < 1e-9, "{shift}");
    }

    #[test]
    fn growth_is_the_hand_integrated_schedule() {
        // Part 1 cuts 5 min, rests 5 min; part 2 has cut 3.75 min. elongation 10 um, τ = 5 min.
        let after_first = 10.0 * (1.0 - (-1f64).exp());
        let at_second = after_first * (-1f64).exp();
        let xi = 10.0 + (at_second - 10.0) * (-0.75f64).exp();
        assert!((shift("tool-thermal-growth", &[10.0, 5.0], moment()) + 2.0 * xi).abs() < 1e-12);
    }
}
