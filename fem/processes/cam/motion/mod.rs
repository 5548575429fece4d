//! The motion of the wheel about the cam as the machine makes it, and what the wheel leaves of the cam.
//!
//! Seen from the cam the wheel's centre runs W(t) = x·e(φ) + h·e⊥(φ): x is where the slide stands, φ
//! how far the cam has turned, h the height of the wheel above the cam's axis. Over a [`Leg`] x and φ go
//! linearly in time, so that W is an arc of an Archimedean spiral. What is left of the cam along the normal
//! of a point of its profile is the least that any position of the wheel leaves there.

mod leg;
mod path;
mod play;
mod reach;
mod tree;

pub use leg::Leg;
pub use path::{Axes, legs};
pub use reach::{Ray, Reach};

use tree::Tree;

/// A turn of the cam under a wheel.
#[derive(Clone, Debug)]
pub struct Motion {
    legs: Vec<Leg>,
    tree: Tree,
    /// Radius of the wheel as it is, m.
    radius: f64,
}

impl Motion {
    /// The motion over these legs, in their order, of a wheel of `radius`.
    pub fn new(legs: Vec<Leg>, radius: f64) -> Self {
        Self { tree: Tree::new(&legs), legs, radius }
    }

    /// The legs, in their order.
    pub fn legs(&self) -> &[Leg] {
        &self.legs
    }

    /// Radius of the wheel, m.
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The first leg of a block of the programme.
    pub fn first_leg(&self, block: usize) -> usize {
        self.legs.partition_point(|leg| leg.block < block).min(self.legs.len() - 1)
    }

    /// The rest along a ray, and the position of the wheel that cuts it last: to round-off the least over
    /// the whole motion. The search begins at leg `guess`. `None` where the wheel never comes.
    pub fn left_along(&self, ray: &Ray, guess: usize) -> Option<Reach> {
        let mut best = Reach::none();
        self.legs[guess].lower(ray, self.radius, guess, (0.0, 1.0), &mut best);
        self.tree.search(ray, self.radius, best.left, |leg| {
            self.legs[leg].lower(ray, self.radius, leg, (0.0, 1.0), &mut best);
            best.left
        });
        best.found()
    }

    /// The least that a leg leaves along a ray between two times of the leg, if it leaves less than `limit`.
    pub fn left_between(&self, ray: &Ray, leg: usize, times: (f64, f64), limit: f64) -> Option<Reach> {
        let mut best = Reach { left: limit, ..Reach::none() };
        self.legs[leg].lower(ray, self.radius, leg, times, &mut best);
        best.found()
    }

    /// The legs that may leave less than `limit` along a ray, in no order.
    pub fn legs_within(&self, ray: &Ray, limit: f64) -> Vec<usize> {
        let mut found = Vec::new();
        self.tree.search(ray, self.radius, limit, |leg| {
            found.push(leg);
            limit
        });
        found
    }
}

#[cfg(test)]
mod tests;
