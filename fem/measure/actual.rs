//! Actual values beside commanded ones: what is observed is their difference.

use std::f64::consts::TAU;

use csv::StringRecord;

use super::heading::Heading;
use super::records::Records;
use super::vocabulary::Vocabulary;
use crate::input::Problem;
use crate::units::{ANGLE, Unit};

/// A column that was made of an actual value less a commanded one in the same unit.
#[derive(Clone, Copy, Debug)]
pub struct Difference {
    /// The column.
    pub column: usize,
    /// That of the commanded value.
    pub commanded: usize,
}

impl Difference {
    /// The actual value of which a cell was made, as it was written.
    pub fn actual(&self, cells: &StringRecord) -> Option<String> {
        let [apart, commanded] = [self.column, self.commanded].map(|column| &cells[column]);
        let digits = apart.split_once('.').map_or(0, |(_, fraction)| fraction.len());
        let sum = apart.parse::<f64>().ok()? + commanded.parse::<f64>().ok()?;
        Some(format!("{sum:.digits$}"))
    }
}

/// Puts actual − commanded in the place of an actual value, in its unit. Beside a column of what is observed an
/// actual value is not used.
///
/// # Errors
/// The actual value has no unit of the commanded one.
pub fn less_commanded(
    headings: &mut [Heading],
    records: &mut Records,
    vocabulary: Vocabulary,
    told: &mut Vec<String>,
) -> Result<Option<Difference>, Problem> {
    let mut made = None;
    for coordinate in vocabulary.coordinates {
        let (Some(observable), Some(kind)) = (coordinate.actual, coordinate.holds.kind()) else { continue };
        let observable = &vocabulary.observables[observable].name;
        let column = |of: &dyn Fn(&str) -> bool| headings.iter().position(|h| h.is_known && of(&h.name));
        let is_actual = |name: &str| name == "actual" || name.strip_prefix("actual_") == Some(&*coordinate.name);
        let (Some(actual), commanded) = (column(&is_actual), column(&|name| name == coordinate.name)) else { continue };
        let is_observed = column(&|name| name == *observable).is_some();
        if let (true, _) | (_, None) = (is_observed, commanded) {
            headings[actual].is_known = false;
            continue;
        }
        let commanded = commanded.unwrap_or_default();
        let unit = kind.unit_of(&headings[actual].unit).map_err(|error| {
            let name = &headings[actual].name;
            Problem::new(format!("`{name}`: {}", error.message)).help(format!("write {name} [{}]", kind.unit))
        })?;
        // A unit of the commanded value that cannot be read is told with the header.
        let of_commanded = kind.unit_of(&headings[commanded].unit).unwrap_or(unit);
        records.rewrite(&[actual], |_, cells, actual| {
            difference([&cells[actual], &cells[commanded]], [unit, of_commanded])
        });
        told.push(format!("{observable} = {} - {}", headings[actual].name, coordinate.name));
        headings[actual].name = observable.to_string();
        made = (unit == of_commanded).then_some(Difference { column: actual, commanded });
    }
    Ok(made)
}

/// The difference of two cells in the unit of the first, to the last of their digits where the units agree;
/// `None` where they are no numbers.
fn difference(cells: [&str; 2], units: [Unit; 2]) -> Option<String> {
    let [actual, commanded] = [cells[0].parse::<f64>().ok()?, cells[1].parse::<f64>().ok()?];
    let mut apart = actual - commanded * units[1].factor / units[0].factor;
    if units[0].dimension == ANGLE.canonical().dimension {
        // 359.999 deg where 0 was commanded is a little less, and no turn more.
        let turn = TAU / units[0].factor;
        apart -= turn * (apart / turn).round();
    }
    let is_decimal = |cell: &&str| !cell.contains(['e', 'E']);
    if units[0] != units[1] || !cells.iter().all(is_decimal) || !apart.is_finite() {
        return Some(apart.to_string());
    }
    let digits = |cell: &&str| cell.split_once('.').map_or(0, |(_, fraction)| fraction.len());
    let most = cells.iter().map(digits).max().unwrap_or(0);
    // More digits than a number has tell nothing.
    Some(format!("{apart:.*}", most.min(17)))
}
