//! Derivatives of the prediction and of the residuals by the search variables.

use std::ops::Range;

use nalgebra::{DMatrix, DVector};
use rayon::prelude::*;

use super::objective::{Objective, Solution};
use crate::process::{Failure, Rows};

/// Differences by which a Jacobian is made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Differences {
    /// From the point itself, one evaluation a variable.
    Forward,
    /// From either side, two evaluations.
    Central,
}

/// Slopes of the prediction about a point.
pub struct Slopes {
    /// SI per unit of the search variables, which no noise changes: a row for each of the data, a column for each variable.
    pub matrix: DMatrix<f64>,
    /// Sides of the variables on which the prediction jumps right beside the point, and χ² is no lower beyond, or ends.
    pub jumps: Vec<Option<Jump>>,
}

/// Side of a variable on which the prediction jumps: where a sensor passes a border, or a row the switch of a law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Jump {
    /// At lower values.
    Below,
    /// At higher values.
    Above,
}

/// Ratio of what the prediction changes on either side of a point from which one of them is looked at more closely.
const UNLIKE: f64 = 10.0;
/// Part of the change that half the way makes, where it is a kink.
const KINK: Range<f64> = 0.1..0.75;
/// Change of all rows together, in standard uncertainties, that is none.
const NO_CHANGE: f64 = 1e-6;

