//! Laws that are in no catalogue, as a diagnosis tells them.

use crate::input::Name;
use crate::model::Setting;
use crate::units::Kind;

/// A law that is in no catalogue.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeLaw {
    /// The observable to which it is added.
    pub observable: Name,
    /// Its formula.
    pub formula: String,
    /// Names of what it varies with.
    pub variables: Vec<String>,
    /// The settings with which `fem add` writes it, the formula first.
    pub settings: Vec<Setting>,
    /// The effect of the catalogue, of whatever process, that has its form, with what that is.
    pub like: Option<&'static str>,
    /// Laws that fit as well.
    pub rivals: Vec<Rival>,
}

/// A law that fits as well as another.
#[derive(Clone, Debug, PartialEq)]
pub struct Rival {
    /// Its formula.
    pub formula: String,
    /// The row that tells the two apart, where one is known.
    pub apart: Option<Apart>,
}

/// The row that tells two laws apart best.
#[derive(Clone, Debug, PartialEq)]
pub struct Apart {
    /// Variables with their values, SI.
    pub at: Vec<(String, Kind, f64)>,
    /// Difference of the laws there, in the unit of the error of the observable.
    pub difference: f64,
    /// Kind of that error.
    pub kind: Kind,
    /// The same in standard uncertainties of a row.
    pub sigmas: f64,
}
