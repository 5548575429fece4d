//! What the makers of cases need to know of a job, whatever its process.

use crate::asked::Asked;
use crate::law::{Cause, Law, draw};
use crate::random::Random;

/// Where the standard uncertainty of a row is to be learnt from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoiseKind {
    /// Column `u`.
    Column,
    /// Two rows per point.
    Repeats,
    /// Nowhere.
    Neither,
}

/// A parameter written with `+-`: what the user believes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shown {
    /// Effect whose table is in the model.
    pub effect: &'static str,
    /// One of its parameters; those of one effect stand together.
    pub parameter: &'static str,
    /// Value as written.
    pub written: f64,
    /// Standard uncertainty as written.
    pub std: f64,
}

/// Something that is made and measured: all numbers of one observable in one unit, rows in the order of the
/// file.
pub trait Job {
    /// The word after `process =`.
    fn process(&self) -> &'static str;

    /// Its effects.
    fn laws(&self) -> &'static [Law];

    /// What the model shows with `+-`.
    fn shown(&self) -> &[Shown];

    /// Takes out of the model what it shows with `+-`: what is then left is an ideal machine.
    fn forget(&mut self);

    /// The shown parameters at these values, as causes.
    fn causes(&self, values: &[f64]) -> Vec<Cause> {
        let cause = |(s, v): (&Shown, &f64)| Cause { effect: s.effect, parameters: vec![(s.parameter, *v)] };
        self.shown().iter().zip(values).map(cause).collect()
    }

    /// Where the noise is to be learnt from.
    fn noise(&self) -> NoiseKind;

    /// Noise of each row at a noise of one; other than one where there are several observables.
    fn scales(&self) -> Vec<f64> {
        vec![1.0; self.rows()]
    }

    /// Size in SI of one of each row's unit.
    fn si(&self) -> Vec<f64> {
        vec![1e-6; self.rows()]
    }

    /// Group of each row: the part or the set-up with which it was measured.
    fn groups(&self) -> Vec<usize> {
        vec![0; self.rows()]
    }

    /// Number of measured rows.
    fn rows(&self) -> usize;

    /// Directions in the space of rows that the way of measuring does not show.
    fn blind(&self) -> Vec<Vec<f64>> {
        Vec::new()
    }

    /// Noise that a workshop has.
    fn noise_range(&self) -> (f64, f64);

    /// Whether an effect can act beside these causes.
    fn admits(&self, effect: &str, causes: &[Cause]) -> bool;

    /// Length of which places are shares, mm.
    fn length(&self) -> f64;

    /// An effect with plausible true values.
    fn draw(&self, effect: &'static str, random: &mut Random) -> Cause {
        draw(self.laws(), effect, self.length(), random)
    }

    /// How far a draw may be scaled down before it is a different kind of thing.
    fn least_factor(&self, _effect: &str) -> f64 {
        0.04
    }

    /// How many draws of an effect stand for all its shapes.
    fn draws(&self, effect: &str) -> usize;

    /// The observables at every row from all causes.
    fn predict(&self, causes: &[Cause]) -> Vec<f64>;

    /// The difference that `causes[index]` makes with all others present.
    fn signature(&self, causes: &[Cause], index: usize) -> Vec<f64> {
        let mut without = causes.to_vec();
        without.remove(index);
        difference(&self.predict(causes), &self.predict(&without), 1.0)
    }

    /// Derivative of the prediction with respect to one parameter of one cause, by a central difference.
    fn tangent(&self, causes: &[Cause], index: usize, parameter: usize) -> Vec<f64> {
        let at = causes[index].parameters[parameter].1;
        let step = if at == 0.0 { 1e-3 } else { 1e-3 * at.abs() };
        let moved = |by: f64| {
            let mut moved = causes.to_vec();
            moved[index].parameters[parameter].1 = at + by;
            self.moved(&moved, index)
        };
        difference(&moved(step), &moved(-step), 2.0 * step)
    }

    /// The prediction, or of it what changes with `causes[index]`.
    fn moved(&self, causes: &[Cause], _index: usize) -> Vec<f64> {
        self.predict(causes)
    }

    /// Structure of size about one at every row that no effect can make, with its name.
    fn shape(&self, random: &mut Random) -> (&'static str, Vec<f64>);

    /// The same machine with these rows measured in the place of its own; None where they cannot be made here.
    fn asked(&self, _rows: &[Asked]) -> Option<Box<dyn Job>> {
        None
    }

    /// The tables of the model file but `[effects]`.
    fn tables(&self) -> String;

    /// The measurement file. `sigma` is written only where the design has uncertainties.
    fn data(&self, observed: &[f64], sigma: f64) -> String;
}

/// What a job of this process answers with its fields `shown`, `noise` and `rows`, and the `LAWS` beside it.
macro_rules! of_fields {
    ($process:literal) => {
        fn process(&self) -> &'static str {
            $process
        }

        fn laws(&self) -> &'static [Law] {
            LAWS
        }

        fn shown(&self) -> &[Shown] {
            &self.shown
        }

        fn forget(&mut self) {
            self.shown.clear();
        }

        fn noise(&self) -> NoiseKind {
            self.noise
        }

        fn rows(&self) -> usize {
            self.rows.len()
        }
    };
}
pub(crate) use of_fields;

/// (a − b)/over.
pub fn difference(a: &[f64], b: &[f64], over: f64) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| (a - b) / over).collect()
}
