//! The tool grows while it cuts and shrinks while it rests.
//!
//! τ·dξ/dt = elongation·\[cutting\] − ξ, ξ(0) = 0, ΔD −= 2ξ [seed 002, thermal deformation of the tool].
//! Cutting is the time of each pass by the model's schedule; cycles of uneven length scatter the parts.
//! elongation is what ξ tends to in a cut without end, m; τ in s.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter, nothing};
use crate::units::{MICRO, TIME};

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
        let cutting = schedule.pass.duration();
        // ξ at the start of each part.
        let mut starts: Vec<(f64, f64)> = Vec::with_capacity(schedule.starts().len());
        for &start in schedule.starts() {
            let growth = starts.last().map_or(0.0, |&last| growth(last, start, cutting, elongation, time_constant));
            starts.push((start, growth));
        }
        machine.add_shift(move |at| {
            let part = starts.partition_point(|s| s.0 <= at.time).saturating_sub(1);
            let xi = starts.get(part).map_or(0.0, |&last| growth(last, at.time, cutting, elongation, time_constant));
            -2.0 * xi
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
    use super::super::bench::*;

    #[test]
    fn growth_is_the_hand_integrated_schedule() {
        // Part 1 cuts 5 min, rests 5 min; part 2 has cut 3.75 min. elongation 10 um, τ = 5 min.
        let after_first = 10.0 * (1.0 - (-1f64).exp());
        let at_second = after_first * (-1f64).exp();
        let xi = 10.0 + (at_second - 10.0) * (-0.75f64).exp();
        assert!((shift("tool-thermal-growth", &[10.0, 5.0], moment()) + 2.0 * xi).abs() < 1e-12);
    }
}
