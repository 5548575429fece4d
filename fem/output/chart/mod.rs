//! Charts: one small vocabulary of axes, series, maps and polar planes, and one look for all of them. What is
//! drawn is plain data in the units of its axes; [`draw`] draws it.

mod curves;
mod data;
mod draw;
mod map;
mod number;
mod polar;
mod scale;
mod style;
mod svg;
mod thin;

pub use data::{Axis, Chart, Form, Plane, Point, Series};
pub use draw::{draw, named};
pub use number::{grouped, number};
pub use style::{COLOURS, sheet};
pub use svg::{Mark, Svg, escaped};
