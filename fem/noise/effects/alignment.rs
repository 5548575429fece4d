//! The part lies askew in the instrument.

use super::super::evidence::Evidence;
use super::super::key::{ALONG, BY, OBSERVABLE};
use super::super::term::{Acts, Along, Column, MeasurementEffect, Size, Term};
use super::zero_shift;
use crate::measure::Measurements;

/// An offset and a slope of the part in the instrument, anew for every group; its slopes.
pub static ALIGNMENT: MeasurementEffect = MeasurementEffect { beside: &[&OFFSETS], ..SLOPES };

const SLOPES: MeasurementEffect = MeasurementEffect {
    name: "alignment",
    about: "the part lies askew in the instrument: an offset and a slope, or around a circle an eccentricity",
    law: "y = prediction + a + b*(x - middle)/(half of the range of x); around an angle a + b*cos + c*sin",
    source: "ISO 1101:2017, 3.7: datum; ISO 12181-1:2011: the least-squares circle takes the same directions out",
    separates: "take the part out, turn it end for end and measure it again: what lies askew turns with it",
    keys: &[BY, ALONG, OBSERVABLE],
    example: "0.7 um",
    size: Size::OfObservable("slope", "standard deviation of what the slopes add at the ends of the range"),
    acts: Acts::Shared(columns),
    ..MeasurementEffect::USUAL
};

/// The offsets of an alignment; they stand in the same table.
static OFFSETS: MeasurementEffect = MeasurementEffect {
    size: Size::OfObservable("offset", "standard deviation of the offsets"),
    acts: Acts::Shared(zero_shift::columns),
    beside: &[&ALIGNMENT],
    ..SLOPES
};

/// Fewest groups that are seen to lie askew each in its own way.
const LEAST_ASKEW: usize = 3;

/// Slopes along places, anew for every part, run or file: how it was put into the instrument. The slope that all of
/// them share is the machine's as well as the instrument's, and is told by neither.
pub fn sought(evidence: &Evidence) -> Vec<Vec<Term>> {
    let is_place = |a: &Along| {
        let is_label = evidence.is_label(a.coordinate);
        !is_label && !evidence.is_time(a.coordinate) && evidence.has_places(a.coordinate)
    };
    let places: Vec<Along> = evidence.places().filter(is_place).collect();
    let is_askew = |by: &Vec<usize>| by.iter().all(|i| evidence.is_label(*i)) && evidence.count(by) >= LEAST_ASKEW;
    let groups = evidence.groupings().into_iter().filter(is_askew);
    let placed = groups.flat_map(|by| places.iter().map(move |place| (by.clone(), *place)).collect::<Vec<_>>());
    placed
        .map(|(by, place)| Term { by, along: Some(place), ..Term::new(&ALIGNMENT) })
        .flat_map(|term| evidence.each_new(term))
        .collect()
}

/// One column a level, rising along the coordinate from −1 to 1 over its range in the file; around an angle a
/// cosine and a sine.
fn columns(term: &Term, measurements: &Measurements) -> Vec<Column> {
    let Some(along) = term.along else { return Vec::new() };
    let x = &measurements.rows.columns[along.coordinate];
    let is_own = |row: usize| term.is_of(measurements, row) && x[row].is_finite();
    let own = || (0..x.len()).filter(|row| is_own(*row)).map(|row| x[row]);
    let (low, high) = (own().fold(f64::INFINITY, f64::min), own().fold(f64::NEG_INFINITY, f64::max));
    if high <= low {
        return Vec::new();
    }
    let steady = |x: f64| (x - 0.5 * (low + high)) / (0.5 * (high - low));
    let shapes: &[&dyn Fn(f64) -> f64] = if along.is_angle { &[&f64::cos, &f64::sin] } else { &[&steady] };
    let weighed = |column: &Column, shape: &dyn Fn(f64) -> f64| -> Column {
        column.iter().filter(|(row, _)| is_own(*row)).map(|(row, _)| (*row, shape(x[*row]))).collect()
    };
    let levels = zero_shift::columns(term, measurements);
    levels.iter().flat_map(|level| shapes.iter().map(move |shape| weighed(level, *shape))).collect()
}

#[cfg(test)]
mod tests {
    use crate::noise::term::Along;
    use crate::noise::tests::{measured, whitened_square};
    use crate::noise::{Term, effects};

    #[test]
    fn rows_at_the_ends_go_opposite_ways() {
        // x from 10 to 30, standard deviation 2 at the ends: V = 1 + 4 (-1, 0, 1)(-1, 0, 1)', det V = 9.
        let along = Some(Along { coordinate: 0, is_angle: false });
        let term = Term { along, size: 2.0, ..Term::new(&effects::ALIGNMENT) };
        let (square, log_determinant) = whitened_square(&measured(&[10.0, 20.0, 30.0]), &[term], &[-1.0, 5.0, 1.0]);
        assert!((square - (25.0 + 2.0 / 9.0)).abs() < 1e-12, "{square}");
        assert!((log_determinant - 9f64.ln()).abs() < 1e-12);
    }

    #[test]
    fn a_free_eccentricity_is_taken_out() {
        let angles: Vec<f64> = (0..8).map(|i| f64::from(i) * std::f64::consts::FRAC_PI_4).collect();
        let along = Some(Along { coordinate: 0, is_angle: true });
        let term = |effect| Term { along, size: f64::INFINITY, ..Term::new(effect) };
        let terms = [term(&effects::ALIGNMENT), Term { along: None, ..term(&super::OFFSETS) }];
        // An offset and an eccentricity leave nothing; two lobes stay whole: the sum of cos² over eight is four.
        let off: Vec<f64> = angles.iter().map(|a| 3.0 + 5.0 * a.cos() - 2.0 * a.sin()).collect();
        assert!(whitened_square(&measured(&angles), &terms, &off).0 < 1e-20);
        let lobes: Vec<f64> = off.iter().zip(&angles).map(|(o, a)| o + (2.0 * a).cos()).collect();
        assert!((whitened_square(&measured(&angles), &terms, &lobes).0 - 4.0).abs() < 1e-12);
    }
}
