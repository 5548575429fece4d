//! Steps in time that keep a tolerance.

use std::collections::HashSet;
use std::sync::{PoisonError, RwLock};

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
    /// A look at a time; `None` of a shape, which follows the temperatures, and of which no tolerance is said.
    pub fn of(look: Look, time: f64, lag: f64) -> Option<Self> {
        let Look::Rise { x, y } = look else { return None };
        Some(Self { x: x.to_bits(), y: y.map(f64::to_bits), time: time.to_bits(), is_late: lag > 0.0 })
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
pub struct Steps(RwLock<Served>);

#[derive(Debug, Default)]
struct Served {
    readings: HashSet<Reading>,
    /// How often the first step was halved.
    halved: Option<Result<i32, Failure>>,
}

impl Served {
    /// Number of halvings that was chosen, if it serves all of these readings.
    fn choice(&self, wanted: &[Reading]) -> Option<Result<i32, Failure>> {
        let halved = self.halved.as_ref()?;
        wanted.iter().all(|reading| self.readings.contains(reading)).then(|| halved.clone())
    }
}

impl Steps {
    /// A step (s) that serves these readings: halved until what its own error changes with the next halving, by the order
    /// of the scheme, is no more than the tolerance at any of them. It is chosen once, for the machine that reads them
    /// first, with what the programme reads: a fit sees the same steps at all its trial values, and a part of its rows the
    /// steps of all. `seen` gives what is read in steps of one length.
    ///
    /// # Errors
    /// The body cannot be computed, or no step is short enough.
    pub fn chosen(
        &self,
        wanted: &[Reading],
        programme: impl FnOnce() -> Vec<Reading>,
        (end, tolerance, order): (f64, f64, u32),
        seen: impl Fn(f64, &[Reading]) -> Result<Vec<f64>, Failure>,
    ) -> Result<f64, Failure> {
        /// The first is this part of the run, the last the first halved so often.
        const FIRST: f64 = 1.0 / 50.0;
        const HALVINGS: i32 = 12;
        let step = |halved: i32| FIRST * end * 0.5f64.powi(halved);
        // Every trial asks, and hardly one chooses.
        if let Some(halved) = self.0.read().unwrap_or_else(PoisonError::into_inner).choice(wanted) {
            return halved.map(step);
        }
        let mut served = self.0.write().unwrap_or_else(PoisonError::into_inner);
        if let Some(halved) = served.choice(wanted) {
            return halved.map(step);
        }
        let mut new = if served.halved.is_none() { programme() } else { Vec::new() };
        new.extend(wanted.iter().filter(|reading| !served.readings.contains(reading)));
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
                message: format!("no time step leaves temperatures within {}", TEMPERATURE_RISE.format(tolerance)),
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
