//! The instruments that measure a bore: a roundness instrument with its filter, gauges that show diameters.

use crate::input::Reader;
use crate::roundness::Contacts;

/// A gauge that shows diameters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gauge {
    /// Two contacts that face each other.
    TwoPoint,
    /// Three contacts that centre themselves.
    ThreePoint,
}

/// How a bore is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
    pub const WORDS: &[(&'static str, Self)] = &[("two-point", Self::TwoPoint), ("three-point", Self::ThreePoint)];

    /// Its contacts.
    pub fn contacts(self) -> Contacts {
        match self {
            Self::TwoPoint => Contacts::TwoPoint,
            Self::ThreePoint => Contacts::ThreePoint,
        }
    }
}

impl Instrument {
    /// Reads its keys of `[measurement]`.
    pub fn read(t: &Reader) -> Self {
        let about =
            "undulations per revolution of which the Gauss filter of traces lets half through; none if left out";
        Self {
            filter: t.count("filter", about).between(2, 1500).optional(),
            gauge: t.choice("gauge", "what shows `diameter_error`", Gauge::WORDS).or_first(Gauge::TwoPoint),
        }
    }
}
