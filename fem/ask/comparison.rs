//! Several models against the same measurements.

use std::sync::Arc;

use super::Error;
use crate::compare::{Comparison, compare};
use crate::input::Problem;
use crate::measure::Measurements;
use crate::model::{Data, Model};
use crate::progress::Progress;

/// Compares every model as it is written with the same measurements, which come back; `each` sees every comparison with
/// its data.
///
/// # Errors
/// Models of several processes, unknown values, measurements that do not fit, a model that cannot be computed.
pub fn compare_all<T>(
    models: &[Model],
    mut measurements: Measurements,
    progress: &Arc<Progress>,
    mut each: impl FnMut(&Data, Comparison) -> T,
) -> Result<(Vec<T>, Measurements), Error> {
    refuse_mixed(models)?;
    for model in models {
        model.require_values()?;
    }
    let mut seen = Vec::new();
    for model in models {
        let data = Data::of(model, measurements).map_err(|error| Error::of_data(error, model))?;
        let data = data.watched(progress.clone());
        seen.push(each(&data, compare(&data)?));
        measurements = data.into_measurements();
    }
    Ok((seen, measurements))
}

/// Models of several processes have no measurements in common.
///
/// # Errors
/// They are of several.
pub fn refuse_mixed(models: &[Model]) -> Result<(), Error> {
    let Some(first) = models.first() else { return Ok(()) };
    let Some(other) = models.iter().find(|m| m.process.name() != first.process.name()) else { return Ok(()) };
    let message = format!(
        "{} models {}, {} models {}",
        first.source.name,
        first.process.name(),
        other.source.name,
        other.process.name()
    );
    Err(Problem::new(message).help("compare models of one process").into())
}
