//! Whether what a noise swallows comes again: a curve along a coordinate that every branch, run or part goes through anew.
//!
//! The curve is a stationary Gaussian process with the covariance τ²·exp(−|x − x'|/ℓ) (Ornstein–Uhlenbeck). A Kalman filter
//! along x gives its marginal likelihood exactly, in linear time (Hartikainen and Särkkä, Kalman filtering and smoothing
//! solutions to temporal Gaussian process regression models, 2010).

use super::evidence::{Evidence, PROMISING};
use super::term::{Acts, Term};

/// Rows of the file that are neighbours, at most so far apart.
const NEIGHBOURS: usize = 2;
/// Fewest places along which a curve is a curve.
const LEAST_PLACES: usize = 4;
/// Lengths of the curve that are tried, from the range of its places down by halves, and its sizes in standard
/// uncertainties, up by factors of √2.
const LENGTHS: i32 = 8;
const SIZES: i32 = 28;
const LEAST_SIZE: f64 = 0.25;

/// Whether a correlation or a larger uncertainty that was found stands for a curve that comes again: which is no noise,
/// whatever the stated uncertainty.
pub fn recurs(evidence: &Evidence, stated: &[Term]) -> bool {
    let is_greedy = |term: &&Term| matches!(term.effect.acts, Acts::Neighbours | Acts::Scales);
    let noise = evidence.noise;
    let greedy: Vec<Term> = noise.terms.iter().filter(is_greedy).cloned().collect();
    if greedy.iter().all(|term| term.is_among(stated)) || evidence.has(|acts| matches!(acts, Acts::Given)) {
        return false;
    }
    let measurements = evidence.measurements;
    let rows = measurements.len() as f64;
    let of_rows = noise.terms.iter().filter(|term| matches!(term.effect.acts, Acts::Rounds | Acts::Weighs));
    let plain = noise.with(of_rows.cloned().collect(), measurements);
    let swallowing = noise.with(plain.terms.iter().cloned().chain(greedy).collect(), measurements);
    let is_known = noise.source.is_known();
    let cost = |square: f64, log_determinant: f64, parameters: usize| {
        let misfit = if is_known { square } else { rows * (1.0 + (square / rows).max(f64::MIN_POSITIVE).ln()) };
        misfit + log_determinant + parameters as f64 * rows.ln()
    };
    // What other terms add is no part of the question.
    let left = noise.unshared(evidence.residuals);
    let square = swallowing.whiten(left.iter().copied()).iter().map(|z| z * z).sum();
    let swallowed = cost(square, swallowing.log_determinant(), swallowing.terms.len() - plain.terms.len());
    let standardised: Vec<f64> = left.iter().zip(plain.sigma.iter()).map(|(v, s)| v / s).collect();
    let own = plain.log_determinant();
    let curves = paths(evidence);
    curves.iter().any(|paths| {
        let range = range(paths);
        let hyper = (0..LENGTHS).flat_map(|i| {
            (0..SIZES).map(move |j| (range * 0.5f64.powi(i), LEAST_SIZE * 2f64.powf(0.5 * f64::from(j))))
        });
        let least = hyper.map(|(length, size)| {
            let (square, log_determinant) = filtered(paths, &standardised, length, size);
            cost(square, own + log_determinant, 2)
        });
        least.fold(f64::INFINITY, f64::min) < swallowed - PROMISING
    })
}

/// The rows in the order of a place, with their places.
type Path = Vec<(f64, usize)>;

