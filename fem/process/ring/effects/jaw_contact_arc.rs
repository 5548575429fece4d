//! The jaws press over an arc and not along a line.
//!
//! The force F of each jaw is spread evenly over the full angle `arc` (rad): p = F/(b·Ro·arc). Each harmonic m of the load shrinks by
//! sinc(m·arc/2), so that the ring is squeezed less, and less pointedly. Soft jaws bored to the ring's diameter have wide arcs, hard ones
//! small ones. Arcs must not overlap: arc ≤ 360 deg over the number of jaws. Left out: pressure that is not even, friction.

use super::super::Machine;
use crate::process::{Description, Effect, Parameter, Values};
use crate::units::ANGLE;

/// `jaw-contact-arc`.
pub struct JawContactArc;

static DESCRIPTION: Description = Description {
    name: "jaw-contact-arc",
    about: "each jaw presses evenly over an arc and not along a line",
    law: "p = F/(width*Ro*arc) over the arc: harmonic m of the load times sin(m*arc/2)/(m*arc/2)",
    source: "Fourier series of an even pressure",
    parameters: &[Parameter::amplitude("arc", ANGLE, "full angle over which a jaw presses", (2.0, 60.0))],
    look_alikes: &[("centrifugal-unloading", "a second spindle speed, or the ring clamped and standing still")],
};

impl Effect<Machine> for JawContactArc {
    fn description(&self) -> &'static Description {
        &DESCRIPTION
    }

    fn act(&self, values: &Values, machine: &mut Machine) {
        machine.arc = values["arc"];
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn jaws_that_press_all_around_leave_the_ring_round() {
        let bore = chuck("jaw-contact-arc", &[120.0]).bore().unwrap();
        let line = chuck("jaw-contact-arc", &[0.0]).bore().unwrap();
        let wave = |bore: &crate::process::ring::BoreMotion| bore.radial(0.0) - bore.radial(1.0);
        assert!(wave(&bore).abs() < 1e-6 * wave(&line).abs());
        // Lamé: −2·p·Ro²·Ri/(E·(Ro² − Ri²)) with 3 N over the whole outside; the coarse mesh is good to 1e-5.
        let pressure = 3.0 / (std::f64::consts::TAU * 0.05 * 0.02);
        let lame = -2.0 * pressure * 0.0025 * 0.042 / (210e9 * (0.0025 - 0.042 * 0.042));
        assert!((bore.radial(0.3) / lame - 1.0).abs() < 1e-4, "{} {lame}", bore.radial(0.3));
    }

    #[test]
    fn jaws_do_not_overlap() {
        assert!(chuck("jaw-contact-arc", &[121.0]).bore().unwrap_err().message.contains("overlap"));
        // Jaw 2 moved by 30 deg leaves 90 deg to the next.
        let moved = |arc: f64| chuck_with(&[("jaw-position", &[2.0, 30.0]), ("jaw-contact-arc", &[arc])]).jaws();
        assert!(moved(91.0).unwrap_err().message.contains("overlap"));
        assert!(moved(89.0).is_ok());
    }
}
