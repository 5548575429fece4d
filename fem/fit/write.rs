//! The model with fitted values and their uncertainties in place, every comment kept.

use crate::fit::Fit;
use crate::measure::Measurements;
use crate::model::Model;
use crate::units::unit_text;

/// The text of the fitted model: `"? um"` and `"60 +- 15 N/um"` become `"59.2 +- 1.1 N/um"`, in the unit that stood there. What the
/// data leave open stays as it was: a value would look better known than it is. A comment at the top says what it was fitted to.
pub fn fitted_text(model: &Model, measurements: &Measurements, fit: &Fit) -> String {
    let text = &model.source.text;
    let mut places: Vec<(std::ops::Range<usize>, String)> = Vec::new();
    for estimate in &fit.estimates {
        let Some(span) = estimate.parameter.span.clone().filter(|_| estimate.is_closed()) else { continue };
        let written = text.get(span.clone()).unwrap_or_default().trim_matches(['"', '\'']);
        let name = unit_text(written);
        let unit = estimate.parameter.kind.unit_of(name).unwrap_or(estimate.parameter.kind.canonical());
        let value = (estimate.value - unit.offset) / unit.factor;
        places.push((
            span,
            format!(
                "\"{}\"",
                format!("{} {name}", uncertain(value, fit.doubt() * estimate.std / unit.factor)).trim_end()
            ),
        ));
    }
    places.sort_by_key(|p| p.0.start);
    let end = if text.contains("\r\n") { "\r\n" } else { "\n" };
    let name = measurements.name.replace(['\n', '\r'], " ");
    let mut fitted =
        format!("# Fitted to {name}, {}: what is known from it stands after `+-`.{end}", mark(measurements));
    let mut from = 0;
    for (span, value) in places {
        fitted.push_str(&text[from..span.start]);
        fitted.push_str(&value);
        from = span.end;
    }
    fitted.push_str(&text[from..]);
    fitted
}

/// What tells these rows from others, in the comment of a fitted model.
fn mark(measurements: &Measurements) -> String {
    format!("{} rows, mark {:016x}", measurements.len(), measurements.digest())
}

/// What must be said where a model is fitted to the rows that its values come from.
pub fn fitted_before(model: &Model, measurements: &Measurements) -> Option<String> {
    let mark = mark(measurements);
    let known = model.source.text.lines().any(|line| line.starts_with('#') && line.contains(&mark));
    known.then(|| {
        "the model's values were fitted to these very rows: as prior knowledge they count them twice, and intervals come out \
         too narrow; fit the model from before"
            .into()
    })
}

/// `59.2 +- 1.1`: the uncertainty with two digits, the value to the same place.
pub fn uncertain(value: f64, std: f64) -> String {
    if !(std.is_finite() && std > 0.0) {
        return format!("{value}");
    }
    // However uncertain, a value keeps three digits of its own: rounded to 0 it might leave its bounds.
    let of_value = if value == 0.0 { 0 } else { 2 - value.abs().log10().floor() as i32 };
    let of_std = 1 - std.abs().log10().floor() as i32;
    let place = if of_std < of_value && std > 0.1 * value.abs() { of_value } else { of_std };
    if (0..=12).contains(&place) {
        let digits = place as usize;
        return format!("{value:.digits$} +- {std:.digits$}");
    }
    let unit = 10f64.powi(-place);
    let round = |v: f64| (v / unit).round() * unit;
    format!("{:e} +- {:e}", round(value), round(std))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_written_to_their_uncertainty() {
        assert_eq!(uncertain(59.2437, 1.1432), "59.2 +- 1.1");
        assert_eq!(uncertain(59.2437, 0.0123), "59.244 +- 0.012");
        assert_eq!(uncertain(-0.5, 0.25), "-0.500 +- 0.250");
        assert_eq!(uncertain(0.536, 700.0), "0.536 +- 700.000");
    }
}
