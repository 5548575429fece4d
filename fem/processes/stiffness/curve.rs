//! The curve of a joint: how far it gives way under a force that rises, and under one that falls again.

use super::setup::{Loading, Setup};
use crate::joint::{Joint, Pair, give_way, lost_motion};

/// The way the force goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Branch {
    /// Up from no force, or from the largest of the other sign.
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

/// A joint. Friction comes first: of the force F it leaves S to the joint, and the laws of spring, contact,
/// preload, clearance and settling are laws of S.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Force at which loading ends, N.
    pub max_force: f64,
    /// Whether the force is let go at zero, or runs on to the other side.
    pub loading: Loading,
    /// Friction f, N.
    pub friction: f64,
    /// Clearance, crossed where S changes its sign, m; a preload has taken it up before.
    pub gap: f64,
    /// Preload P with which two of the joint press on each other, N; 0 where there is one.
    pub preload: f64,
    /// Spring and contacts in series, under S.
    pub joint: Joint,
    /// Permanent set under the largest force, m.
    pub settles: f64,
    /// Reading of the gauge before any force, m.
    pub offset: f64,
}

impl Curve {
    /// The ideal joint: a spring.
    pub fn ideal(setup: &Setup) -> Self {
        let Setup { stiffness, max_force, loading, .. } = *setup;
        let mut joint = Joint::default();
        joint.soften(stiffness);
        Self { max_force, loading, friction: 0.0, gap: 0.0, preload: 0.0, joint, settles: 0.0, offset: 0.0 }
    }

    /// S, the force on the joint under F, N. Friction holds the first f of the load; when the force turns
    /// back it holds until 2f are gone.
    pub fn spring_force(&self, force: f64, branch: Branch) -> f64 {
        let most = self.largest();
        match (branch, self.loading) {
            (Branch::Load, Loading::FromZero) => (force - self.friction).max(0.0),
            (Branch::Load, Loading::Reversed) => (force - self.friction).max(-most),
            (Branch::Unload, _) => (force + self.friction).min(most),
        }
    }

    /// y under the force F, m.
    pub fn displacement(&self, force: f64, branch: Branch) -> f64 {
        let s = self.spring_force(force, branch);
        give_way(self.clearance(), self.bend(s), s) + self.settled(force, branch) + self.offset
    }

    /// Clearance that is there to be taken up, m: none under a preload.
    pub fn clearance(&self) -> f64 {
        if self.preload > 0.0 { 0.0 } else { self.gap }
    }

    /// Permanent set under the F of a branch, m: in proportion to S while it rises, and as much all the way back.
    fn settled(&self, force: f64, branch: Branch) -> f64 {
        let largest = match branch {
            Branch::Load => self.spring_force(force, Branch::Load),
            Branch::Unload => self.largest(),
        };
        self.settles * largest / self.max_force
    }

    /// S at the largest force, N.
    fn largest(&self) -> f64 {
        (self.max_force - self.friction).max(0.0)
    }

    /// The joint, alone or pressed against its like.
    pub fn pair(&self) -> Pair<'_> {
        Pair::new(&self.joint, self.preload)
    }

    /// How far the joint gives way under S, m.
    fn bend(&self, s: f64) -> f64 {
        self.pair().displacement(s)
    }

    /// Tangent stiffness dF/dy, N/m; `None` where friction holds the joint still.
    pub fn tangent(&self, force: f64, branch: Branch) -> Option<f64> {
        let s = self.spring_force(force, branch);
        let moves = match (branch, self.loading) {
            (Branch::Load, Loading::FromZero) => force >= self.friction,
            (Branch::Load, Loading::Reversed) => s > -self.largest(),
            (Branch::Unload, _) => s < self.largest(),
        };
        let settling = if branch == Branch::Load { self.settles / self.max_force } else { 0.0 };
        moves.then(|| 1.0 / (self.pair().compliance(s) + settling))
    }

    /// Lost motion of the joint where a force changes its sign, m: clearance, and the friction that first lets go of
    /// the one side and then bends the other, 2·y(f).
    pub fn lost_motion(&self) -> f64 {
        lost_motion(self.clearance(), self.bend(self.friction))
    }

    /// The friction with which this joint would lose as much (m) by elasticity alone, N.
    pub fn friction_that_loses(&self, lost: f64) -> f64 {
        self.pair().force_at(0.5 * lost)
    }

    /// Work ∮F dy that friction and settling take up over loading and unloading, J: the area between the
    /// curves.
    ///
    /// While the joint moves F = S ± f, so that the area is ∫(S + f)dy up to the largest S₁ less ∫(S − f)dy
    /// from what is left at no force, S₀, on. What settles moves on loading alone. A reversed force moves the
    /// joint from −S₁ to S₁ and back against f: 4·f·y(S₁). Clearance is crossed under F = ±f, once where the force
    /// is let go at zero and S is not, and twice where it is reversed.
    pub fn loop_area(&self) -> f64 {
        let (most, f) = (self.largest(), self.friction);
        if self.loading == Loading::Reversed {
            return f * (4.0 * self.bend(most) + 2.0 * self.crossed());
        }
        let left = self.spring_force(0.0, Branch::Unload);
        let crossing = f * self.crossed();
        self.pair().work(left) + 2.0 * f * self.bend(most) - f * self.bend(left) + crossing + self.work_of_settling()
    }

    /// Clearance that the test crosses, m: none where friction takes all of the force.
    fn crossed(&self) -> f64 {
        if self.largest() > 0.0 { self.clearance() } else { 0.0 }
    }

    /// Work put in while a force drives the joint away from the middle, ∫F dy, J; on both sides where the
    /// force is reversed. There the joint sets out from −S₀, S₀ what is left at no force.
    pub fn work_of_loading(&self) -> f64 {
        let (most, f) = (self.largest(), self.friction);
        if self.loading == Loading::Reversed {
            let left = self.spring_force(0.0, Branch::Unload);
            let stored = self.pair().work(most) - self.pair().work(left);
            return 2.0 * (stored + f * (self.bend(most) + self.bend(left) + self.crossed()));
        }
        self.pair().work(most) + f * (self.bend(most) + self.crossed()) + self.work_of_settling()
    }

    /// Work ∫(S + f)dy that goes into what settles while loading, J.
    fn work_of_settling(&self) -> f64 {
        (0.5 * self.largest() + self.friction) * self.settled(self.max_force, Branch::Load)
    }

    /// The same joint with another preload, N.
    #[must_use]
    pub fn preloaded(&self, preload: f64) -> Self {
        Self { preload, ..self.clone() }
    }
}
