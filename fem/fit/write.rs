//! Writes a model with fitted values and their uncertainties in place; every comment is kept.

use super::sizes::EstimatedSize;
use crate::fit::Fit;
use crate::model::Data;
use crate::units::unit_text;

/// Makes the text of the fitted model: `"? um"` and `"60 +- 15 N/um"` become `"59.2 +- 1.1 N/um"`, in the
/// unit that stood there. A parameter that the data leave open stays as it was, for a value would look
/// better known than it is. Sizes of effects of the measurement have no `+-`. A comment at the top names the
/// data.
pub fn fitted_text(data: &Data, fit: &Fit) -> String {
    let text = &data.model.source.text;
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
                format!("{} {name}", uncertain(value, fit.birge_ratio() * estimate.std / unit.factor)).trim_end()
            ),
        ));
    }
    places.extend(fit.sizes.iter().filter(|size| size.is_told()).filter_map(|size| size_place(data, size)));
    places.sort_by_key(|p| p.0.start);
    let end = if text.contains("\r\n") { "\r\n" } else { "\n" };
    let name = data.name.replace(['\n', '\r'], " ");
    let mut fitted = format!("# Fitted to {name}, {}: what is known from it stands after `+-`.{end}", data.mark());
    let mut from = 0;
    for (span, value) in places {
        fitted.push_str(&text[from..span.start]);
        fitted.push_str(&value);
        from = span.end;
    }
    fitted.push_str(&text[from..]);
    fitted
}

/// The place of a size of an effect of the measurement in the file and what to write there: in the unit that
/// stood there, or where the size was left out, as a key behind the head of its table.
fn size_place(data: &Data, size: &EstimatedSize) -> Option<(std::ops::Range<usize>, String)> {
    let (estimate, text) = (&size.estimate, &data.model.source.text);
    let [value, table] = data.model.places_of_size(&size.term);
    let written = value.clone().and_then(|span| text.get(span)).unwrap_or_default().trim_matches(['"', '\'']);
    let kind = estimate.parameter.kind;
    let unit = kind.unit_of(unit_text(written));
    let name = if unit.is_ok() && value.is_some() { unit_text(written) } else { &kind.unit };
    let factor = unit.unwrap_or(kind.canonical()).factor;
    let number = five_digits(estimate.value / factor);
    let quoted = if name.is_empty() { number } else { format!("\"{number} {name}\"") };
    if let Some(span) = value {
        return Some((span, quoted));
    }
    let (table, key) = (table?, size.term.effect.size.key());
    let own = text.get(table.clone())?;
    if let Some(inside) = own.strip_prefix('{') {
        let more = if inside.trim_start().starts_with('}') { "" } else { "," };
        return Some((table.start + 1..table.start + 1, format!(" {key} = {quoted}{more}")));
    }
    let rest = &text[table.start..];
    let end = table.start + rest.find('\n').map_or(rest.len(), |i| i + 1);
    let gap = if text[..end].ends_with('\n') { "" } else { "\n" };
    Some((end..end, format!("{gap}{key} = {quoted}\n")))
}

/// A number with five significant digits.
fn five_digits(value: f64) -> String {
    let place = if value == 0.0 { 0 } else { (4 - value.abs().log10().floor() as i32).clamp(0, 12) };
    format!("{value:.*}", place as usize)
}

/// Writes `59.2 +- 1.1`: the uncertainty with two digits, the value to the same place.
pub fn uncertain(value: f64, std: f64) -> String {
    if !(std.is_finite() && std > 0.0) {
        return format!("{value}");
    }
    // A value keeps three digits however uncertain it is: rounded to 0 it might leave its bounds.
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