/// Ways through the rows along a place to which they return: all of them, and of every approach or branch by itself; of
/// every observable a path.
fn paths(evidence: &Evidence) -> Vec<Vec<Path>> {
    let places = evidence.quantities().filter(|i| !evidence.is_time(*i));
    let by = |place: usize| {
        std::iter::once(Vec::new()).chain(evidence.words().map(|word| vec![word])).map(move |by| (place, by))
    };
    let along = |(place, by): (usize, Vec<usize>)| {
        let x = &evidence.measurements.rows.columns[place];
        let levels = evidence.measurements.levels(&by);
        let mut own: std::collections::BTreeMap<(usize, usize), Path> = std::collections::BTreeMap::new();
        for row in (0..x.len()).filter(|row| x[*row].is_finite()) {
            own.entry((evidence.measurements.rows.observable[row], levels[row])).or_default().push((x[row], row));
        }
        own.values_mut().for_each(|path| path.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1))));
        own.into_values().collect::<Vec<Path>>()
    };
    places.flat_map(by).map(along).filter(|paths| returns(paths)).collect()
}

/// Whether rows that are neighbours along the paths were mostly measured apart, at places that make a curve.
fn returns(paths: &[Path]) -> bool {
    let steps = || paths.iter().flat_map(|path| path.windows(2));
    let apart = steps().filter(|two| two[0].1.abs_diff(two[1].1) > NEIGHBOURS).count();
    let places = steps().filter(|two| two[0].0 < two[1].0).count() + paths.len();
    2 * apart > steps().count() && places >= LEAST_PLACES * paths.len()
}

/// Largest range of the places of a path.
fn range(paths: &[Path]) -> f64 {
    let of = |path: &Path| path.last().zip(path.first()).map_or(0.0, |(last, first)| last.0 - first.0);
    paths.iter().map(of).fold(0.0, f64::max)
}

/// Square of the innovations and ln det of the covariance of standardised values: a curve of this length and size along
/// every path, and noise of one.
fn filtered(paths: &[Path], values: &[f64], length: f64, size: f64) -> (f64, f64) {
    let (mut square, mut log_determinant) = (0.0, 0.0);
    for path in paths {
        let (mut mean, mut variance, mut at) = (0.0, size * size, f64::NEG_INFINITY);
        for (x, row) in path {
            let kept = (-(x - at) / length).exp();
            (mean, variance, at) = (kept * mean, kept * kept * variance + (1.0 - kept * kept) * size * size, *x);
            let total = variance + 1.0;
            let off = values[*row] - mean;
            square += off * off / total;
            log_determinant += total.ln();
            mean += off * variance / total;
            variance /= total;
        }
    }
    (square, log_determinant)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_filter_is_the_dense_likelihood() {
        let path: Path = vec![(0.0, 3), (0.5, 0), (0.5, 2), (2.0, 1)];
        let values = [1.0, -0.3, 0.8, 0.4];
        let (length, size) = (1.3, 1.7);
        let at = |row: usize| path.iter().find(|p| p.1 == row).unwrap().0;
        let dense = nalgebra::DMatrix::from_fn(4, 4, |i, j| {
            size * size * (-(at(i) - at(j)).abs() / length).exp() + if i == j { 1.0 } else { 0.0 }
        });
        let v = nalgebra::DVector::from_row_slice(&values);
        let exact = (v.dot(&dense.clone().lu().solve(&v).unwrap()), dense.determinant().ln());
        let (square, log_determinant) = filtered(&[path], &values, length, size);
        assert!((square - exact.0).abs() < 1e-12 && (log_determinant - exact.1).abs() < 1e-12);
    }

    #[test]
    fn places_return_where_a_branch_comes_back_and_not_where_rows_repeat_side_by_side() {
        let there_and_back: Path = (0..12)
            .map(|i| (f64::from(i), i as usize))
            .chain((0..12).map(|i| (f64::from(i), 23 - i as usize)))
            .collect();
        let sorted = |mut path: Path| {
            path.sort_by(|a, b| a.0.total_cmp(&b.0));
            vec![path]
        };
        assert!(returns(&sorted(there_and_back)));
        assert!(!returns(&sorted((0..24).map(|i| (f64::from(i / 2), i as usize)).collect())));
        assert!(!returns(&sorted((0..24).map(|i| (f64::from(i), i as usize)).collect())));
    }
}
