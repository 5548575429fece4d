//! The one door by which measurements reach what compares, fits, diagnoses, plans and compensates.

use std::ops::Deref;
use std::sync::{Arc, OnceLock};

use nalgebra::DMatrix;

use super::plausible::implausible;
use super::{Model, terms};
use crate::input::{InputError, Problem, Source};
use crate::measure::{Measurements, Repeats, repeats};
use crate::noise::{Acts, Evidence, Noise, Term, at_true_times, time_of};
use crate::process::{Absent, Coordinate, DatumDirection, Misplaced, Rows, Values};
use crate::progress::Progress;

/// Most misplaced rows that are reported.
const MOST_PROBLEMS: usize = 20;

/// Measurements that belong to a model: every row lies in it, and the datum directions are taken out of the
/// observed values. Reads as [`Measurements`].
#[derive(Clone)]
pub struct Data<'m> {
    /// Model against which the rows were checked.
    pub model: &'m Model,
    /// Datum directions that were taken out of the observed values: the way of measuring is blind to them.
    #[doc(hidden)]
    pub datum_directions: Vec<DatumDirection>,
    /// Effects of the measurement that the model states, with the rows on which they act; a size that is not
    /// a number is unknown.
    #[doc(hidden)]
    pub terms: Vec<Term>,
    /// Cautions about these effects in these rows.
    pub cautions: Vec<String>,
    /// Progress of computations with these rows, and the time that they may take.
    pub progress: Arc<Progress>,
    measurements: Measurements,
    /// Observed values as they were read, where datum directions were taken out of them.
    as_read: Option<Vec<f64>>,
    /// Standard uncertainties as they were read, where a known covariance takes their place.
    u_as_read: Option<Option<Values>>,
    /// Rows that repeat each other, once somebody has asked.
    repeats: OnceLock<Repeats>,
}

impl<'m> Data<'m> {
    /// Checks every row against the model and takes the datum directions out.
    ///
    /// # Errors
    /// Rows lie off the model's body or beyond its programme; each is named with its line.
    pub fn of(model: &'m Model, mut measurements: Measurements) -> Result<Self, InputError> {
        measurements.keep_recorded(model.recorded());
        let time = time_of(&*model.process);
        let rows = at_true_times(&measurements.rows, &model.measurement, time);
        let misplaced = model.system.misplaced(&rows);
        if misplaced.is_empty() {
            if let Some(problem) = implausible(model, &measurements, &rows) {
                return Err(InputError::one(Source::new(measurements.name.clone(), ""), problem));
            }
            let data = Self::within(model, measurements);
            let refused = |problems| InputError::new(model.source.clone(), problems);
            let own = terms::resolved(model, &data, data.as_read()).map_err(refused)?;
            let cautions = terms::cautions(model, &own, &data);
            return Ok(Self { cautions, ..data }.with_terms(own));
        }
        let problem = |m: &Misplaced| {
            Problem::new(format!("{}: {}", measurements.place(m.row), m.message))
                .help("mend the row, or let the model cover it")
        };
        let source = Source::new(measurements.name.clone(), "");
        let problems: Vec<Problem> = misplaced.iter().take(MOST_PROBLEMS).map(problem).collect();
        Err(InputError { found: misplaced.len(), ..InputError::new(source, problems) })
    }

    /// The same rows, watched by `progress`, which may limit the time of what is computed with them.
    #[must_use]
    pub fn watched(self, progress: Arc<Progress>) -> Self {
        Self { progress, ..self }
    }

