//! The table `[known.together]`: what is known of values that were fitted together, as those of this very model. What stands behind
//! the `+-` of a value may be wider: it holds for other models too that explain the same measurements.

use nalgebra::{Cholesky, DMatrix, Dyn};

use super::other_set::{INSTEAD, OtherSet};
use super::{Edit, Entry, Model, Spread};
use crate::input::{Parameter, ParameterId, Reader};
use crate::units::{Kind, Knowledge};

/// Its place in a model.
const PARENT: &str = "known";
const NAME: &str = "together";
const PATH: &str = "known.together";
/// Key of what stays unexplained.
const UNEXPLAINED: &str = "unexplained";
/// Correlations below this are none.
const NONE: f64 = 1e-3;
/// What is added to a variance of one, for numbers that are written to nine decimals may make a matrix that is none of a
/// covariance by so much.
const ROUND_OFF: f64 = 2e-8;

/// Values with their correlations.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Together {
    /// The quantities.
    of: Vec<ParameterId>,
    /// Their correlations.
    correlation: DMatrix<f64>,
    /// Their standard uncertainties as written, in the usual units of their kinds; empty where none are.
    std: Vec<String>,
    /// In which terms each is spread; empty where all are as is usual.
    spreads: Vec<Spread>,
    /// What stays unexplained of the measurements that they were fitted to, SI.
    unexplained: f64,
    /// Other sets of effects that explain them as well.
    instead: Vec<OtherSet>,
}

