//! A uniform length of the shaft.

use crate::element::Round;
use crate::input::Reader;
use crate::units::LENGTH;

/// A uniform length of the finished shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// m.
    pub length: f64,
    /// Finished diameter and bore.
    pub section: Round,
}

impl Segment {
    /// Reads an entry of `segments`.
    pub fn read(t: &Reader, _: usize) -> Self {
        let length = t.quantity("length", LENGTH, "length of the segment").positive().required();
        let diameter = t.quantity("diameter", LENGTH, "finished diameter").positive().required();
        let bore = t.quantity("bore", LENGTH, "diameter of the bore").not_negative().or(0.0);
        if bore >= diameter {
            t.problem("bore", "the bore is as wide as the shaft or wider", "it must be below the diameter");
        }
        Self { length, section: Round { diameter, bore } }
    }
}
