//! The tables of an axis.

use super::Error;
use crate::compensate::Compensation;
use crate::input::Problem;
use crate::model::Data;

/// Evaluates the test of an axis, and compensates it.
///
/// # Errors
/// The model is of no axis that is tested, or the readings make no table.
pub fn compensate(data: &Data) -> Result<Compensation, Error> {
    let model = data.model;
    let Some(axis) = model.system.positioning() else {
        let problem = Problem::new(format!("{} models {}", model.source.name, model.process.about()));
        return Err(problem
            .help("compensation is for axes that are tested by going to targets from both sides")
            .into());
    };
    if let Some(pulled) = (0..data.len()).find(|row| !axis.is_free(&data.rows, *row)) {
        let [words, column] = match axis.measures().is_rotary() {
            true => ["another torque than the test's turned the axis", "torque"],
            false => ["a force pulled the slide", "pull"],
        };
        let problem = Problem::new(format!("line {}: {words}", data.line(pulled)));
        let help = format!("a table is for the axis as it works: leave out the rows with such a `{column}`");
        return Err(problem.help(help).into());
    }
    Ok(crate::compensate::compensate(data, axis)?)
}
