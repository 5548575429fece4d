//! The curve of a joint: how far it gives way under a force that rises, and under one that falls again.

use super::setup::Setup;
use crate::joint::{Contact, Joint};

/// The way the force goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branch {
    /// Up from no force.
    Load,
    /// Down from the largest.
    Unload,
}

impl Branch {
    /// Its position among the words of the coordinate.
    pub fn word(self) -> f64 {
        f64::from(self as u8)
    }
}

/// A joint. Friction comes first: of the force F it leaves S to the spring, and the laws of spring, preload,
/// contact and settling are laws of S. Only clearance asks for F itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Stiffness k of the spring, N/m.
    stiffness: f64,
    /// Force at which loading ends, N.
    pub max_force: f64,
    /// Friction f, N.
    pub friction: f64,
    /// Clearance, taken up as soon as a force acts, m.
    pub gap: f64,
    /// Preload F₀ of two springs that press on each other, N; 0 where there is one spring.
    pub preload: f64,
    /// Contacts in series, under S.
    pub contacts: Joint,
    /// What settles for good under the largest force, m.
    pub settles: f64,
    /// What the gauge shows before any force, m.
    pub offset: f64,
}

impl Curve {
    /// The ideal joint: a spring.
    pub fn ideal(setup: &Setup) -> Self {
        let Setup { stiffness, max_force, .. } = *setup;
        Self {
            stiffness,
            max_force,
            friction: 0.0,
            gap: 0.0,
            preload: 0.0,
            contacts: Joint::default(),
            settles: 0.0,
            offset: 0.0,
        }
    }

    /// S, the force on the spring under F, N. Friction holds the first f of the load; when the force turns
    /// back it holds until 2f are gone.
    pub fn spring_force(&self, force: f64, branch: Branch) -> f64 {
        match branch {
            Branch::Load => (force - self.friction).max(0.0),
            Branch::Unload => (force + self.friction).min(self.spring_force(self.max_force, Branch::Load)),
        }
    }

    /// y under the force F, m.
    pub fn displacement(&self, force: f64, branch: Branch) -> f64 {
        let clearance = if force > 0.0 { self.gap } else { 0.0 };
        self.bend(self.spring_force(force, branch)) + self.settled(force, branch) + clearance + self.offset
    }

    /// What has settled under the F of a branch, m: in proportion to S while it rises, and as much all the way
    /// back.
    fn settled(&self, force: f64, branch: Branch) -> f64 {
        let largest = match branch {
            Branch::Load => self.spring_force(force, Branch::Load),
            Branch::Unload => self.spring_force(self.max_force, Branch::Load),
        };
        self.settles * largest / self.max_force
    }

    /// How far spring, preload and contacts give way under S, m. Of two springs both resist until one is
    /// relaxed, at S = 2F₀.
    fn bend(&self, s: f64) -> f64 {
        let both = s.min(2.0 * self.preload);
        (0.5 * both + (s - both)) / self.stiffness + self.contacts.displacement(s)
    }

    /// ∫S dy from no force to S, J.
    fn work_at(&self, s: f64) -> f64 {
        let both = s.min(2.0 * self.preload);
        let spring = (0.25 * both * both + 0.5 * (s * s - both * both)) / self.stiffness;
        let contact = |c: &Contact| c.displacement(s) * s * c.exponent / (c.exponent + 1.0);
        spring + self.contacts.contacts.iter().map(contact).sum::<f64>()
    }

    /// Tangent stiffness dF/dy, N/m; `None` where friction holds the joint still.
    pub fn tangent(&self, force: f64, branch: Branch) -> Option<f64> {
        let s = self.spring_force(force, branch);
        let moves = match branch {
            Branch::Load => force >= self.friction,
            Branch::Unload => s < self.spring_force(self.max_force, Branch::Load),
        };
        let springs = if s < 2.0 * self.preload { 2.0 } else { 1.0 };
        let (_, contact) = self.contacts.yield_under(s);
        let settling = if branch == Branch::Load { self.settles / self.max_force } else { 0.0 };
        moves.then(|| 1.0 / (1.0 / (springs * self.stiffness) + contact + settling))
    }

    /// Work ∮F dy that friction and settling take up over loading and unloading, J: the area between the
    /// curves.
    ///
    /// While the joint moves F = S ± f, so that the area is ∫(S + f)dy up to the largest S₁ less ∫(S − f)dy
    /// from what is left at no force, S₀, on. What settles moves on loading alone.
    pub fn loop_area(&self) -> f64 {
        let most = self.spring_force(self.max_force, Branch::Load);
        let left = self.spring_force(0.0, Branch::Unload);
        let f = self.friction;
        self.work_at(left) + 2.0 * f * self.bend(most) - f * self.bend(left) + self.work_of_settling()
    }

    /// Work put in while loading, ∫F dy, J.
    pub fn work_of_loading(&self) -> f64 {
        let most = self.spring_force(self.max_force, Branch::Load);
        self.work_at(most) + self.friction * self.bend(most) + self.work_of_settling()
    }

    /// Work ∫(S + f)dy that goes into what settles while loading, J.
    fn work_of_settling(&self) -> f64 {
        let most = self.spring_force(self.max_force, Branch::Load);
        (0.5 * most + self.friction) * self.settled(self.max_force, Branch::Load)
    }

    /// The same joint with another preload, N.
    #[must_use]
    pub fn preloaded(&self, preload: f64) -> Self {
        Self { preload, ..self.clone() }
    }
}
