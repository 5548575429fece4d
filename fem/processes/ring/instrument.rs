//! The instruments that measure a ring: a roundness instrument with its filter, gauges that show diameters.

use crate::input::Reader;
use crate::roundness::Contacts;
use crate::units::ANGLE;
use std::f64::consts::FRAC_PI_2;

use super::grip::Grip;

/// A gauge that shows diameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gauge {
    /// Two contacts that face each other.
    TwoPoint,
    /// Three contacts that centre themselves.
    ThreePoint,
    /// A dial over a V-block, whose flanks stand at this angle (rad); of an outside.
    VBlock(f64),
}

/// How a bore is measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Instrument {
    /// Waves around of which the filter of the roundness instrument lets half through; `None` without a filter.
    pub filter: Option<usize>,
    /// What shows diameters.
    pub gauge: Gauge,
}

impl Default for Instrument {
    fn default() -> Self {
        Self { filter: None, gauge: Gauge::TwoPoint }
    }
}

impl Gauge {
    /// The words of the model file, the default first.
    pub const WORDS: &[(&'static str, Self)] =
        &[("two-point", Self::TwoPoint), ("three-point", Self::ThreePoint), ("v-block", Self::VBlock(FRAC_PI_2))];

    /// Its contacts.
    pub fn contacts(self) -> Contacts {
        match self {
            Self::TwoPoint => Contacts::TwoPoint,
            Self::ThreePoint => Contacts::ThreePoint,
            Self::VBlock(angle) => Contacts::VBlock(angle),
        }
    }
}

impl Instrument {
    /// Reads its keys of `[measurement]`.
    pub fn read(t: &Reader, grip: Grip) -> Self {
        let about =
            "undulations per revolution of which the Gauss filter of traces lets half through; none if left out";
        let gauge = t.choice("gauge", "what shows `diameter_error`", Gauge::WORDS).or_first(Gauge::TwoPoint);
        let angle = t.quantity("block_angle", ANGLE, "between the flanks of the V-block; 90 deg if left out");
        let angle = angle.within(0.1, 3.0).optional();
        let is_block = matches!(gauge, Gauge::VBlock(_));
        if is_block && grip == Grip::Outside && !t.is_described() {
            let help = "write gauge = \"two-point\" or \"three-point\", or grip = \"inside\" in [chuck]";
            t.problem("gauge", "a bore does not lie in a V-block", help);
        }
        if angle.is_some() && !is_block && !t.is_described() {
            t.problem("block_angle", "no V-block measures here", "write gauge = \"v-block\", or leave it out");
        }
        Self {
            filter: t.count("filter", about).between(2, 1500).optional(),
            gauge: if is_block { Gauge::VBlock(angle.unwrap_or(FRAC_PI_2)) } else { gauge },
        }
    }
}