impl Together {
    /// Reads the table, if the model has it.
    pub fn read(model: &Reader, kind: Kind) -> Self {
        let read = |t: &Reader| {
            let left = "what stays unexplained of the measurements, as a standard deviation";
            let left = t.quantity(UNEXPLAINED, kind, left).chosen().not_negative().optional();
            let unexplained = left.unwrap_or(0.0);
            let instead = OtherSet::all(t);
            let of = t.text("of", "the quantities, as `effects.tool-wear.rate`");
            let rows =
                t.text("correlation", "of each but the first with those before it: a row each, parted by semicolons");
            if of.is_none() && rows.is_none() {
                return Self { unexplained, instead, ..Self::default() };
            }
            let of: Vec<ParameterId> =
                of.unwrap_or_default().split(',').map(|path| ParameterId::from(path.trim())).collect();
            let std = t.text("std", "standard uncertainty of each beside the others, those of `+-` if left out");
            let std: Vec<String> =
                std.map(|all| all.split(',').map(|own| own.trim().to_string()).collect()).unwrap_or_default();
            if !(std.is_empty() || std.len() == of.len() && std.iter().all(|own| number(own).is_some())) {
                let message = format!("`std` is none of {} quantities", of.len());
                t.problem("std", message, "write a number with its unit for each, parted by commas");
            }
            let words = t.text("spread", "in which terms each is normal: plain, logarithm or reciprocal");
            let words: Vec<Option<Spread>> =
                words.map(|all| all.split(',').map(|own| Spread::of(own.trim())).collect()).unwrap_or_default();
            let spreads: Vec<Spread> = words.iter().copied().flatten().collect();
            if !(words.is_empty() || spreads.len() == of.len() && words.len() == of.len()) {
                let message = format!("`spread` is none of {} quantities", of.len());
                t.problem("spread", message, "write plain, logarithm or reciprocal for each, parted by commas");
            }
            match triangle(&rows.unwrap_or_default(), of.len()) {
                Some(correlation) => Self { of, correlation, std, spreads, unexplained, instead },
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

    /// Standard uncertainties of parameters as those of this very model, SI: never wider than what stands behind their `+-`.
    pub fn deviations(&self, parameters: &[Parameter]) -> Vec<f64> {
        let own = |parameter: &Parameter| {
            let place = self.of.iter().position(|own| *own == parameter.path)?;
            Some(number(self.std.get(place)?)? * parameter.kind.canonical().factor)
        };
        let of = |parameter: &Parameter| match parameter.quantity.knowledge {
            Knowledge::Rough(wide) => own(parameter).map_or(wide, |own| own.min(wide)),
            Knowledge::Known | Knowledge::Free => 0.0,
        };
        parameters.iter().map(of).collect()
    }

    /// In which terms parameters are spread, in their order.
    pub fn spreads(&self, parameters: &[Parameter]) -> Vec<Spread> {
        let own = |parameter: &Parameter| {
            let place = self.of.iter().position(|own| *own == parameter.path)?;
            self.spreads.get(place).copied()
        };
        parameters.iter().map(|parameter| own(parameter).unwrap_or_else(|| Spread::usual(parameter))).collect()
    }

    /// A root of the correlations: what it makes of independent numbers is correlated so.
    pub fn root(&self, parameters: &[Parameter]) -> DMatrix<f64> {
        Self::root_of(self.correlation(parameters))
            .unwrap_or_else(|| DMatrix::identity(parameters.len(), parameters.len()))
    }

    /// A root of correlations; `None` where they are none.
    pub fn root_of(correlation: DMatrix<f64>) -> Option<DMatrix<f64>> {
        cholesky(correlation).map(|own| own.l())
    }

    /// What stays unexplained of the measurements, as a standard deviation, SI.
    pub fn unexplained(&self) -> f64 {
        self.unexplained
    }

    /// Other sets of effects that explain the measurements as well.
    pub fn instead(&self) -> &[OtherSet] {
        &self.instead
    }

    /// Edits that put what is known of these quantities into a model, with their standard uncertainties (SI), the terms in which they
    /// are spread, what stays unexplained (SI, told in a kind), and what may be there instead, in the place of what it has; none where nothing is
    /// correlated, all is explained and nothing else explains it.
    pub fn edits(
        &self,
        of: &[(Parameter, f64, Spread)],
        correlation: &DMatrix<f64>,
        ((unexplained, kind), instead): ((f64, Kind), &[OtherSet]),
    ) -> Vec<Edit> {
        let had = (*self != Self::default()).then(|| Edit::Remove { parent: PARENT, name: NAME.into() });
        let is_any = (0..of.len()).any(|i| (0..i).any(|j| correlation[(i, j)].abs() > NONE));
        let mut keys = if is_any { Self::correlated(of, correlation) } else { Vec::new() };
        if unexplained > 0.0 {
            let text = format!("{:.3} {}", kind.from_si(unexplained), kind.unit);
            keys.push((UNEXPLAINED.to_string(), Entry::Text(text)));
        }
        if !instead.is_empty() {
            keys.push((INSTEAD.to_string(), Entry::Tables(instead.iter().map(OtherSet::entry).collect())));
        }
        let own = (!keys.is_empty()).then(|| Edit::Add { parent: PARENT, name: NAME.into(), keys });
        had.into_iter().chain(own).collect()
    }

    /// Keys of what is correlated.
    fn correlated(of: &[(Parameter, f64, Spread)], correlation: &DMatrix<f64>) -> Vec<(String, Entry)> {
        let row = |i: usize| (0..i).map(|j| decimals(correlation[(i, j)])).collect::<Vec<_>>().join(" ");
        let rows: Vec<String> = (1..of.len()).map(row).collect();
        let names: Vec<&str> = of.iter().map(|(own, ..)| &*own.path).collect();
        let one = |(own, std, _): &(Parameter, f64, Spread)| {
            let text = format!("{:.4e} {}", std / own.kind.canonical().factor, own.kind.unit);
            text.trim_end().to_string()
        };
        let written: Vec<String> = of.iter().map(one).collect();
        let text = |key: &str, text: String| (key.to_string(), Entry::Text(text));
        let mut keys = vec![text("of", names.join(", ")), text("correlation", rows.join("; "))];
        // Of what the data leave open there is no more than stands behind its `+-`.
        if of.iter().all(|(_, std, _)| std.is_finite()) {
            keys.insert(1, text("std", written.join(", ")));
        }
        if of.iter().any(|(own, _, spread)| *spread != Spread::usual(own)) {
            let words: Vec<&str> = of.iter().map(|(.., spread)| spread.word()).collect();
            keys.push(text("spread", words.join(", ")));
        }
        keys
    }
}

impl Model {
    /// The models that explain the measurements of this one as well, each with its probability; those that make none any more are left
    /// out.
    pub fn alternatives(&self) -> Vec<(f64, Self)> {
        let own = |own: &OtherSet| {
            let edits: Vec<Edit> = std::iter::once(Edit::Erase(PATH.into())).chain(own.edits()).collect();
            self.edited(&edits).ok().map(|model| (own.probability, model))
        };
        self.together.instead().iter().filter_map(own).collect()
    }
}

/// The number of a standard uncertainty with its unit.
fn number(text: &str) -> Option<f64> {
    text.split_whitespace().next()?.parse().ok().filter(|own: &f64| own.is_finite() && *own >= 0.0)
}

/// A correlation with nine decimals at most.
fn decimals(value: f64) -> String {
    let rounded = (value * 1e9).round() / 1e9;
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
