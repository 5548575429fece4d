//! A zero that wanders while rows are taken: it makes slow structure that some law of what was set once for many rows follows
//! as well, if enough of them are tried.

use nalgebra::{DMatrix, DVector};

use super::search::{Bench, Found};

/// Rows over which the zero forgets where it was, each that is tried.
const MEMORIES: [f64; 6] = [3.0, 10.0, 30.0, 100.0, 300.0, 1000.0];
/// Sizes of the wandering that are tried, in standard uncertainties of a row: from one to another, each larger by a factor.
const SIZES: (f64, f64, f64) = (0.5, 200.0, 1.4);
/// Numbers of which it is made: the size and the memory.
const NUMBERS: usize = 2;
/// Turns from which a variable does not follow the order of the rows.
const TURNS: usize = 4;

/// A zero that wanders about with a memory (an Ornstein-Uhlenbeck process), beside noise of each row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wandering {
    /// How far it wanders, in standard uncertainties of a row: standard deviation.
    pub size: f64,
    /// Rows over which it forgets where it was, to 1/e.
    pub memory: f64,
    /// −2 ln of the likelihood of the rows with it and its price, as that of a law.
    pub criterion: f64,
}

impl Wandering {
    /// The most likely one; rows are in the order in which they were taken, those of each observable have a zero of their own.
    pub fn of(bench: &Bench, observables: impl Iterator<Item = usize>) -> Option<Self> {
        let mut rows_of: Vec<Vec<usize>> = Vec::new();
        for (row, observable) in observables.enumerate() {
            rows_of.resize(rows_of.len().max(observable + 1), Vec::new());
            rows_of[observable].push(row);
        }
        let price = bench.price(NUMBERS, 0.0);
        let sizes =
            std::iter::successors(Some(SIZES.0), |size| Some(size * SIZES.2)).take_while(|size| *size < SIZES.1);
        let all = sizes.flat_map(|size| MEMORIES.map(|memory| (size, memory)));
        let one = |(size, memory): (f64, f64)| {
            let (misfit, log_determinant) = restricted(bench, &rows_of, size, memory)?;
            Some(Self { size, memory, criterion: bench.misfit(misfit) + log_determinant + price })
        };
        all.filter_map(one).min_by(|a, b| a.criterion.total_cmp(&b.criterion))
    }

    /// Whether it says more than a law of what does not follow the order of the rows. Of a law that does nobody can tell it.
    pub fn says_more_than(&self, law: &Found, bench: &Bench) -> bool {
        self.criterion < law.criterion && is_out_of_order(law, bench)
    }

    /// Whether it says more than all that a law can become with further terms, in the same sense.
    pub fn says_more_than_any_of(&self, law: &Found, bench: &Bench) -> bool {
        self.criterion <= bench.least_of_further(law) && is_out_of_order(law, bench)
    }
}

/// Whether a law is made of something that does not follow the order of the rows.
fn is_out_of_order(law: &Found, bench: &Bench) -> bool {
    bench.variables_of(law).into_iter().any(|v| turns(&bench.variables[v].level) >= TURNS)
}

/// χ² beside what the model's own values imitate and the logarithm of the determinants, less those without wandering
/// (restricted likelihood: Harville, Journal of the American Statistical Association 72, 1977, 320).
fn restricted(bench: &Bench, rows_of: &[Vec<usize>], size: f64, memory: f64) -> Option<(f64, f64)> {
    let gains: Vec<Vec<Gain>> = rows_of.iter().map(|rows| gains(rows.len(), size, memory)).collect();
    let freed = |mut column: DVector<f64>| {
        rows_of.iter().zip(&gains).for_each(|(rows, gains)| free(&mut column, rows, gains, memory));
        column
    };
    let residual = freed(bench.residual.clone());
    let own: f64 = gains.iter().flatten().map(|gain| 2.0 * gain.deviation.ln()).sum();
    if bench.tangent.ncols() == 0 {
        return Some((residual.norm_squared(), own));
    }
    let columns: Vec<DVector<f64>> = bench.tangent.column_iter().map(|column| freed(column.into_owned())).collect();
    let tangent = DMatrix::from_columns(&columns);
    let along = tangent.tr_mul(&residual);
    let information = tangent.tr_mul(&tangent).cholesky()?;
    let log_determinant = own + information.ln_determinant();
    Some((residual.norm_squared() - along.dot(&information.solve(&along)), log_determinant))
}

/// What a row says of the zero (Kalman, Journal of Basic Engineering 82, 1960, 35).
struct Gain {
    /// Standard deviation of what is new in it.
    deviation: f64,
    /// Part of what is new that is the zero's.
    kept: f64,
}

fn gains(rows: usize, size: f64, memory: f64) -> Vec<Gain> {
    let forgets = (-2.0 / memory).exp();
    let mut unknown = size * size;
    let next = |_| {
        let variance = unknown + 1.0;
        let kept = unknown / variance;
        unknown = forgets * unknown * (1.0 - kept) + size * size * (1.0 - forgets);
        Gain { deviation: variance.sqrt(), kept }
    };
    (0..rows).map(next).collect()
}

/// Frees the values of rows, one after another, of what the zero shares among them.
fn free(column: &mut DVector<f64>, rows: &[usize], gains: &[Gain], memory: f64) {
    let forgets = (-1.0 / memory).exp();
    let mut expected = 0.0;
    for (row, gain) in rows.iter().zip(gains) {
        let new = column[*row] - expected;
        expected = forgets * (expected + gain.kept * new);
        column[*row] = new / gain.deviation;
    }
}

/// How often a sequence turns from rising to falling, or back.
fn turns(sequence: &[usize]) -> usize {
    let mut turns = 0;
    let mut was_rising = None;
    for pair in sequence.windows(2).filter(|pair| pair[0] != pair[1]) {
        let is_rising = Some(pair[1] > pair[0]);
        turns += usize::from(was_rising.is_some() && was_rising != is_rising);
        was_rising = is_rising;
    }
    turns
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sweep_there_and_back_turns_once() {
        assert_eq!(turns(&[0, 0, 1, 2, 2, 1, 0, 0]), 1);
        assert_eq!(turns(&[3, 1, 1, 2, 0]), 2);
        assert_eq!(turns(&[1, 1]), 0);
    }

    /// Three rows in steps of a memory: V = I + s²·exp(−|i − j|/m), against the dense determinant and inverse.
    #[test]
    fn rows_are_freed_of_what_they_share() {
        let (size, memory, rows) = (2.0, 3.0, 3);
        let dense = DMatrix::from_fn(rows, rows, |i, j| {
            f64::from(i == j) + size * size * (-(i.abs_diff(j) as f64) / memory).exp()
        });
        let gains = gains(rows, size, memory);
        let log_determinant: f64 = gains.iter().map(|gain| 2.0 * gain.deviation.ln()).sum();
        assert!((log_determinant - dense.determinant().ln()).abs() < 1e-12);
        let values = DVector::from_vec(vec![1.0, -2.0, 0.5]);
        let square = values.dot(&(dense.try_inverse().unwrap() * &values));
        let mut freed = values;
        free(&mut freed, &[0, 1, 2], &gains, memory);
        assert!((freed.norm_squared() - square).abs() < 1e-12, "{} {square}", freed.norm_squared());
    }
}
