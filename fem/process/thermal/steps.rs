//! Steps in time that keep a tolerance.

use std::collections::HashSet;
use std::sync::{Mutex, PoisonError};

use super::follow::Look;
use crate::process::Failure;
use crate::units::TEMPERATURE_RISE;

/// A temperature that is read: where, when (s), and behind what lag (s). Compared bit by bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Reading {
    x: u64,
    y: Option<u64>,
    time: u64,
    is_late: bool,
}

impl Reading {
    /// What is seen of a rise at a time.
    pub fn new(look: Look, time: f64, lag: f64) -> Self {
        let (x, y) = match look {
            Look::Rise { x, y } => (x, y),
            Look::Elongation | Look::Bow => (f64::NAN, None),
        };
        Self { x: x.to_bits(), y: y.map(f64::to_bits), time: time.to_bits(), is_late: lag > 0.0 }
    }

    /// Where it is read.
    pub fn look(&self) -> Look {
        Look::Rise { x: f64::from_bits(self.x), y: self.y.map(f64::from_bits) }
    }

    /// When, s.
    pub fn time(&self) -> f64 {
        f64::from_bits(self.time)
    }

    /// Whether the sensor lags.
    pub fn is_late(&self) -> bool {
        self.is_late
    }
}

/// The longest step that serves everything that was read so far.
#[derive(Debug, Default)]
pub struct Steps(Mutex<Served>);

#[derive(Debug, Default)]
struct Served {
    readings: HashSet<Reading>,
    /// How often the first step was halved.
    halved: Option<Result<i32, Failure>>,
}

impl Steps {
    /// A step (s) that serves these readings: halved until what its own error changes with the next halving, by the order
    /// of the scheme, is no more than the tolerance at any of them. It is chosen once, for the machine that reads them
    /// first: a fit sees the same steps at all its trial values, and a part of its rows the steps of all. `seen` gives
    /// what is read in steps of one length.
    ///
    /// # Errors
    /// The body cannot be computed, or no step is short enough.
    pub fn chosen(
        &self,
        wanted: Vec<Reading>,
        (end, tolerance, order): (f64, f64, u32),
        seen: impl Fn(f64, &[Reading]) -> Result<Vec<f64>, Failure>,
    ) -> Result<f64, Failure> {
        /// The first is this part of the run, the last the first halved so often.
        const FIRST: f64 = 1.0 / 50.0;
        const HALVINGS: i32 = 12;
        let step = |halved: i32| FIRST * end * 0.5f64.powi(halved);
        let mut served = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let mut new: Vec<Reading> = wanted.into_iter().filter(|reading| !served.readings.contains(reading)).collect();
        if new.is_empty()
            && let Some(halved) = &served.halved
        {
            return halved.clone().map(step);
        }
        new.sort_unstable_by(|a, b| a.time().total_cmp(&b.time()));
        new.dedup();
        let choose = |known: i32| {
            let mut coarse = seen(step(known - 1), &new)?;
            for halved in known..=HALVINGS {
                let fine = seen(step(halved), &new)?;
                let serves = |((a, b), reading): ((&f64, &f64), &Reading)| {
                    // A lag is followed along straight lines, which after a switch are of first order.
                    let order = if reading.is_late { 1 } else { order };
                    (a - b).abs() <= f64::from((1 << order) - 1) * tolerance
                };
                if coarse.iter().zip(&fine).zip(&new).all(serves) {
                    return Ok(halved);
                }
                coarse = fine;
            }
            Err(Failure {
                message: format!("no time step leaves temperatures within {}", TEMPERATURE_RISE.told(tolerance)),
                help: "give a larger tolerance in [time], another scheme, or the step itself".into(),
            })
        };
        let halved = match &served.halved {
            Some(Err(failure)) => Err(failure.clone()),
            Some(Ok(known)) => choose(*known),
            None => choose(1),
        };
        served.readings.extend(new);
        served.halved = Some(halved.clone());
        halved.map(step)
    }
}
