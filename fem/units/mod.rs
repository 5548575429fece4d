//! Units at the border, SI inside.
//!
//! Model files and measurement headers carry a unit with every quantity; the program computes with plain
//! `f64` in coherent SI units (metre, kilogram, second, kelvin, radian). Angles are kept apart from pure
//! numbers, so that a feed per revolution is not taken for a length nor a rate of turn for a frequency.

mod dimension;
mod kind;
mod parse;
mod quantity;
mod spelling;
mod symbol;
mod unit;

pub use dimension::Dimension;
pub use kind::*;
pub use kind::{Kind, Shown};
pub use quantity::{Knowledge, LARGEST, Quantity, unit_text};
pub use spelling::plain as plain_unit;
pub use symbol::UnitSymbol;
pub use unit::{Unit, UnitError};