impl Objective<'_> {
    /// Slopes of the prediction about a point by these differences; columns of variables that are `held` are zero. Central ones
    /// leave out a side on which the prediction jumps, or that cannot be computed: a difference across a jump is no slope.
    pub fn slopes_about(&self, here: &Solution, held: &[usize], differences: Differences) -> Option<Slopes> {
        let column = |i: usize| -> Option<(Vec<f64>, Option<Jump>)> {
            if held.contains(&i) {
                return Some((vec![0.0; here.predicted.len()], None));
            }
            let (low, high) = self.around(&here.position, i);
            let middle = here.position[i];
            let slope = |near: &[f64], far: &[f64], step: f64| -> Vec<f64> {
                far.iter().zip(near).map(|(far, near)| (far - near) / step).collect()
            };
            match differences {
                Differences::Central => {
                    let (below, above) = (self.moved(here, i, low), self.moved(here, i, high));
                    let of_above = |above: &[f64]| slope(&here.predicted, above, high - middle);
                    let of_below = |below: &[f64]| slope(below, &here.predicted, middle - low);
                    match (below, above) {
                        (Some(below), Some(above)) => {
                            let jump = self.jump(here, i, [(low, &below), (high, &above)]);
                            let slope = match jump {
                                None => slope(&below, &above, high - low),
                                Some(Jump::Below) => of_above(&above),
                                Some(Jump::Above) => of_below(&below),
                            };
                            Some((slope, jump))
                        }
                        // The edge of where the model can be computed bars a side as a jump does.
                        (None, Some(above)) if high > middle => Some((of_above(&above), Some(Jump::Below))),
                        (Some(below), None) if low < middle => Some((of_below(&below), Some(Jump::Above))),
                        _ => None,
                    }
                }
                Differences::Forward => {
                    // Inwards at a bound.
                    let to = if (high - middle).abs() >= (low - middle).abs() { high } else { low };
                    Some((slope(&here.predicted, &self.moved(here, i, to)?, to - middle), None))
                }
            }
        };
        let all = 0..self.variables.len();
        // All are made, so that the count of evaluations does not depend on which thread was the first to fail.
        let columns: Vec<Option<(Vec<f64>, Option<Jump>)>> = match differences {
            Differences::Central => all.into_par_iter().map(column).collect(),
            // The rough searches that take these run side by side, and would only wait for each other.
            Differences::Forward => all.map(column).collect(),
        };
        let columns: Vec<(Vec<f64>, Option<Jump>)> = columns.into_iter().collect::<Option<_>>()?;
        let (columns, jumps): (Vec<_>, Vec<_>) = columns.into_iter().unzip();
        Some(Slopes { matrix: matrix(here.predicted.len(), columns.into_iter().map(Some))?, jumps })
    }

    /// The prediction with one variable elsewhere.
    fn moved(&self, here: &Solution, i: usize, to: f64) -> Option<Vec<f64>> {
        let mut position = here.position.clone();
        position[i] = to;
        self.predict(&position)
    }

    /// The side of a variable on which the prediction jumps, of what is predicted on either. Beyond a kink it changes half as much
    /// over half the way, or less where the kink is on the way; beyond a jump all or nothing.
    fn jump(&self, here: &Solution, i: usize, sides: [(f64, &[f64]); 2]) -> Option<Jump> {
        let change = |predicted: &[f64]| {
            let one = |((there, here), sigma): ((&f64, &f64), &f64)| ((there - here) / sigma).powi(2);
            predicted.iter().zip(&here.predicted).zip(self.noise.sigma.iter()).map(one).sum::<f64>().sqrt()
        };
        let middle = here.position[i];
        let [below, above] = sides.map(|(s, predicted)| change(predicted) / (s - middle).abs());
        let (jump, (s, there)) = match (below > UNLIKE * above, above > UNLIKE * below) {
            (true, _) => (Jump::Below, sides[0]),
            (_, true) => (Jump::Above, sides[1]),
            _ => return None,
        };
        let whole = change(there);
        if !whole.is_finite() || whole < NO_CHANGE {
            return None;
        }
        let half = change(&self.moved(here, i, 0.5 * (middle + s))?);
        let mut position = here.position.clone();
        position[i] = s;
        let is_lower = || self.residuals(&position, there).norm_squared() < here.chi2;
        (!KINK.contains(&(half / whole)) && !is_lower()).then_some(jump)
    }

    /// Jacobian of the residuals, those of the priors included, by the slopes of the prediction at a position.
    pub fn jacobian_of(&self, slopes: &DMatrix<f64>, position: &DVector<f64>) -> DMatrix<f64> {
        let mut jacobian = DMatrix::zeros(slopes.nrows() + self.priors(), slopes.ncols());
        let mut prior = slopes.nrows();
        for (i, variable) in self.variables.iter().enumerate() {
            let column = self.noise.whiten(slopes.column(i).iter().map(|slope| -slope));
            jacobian.column_mut(i).rows_mut(0, column.len()).copy_from_slice(&column);
            if let Some((_, std)) = variable.prior {
                let (low, high) = self.around(position, i);
                jacobian[(prior, i)] = (variable.value(low) - variable.value(high)) / ((high - low) * std);
                prior += 1;
            }
        }
        jacobian
    }

    /// Jacobian of the residuals by central differences, one-sided at a bound.
    pub fn jacobian(&self, here: &Solution) -> Option<DMatrix<f64>> {
        let slopes = self.slopes_about(here, &[], Differences::Central)?;
        Some(self.jacobian_of(&slopes.matrix, &here.position))
    }

    /// Sensitivities: derivatives of the prediction of any rows, SI per unit of the search variables.
    pub fn sensitivities(&self, position: &DVector<f64>, rows: &Rows) -> Option<DMatrix<f64>> {
        let column = |i: usize| {
            let (low, high) = self.around(position, i);
            let at = |s: f64| {
                let mut moved = position.clone();
                moved[i] = s;
                self.predict_rows(&moved, rows)
            };
            let (high_end, low_end) = (at(high)?, at(low)?);
            Some(high_end.iter().zip(&low_end).map(|(h, l)| (h - l) / (high - low)).collect())
        };
        self.columns(rows.len(), column)
    }

    /// A matrix with a column for each variable, made on all threads; `None` where one of them cannot be made.
    fn columns(&self, rows: usize, column: impl Fn(usize) -> Option<Vec<f64>> + Send + Sync) -> Option<DMatrix<f64>> {
        // All are made, so that the count of evaluations does not depend on which thread was the first to fail.
        let all: Vec<Option<Vec<f64>>> = (0..self.variables.len()).into_par_iter().map(column).collect();
        matrix(rows, all.into_iter())
    }

    /// Derivatives of the prediction of the measured rows by the free variables, beside the datum directions,
    /// SI.
    pub fn mean(&self, solution: &Solution) -> Option<DMatrix<f64>> {
        let own = self.slopes_about(solution, &[], Differences::Central)?.matrix;
        let blind = &self.data.datum_directions;
        let mut all = DMatrix::zeros(self.data.len(), blind.len() + own.ncols());
        for (column, direction) in blind.iter().enumerate() {
            all.column_mut(column).copy_from_slice(&direction.whole(self.data.len()));
        }
        all.columns_mut(blind.len(), own.ncols()).copy_from(&own);
        Some(all)
    }

    /// Why the model cannot be computed beside a position: the first parameter that stands alone there, and what the model
    /// says of a value beside.
    pub fn why_not_beside(&self, position: &DVector<f64>) -> Failure {
        let reason = |i: usize| {
            let (low, high) = self.around(position, i);
            let at = |s: f64| {
                let mut moved = position.clone();
                moved[i] = s;
                self.forward(&moved).and_then(|job| job.observe(&self.data.rows)).err()
            };
            let failure = at(low).and(at(high))?;
            let (parameter, value) = (&self.parameters[i], self.variables[i].value(position[i]));
            Some((parameter.path.clone(), parameter.kind.format(value), failure))
        };
        match (0..self.variables.len()).find_map(reason) {
            Some((path, value, failure)) => Failure {
                message: format!("beside the best value of {path}, {value}, the model cannot be computed: {failure}"),
                help: failure.help,
            },
            None => Failure {
                message: "the model cannot be computed beside the best values".into(),
                help: "give the parameters values from which `fem run` works".into(),
            },
        }
    }

    /// Two values of a search variable close by, for a central difference; one-sided at a bound.
    fn around(&self, position: &DVector<f64>, i: usize) -> (f64, f64) {
        let variable = &self.variables[i];
        let step = 1e-4 * variable.unit.max(1e-3 * position[i].abs());
        ((position[i] - step).max(variable.low), (position[i] + step).min(variable.high))
    }
}

