//! A body through time, at the places that are looked at.

use super::body::Body;
use super::machine::Machine;
use super::{plate, rod};
use crate::process::Failure;
use crate::solve::conduction::Energy;
use crate::solve::rod::Track;

/// What is looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Look {
    /// Growth of the body from its base to its free end, m.
    Elongation,
    /// Rise of the middle of a plane body over its ends, upwards, m.
    Bow,
    /// Rise of temperature at a place, m; K.
    Rise {
        /// From the base.
        x: f64,
        /// Above the lower edge's origin; half way up where it is `None`. Rods have none.
        y: Option<f64>,
    },
}

/// Through which times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Longest step, s.
    pub step: f64,
    /// s.
    pub end: f64,
    /// How many pictures of all nodes are kept, evenly spaced, beside that of the start.
    pub pictures: usize,
}

/// What was seen.
#[derive(Clone, Debug, Default)]
pub struct Followed {
    /// Of every look at the end of every step.
    pub track: Track,
    /// Where the heat went.
    pub energy: Energy,
    /// Times (s) with the rises of all nodes (K).
    pub pictures: Vec<(f64, Vec<f64>)>,
    /// The hottest node at the end of any step, where pictures are kept.
    pub hottest: Option<Hottest>,
}

/// Where and when a body is hottest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hottest {
    /// K.
    pub rise: f64,
    /// Its number.
    pub node: usize,
    /// s.
    pub time: f64,
}

impl Followed {
    pub(super) fn of(looks: usize) -> Self {
        Self { track: Track::new(looks), ..Self::default() }
    }

    /// Keeps a picture when its time has come, and the hottest node at any time.
    pub(super) fn picture(&mut self, span: &Span, time: f64, nodes: impl FnOnce() -> Vec<f64>) {
        if span.pictures == 0 {
            return;
        }
        let rises = nodes();
        // Of what is equal but for rounding the first.
        let above = |best: Option<Hottest>, rise: f64| best.is_none_or(|b| rise > b.rise + 1e-9 * rise.abs());
        for (node, &rise) in rises.iter().enumerate() {
            if above(self.hottest, rise) {
                self.hottest = Some(Hottest { rise, node, time });
            }
        }
        let due = span.end * self.pictures.len() as f64 / span.pictures as f64;
        if time >= due * (1.0 - 1e-9) {
            self.pictures.push((time, rises));
        }
    }
}

/// Follows a body from the start to the end of a span.
///
/// # Errors
/// It cannot be computed, or a place is not on it.
pub fn follow(machine: &Machine, looks: &[Look], span: &Span) -> Result<Followed, Failure> {
    match &machine.setup.body {
        Body::Rod(segments) => rod::follow(machine, segments, looks, span),
        Body::Plane(plane) => plate::follow(machine, plane, looks, span),
    }
}

/// A body that cannot be computed.
pub fn unsolvable(error: &dyn std::fmt::Display) -> Failure {
    Failure {
        message: format!("the body cannot be computed: {error}"),
        help: "check its dimensions, sources, joints and steps: a unit may be wrong".into(),
    }
}

/// The longest step: that which the model gives, or one that is halved until what its own error changes with the next halving, by the order of the
/// scheme, is no more than the model's tolerance at any time and place of the programme. It is chosen once, for the machine that is followed first:
/// a fit sees the same steps at all its trial values.
///
/// # Errors
/// The body cannot be computed, or no step is short enough.
pub fn step(machine: &Machine) -> Result<f64, Failure> {
    /// The first is this part of the run, the last the first halved so often.
    const FIRST: f64 = 1.0 / 50.0;
    const HALVINGS: i32 = 12;
    let setup = &machine.setup;
    if let Some(step) = setup.time.step {
        return Ok(step);
    }
    let choose = || {
        let looks: Vec<Look> = setup.places.iter().map(|x| Look::Rise { x: *x, y: None }).collect();
        let end = setup.time.end;
        let seen = |step: f64| -> Result<Vec<f64>, Failure> {
            let followed = follow(machine, &looks, &Span { step, end, pictures: 0 })?;
            let track = &followed.track;
            Ok(setup.times.iter().flat_map(|t| track.values.iter().map(|v| track.at(v, *t))).collect())
        };
        let mut coarse = seen(FIRST * end)?;
        for halved in 1..=HALVINGS {
            let step = FIRST * end * 0.5f64.powi(halved);
            let fine = seen(step)?;
            let apart = coarse.iter().zip(&fine).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            if apart <= f64::from((1 << setup.time.order()) - 1) * setup.time.tolerance {
                return Ok(step);
            }
            coarse = fine;
        }
        Err(Failure {
            message: format!("no time step leaves temperatures within {} K", setup.time.tolerance),
            help: "give a larger tolerance in [time], another scheme, or the step itself".into(),
        })
    };
    setup.chosen.get_or_init(choose).clone()
}
