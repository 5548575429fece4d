//! The cross slide has play in its nut.
//!
//! Moving inwards, towards the axis, the slide is pushed by one flank of the screw and stands where it is meant to. After a
//! command to move outwards, at a shoulder that the pass climbs, the screw first crosses the play, and the slide stays
//! behind: the play operator of kinematic clearance, seen at the nose [seed 000, fig. 2a]. The slide is fed inwards before
//! the pass, so that the section in which the pass begins is exact, λ = 0. At each shoulder along the travel the slide lags
//! by λ' = min(max(λ + (D' − D)/2, 0), gap), D and D' being the diameters before and behind it, and ΔD −= 2·λ until the
//! next: 2·gap behind a shoulder that rises by more than the play, nothing behind one that falls by more, and what was
//! there before where the diameter stays. Every pass begins anew, and all climb the same shoulders. gap in m. Left out: the
//! radial force, which where friction does not hold the slide pushes it outwards after the screw and takes the play up.

use std::sync::Arc;

use super::super::machine::Effect;
use super::super::setup::Setup;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::MICRO;

/// `cross-slide-play`.
pub static CROSS_SLIDE_PLAY: Effect<1> = Effect {
    name: "cross-slide-play",
    about: "the cross slide has play in its nut, and stays behind where it is to move outwards at a shoulder",
    law: "dD -= 2*lag, at each shoulder along the pass lag = min(max(lag + rise, 0), gap), 0 where the pass begins",
    source: "seed 000, fig. 2a (kinematic clearance)",
    belongs: Belongs::Machine,
    odds: Odds::of(0.3, "gibs wear, but a cut presses the slide one way"),
    parameters: [Parameter::amplitude("gap", MICRO, "play of the slide, of the radius", (1.0, 30.0))],
    look_alikes: &[
        ("setting-error", "a diameter in the section where the pass begins: play leaves it on size"),
        ("guideway-taper", "more places in each section: a taper goes on within it, play does not"),
    ],
    needs: a_climb,
    act: |[gap], machine| {
        let setup = Arc::clone(&machine.setup);
        let lags = lags(&setup, gap);
        machine.add_shift(move |at| -2.0 * lags.get(setup.segment(at.x)).copied().unwrap_or(0.0));
    },
};

/// How far the slide lags in each segment, m.
fn lags(setup: &Setup, gap: f64) -> Vec<f64> {
    let mut lags = vec![0.0; setup.segments.len()];
    for (before, behind, rise) in shoulders(setup) {
        lags[behind] = f64::min((lags[before] + rise).max(0.0), gap);
    }
    lags
}

/// The shoulders along the pass: the numbers of the segments before and behind each, and by how much (m) the radius rises.
fn shoulders(setup: &Setup) -> Vec<(usize, usize, f64)> {
    let pass = setup.schedule.pass;
    let ((low, high), tiny) = (pass.ends(), 1e-9 * setup.length());
    let mut end = 0.0;
    let is_cut = |number: &usize| {
        let start = end;
        end += setup.segments[*number].length;
        // The pass may begin and end on a shoulder.
        end > low + tiny && start < high - tiny
    };
    let mut cut: Vec<usize> = (0..setup.segments.len()).filter(is_cut).collect();
    if pass.to < pass.from {
        cut.reverse();
    }
    let radius = |number: usize| 0.5 * setup.segments[number].section.diameter;
    cut.windows(2).map(|pair| (pair[0], pair[1], radius(pair[1]) - radius(pair[0]))).collect()
}

fn a_climb(setup: &Setup) -> Result<(), String> {
    // Of a diameter that is still to be found nobody knows that it is not larger.
    match shoulders(setup).iter().any(|(_, _, rise)| rise.is_nan() || *rise > 0.0) {
        true => Ok(()),
        false => {
            Err("needs a shoulder that the pass climbs: segments of which one is larger than that turned before it"
                .into())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::Turning;
    use super::super::super::machine::Moment;
    use super::super::bench::*;
    use super::a_climb;
    use crate::process::{Assembled, with_effect};

    /// A lathe with 10 um of play and a shaft of Ø50, Ø60, Ø60 and Ø40, 150 mm each.
    fn stepped(pass: &str) -> Assembled<Turning> {
        let one = |diameter: &str| format!("{{ length = \"150 mm\", diameter = \"{diameter} mm\" }}");
        let four = ["50", "60", "60", "40"].map(one).join(", ");
        let text = model("centres").replace("{ length = \"600 mm\", diameter = \"50 mm\" }", &four);
        with_effect(&text.replace("cut = { ", &format!("cut = {{ {pass}")), "cross-slide-play", &[10.0])
    }

    /// Changes of its diameter at places (mm), um.
    fn changes(pass: &str, places: [f64; 4]) -> [f64; 4] {
        let lathe = stepped(pass);
        places.map(|x| 1e6 * unloaded(lathe.machine(), &Moment { x: 1e-3 * x, ..moment() }).unwrap())
    }

    fn close(found: [f64; 4], expected: [f64; 4]) {
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{found:?} and not {expected:?}");
    }

    #[test]
    fn it_is_behind_where_the_slide_has_moved_outwards() {
        let middles = [75.0, 225.0, 375.0, 525.0];
        // From the tailstock Ø40 is exact, Ø60 twice the play too small, Ø50 exact again.
        close(changes("", middles), [0.0, -20.0, -20.0, 0.0]);
        // From the headstock Ø50 is exact, Ø60 too small, Ø40 exact.
        close(changes("from = \"0 mm\", to = \"600 mm\", ", middles), [0.0, -20.0, -20.0, 0.0]);
        // A pass that ends in between leaves the rest as it is.
        close(changes("from = \"0 mm\", to = \"300 mm\", ", middles), [0.0, -20.0, 0.0, 0.0]);
        // On a shoulder the segment toward the tailstock counts.
        close(changes("", [149.0, 150.0, 449.0, 450.0]), [0.0, -20.0, -20.0, 0.0]);
    }
    #[test]
    fn a_pass_that_climbs_nothing_is_refused() {
        // Ø60 is where it begins, on the shoulder behind Ø40; then it goes in to Ø50.
        assert!(a_climb(&stepped("from = \"450 mm\", to = \"0 mm\", ").machine().setup).is_err());
        assert!(a_climb(&stepped("from = \"460 mm\", to = \"0 mm\", ").machine().setup).is_ok());
        assert!(a_climb(&lathe("centres", "cross-slide-play", &[10.0]).machine().setup).is_err());
    }
}
