//! The answer of `fem compare`: models held against measurements.

mod answer;
mod asked;
mod drawing;
mod residuals;
mod shapes;
mod text;

pub use answer::ComparisonAnswer;
pub use asked::Asked;
pub use drawing::drawing;
pub use residuals::residuals;
pub(super) use text::{
    NO_STRUCTURE, compared, features, noise as noise_text, noise_of_both, not_judged, residual_curve, verdict,
};

use serde_json::{Value as Json, json};

use crate::compare::{Agreement, Feature};
use crate::measure::{MeasuredObservable, Measurements};
use crate::noise::{NoiseLevel, NoiseSource};
use crate::process::{Coordinate, Holds};
use crate::units::Kind;

impl NoiseSource {
    /// Word in JSON.
    pub fn word(self) -> &'static str {
        match self {
            Self::Column => "column u",
            Self::Covariance => "covariance",
            Self::Repeats => "repeats",
            Self::Estimated => "estimated",
        }
    }
}

/// Makes the JSON of the noise, in the unit of the errors of all rows.
pub(super) fn noise(noise: &NoiseLevel, kind: Kind) -> Json {
    let (sigma, source) = (kind.from_si(noise.together()), noise.source.word());
    let mut told = json!({ "sigma": sigma, "unit": kind.unit, "source": source });
    if noise.factor != 1.0 {
        told["times_u"] = json!(noise.factor);
    }
    told
}

/// Makes the JSON of the agreement of each observable.
pub(super) fn observables(
    measurements: &Measurements,
    agreement: impl Fn(&MeasuredObservable) -> Agreement,
) -> Vec<Json> {
    let one = |seen: &MeasuredObservable| {
        let [rms, sigma] = [agreement(seen).rms, agreement(seen).sigma].map(|si| seen.kind.from_si(si));
        json!({ "name": seen.name, "unit": seen.kind.unit, "rms": rms, "sigma": sigma })
    };
    measurements.observables.iter().map(one).collect()
}

/// Makes the JSON of a feature of the residuals.
pub(super) fn feature(feature: &Feature) -> Json {
    json!({
        "coordinate": feature.coordinate,
        "shape": feature.trend.map(|s| s.word()),
        "share": feature.share,
        "p_value": feature.p_value,
        "text": feature.text,
    })
}

/// Makes the JSON of the coordinates of a row that the file gives: labels as numbers or words, quantities
/// with their units.
pub(super) fn place(coordinates: &[Coordinate], measurements: &Measurements, row: usize) -> Json {
    let mut place = serde_json::Map::new();
    for &i in &measurements.given {
        let Some(value) = measurements.rows.get(i, row) else { continue };
        let shown = match &coordinates[i].holds {
            Holds::Quantity(kind) => json!(format!("{} {}", rounded(kind.from_si(value)), kind.unit)),
            Holds::Number(_) => json!(value as u64),
            Holds::Word(words) => json!(words.of_value(value)),
        };
        place.insert(coordinates[i].name.to_string(), shown);
    }
    Json::Object(place)
}

/// Rounds off the digits that unit conversion leaves.
fn rounded(value: f64) -> f64 {
    let digits = format!("{value:.9e}");
    digits.parse().unwrap_or(value)
}
