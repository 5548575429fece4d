//! The instrument shows steps.

use super::super::evidence::Evidence;
use super::super::key::OBSERVABLE;
use super::super::term::{Acts, MeasurementEffect, Size, Term};
use crate::measure::step_of;

/// Readings are rounded to the instrument's step.
pub static RESOLUTION: MeasurementEffect = MeasurementEffect {
    name: "resolution",
    about: "the instrument shows steps: what is read is rounded to a multiple of its step",
    law: "variance of a row = u^2 + step^2/12; without `u` never less than step^2/12",
    source: "JCGM 100:2008 (GUM), F.2.2.1: resolution of a digital indication",
    separates: "read the same rows with a finer instrument",
    size: Size::OfObservable("step", "step of the instrument; `?` reads it off the values of the file"),
    keys: &[OBSERVABLE],
    example: "1 um",
    // Read off the values, and not chosen by the residuals.
    parameters: 0.0,
    acts: Acts::Rounds,
    ..MeasurementEffect::USUAL
};

/// The step of the instrument where the values of the file show one that is coarse beside their noise.
pub fn sought(evidence: &Evidence) -> Vec<Vec<Term>> {
    /// Standard deviation of rounding, over the noise, from which a step is coarse.
    const COARSE: f64 = 0.5;
    let (rows, noise) = (evidence.measurements, evidence.noise);
    let is_at_work = |own: Option<usize>| noise.terms.iter().any(|t| *t.effect == RESOLUTION && t.observable == own);
    let term = |(number, term): (usize, Term)| {
        let size = step_of(rows, evidence.as_read, number)?;
        let is_coarse = size / 12f64.sqrt() > COARSE * noise.usual(rows, rows.observables[number].position);
        is_coarse.then_some(Term { size, ..term })
    };
    let own = evidence.each(Term::new(&RESOLUTION)).enumerate().filter(|(_, term)| !is_at_work(term.observable));
    own.filter_map(term).map(|term| evidence.and(term)).collect()
}

#[cfg(test)]
mod tests {
    use crate::noise::tests::measured;
    use crate::noise::{Noise, NoiseSource, Term, effects};

    #[test]
    fn rounding_adds_to_what_is_stated_and_is_a_floor_of_what_is_not() {
        // A step of sqrt(12) has a standard deviation of 1.
        let rows = measured(&[1.0, 2.0]);
        let term = Term { size: 12f64.sqrt(), ..Term::new(&effects::RESOLUTION) };
        let with =
            |sigma: f64, source| Noise::independent(vec![sigma; 2], source).with(vec![term.clone()], &rows).sigma[0];
        assert!((with(0.75, NoiseSource::Column) - 1.25).abs() < 1e-12);
        assert!((with(0.75, NoiseSource::Repeats) - 1.0).abs() < 1e-12);
        assert!((with(3.0, NoiseSource::Estimated) - 3.0).abs() < 1e-12);
    }
}
