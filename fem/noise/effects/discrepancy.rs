//! At every place there is an error that no law here has.

use super::super::evidence::Evidence;
use super::super::key::{BY, OBSERVABLE};
use super::super::term::{Acts, MeasurementEffect, Shape, Size, Term};
use super::zero_shift;

/// An unknown curve: every place along a coordinate has an error of its own, the same whenever it is
/// measured.
pub static DISCREPANCY: MeasurementEffect = MeasurementEffect {
    name: "discrepancy",
    about: "every place has an error of its own, the same whenever it is measured: a curve that no law here has",
    law: "y = prediction + e(level of `by`), e ~ N(0, size^2)",
    source: "Kennedy & O'Hagan, Bayesian calibration of computer models, J. R. Stat. Soc. B 63, 2001",
    separates: "measure at further places between: a curve of the machine goes on between them",
    size: Size::OfObservable("size", "standard deviation of the curve"),
    keys: &[BY, OBSERVABLE],
    example: "0.7 um",
    shape: Some(Shape::Curve),
    acts: Acts::Shared(zero_shift::columns),
    ..MeasurementEffect::USUAL
};

/// A curve over places, and over places in every direction.
pub fn sought(evidence: &Evidence) -> Vec<Vec<Term>> {
    let is_curve = |by: &Vec<usize>| evidence.is_curve(by);
    let both = evidence.quantities().flat_map(|i| evidence.words().map(move |j| vec![i, j]));
    let all = evidence.quantities().map(|i| vec![i]).chain(both).filter(is_curve);
    let with = |by: Vec<usize>| evidence.each(Term { by, ..Term::new(&DISCREPANCY) });
    let alone = all.flat_map(with).map(|term| vec![term]);
    // A curve that is the same in every direction, and what differs from one direction to the other: the
    // mean difference of directions is told by neither.
    let nested = evidence.quantities().flat_map(|i| evidence.words().map(move |j| [vec![i], vec![i, j]]));
    let nested = nested.filter(|by| is_curve(&by[1]));
    let nested = nested.flat_map(|[whole, own]| with(whole).zip(with(own)).map(|(a, b)| vec![a, b]));
    alone.chain(nested).map(|terms| evidence.and_all(terms)).collect()
}
