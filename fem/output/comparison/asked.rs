//! What the drawing asks, and how the measured parts stand against it.

use serde_json::{Value as Json, json};

use crate::compare::rms;
use crate::measure::Measurements;
use crate::model::Model;
use crate::output::block::Block;
use crate::output::{number, tolerance};
use crate::process::Standing;
use crate::units::Kind;

/// Measured parts against the `[tolerance]` of a model.
pub struct Asked {
    standings: Vec<Standing>,
    off: Option<(Kind, f64)>,
    /// The largest standard uncertainty of a row, SI.
    uncertainty: f64,
}

impl Asked {
    /// How measured values, without what the way of measuring leaves open and with the largest of their standard
    /// uncertainties, stand against what a model asks; `None` where that is nothing.
    pub fn of(model: &Model, measurements: &Measurements, (measured, uncertainty): (&[f64], f64)) -> Option<Self> {
        let system = &*model.system;
        // A million rows need not be looked at where nothing is asked.
        if system.requirements().is_empty() {
            return None;
        }
        let rows = system.resolved(&measurements.rows);
        let standings = Standing::all(system, &rows, measured);
        let sized = standings.iter().map(|own| &own.requirement).find(|own| own.limits.middle().is_some());
        let off = sized.filter(|_| measurements.observables.len() == 1).map(|requirement| {
            let references = system.places(&rows).map(|places| places.references);
            let reference = |row: usize| references.as_ref().map_or(0.0, |all| all[row]);
            let limits = system.limits(&rows);
            let aim = |row: usize| limits[row].and_then(|own| own.middle()).unwrap_or_else(|| reference(row));
            let errors = (0..rows.len()).map(|row| measured[row] - aim(row));
            (requirement.kind, rms(&errors.collect::<Vec<f64>>()))
        });
        (!standings.is_empty()).then_some(Self { standings, off, uncertainty })
    }

    /// Root mean square distance of the rows from the middle of their limits, SI, and the kind in which it is told.
    pub fn off(&self) -> Option<(Kind, f64)> {
        self.off
    }

    /// A line for each requirement, how far the rows are off the middle, and what their uncertainty leaves open.
    pub fn blocks(&self) -> [Block; 2] {
        let off = |(kind, si): (Kind, f64)| {
            format!("{} {} rms from the middle of the limits", number::fixed(kind.from_si(si), 3), kind.unit)
        };
        let lines = tolerance::lines(&self.standings).into_iter().chain(self.off.map(off));
        let lines = lines.chain(tolerance::open(&self.standings, self.uncertainty));
        [Block::Heading("tolerance, as measured".into()), Block::List(lines.collect())]
    }

    /// The requirements, and the distance from the middle; none where nothing is asked.
    pub fn json(asked: Option<&Self>) -> [Json; 2] {
        let standings = asked.map_or(&[][..], |asked| &asked.standings);
        let off = asked.and_then(|asked| asked.off);
        let off = off.map(|(kind, si)| json!({ "value": kind.from_si(si), "unit": kind.unit }));
        [tolerance::json(standings), json!(off)]
    }
}
