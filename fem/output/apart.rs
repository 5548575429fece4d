//! The row that tells two laws apart.

use serde_json::{Value as Json, json};

use super::fit::Short;
use crate::diagnose::Apart;
use crate::units::Kind;

/// The row that tells two laws apart, in JSON; `kind` is that of what they add.
pub fn json(own: &Apart, kind: Kind) -> Json {
    let at = |(name, kind, value): &(String, Kind, f64)| json!({ "variable": name, "unit": kind.unit, "value": kind.from_si(*value) });
    json!({
        "at": own.at.iter().map(at).collect::<Vec<_>>(),
        "difference": own.difference,
        "unit": kind.unit,
        "standard_uncertainties": own.sigmas,
    })
}

/// The row that tells two laws apart, in words; `kind` is that of what they add.
pub fn words(own: &Apart, kind: Kind) -> String {
    let at = |(name, kind, value): &(String, Kind, f64)| {
        format!("{name} {:.4} {}", Short(kind.from_si(*value)), kind.unit).trim_end().to_string()
    };
    let at: Vec<String> = own.at.iter().map(at).collect();
    format!(
        "a row at {} tells: {:.3} {} apart ({:.1} standard uncertainties)",
        at.join(", "),
        Short(own.difference.abs()),
        kind.unit,
        own.sigmas
    )
}
