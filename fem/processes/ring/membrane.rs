//! A membrane chuck: jaws on a plate that is pushed open and springs back on the ring.
//!
//! The plate is clamped around its edge; a push in its middle bends it, and the jaws, which stand on a circle of it and out by
//! l, turn outwards. Let go, the plate would turn them back to where they stand free; the ring is larger by the interference δ on the
//! radius. With the compliance c of the chuck at a pad and c_r of the ring under all its pads (m/N)
//!
//! ```text
//!   F = δ/(c + c_r),   c = l²·(slope of the plate at a root per moment on every jaw)
//! ```
//!
//! A jaw that the turning chuck throws outwards by m·r·ω² at the height h of its centre turns its root by the moment m·r·ω²·h. The ring,
//! sprung against the plate, springs after it, so that its pad loses the part
//!
//! ```text
//!   h/l · c/(c + c_r)
//! ```
//!
//! of m·r·ω² alone, as a preloaded bolt does. Jaws are rigid, and the plate is
//! ([`crate::solve::diaphragm`]). Left out: what jaws and their seats give way, what the plate yields in its own plane (a part of some t²/12l²
//! with its thickness t), how roots stiffen it, a hole in its middle, friction at the pads.

use std::f64::consts::TAU;

use crate::input::Reader;
use crate::material::Material;
use crate::process::estimates::INTERFERENCE;
use crate::solve::diaphragm::{Arms, Bent, Diaphragm};
use crate::units::{FORCE, LENGTH, MICRO};

/// What opens the chuck.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Push {
    /// N.
    pub force: f64,
    /// Radius of the circle on which it acts, m.
    pub radius: f64,
}

/// A membrane with its jaws.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Membrane {
    /// The plate.
    pub plate: Diaphragm,
    /// Roots of the jaws on it.
    pub arms: Arms,
    /// l, from the middle of the plate to that of the pads, m.
    pub length: f64,
    /// h, from the middle of the plate to the centre of mass of a jaw, m.
    pub centre: f64,
    /// Width of a pad along the ring, m.
    pub pad: f64,
    /// By how much the ring is larger than the free jaws, on the diameter, m.
    pub interference: f64,
    /// What opens it, if that is known.
    pub push: Option<Push>,
}

/// A membrane that holds a ring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grasp {
    /// The membrane.
    pub membrane: Membrane,
    /// How far the chuck gives way at each pad per newton on all of them, m/N.
    pub own: f64,
    /// How far the ring gives way at each pad per newton on all of them, m/N.
    pub ring: f64,
}

impl Membrane {
    /// Reads the table.
    pub fn read(t: &Reader, jaws: usize) -> Self {
        let length = |key, about| t.quantity(key, LENGTH, about).positive();
        let material = Material::read_or(t, "material", &Material::STEEL);
        let radius =
            0.5 * length("diameter", "diameter within which the plate is free; its edge is clamped").required();
        let thickness = length("thickness", "thickness of the plate").required();
        let circle = 0.5 * length("jaw_circle", "diameter of the circle on which the jaws stand").required();
        let root = length("root", "width of a jaw where it stands on the plate, along that circle").optional();
        let out = length("jaw_length", "from the middle of the plate to the middle of the pads").required();
        let centre = length("jaw_centre", "from the middle of the plate to a jaw's centre of mass; half of jaw_length");
        let pad = length("pad", "width of a pad where it presses, along the ring").required();
        let interference = t
            .quantity("interference", MICRO, "by how much the ring is larger than the free jaws, on the diameter")
            .estimated(INTERFERENCE)
            .not_negative()
            .required();
        let push = t.optional_table("push", "what opens the chuck", |t| Push {
            force: t.quantity("force", FORCE, "force of the actuator").positive().required(),
            radius: 0.5
                * t.quantity("diameter", LENGTH, "diameter of the circle on which it pushes").positive().required(),
        });
        let centre = centre.or(0.5 * out);
        let count = jaws.max(2);
        let whole = TAU / count as f64;
        let arms = Arms { circle, count, root: root.map_or(whole, |root| (root / circle).min(whole)) };
        let plate = Diaphragm {
            radius,
            thickness,
            youngs_modulus: material.youngs_modulus,
            poisson_ratio: material.poisson_ratio,
        };
        let own = Self { plate, arms, length: out, centre, pad, interference, push };
        own.check(t, root);
        own
    }

    /// Tells what does not go together.
    fn check(&self, t: &Reader, root: Option<f64>) {
        let Self { plate, arms, push, .. } = self;
        let [across, circle] = [plate.radius, arms.circle].map(|radius| LENGTH.format(2.0 * radius));
        if arms.circle >= plate.radius {
            t.problem(
                "jaw_circle",
                format!("the jaws stand on {circle}, and the plate is free within {across}"),
                "the circle of the jaws lies within the clamped edge",
            );
        }
        let room = TAU * arms.circle / arms.count as f64;
        if root.is_some_and(|root| root > room * (1.0 + 1e-9)) {
            let help = format!("at most {}; left out, roots reach all around", LENGTH.format(room));
            t.problem("root", format!("{} jaws of that width overlap on {circle}", arms.count), help);
        }
        if push.is_some_and(|push| push.radius >= arms.circle) {
            let help = format!("push within the circle of the jaws, {circle}");
            t.problem("push", "the push acts where the jaws stand, or outside of them", help);
        }
    }

    /// The plate under a force (N) at every pad.
    pub fn pressed(&self, force: f64) -> Bent {
        self.plate.under_arms(&self.arms).times(force * self.length)
    }

    /// The plate under what opens it.
    pub fn opened(&self, push: Push) -> Bent {
        self.plate.pushed(push.radius, self.arms.circle).times(push.force)
    }
}

impl Grasp {
    /// The membrane on a ring that gives way at each pad by `ring` (m/N).
    pub fn new(membrane: Membrane, ring: f64) -> Self {
        let own = membrane.plate.under_arms(&membrane.arms).slope * membrane.length * membrane.length;
        Self { membrane, own, ring }
    }

    /// Force of each jaw at standstill, N.
    pub fn force(&self) -> f64 {
        0.5 * self.membrane.interference / (self.own + self.ring)
    }

    /// Part of what throws a jaw outwards that its pad loses.
    pub fn felt(&self) -> f64 {
        let Membrane { centre, length, .. } = self.membrane;
        centre / length * self.own / (self.own + self.ring)
    }
}
