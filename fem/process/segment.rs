//! A uniform length of a round body.

use crate::element::Round;
use crate::input::Reader;
use crate::units::LENGTH;

/// A uniform length of a round body; of a shaft as it is when finished.
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
        let diameter =
            t.quantity("diameter", LENGTH, "outer diameter; of a turned shaft the finished one").positive().required();
        let bore = t.quantity("bore", LENGTH, "diameter of the bore").not_negative().or(0.0);
        if bore >= diameter {
            t.problem("bore", "the bore is as wide as the segment or wider", "it must be below the diameter");
        }
        Self { length, section: Round { diameter, bore } }
    }
}
