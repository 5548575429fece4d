//! The least squares held against certified values: the nonlinear regression problems of NIST.

mod problems;

use crate::fit::least_squares::solve;
use crate::fit::{Objective, starts};
use crate::input::Source;
use crate::measure::Measurements;
use crate::model::{Data, Model};
use crate::validation::{Case, Tolerance};
use problems::{ALL, Parameter, Problem};

/// A model of which the formula is all: the ideal axis goes where it is told.
const MODEL: &str = include_str!("nist/model.toml");

/// More than five certified digits of a value, and more than four of a standard deviation: the search ends
/// where χ² falls no more by 1e-10 of itself, and derivatives are differences over 1e-4 of a start.
const VALUE: Tolerance = Tolerance::Relative(5e-6);
const DEVIATION: Tolerance = Tolerance::Relative(5e-5);

/// Fits in which values and noise settle.
const ROUNDS: usize = 3;

/// Every problem from the starts from which its minimum is reached.
pub fn cases() -> Vec<Case> {
    ALL.iter().flat_map(|problem| problem.reached_from.iter().flat_map(|start| rows(problem, *start))).collect()
}

/// A row for every parameter of a problem, and one for every standard deviation.
fn rows(problem: &Problem, start: usize) -> Vec<Case> {
    let found = fitted(problem, start);
    let of = |(i, (_, _, value, deviation)): (usize, &Parameter)| {
        let (b, s) = found.as_ref().map_or((f64::NAN, f64::NAN), |f| f[i]);
        let case = |quantity, expected: f64, computed, tolerance| Case {
            name: format!("{} from start {start}, b{}", problem.name, i + 1),
            quantity,
            expected,
            computed,
            unit: "SI",
            tolerance,
            source: "NIST StRD, nonlinear regression, certified",
        };
        [case("least squares", *value, b, VALUE), case("standard deviation", *deviation, s, DEVIATION)]
    };
    problem.parameters.iter().enumerate().flat_map(of).collect()
}

/// Value and standard deviation of every parameter, SI; `None` where there is no fit.
fn fitted(problem: &Problem, start: usize) -> Option<Vec<(f64, f64)>> {
    let model = Model::parse(Source::new("nist.toml", text(problem, start))).ok()?;
    let rows = Measurements::parse(Source::new("nist.csv", problem.data.to_string()), &*model.process).ok()?;
    let data = Data::of(&model, rows).ok()?;
    let mut objective = Objective::new(&data).ok()?;
    let mut solution = starts::best(&mut objective).ok()?;
    // What is left is the noise, as for any rows whose uncertainty nobody knows, and settles with the values.
    for _ in 0..ROUNDS {
        objective.noise = objective.residual_noise(&solution);
        solution = solve(&mut objective, &solution.position).ok()?;
    }
    let jacobian = objective.jacobian(&solution)?;
    let covariance = objective.covariance(&jacobian);
    let one = |(i, value): (usize, f64)| (value, covariance[(i, i)].sqrt());
    Some(objective.values(&solution.position).into_iter().enumerate().map(one).collect())
}

/// The model file of a problem.
fn text(problem: &Problem, start: usize) -> String {
    let parameter = |(i, (unit, starts, ..)): (usize, &Parameter)| {
        format!("b{} = \"{}\"\n", i + 1, format!("? near {} {unit}", starts[start - 1]).trim())
    };
    let unit = if problem.formula.contains("unit") { "unit = \"1 m\"\n" } else { "" };
    let own: String = problem.parameters.iter().enumerate().map(parameter).collect();
    format!("{MODEL}formula = \"{}\"\n{unit}{own}", problem.formula)
}
