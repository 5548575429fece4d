//! The joint as effects shape it.

use std::sync::Arc;

use super::curve::Curve;
use super::setup::Setup;
use crate::process;

/// An effect on this machine, with `N` parameters.
pub type Effect<const N: usize> = process::Effect<Setup, Machine, N>;

/// A joint with its effects, under test.
pub struct Machine {
    /// The tables of the model.
    pub setup: Arc<Setup>,
    /// The curve of the joint.
    pub curve: Curve,
}

impl Machine {
    /// The ideal joint: a spring.
    pub fn ideal(setup: Arc<Setup>) -> Self {
        Self { curve: Curve::ideal(&setup), setup }
    }
}
