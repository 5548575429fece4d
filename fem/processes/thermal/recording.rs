//! A body followed once for all that a run tells of it: what rows read, its shape, and all of its nodes from time to time.

use super::follow::Look;
use crate::solve::conduction::{Energy, Run};
use crate::solve::rod::Track;

/// A body that was followed.
#[derive(Debug)]
pub struct Recording {
    /// In which steps, and to which end.
    pub run: Run,
    /// What was looked at.
    pub looks: Vec<Look>,
    /// Values of every look at the start and at the end of every step.
    pub track: Track,
    /// Where the heat went.
    pub energy: Energy,
    /// All nodes at some of these times.
    pub pictures: Vec<Picture>,
    /// The hottest node at any of these times.
    pub hottest: Option<Hottest>,
}

/// All nodes at a time.
#[derive(Debug)]
pub struct Picture {
    /// s.
    pub time: f64,
    /// Rises of the nodes, K.
    pub rises: Vec<f64>,
    /// The same with formula effects, which deform no body; `None` where there are none.
    pub shown: Option<Vec<f64>>,
}

/// Where and when a body is hottest.
#[derive(Clone, Copy, Debug)]
pub struct Hottest {
    /// Number of the node.
    pub node: usize,
    /// Rise of its temperature, K.
    pub rise: f64,
    /// Time, s.
    pub time: f64,
}

impl Recording {
    /// Values of a look at the start and at the end of every step, if it was looked at.
    pub fn seen(&self, look: Look) -> Option<Vec<f64>> {
        self.looks.iter().position(|own| *own == look).map(|i| self.track.values[i].clone())
    }
}
