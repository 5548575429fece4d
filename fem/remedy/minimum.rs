//! Least values within limits, without slopes: by Brent's method of one number, by Powell's COBYLA of several and beside
//! constraints. Both are of the crate `basin`, which ports the latter from PRIMA.

use std::cell::RefCell;
use std::convert::Infallible;

use basin::{
    BoxBounds, Brent, Cobyla, ConstraintDescription, ConstraintSet, ConstraintSolveError, Constraints, CostFunction,
    Executor, NoBounds, NoLinearConstraints, NoNonlinearBlock, NonlinearBlock, NonlinearBlocks,
    NonlinearInequalityValues, PointState, SelectedState,
};

/// Radius within which COBYLA begins, and that with which it is content, of numbers from 0 to 1.
const RADII: (f64, f64) = (0.2, 1e-3);
/// Part of a bracket to which Brent's method finds a place.
const NEAR: f64 = 1e-3;

/// A function on an interval.
struct OnInterval<F> {
    low: f64,
    high: f64,
    value: F,
}

impl<F> Constraints for OnInterval<F> {
    type Set = ConstraintSet<BoxBounds<f64>>;

    fn constraints(&self) -> <Self::Set as ConstraintDescription>::Borrowed<'_> {
        ConstraintSet::new().with_bounds(BoxBounds::new(Some(&self.low), Some(&self.high)))
    }
}

impl<F: Fn(f64) -> f64> CostFunction for OnInterval<F> {
    type Param = f64;
    type Output = f64;
    type Error = Infallible;

    fn cost(&self, at: &f64) -> Result<f64, Infallible> {
        Ok((self.value)(at.clamp(self.low, self.high)))
    }
}

/// Seeks the least value of a function on an interval, from a place within it, by at most so many evaluations. Whoever asks
/// keeps what was evaluated.
pub fn on_interval(value: impl Fn(f64) -> f64, [low, high]: [f64; 2], start: f64, most: u64) {
    if low >= high {
        return;
    }
    let solver = Brent::new().with_absolute_position_tolerance(NEAR * (high - low));
    let problem = OnInterval { low, high, value };
    // What was evaluated until then stands, whatever ends the search.
    drop(Executor::new(problem, solver, PointState::new(start)).max_cost_evals(most).run());
}

/// A place, the value there, and the constraints.
type Judged = (Vec<f64>, f64, Vec<f64>);

/// A value and constraints, which hold where they are zero or below, of numbers from 0 to 1.
struct InCube<F> {
    count: usize,
    constraints: usize,
    judged: F,
    /// The last place and what was found there: value and constraints are asked for one after the other.
    last: RefCell<Option<Judged>>,
}

impl<F: Fn(&[f64]) -> (f64, Vec<f64>)> InCube<F> {
    /// The value, and the constraints with those of the cube.
    fn at(&self, place: &[f64]) -> (f64, Vec<f64>) {
        if let Some((_, value, all)) = self.last.borrow().as_ref().filter(|(last, ..)| last == place) {
            return (*value, all.clone());
        }
        let inside: Vec<f64> = place.iter().map(|x| x.clamp(0.0, 1.0)).collect();
        let (value, own) = (self.judged)(&inside);
        let all: Vec<f64> = place.iter().flat_map(|x| [-x, x - 1.0]).chain(own).collect();
        self.last.replace(Some((place.to_vec(), value, all.clone())));
        (value, all)
    }
}

impl<F> Constraints for InCube<F> {
    type Set = ConstraintSet<NoBounds, NoLinearConstraints, NonlinearBlocks<NoNonlinearBlock, NonlinearBlock>>;

    fn constraints(&self) -> <Self::Set as ConstraintDescription>::Borrowed<'_> {
        ConstraintSet::new().with_nonlinear_inequalities(2 * self.count + self.constraints)
    }
}

impl<F: Fn(&[f64]) -> (f64, Vec<f64>)> CostFunction for InCube<F> {
    type Param = Vec<f64>;
    type Output = f64;
    type Error = Infallible;

    fn cost(&self, at: &Vec<f64>) -> Result<f64, Infallible> {
        Ok(self.at(at).0)
    }
}

impl<F: Fn(&[f64]) -> (f64, Vec<f64>)> NonlinearInequalityValues for InCube<F> {
    type Param = Vec<f64>;
    type Values = Vec<f64>;
    type Error = Infallible;

    fn nonlinear_inequalities(&self, at: &Vec<f64>) -> Result<Vec<f64>, ConstraintSolveError<Infallible>> {
        Ok(self.at(at).1)
    }
}

/// Seeks the least value of numbers from 0 to 1 at which so many constraints are zero or below, from a place, by at most so
/// many evaluations. Whoever asks keeps what was evaluated.
pub fn in_cube(judged: impl Fn(&[f64]) -> (f64, Vec<f64>), constraints: usize, start: &[f64], most: u64) {
    if start.is_empty() {
        judged(start);
        return;
    }
    let problem = InCube { count: start.len(), constraints, judged, last: RefCell::default() };
    let solver = Cobyla::new().with_initial_radius(RADII.0).with_final_radius(RADII.1);
    drop(Executor::new(problem, solver, SelectedState::new(start.to_vec())).max_cost_evals(most).run());
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_value_on_an_interval_is_inside_or_at_an_end() {
        for (least, place) in [(0.3, 0.3), (-1.0, 0.0), (2.0, 1.0)] {
            let best = RefCell::new((f64::INFINITY, f64::NAN));
            let value = |x: f64| {
                let value = (x - least).powi(2);
                if value < best.borrow().0 {
                    best.replace((value, x));
                }
                value
            };
            on_interval(value, [0.0, 1.0], 0.5, 40);
            assert!((best.borrow().1 - place).abs() < 5e-3, "{least}: {best:?}");
        }
    }

    /// Where x + y is one or more, the sum of squares is least half way.
    #[test]
    fn constraints_hold() {
        let best = RefCell::new((f64::INFINITY, Vec::new()));
        let judged = |x: &[f64]| {
            let value = x[0] * x[0] + x[1] * x[1];
            let constraint = 1.0 - x[0] - x[1];
            if constraint <= 1e-6 && value < best.borrow().0 {
                best.replace((value, x.to_vec()));
            }
            (value, vec![constraint])
        };
        in_cube(judged, 1, &[0.9, 0.4], 200);
        assert!(best.borrow().1.iter().all(|x| (x - 0.5).abs() < 0.02), "{best:?}");
    }
}
