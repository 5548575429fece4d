//! Programs of numerically controlled machines (ISO 6983-1, RS-274/NGC) as text and numbers: what the finishing pass of
//! one commands, and the same program with other words across the part. Everything else in it stays as it is, to the
//! byte.
//!
//! `words` finds letters and numbers with their bytes, `codes` says what they order, `interpret` follows them as a
//! control does. What is not understood is refused where it stands. `surface` and `plan` find the blocks that finish
//! the part, `fit` the values of their words, `write` puts them in. A lathe makes a profile, a mill a top by tracks
//! beside each other (`top`); what sets them apart otherwise stands in `axes`. SI units; the level across the part is a
//! radius or a height.

mod arc;
mod axes;
mod codes;
mod contour;
mod corrected;
mod fineness;
mod fit;
mod interpret;
mod knots;
mod number;
mod plan;
mod program;
mod sample;
mod spot;
mod steps;
mod surface;
mod top;
mod wanted;
mod words;
mod workpiece;
mod write;

pub use axes::{Across, Axes, LATHE, Level, MILL, Machine};
pub use contour::contour;
pub use corrected::{Corrected, Deeper, Left, Other, corrected};
pub use fineness::Fineness;
pub use program::Program;
pub use spot::Spot;
pub use wanted::Course;
pub use workpiece::{Breadth, Stretch, Workpiece};
