//! Files that controls read: one file of this folder for each, one line in [`ALL`].
//!
//! A control's file says which sign its values have, at which points it takes them, how many, how fine and how
//! large. What a control cannot hold is refused with a sentence, or taken at other points, and what then is left at
//! the targets is told.

mod beckhoff;
mod fanuc;
mod fanuc_bidirectional;
mod heidenhain;
mod linuxcnc;
mod mach4;
mod mitsubishi;
mod order;
mod siemens_cec;
mod siemens_eec;

pub use linuxcnc::FILE as LINUXCNC;
pub use order::Control;

use order::Order;

use crate::compensate::Compensation;
use crate::positioning::{Direction, Table};

/// Controls whose files are written; the first is written unasked.
pub const ALL: &[Control] = &[
    linuxcnc::LINUXCNC,
    siemens_eec::SIEMENS_EEC,
    siemens_cec::SIEMENS_CEC,
    heidenhain::HEIDENHAIN,
    fanuc::FANUC,
    fanuc_bidirectional::FANUC_BIDIRECTIONAL,
    mitsubishi::MITSUBISHI,
    mach4::MACH4,
    beckhoff::BECKHOFF,
];

/// Files for a control.
pub struct Supplied {
    /// The control.
    pub control: &'static Control,
    /// Names of the files and what stands in them.
    pub files: Vec<(&'static str, String)>,
    /// Notes for the user: changes made on the way, further settings, and assumptions where the manual is silent.
    pub notes: Vec<String>,
    /// Range of the mean deviations that are left at the targets, from both sides, m or rad.
    pub left: f64,
    /// Whether the user has named the control: what nobody has asked for is written, and not told.
    pub is_asked: bool,
}

/// Makes the files for a control, whose axis has a name and which the user may have named.
///
/// # Errors
/// Why the control cannot hold the table, and what would help.
pub fn supplied(
    control: &'static Control,
    found: &Compensation,
    axis: &str,
    is_asked: bool,
) -> Result<Supplied, String> {
    let measures = found.measures;
    if measures.is_rotary() && !control.turns {
        let takes: Vec<&str> = ALL.iter().filter(|other| other.turns).map(|other| other.name).collect();
        return Err(format!(
            "its file is written for axes that travel along a line alone: of a rotary axis take {}, or type in points.csv",
            takes.join(", ")
        ));
    }
    let [one, _, both] = &found.schemes;
    let order = Order { axis, one: &one.entered, both: &both.entered, steps: found.steps, measures };
    let written = (control.write)(&order)?;
    let left = left(found, &written.table);
    Ok(Supplied { control, files: written.files, notes: written.notes, left, is_asked })
}

/// Range of the mean deviations at the targets with a table in the place of the control's during the test. An offset
/// that is the same everywhere is no error of the axis: it is where its zero stands.
fn left(found: &Compensation, table: &Table) -> f64 {
    let had = |at, direction| found.active.as_ref().map_or(0.0, |active| active.correction(at, direction));
    let targets = || found.evaluation.targets.iter();
    let sides = targets().flat_map(|t| Direction::BOTH.map(|d| (t.position, d, t.side(d))));
    let means = sides.filter_map(|(at, d, side)| Some(side?.mean - had(at, d) + table.correction(at, d)));
    let (low, high) = means.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), m| (l.min(m), h.max(m)));
    if high >= low { high - low } else { 0.0 }
}
