//! The table `[known.together]`: correlations of values that were fitted together. What is known of each alone stands behind its
//! `+-`; what a model predicts with them depends on both.

use nalgebra::{Cholesky, DMatrix, Dyn};

use super::{Edit, Entry};
use crate::input::{Parameter, ParameterId, Reader};
use crate::units::Knowledge;

/// Its place in a model.
const PARENT: &str = "known";
const NAME: &str = "together";
/// Correlations below this are none.
const NONE: f64 = 1e-3;
/// What is added to a variance of one, for numbers that are written to six decimals may make a matrix that is none of a
/// covariance by so much.
const ROUND_OFF: f64 = 2e-6;

/// Values with their correlations.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Together {
    /// The quantities.
    of: Vec<ParameterId>,
    /// Their correlations.
    correlation: DMatrix<f64>,
}

impl Together {
    /// Reads the table, if the model has it.
    pub fn read(model: &Reader) -> Self {
        let read = |t: &Reader| {
            let of = t.text("of", "the quantities, as `effects.tool-wear.rate`");
            let rows =
                t.text("correlation", "of each but the first with those before it: a row each, parted by semicolons");
            let of: Vec<ParameterId> =
                of.unwrap_or_default().split(',').map(|path| ParameterId::from(path.trim())).collect();
            match triangle(&rows.unwrap_or_default(), of.len()) {
                Some(correlation) => Self { of, correlation },
                None => {
                    let message = format!("`correlation` is none of {} quantities", of.len());
                    t.problem("correlation", message, "leave the table out: values are known each for itself then");
                    Self::default()
                }
            }
        };
        let about = "what was fitted together";
        model.optional_table(PARENT, about, |t| t.optional_table(NAME, about, read)).flatten().unwrap_or_default()
    }

    /// The correlations of parameters that are known roughly, in their order; what is not among those here is known for itself.
    fn correlation(&self, parameters: &[Parameter]) -> DMatrix<f64> {
        let place = |parameter: &Parameter| {
            let is_rough = matches!(parameter.quantity.knowledge, Knowledge::Rough(_));
            self.of.iter().position(|own| *own == parameter.path).filter(|_| is_rough)
        };
        let places: Vec<Option<usize>> = parameters.iter().map(place).collect();
        DMatrix::from_fn(places.len(), places.len(), |i, j| match (places[i], places[j]) {
            _ if i == j => 1.0,
            (Some(a), Some(b)) => self.correlation[(a, b)],
            _ => 0.0,
        })
    }

    /// A root of the correlations: what it makes of independent numbers is correlated so.
    pub fn root(&self, parameters: &[Parameter]) -> DMatrix<f64> {
        let all = self.correlation(parameters);
        cholesky(all).map_or_else(|| DMatrix::identity(parameters.len(), parameters.len()), |own| own.l())
    }

    /// Edits that put correlations of these quantities into a model, in the place of those that it has; none where nothing is
    /// correlated.
    pub fn edits(&self, of: &[ParameterId], correlation: &DMatrix<f64>) -> Vec<Edit> {
        let had = (!self.of.is_empty()).then(|| Edit::Remove { parent: PARENT, name: NAME.into() });
        let is_any = (0..of.len()).any(|i| (0..i).any(|j| correlation[(i, j)].abs() > NONE));
        let own = is_any.then(|| {
            let row = |i: usize| (0..i).map(|j| decimals(correlation[(i, j)])).collect::<Vec<_>>().join(" ");
            let rows: Vec<String> = (1..of.len()).map(row).collect();
            let names: Vec<&str> = of.iter().map(|path| &**path).collect();
            let text = |key: &str, text: String| (key.to_string(), Entry::Text(text));
            let keys = vec![text("of", names.join(", ")), text("correlation", rows.join("; "))];
            Edit::Add { parent: PARENT, name: NAME.into(), keys }
        });
        had.into_iter().chain(own).collect()
    }
}

/// A correlation with six decimals at most.
fn decimals(value: f64) -> String {
    let rounded = (value * 1e6).round() / 1e6;
    format!("{}", rounded + 0.0)
}

/// The matrix of a triangle of numbers below its diagonal; `None` where it is none of correlations.
fn triangle(rows: &str, count: usize) -> Option<DMatrix<f64>> {
    let number = |text: &str| text.parse::<f64>().ok().filter(|value| value.abs() <= 1.0);
    let rows: Vec<Vec<f64>> =
        rows.split(';').map(|row| row.split_whitespace().map(number).collect()).collect::<Option<_>>()?;
    let is_triangle = rows.len() + 1 == count && rows.iter().enumerate().all(|(i, row)| row.len() == i + 1);
    let own = is_triangle.then(|| {
        DMatrix::from_fn(count, count, |i, j| match i.cmp(&j) {
            std::cmp::Ordering::Equal => 1.0,
            std::cmp::Ordering::Greater => rows[i - 1][j],
            std::cmp::Ordering::Less => rows[j - 1][i],
        })
    })?;
    cholesky(own.clone()).map(|_| own)
}

fn cholesky(mut matrix: DMatrix<f64>) -> Option<Cholesky<f64, Dyn>> {
    (0..matrix.nrows()).for_each(|i| matrix[(i, i)] += ROUND_OFF);
    matrix.cholesky()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_triangle_is_read_to_both_sides() {
        let own = triangle("0.5; -0.25 0.1", 3).unwrap();
        assert_eq!(own, DMatrix::from_row_slice(3, 3, &[1.0, 0.5, -0.25, 0.5, 1.0, 0.1, -0.25, 0.1, 1.0]));
        for wrong in ["", "0.5", "0.5; 0.1", "0.9; 0.9 -0.9", "2; 0 0", "0.5; a 0"] {
            assert_eq!(triangle(wrong, 3), None, "{wrong}");
        }
    }
}
