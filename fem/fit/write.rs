//! The model with fitted values and their uncertainties in place, every comment kept.

use crate::fit::Fit;
use crate::model::Model;

/// The text of the fitted model: `"? um"` and `"60 +- 15 N/um"` become `"59.2 +- 1.1 N/um"`, in the unit that stood there. What the
/// data leave open stays as it was: a value would look better known than it is.
pub fn fitted_text(model: &Model, fit: &Fit) -> String {
    let text = &model.source.text;
    let mut places: Vec<(std::ops::Range<usize>, String)> = Vec::new();
    for estimate in &fit.estimates {
        let Some(span) = estimate.parameter.span.clone().filter(|_| estimate.is_closed()) else { continue };
        let written = text.get(span.clone()).unwrap_or_default().trim_matches(['"', '\'']);
        let name = unit_of(written);
        let unit = estimate.parameter.kind.unit_of(name).unwrap_or(estimate.parameter.kind.canonical());
        let value = (estimate.value - unit.offset) / unit.factor;
        places.push((
            span,
            format!("\"{}\"", format!("{} {name}", uncertain(value, estimate.std / unit.factor)).trim_end()),
        ));
    }
    places.sort_by_key(|p| p.0.start);
    let mut fitted = String::with_capacity(text.len() + 16 * places.len());
    let mut from = 0;
    for (span, value) in places {
        fitted.push_str(&text[from..span.start]);
        fitted.push_str(&value);
        from = span.end;
    }
    fitted.push_str(&text[from..]);
    fitted
}

/// What stands after the numbers.
fn unit_of(written: &str) -> &str {
    let number = |c: char| c.is_ascii_digit() || matches!(c, '.' | '+' | '-' | '±' | '?' | ' ' | '/');
    let mut rest = written.trim();
    loop {
        rest = rest.trim_start_matches(number);
        // An exponent, not a unit: `1.5e3 N/um`.
        match rest.strip_prefix(['e', 'E']) {
            Some(after) if after.starts_with(|c: char| c.is_ascii_digit() || c == '+' || c == '-') => rest = after,
            _ => break,
        }
    }
    // A unit may begin with a slash: `/K`.
    let start = written.len() - rest.len();
    if written[..start].ends_with('/') && !rest.is_empty() { &written[start - 1..] } else { rest }
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
    fn units_are_found_behind_every_kind_of_number() {
        for (written, unit) in [
            ("60 +- 15 N/um", "N/um"),
            ("? min", "min"),
            ("1.5e3 +- 2e1 kN/mm", "kN/mm"),
            ("?", ""),
            ("11e-6 +- 1e-6 /K", "/K"),
            ("0.5 ± 0.1", ""),
        ] {
            assert_eq!(unit_of(written), unit, "{written}");
        }
    }

    #[test]
    fn values_are_written_to_their_uncertainty() {
        assert_eq!(uncertain(59.2437, 1.1432), "59.2 +- 1.1");
        assert_eq!(uncertain(59.2437, 0.0123), "59.244 +- 0.012");
        assert_eq!(uncertain(-0.5, 0.25), "-0.500 +- 0.250");
        assert_eq!(uncertain(0.536, 700.0), "0.536 +- 700.000");
    }
}
