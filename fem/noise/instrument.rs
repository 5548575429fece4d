//! Readings of a prediction: the scale of an instrument may be off, and its clock late.

use super::effects;
use super::term::{Acts, Term};
use crate::process::{Active, Failure, ForwardModel, Process, Rows, RunReport};
use crate::progress::Progress;
use crate::units::TIME;

/// A forward model behind an instrument. What is measured passes through the instrument; what a run predicts
/// is the part itself.
struct Instrument {
    part: Box<dyn ForwardModel>,
    /// The zero of the scale of each observable, SI: that of a thermometer is 0 degC.
    zeros: Vec<f64>,
    /// Effects that change readings, with their values.
    terms: Vec<Term>,
    /// The coordinate that is a time, by its position.
    time: Option<usize>,
}

/// Whether a parameter, by its path, is the size of an effect of the measurement.
pub fn is_size_of(path: &str, term: &Term) -> bool {
    let own = path.strip_prefix("measurement.").and_then(|rest| rest.split_once('.'));
    own == Some((&term.table, term.effect.size.key()))
}

/// The term that an effect of the measurement makes which a search has added.
pub fn reading(reading: &Active, process: &dyn Process) -> Option<Term> {
    let effect = effects::all().find(|e| e.name == reading.description.name)?;
    let observable =
        process.observables().iter().position(|o| Some(&o.name) == reading.description.observable.as_ref());
    let range = reading.description.parameters.first()?.over;
    Some(Term { observable, range, size: *reading.values.first()?, ..Term::new(effect) })
}

/// Puts a forward model behind the instrument that some of `terms` describe, if any do.
pub fn behind(
    part: Box<dyn ForwardModel>,
    terms: &[Term],
    process: &dyn Process,
    time: Option<usize>,
) -> Box<dyn ForwardModel> {
    let terms: Vec<Term> = terms.iter().filter(|t| t.effect.acts.is_reading()).cloned().collect();
    if terms.is_empty() {
        return part;
    }
    let zeros = process.observables().iter().map(|o| o.kind.to_si(0.0)).collect();
    Box::new(Instrument { part, zeros, terms, time })
}

/// The coordinate that is a time, by its position in the process's list.
pub fn time_of(process: &dyn Process) -> Option<usize> {
    process.coordinates().iter().position(|c| c.holds.kind() == Some(TIME))
}

/// The rows at the times at which they were really taken.
pub fn at_true_times(rows: &Rows, terms: &[Term], time: Option<usize>) -> Rows {
    let mut rows = rows.clone();
    let Some(times) = time.and_then(|time| rows.columns.get_mut(time)) else { return rows };
    for clock in terms.iter().filter(|t| t.size.is_finite()) {
        let Acts::Times(true_time) = clock.effect.acts else { continue };
        let is_own = |row: &usize| clock.observable.is_none_or(|own| own == rows.observable[*row]);
        for row in (0..times.len()).filter(is_own) {
            if times[row].is_finite() {
                times.set(row, true_time(clock.size, times[row]));
            }
        }
    }
    rows
}

/// Says that rows are beyond the range of a characteristic, where they are.
fn beyond(term: &Term, rows: &Rows, values: &[f64]) -> Option<String> {
    let [low, high] = term.range?;
    let wide = FURTHER * (high - low);
    let is_own = |row: &usize| term.observable.is_none_or(|own| own == rows.observable[*row]);
    let is_beyond = |row: &usize| !(low - wide..=high + wide).contains(&values[*row]);
    let count = (0..rows.len()).filter(is_own).filter(is_beyond).count();
    (count > 0).then(|| {
        format!(
            "{count} of {} rows are beyond `low` and `high` of `{}`: its curve is known between them, and goes on as a polynomial",
            rows.len(),
            term.name()
        )
    })
}

/// Part of its range by which a reading may be beyond it.
const FURTHER: f64 = 0.05;

impl ForwardModel for Instrument {
    fn predict(&self, progress: &Progress) -> Result<Vec<f64>, Failure> {
        self.part.predict(progress)
    }

    fn observe(&self, rows: &Rows) -> Result<Vec<f64>, Failure> {
        let mut values = self.part.observe(&at_true_times(rows, &self.terms, self.time))?;
        let there_is = values.clone();
        for term in &self.terms {
            let Acts::Shows(added) = term.effect.acts else { continue };
            for (row, observable) in rows.observable.iter().enumerate() {
                if term.observable.is_none_or(|own| own == *observable) {
                    let value = there_is[row];
                    let place = term.range.map_or(0.0, |[low, high]| (2.0 * value - low - high) / (high - low));
                    values[row] += added(term.size, value - self.zeros[*observable], place);
                }
            }
        }
        Ok(values)
    }

    fn doubts(&self, rows: &Rows) -> Result<Vec<String>, Failure> {
        let rows = at_true_times(rows, &self.terms, self.time);
        let mut doubts = self.part.doubts(&rows)?;
        let mut ranges: Vec<&Term> = self.terms.iter().filter(|term| term.range.is_some()).collect();
        ranges.dedup_by(|a, b| a.table == b.table);
        if !ranges.is_empty() {
            let values = self.part.observe(&rows)?;
            doubts.extend(ranges.into_iter().filter_map(|term| beyond(term, &rows, &values)));
        }
        Ok(doubts)
    }

    fn report(&self, prediction: Vec<f64>) -> Result<RunReport, Failure> {
        self.part.report(prediction)
    }
}
