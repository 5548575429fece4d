//! Single rows are wrong.

use super::super::term::{Acts, MeasurementEffect, Size};

/// Factor by which the noise of an outlying row exceeds that of the others, where nothing else is said: its
/// weight is then a hundredth, and no likelihood of single rows could tell it.
pub const OUTLYING: f64 = 10.0;

/// Single rows are wrong, and weighed down.
pub static OUTLIERS: MeasurementEffect = MeasurementEffect {
    name: "outliers",
    about: "single rows are wrong: a chip under the stylus, a slip of the pen, a reading taken too soon",
    law: "standard deviation of an outlying row = factor * that of the others",
    source: "Hogg, Bovy & Lang, Data analysis recipes: fitting a model to data, 2010, sec. 3 (mixture)",
    separates: "measure these rows again",
    size: Size::Number("factor", "by which the noise of an outlying row exceeds that of the others"),
    acts: Acts::Weighs,
};
