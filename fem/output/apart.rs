//! The row that tells two laws apart.

use serde_json::{Value as Json, json};

use super::fit::Short;
use crate::diagnose::Apart;
use crate::units::Kind;

/// The row, in JSON.
pub fn json(own: &Apart) -> Json {
    let at = |(name, kind, value): &(String, Kind, f64)| json!({ "variable": name, "unit": kind.unit, "value": kind.from_si(*value) });
    json!({
        "at": own.at.iter().map(at).collect::<Vec<_>>(),
        "difference": own.difference,
        "unit": own.kind.unit,
        "standard_uncertainties": own.sigmas,
    })
}

/// The row, in words.
pub fn words(own: &Apart) -> String {
    let at = |(name, kind, value): &(String, Kind, f64)| {
        format!("{name} {:.4} {}", Short(kind.from_si(*value)), kind.unit).trim_end().to_string()
    };
    let at: Vec<String> = own.at.iter().map(at).collect();
    format!(
        "a row at {} tells: {:.3} {} apart ({:.1} standard uncertainties)",
        at.join(", "),
        Short(own.difference.abs()),
        own.kind.unit,
        own.sigmas
    )
}