    /// The same rows beside another model, watched as these are.
    ///
    /// # Errors
    /// As those of [`Data::of`].
    pub(crate) fn beside<'o>(&self, model: &'o Model) -> Result<Data<'o>, InputError> {
        Ok(Data::of(model, self.clone().into_measurements())?.watched(self.progress.clone()))
    }

    /// Makes a design of rows that the model itself proposes, which need no check. Of its effects of the
    /// measurement those are at work that name no rows.
    pub(crate) fn proposed(model: &'m Model, name: &str, rows: Rows) -> Self {
        let data = Self::within(model, Measurements::planned(&*model.process, name, rows));
        let own = terms::of_design(model, &data);
        data.with_terms(own)
    }

    /// The data with the effects of the measurement on its rows; a known covariance is their uncertainty.
    fn with_terms(mut self, terms: Vec<Term>) -> Self {
        if let Some(given) = terms.iter().find_map(|t| t.covariance.as_ref()) {
            self.u_as_read = Some(self.measurements.uncertainty.replace(given.sigma().into()));
        }
        Self { terms, ..self }
    }

    /// Makes a design of the model's own programme, thinned to what a person would measure.
    ///
    /// # Errors
    /// The places of the programme follow from what the model does not know.
    pub fn programme(model: &'m Model) -> Result<Self, Problem> {
        /// Most rows of such a design.
        const MOST: usize = 240;
        let all = model.system.programme();
        let is_place = |c: &Coordinate| matches!(c.absent, Absent::Refused | Absent::NeededBut(_));
        let places = model.process.coordinates().iter().zip(&all.columns).filter(|(c, _)| is_place(c));
        if let Some((c, _)) = places.into_iter().find(|(_, values)| values.iter().any(|v| !v.is_finite())) {
            let problem = Problem::new(format!("where the model's own programme looks along {} is unknown", c.name));
            return Err(problem.help("give the length that is `?` a value, or name the rows: --with FILE.csv"));
        }
        let step = all.len().div_ceil(MOST).max(1);
        // A step that has no common factor with the length of a pass visits every place.
        let step = (step..).find(|s| !all.len().is_multiple_of(*s) || *s == 1).unwrap_or(step);
        let rows = all.some(&(0..all.len()).step_by(step).collect::<Vec<_>>());
        Ok(Self::proposed(model, "the model's own programme", rows))
    }

    /// Prepares rows that lie in the model.
    pub(super) fn within(model: &'m Model, mut measurements: Measurements) -> Self {
        let datum_directions = model.system.datum_directions(&measurements.rows);
        let as_read = (!datum_directions.is_empty()).then(|| measurements.observed.clone());
        datum_directions.iter().for_each(|direction| direction.take_out(&mut measurements.observed));
        let (terms, cautions) = (Vec::new(), Vec::new());
        let progress = Arc::default();
        Self {
            model,
            datum_directions,
            terms,
            cautions,
            progress,
            measurements,
            as_read,
            u_as_read: None,
            repeats: OnceLock::new(),
        }
    }

    /// Selects the rows whose numbers `keep` accepts. Their datum directions are others, and are taken out
    /// anew.
    #[must_use]
    pub fn some(&self, keep: impl Fn(usize) -> bool) -> Self {
        let mut some = self.measurements.some(&keep);
        let kept: Vec<usize> = (0..self.len()).filter(|row| keep(*row)).collect();
        if let Some(observed) = &self.as_read {
            some.observed = (0..self.len()).filter(|row| keep(*row)).map(|row| observed[row]).collect();
        }
        let mut numbers = (0..self.len()).filter(|row| keep(*row)).enumerate().map(|(new, old)| (old, new));
        let numbers: std::collections::BTreeMap<usize, usize> = numbers.by_ref().collect();
        let of = |term: &Term| {
            let rows = match term.effect.acts {
                // The first row of a step is the next one that stays.
                Acts::Shared(_) => term.rows.iter().filter_map(|r| numbers.range(r..).next().map(|n| *n.1)).collect(),
                _ => term.rows.iter().filter_map(|r| numbers.get(r).copied()).collect(),
            };
            let covariance = term.covariance.as_ref().and_then(|given| given.some(&kept)).map(Arc::new);
            Term { rows, covariance, ..term.clone() }
        };
        let terms = self.terms.iter().map(of).collect();
        let (cautions, progress) = (self.cautions.clone(), self.progress.clone());
        Self { terms, cautions, progress, ..Self::within(self.model, some) }
    }

    /// Residuals of a model of these data, with the noise by which they are judged and the derivatives of what was
    /// fitted, for effects of the measurement to be sought in them.
    #[doc(hidden)]
    pub fn evidence<'a>(
        &'a self,
        noise: &'a Noise,
        repeats: &'a Repeats,
        residuals: &'a [f64],
        mean: &'a DMatrix<f64>,
    ) -> Evidence<'a> {
        let (process, measurements, as_read) = (&*self.model.process, &self.measurements, self.as_read());
        Evidence { process, measurements, as_read, noise, repeats, residuals, mean, scan: OnceLock::new() }
    }

    /// The data with one effect of the measurement more at work.
    #[must_use]
    #[doc(hidden)]
    pub fn and_term(mut self, term: Term) -> Self {
        self.terms.push(term);
        self
    }

    /// Observed values as they were read, with what lies along datum directions.
    pub fn as_read(&self) -> &[f64] {
        self.as_read.as_ref().unwrap_or(&self.observed)
    }

    /// Gives the measurements back as they were read, for another model.
    pub fn into_measurements(self) -> Measurements {
        let Self { mut measurements, as_read, u_as_read, .. } = self;
        if let Some(uncertainty) = u_as_read {
            measurements.uncertainty = uncertainty;
        }
        if let Some(observed) = as_read {
            measurements.observed = observed;
        }
        measurements
    }

    /// Rows that repeat each other, and their scatter.
    #[doc(hidden)]
    pub fn repeats(&self) -> &Repeats {
        self.repeats.get_or_init(|| repeats(&self.measurements, self.model.process.coordinates()))
    }

    /// Degrees of freedom: observations less datum directions.
    pub fn freedom(&self) -> f64 {
        (self.len() - self.datum_directions.len()) as f64
    }

    /// Whether the model was fitted to these very rows, or to those of one of the files, as its comments say.
    pub fn was_fitted_before(&self) -> bool {
        let marks = self.marks();
        let is_marked = |line: &str| marks.iter().any(|mark| line.contains(mark));
        self.model.tables.remarks(&self.model.source).any(is_marked)
    }

    /// Notes of the file, with a caution where a fit would count the rows twice.
    pub fn notes_of_fit(&self) -> Vec<String> {
        let twice = self.was_fitted_before().then(|| {
            "the model's values were fitted to these very rows: as prior knowledge they count them twice, and \
             intervals come out too narrow; fit the model from before"
                .to_string()
        });
        self.notes.iter().cloned().chain(twice).collect()
    }

    /// Marks by which the comment of a fitted model tells the rows of each file from others.
    pub fn marks(&self) -> Vec<String> {
        let mut of_files = vec![Vec::new(); self.files.len()];
        for (row, observed) in self.as_read().iter().enumerate() {
            of_files[self.file_number(row)].push(*observed);
        }
        let mark = |rows: &Vec<f64>| format!("{} rows, mark {:016x}", rows.len(), Measurements::digest(rows));
        of_files.iter().filter(|rows| !rows.is_empty()).map(mark).collect()
    }
}

impl Deref for Data<'_> {
    type Target = Measurements;

    fn deref(&self) -> &Measurements {
        &self.measurements
    }
}
