//! Formula effects, which users write: a formula over the process's coordinates, columns that files record beside them,
//! what the model predicts, its quantities and the effect's own parameters, added to what is observed.

use super::{Holds, Rows};
use crate::formula::{Column, Formula, ROWS};
use crate::units::Dimension;

/// The law of a formula effect.
#[derive(Clone, Debug, PartialEq)]
pub struct FormulaLaw {
    formula: Formula,
    /// Meaning of each name in the formula.
    meanings: Vec<Meaning>,
    /// For each observable of the process, whether the formula adds to it.
    adds_to: Vec<bool>,
}

/// Meaning of a name in a formula.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Meaning {
    /// A coordinate, by its position in the process's list.
    Coordinate(usize),
    /// A column that files record, by its position; and its value where rows have none, SI.
    Recorded(usize, f64),
    /// A parameter, by its position in the effect's.
    Parameter(usize),
    /// What the model predicts of the row without any formula.
    Prediction,
    /// A quantity of the model, SI.
    Quantity(f64),
}

impl FormulaLaw {
    /// A formula whose names have these meanings and whose result adds to these observables.
    pub fn new(formula: Formula, meanings: Vec<Meaning>, adds_to: Vec<bool>) -> Self {
        Self { formula, meanings, adds_to }
    }

    /// Columns that files record and that it names, by their positions, with the values (SI) where rows have none.
    pub fn recorded(&self) -> impl Iterator<Item = (usize, f64)> {
        self.meanings.iter().filter_map(|meaning| match meaning {
            Meaning::Recorded(column, usual) => Some((*column, *usual)),
            _ => None,
        })
    }

    /// Whether values of a parameter (SI) that differ by `period` are the same, as phases are: tried at a few places.
    pub fn repeats_after(&self, parameter: usize, period: f64) -> bool {
        let own = self.meanings.iter().position(|m| *m == Meaning::Parameter(parameter));
        let at = |place: usize, shift: f64| {
            // Places that no law knows, unequal for every name.
            let value = |i: usize| 0.31 + ((place + 1) as f64 * (i + 2) as f64 * 0.754_877).fract();
            let mut names: Vec<f64> = (0..self.meanings.len()).map(value).collect();
            own.iter().for_each(|i| names[*i] += shift);
            self.formula.value(&names)
        };
        (0..5).all(|place| {
            let (here, there) = (at(place, 0.0), at(place, period));
            (here - there).abs() <= 1e-9 * here.abs().max(there.abs()) && here.is_finite()
        })
    }

    /// Adds it to the values of rows, SI; `rows` with every coordinate resolved, and `predicted` what they were before any
    /// formula.
    pub(super) fn add_to(&self, values: &mut [f64], (rows, predicted): (&Rows, &[f64]), parameters: &[f64]) {
        let mut names = Vec::with_capacity(self.meanings.len());
        for first in (0..values.len()).step_by(ROWS) {
            let own = first..values.len().min(first + ROWS);
            if !own.clone().any(|row| self.adds_to[rows.observable[row]]) {
                continue;
            }
            // The last of them stands for those that are missing in the end.
            let of_rows =
                |of: &dyn Fn(usize) -> f64| Column::new(std::array::from_fn(|i| of((first + i).min(own.end - 1))));
            names.clear();
            names.extend(self.meanings.iter().map(|meaning| match *meaning {
                Meaning::Coordinate(column) => of_rows(&|row| rows.columns[column][row]),
                Meaning::Recorded(column, usual) => of_rows(&|row| rows.get(column, row).unwrap_or(usual)),
                Meaning::Prediction => of_rows(&|row| predicted[row]),
                Meaning::Parameter(i) => Column::Same(parameters[i]),
                Meaning::Quantity(value) => Column::Same(value),
            }));
            let added = self.formula.values(&names);
            for row in own {
                if self.adds_to[rows.observable[row]] {
                    values[row] += added.at(row - first);
                }
            }
        }
    }
}

/// The dimension of a coordinate's values in a formula; numbers and words are pure.
pub fn dimension(holds: &Holds) -> Dimension {
    match holds {
        Holds::Quantity(kind) => kind.canonical().dimension,
        Holds::Number(_) | Holds::Word(_) => Dimension::NONE,
    }
}