/// The matrix of these columns, if all could be made.
fn matrix(rows: usize, columns: impl ExactSizeIterator<Item = Option<Vec<f64>>>) -> Option<DMatrix<f64>> {
    let mut matrix = DMatrix::zeros(rows, columns.len());
    for (mut to, from) in matrix.column_iter_mut().zip(columns) {
        to.copy_from_slice(&from?);
    }
    Some(matrix)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fit::{StoppingCriterion, minimise};
    use crate::input::Source;
    use crate::measure::Measurements;
    use crate::model::{Data, Model};

    /// Deviations 5 um beyond 160 mm, beside 3 um/m, and the place of the step as close above 160 mm as that it is passed by the
    /// differences.
    const STEP: &str = "a*step(position - p_c) + b*position";

    fn with<T>(formula: &str, ask: impl FnOnce(&mut Objective, &DVector<f64>) -> T) -> T {
        let text = format!(
            "process = \"axis\"\naxis = {{ travel = \"1 m\" }}\n\
             screw = {{ material = \"steel\", diameter = \"40 mm\", lead = \"10 mm\" }}\n\
             [effects.law]\nformula = \"{formula}\"\n\
             a = \"? near 1 um\"\np_c = \"? near 160.004 mm\"\nb = \"? near 1 um/m\"\n"
        );
        let model = Model::parse(Source::new("model.toml", text)).unwrap();
        let one = |x: i32| {
            let step = if x > 160 { 5.0 } else { 0.0 };
            format!("{x},+,{},0.1\n", step + 0.003 * f64::from(x))
        };
        let rows: String = (5..15).map(|i| one(20 * i)).collect();
        let rows = format!("position [mm],direction,deviation [um],u [um]\n{rows}");
        let rows = Measurements::parse(Source::new("rows.csv", rows), &*model.process).unwrap();
        let data = Data::of(&model, rows).unwrap();
        let mut objective = Objective::new(&data).unwrap();
        let start = objective.variables.iter().map(|own| own.position(own.starts[0]));
        let start = DVector::from_iterator(objective.variables.len(), start);
        ask(&mut objective, &start)
    }

    fn number(objective: &Objective, key: &str) -> usize {
        objective.parameters.iter().position(|p| p.path.key() == key).unwrap()
    }

    /// Beyond the row at 160 mm the prediction jumps: there is no slope. A kink has one on either side.
    #[test]
    fn a_difference_across_a_jump_is_no_slope() {
        for (formula, jump) in [(STEP, Some(Jump::Below)), ("a*max(0, position/p_c - 1.75) + b*position", None)] {
            with(formula, |objective, start| {
                let here = objective.evaluate(start.clone()).unwrap();
                let slopes = objective.slopes_about(&here, &[], Differences::Central).unwrap();
                let place = number(objective, "p_c");
                assert_eq!(slopes.jumps[place], jump, "{formula}");
                let is_flat = slopes.matrix.column(place).iter().all(|slope| *slope == 0.0);
                assert_eq!(is_flat, jump.is_some(), "{formula}");
                assert_eq!(slopes.jumps[number(objective, "b")], None, "{formula}");
            });
        }
    }

    /// Data without noise: the step may stand anywhere between two rows, and all else is exact.
    #[test]
    fn a_search_passes_along_a_jump() {
        with(STEP, |objective, start| {
            let found = minimise(objective, start, &[], StoppingCriterion::FULL).unwrap();
            let value = |key: &str| objective.values(&found.position)[number(objective, key)];
            assert!(found.is_at_rest && found.chi2 < 1e-9, "{}", found.chi2);
            assert!((value("a") - 5e-6).abs() < 1e-11 && (value("b") - 3e-6).abs() < 1e-11, "{}", value("a"));
            assert!((0.16..0.18).contains(&value("p_c")), "{}", value("p_c"));
        });
    }
}
