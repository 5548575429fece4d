//! The jaws press over an arc and not along a line.
//!
//! The force F of each jaw is spread evenly over the full angle `arc` (rad): p = F/(b·Ro·arc). Each harmonic
//! m of the load shrinks by sinc(m·arc/2), so that the ring is squeezed less, and less pointedly. Soft jaws
//! bored to the ring's diameter have wide arcs, hard ones small ones. Arcs must not overlap: arc ≤ 360 deg
//! over the number of jaws. Left out: pressure that is not even, friction.

use super::super::machine::Effect;
use crate::process::{Belongs, Odds, Parameter};
use crate::units::ANGLE;

/// `jaw-contact-arc`.
pub static JAW_CONTACT_ARC: Effect<1> = Effect {
    name: "jaw-contact-arc",
    about: "each jaw presses evenly over an arc and not along a line",
    law: "p = F/(width*Ro*arc) over the arc: harmonic m of the load times sin(m*arc/2)/(m*arc/2)",
    source: "Fourier series of an even pressure",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "every jaw presses over an arc, some over a narrow one"),
    parameters: [Parameter::amplitude("arc", ANGLE, "full angle over which a jaw presses", (2.0, 60.0))],
    look_alikes: &[("centrifugal-unloading", "a second spindle speed, or the ring clamped and standing still")],
    needs: |setup| match setup.arc {
        0.0 => Ok(()),
        arc if setup.grasp.is_some() => Err(format!(
            "says over which arc the jaws press, and so does `pad` in [chuck.membrane], over {:.2}: leave the effect out",
            ANGLE.shown(arc)
        )),
        arc => Err(format!(
            "says over which arc the jaws press, and so does the mesh, over {:.2}: draw the jaws as points",
            ANGLE.shown(arc)
        )),
    },
    act: |[arc], machine| machine.arc = arc,
};

#[cfg(test)]
mod tests {
    use super::super::super::forward::{Squeeze, squeezed};
    use super::super::super::jaws::in_equilibrium;
    use super::super::bench::*;

    #[test]
    fn jaws_that_press_all_around_leave_the_ring_round() {
        let [even, line] = [120.0, 0.0].map(|arc| squeezed(chuck("jaw-contact-arc", &[arc]).machine()).unwrap());
        let under = |ring: &Squeeze, angle: f64| ring.at([angle, 0.0], |part| part);
        let wave = |ring: &Squeeze| under(ring, 0.0) - under(ring, 1.0);
        assert!(wave(&even).abs() < 1e-6 * wave(&line).abs());
        // Lamé: −2·p·Ro²·Ri/(E·(Ro² − Ri²)) with 3 N over the whole outside; the mesh is good to 1e-5.
        let pressure = 3.0 / (std::f64::consts::TAU * 0.05 * 0.02);
        let lame = -2.0 * pressure * 0.0025 * 0.042 / (210e9 * (0.0025 - 0.042 * 0.042));
        assert!((under(&even, 0.3) / lame - 1.0).abs() < 1e-4, "{} {lame}", under(&even, 0.3));
    }

    #[test]
    fn jaws_do_not_overlap() {
        let chucked = |arc: f64| chuck("jaw-contact-arc", &[arc]).machine().jaws();
        assert!(chucked(121.0).unwrap_err().message.contains("overlap") && chucked(119.0).is_ok());
        let pressed = |angles: [f64; 3], arc: f64| in_equilibrium(&angles.map(f64::to_radians), arc.to_radians(), 0.0);
        // Jaw 3 moved by 30 deg leaves 90 deg to the next.
        assert!(pressed([0.0, 122.0, 270.0], 91.0).unwrap_err().message.contains("overlap"));
        assert!(pressed([0.0, 122.0, 270.0], 89.0).is_ok());
    }
}
