//! Programs of numerically controlled machines (ISO 6983-1, RS-274/NGC) as text and numbers: what the finishing pass of one
//! commands, and the same program with other words across the part. Everything else in it stays as it is, to the byte.
//!
//! `words` finds letters and numbers with their bytes, `codes` says what they order, `interpret` follows them as a control
//! does. What is not understood is refused where it stands. `surface` and `plan` find the blocks that finish the part, `fit`
//! the values of their words, `write` puts them in. SI units; radii across, places along the part.

mod arc;
mod codes;
mod contour;
mod corrected;
mod fit;
mod interpret;
mod knots;
mod number;
mod plan;
mod program;
mod spot;
mod steps;
mod surface;
mod wanted;
mod words;
mod workpiece;
mod write;

pub use contour::contour;
pub use corrected::{Corrected, Left, Other, corrected};
pub use program::Program;
pub use workpiece::{Across, Axes, LATHE, Stretch, Workpiece};
