//! A wave along a coordinate whose maker nobody knows.

use std::f64::consts::{FRAC_1_SQRT_2, TAU};

use super::super::evidence::Evidence;
use super::super::key::{ALONG, OBSERVABLE, PERIOD};
use super::super::term::{Acts, Column, MeasurementEffect, Shape, Size, Term};
use crate::measure::Measurements;

/// A wave of any phase along a coordinate. It describes, as a curve does: what made it, it does not say.
pub static WAVE: MeasurementEffect = MeasurementEffect {
    name: "wave",
    about: "the error goes up and down along a coordinate by a wave that no law here has",
    law: "y = prediction + a*cos(2*pi*x/period) + b*sin(2*pi*x/period); size^2 = a^2 + b^2",
    source: "a sinusoid of unknown period: Bretthorst, Bayesian Spectrum Analysis and Parameter Estimation, 1988, ch. 2",
    separates: "look for what turns or repeats once in a period: a screw, a gear, a roller, a heater that switches",
    size: Size::OfObservable("size", "amplitude of the wave"),
    keys: &[ALONG, PERIOD, OBSERVABLE],
    example: "0.7 um",
    // A period among all counts as two parameters, as a place does.
    parameters: 3.0,
    shape: Some(Shape::Wave),
    acts: Acts::Shared(columns),
    ..MeasurementEffect::USUAL
};

/// One for each observable along every place, of the period that gains most, and along time in what neither approaches nor
/// places say. Several waves make any curve, and none of them is there.
pub fn sought(evidence: &Evidence) -> Vec<Vec<Term>> {
    let present = &evidence.noise.terms;
    let is_at_work = |own: Option<usize>| present.iter().any(|t| *t.effect == WAVE && t.observable == own);
    let free = evidence.each(Term::new(&WAVE)).filter(|term| !is_at_work(term.observable));
    let along = free.flat_map(|term| evidence.places().map(move |along| Term { along: Some(along), ..term.clone() }));
    let scan = |term: Term| match term.along.is_some_and(|along| evidence.is_time(along.coordinate)) {
        true => evidence.scan().beside(&evidence.returning()).wave(&term),
        false => evidence.scan().wave(&term),
    };
    along.filter_map(scan).map(|term| evidence.and(term)).collect()
}

/// Cosine and sine, which share the square of the amplitude.
fn columns(term: &Term, measurements: &Measurements) -> Vec<Column> {
    let (Some(along), Some(period)) = (term.along, term.period) else { return Vec::new() };
    let x = &measurements.rows.columns[along.coordinate];
    let own: Vec<usize> = (0..x.len()).filter(|row| term.is_of(measurements, *row) && x[*row].is_finite()).collect();
    let shape = |of: fn(f64) -> f64| own.iter().map(|row| (*row, FRAC_1_SQRT_2 * of(TAU * x[*row] / period))).collect();
    vec![shape(f64::cos), shape(f64::sin)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::noise::effects;
    use crate::noise::term::Along;
    use crate::noise::tests::{measured, whitened_square};

    #[test]
    fn a_wave_of_its_period_is_taken_up_and_another_is_not() {
        // Eight places over one period, sd 2 of the amplitude: V = 1 + 2·(cc' + ss'), |c|² = |s|² = 4: a cosine of
        // height 3 has z² = 9·4/(1 + 2·4), det V = 9², and two periods are left whole.
        let x: Vec<f64> = (0..8).map(f64::from).collect();
        let along = Some(Along { coordinate: 0, is_angle: false });
        let term = Term { along, period: Some(8.0), size: 2.0, ..Term::new(&effects::WAVE) };
        let of = |periods: f64| x.iter().map(|x| 3.0 * (TAU * periods * x / 8.0).cos()).collect::<Vec<_>>();
        let (square, log_determinant) = whitened_square(&measured(&x), std::slice::from_ref(&term), &of(1.0));
        assert!((square - 4.0).abs() < 1e-12, "{square}");
        assert!((log_determinant - 81f64.ln()).abs() < 1e-12, "{log_determinant}");
        assert!((whitened_square(&measured(&x), &[term], &of(2.0)).0 - 36.0).abs() < 1e-12);
    }
}
