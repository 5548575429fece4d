//! Charts of a law over what it is made of, with the rows that it describes.

use super::measured::{Rows, dots, thinned};
use crate::input::Name;
use crate::output::chart::{Axis, Chart, Form, Plane, Series};

/// What a law says of rows, SI.
pub struct Said<'a> {
    /// Its name.
    pub name: &'a Name,
    /// Names of its variables.
    pub variables: &'a [String],
    /// What it adds to each row.
    pub added: &'a [f64],
    /// Measured less predicted with the law.
    pub residuals: &'a [f64],
}

/// A law along each of its variables that is a column, beside what every row leaves without it.
pub fn law(rows: &Rows, said: &Said) -> Vec<Chart> {
    let Said { name, variables, added, residuals } = said;
    let mut charts = Vec::new();
    for layout in &rows.layouts {
        let (factor, unit) = rows.unit(layout);
        let is_of_law = |axis: &Axis| variables.iter().any(|own| own.replace('_', " ") == axis.name);
        if layout.rows.iter().all(|row| added[*row] == 0.0) {
            continue;
        }
        for variable in layout.variables.iter().filter(|own| is_of_law(&own.axis)) {
            let own = |value: &dyn Fn(usize) -> f64| dots(layout, variable, &|at| factor * value(layout.rows[at]));
            let along = &variable.axis.name;
            charts.push(Chart {
                name: format!("{name}-{}{}", along.replace(' ', "-"), layout.end),
                title: format!("{name} over {along}"),
                note: format!(
                    "what each row leaves without it, and what it says of that row{}",
                    thinned(layout.rows.len())
                ),
                plane: Plane::Curves {
                    x: variable.axis.clone(),
                    y: Axis::new("measured less predicted without it", unit),
                    series: vec![
                        Series::new("rows", 0, Form::Dots, own(&|row| added[row] + residuals[row])),
                        Series::new(name.to_string(), 1, Form::Dots, own(&|row| added[row])),
                    ],
                },
            });
        }
    }
    charts
}
