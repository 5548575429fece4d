//! The rise of temperature of heated rods at the tool, kept from one reading of a model to the next.
//!
//! A search tries many values of everything else for one rod, and the rise is by far the dearest part of a
//! prediction: each convection is solved once, and when a rod is asked for yet another the rises between are
//! taken from a few.

use std::sync::{Arc, Mutex, PoisonError};

use crate::input::Cache;
use crate::solve::heat::{AnyLoss, HeatError, Pass, RodPiece, ToolTemperature, cooled, moving_source};

/// Error of the temperature, relative to its largest value: about a nanometre where the work is 10 um too
/// thin.
const TOLERANCE: f64 = 1e-4;
/// A run needs one convection, and a table beside it perhaps a second; who asks for a third is searching.
const SEARCHED: usize = 2;
/// Convections that are kept of a rod, at most.
const MOST_SOLVED: usize = 32;

/// Temperature rises of the rods that a model has heated last.
pub type HeatedRods = Cache<Rod, Mutex<Rises>, 8>;

/// A rod under the tool; its pieces carry the loss of a convection of one.
#[derive(Clone, Debug, PartialEq)]
pub struct Rod {
    /// From the headstock.
    pub pieces: Vec<RodPiece>,
    /// Way of the tool.
    pub pass: Pass,
}

/// Rises of a rod at the tool per watt, K/W.
#[derive(Debug, Default)]
pub struct Rises {
    /// By convection, the newest last.
    solved: Vec<(f64, Arc<ToolTemperature>)>,
    any: Option<Arc<AnyLoss>>,
}

impl Rises {
    fn at(&self, convection: f64) -> Option<Arc<ToolTemperature>> {
        if let Some(any) = self.any.as_ref().filter(|any| convection <= any.largest()) {
            return Some(Arc::new(any.at(convection)));
        }
        self.solved.iter().find(|(known, _)| *known == convection).map(|(_, rise)| rise.clone())
    }
}

/// The rise of a rod at the tool per watt, K/W, with a convection in W/(m² K).
///
/// # Errors
/// The heat equation cannot be solved.
pub fn rise_per_watt(rods: &HeatedRods, rod: Rod, convection: f64) -> Result<Arc<ToolTemperature>, HeatError> {
    let Rod { pieces, pass } = &rod;
    let rises = rods.get_or(rod.clone(), |_| Ok::<_, HeatError>(Mutex::default()))?;
    // A panic while they were held leaves them whole: entries are added and removed in one step each.
    let known = || rises.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(rise) = known().at(convection) {
        return Ok(rise);
    }
    let solved = known().solved.len();
    // Solved without the list, which others need meanwhile; two that solve the same do no harm.
    let rise = Arc::new(moving_source(&cooled(pieces, convection), pass, TOLERANCE)?);
    let any = (solved == SEARCHED).then(|| AnyLoss::solve(pieces, pass, TOLERANCE)).and_then(Result::ok);
    let mut rises = known();
    rises.any = rises.any.take().or(any.map(Arc::new));
    if rises.solved.len() == MOST_SOLVED {
        // Not below the number at which the others were solved: that is done once.
        rises.solved.remove(SEARCHED + 1);
    }
    rises.solved.push((convection, rise.clone()));
    Ok(rises.at(convection).unwrap_or(rise))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rises_between_come_from_few() {
        let piece = RodPiece { length: 0.5, heat_capacity: 4600.0, conductance: 0.063, loss: 0.126 };
        let rod = Rod { pieces: vec![piece], pass: Pass { from: 0.5, to: 0.0, speed: 2e-3 } };
        let rods = HeatedRods::default();
        let direct = |h| rise_per_watt(&HeatedRods::default(), rod.clone(), h).unwrap().rise_at(0.1);
        for convection in [10.0, 20.0, 30.0, 25.0, 7.0] {
            let rise = rise_per_watt(&rods, rod.clone(), convection).unwrap().rise_at(0.1);
            assert!((rise / direct(convection) - 1.0).abs() < 5e-4, "{convection}");
        }
        let known = rods.get_or(rod.clone(), |_| Err(())).unwrap();
        assert_eq!(known.lock().unwrap().solved.len(), 3);
    }
}
