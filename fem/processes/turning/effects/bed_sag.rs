//! The bed sags between its feet, the front guideway by something else than the rear one.
//!
//! Badly set up, or where its foundation settles, a bed is curved under its own weight before any cut [seed 002,
//! machines that are not loaded]. Between the ends of the travel the guideways sag by 4·s·ξ(1 − ξ), ξ = x/L, s being
//! front and rear in the middle: the parabola of a bed on two feet. The carriage tilts by the difference over the
//! spacing b of the guideways, and the nose, at the centre height H, leaves the axis by Δy = (s_front −
//! s_rear)·H/b·4ξ(1 − ξ); it falls by their mean, Δz = (s_front + s_rear)/2·4ξ(1 − ξ), which shows by its square
//! alone [(2), (7)]. The seed says that it acts as the wear of the guideways does, and prints no formula: ours, by
//! geometry. All lengths in m. Left out: the shape of beds on more feet.

use super::super::machine::Effect;
use super::front_guideway_wear::two_guideways;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::MICRO;

/// `bed-sag`.
pub static BED_SAG: Effect<2> = Effect {
    name: "bed-sag",
    about: "the bed sags between its feet, one guideway more than the other, and the carriage tilts and falls",
    law: "dD += 2*(front - rear)*H/b*4*xi*(1 - xi), dz -= (front + rear)/2*4*xi*(1 - xi), xi = x/L",
    source: "geometry, ours; cf. seed 002, deformation of machines that are not loaded, (2)",
    belongs: Belongs::Test,
    odds: Odds::of(0.1, "beds are stiff and levelled"),
    parameters: [
        Parameter::signed("front", MICRO, "sag of the front guideway in the middle", (-200.0, 200.0)),
        Parameter::signed("rear", MICRO, "sag of the rear guideway in the middle", (-200.0, 200.0)).or(0.0),
    ],
    look_alikes: &[
        ("front-guideway-wear", "a level along the guideways: wear stands at one place"),
        ("guideway-wear", "a level along the guideways: wear stands at one place"),
    ],
    needs: two_guideways,
    act: |[front, rear], machine| {
        let Some(spacing) = machine.setup.guideway_spacing else { return };
        let (length, lever) = (machine.setup.length(), machine.setup.centre_height / spacing);
        let parabola = move |x: f64| 4.0 * x / length * (1.0 - x / length);
        machine.add_shift(move |at| 2.0 * (front - rear) * lever * parabola(at.x));
        machine.add_lift(move |at| -0.5 * (front + rear) * parabola(at.x));
    },
};

#[cfg(test)]
mod tests {
    use super::super::bench::*;
    use crate::process::with_effect;

    #[test]
    fn the_nose_moves_by_the_difference_and_falls_by_the_mean() {
        // At a quarter 3/4 of the sag: 15 and 9 um; 6 um over 300 mm at 250 mm are 5 um, and 12 um of fall.
        let text = model("centres").replace("type = \"centres\"", "type = \"centres\", guideway_spacing = \"300 mm\"");
        let sagged = with_effect::<super::super::super::Turning>(&text, "bed-sag", &[20.0, 12.0]);
        let across = 0.05 + 2.0 * 5e-6;
        let expected = (across * across + 4.0 * 12e-6 * 12e-6f64).sqrt() - 0.05;
        assert!((unloaded(sagged.machine(), &moment()).unwrap() - expected).abs() < 1e-15);
    }
}
