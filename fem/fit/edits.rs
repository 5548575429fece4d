//! Fitted values and their uncertainties as edits of a model.

use super::sizes::EstimatedSize;
use crate::fit::Fit;
use crate::input::Parameter;
use crate::model::{Data, Edit, Entry, Spread};
use crate::units::{MICRO, unit_text};

/// Edits that put what was fitted into the model: `"? um"` and `"60 +- 15 N/um"` become `"59.2 +- 1.1 N/um"`, in the
/// unit that stood there. A parameter that the data leave open stays as it was, for a value would look better known
/// than it is. Sizes of effects of the measurement have no `+-`. A comment at the top names the data.
pub fn edits(data: &Data, fit: &Fit) -> Vec<Edit> {
    let name = data.name.replace(char::is_control, " ");
    let remark = format!("Fitted to {name}, {}: what is known from it stands after `+-`.", data.marks().join("; "));
    let closed = fit.estimates.iter().zip(&fit.known.alone).filter(|(estimate, _)| estimate.is_closed());
    let values = closed.filter_map(|(estimate, alone)| {
        let parameter = &estimate.parameter;
        let name = unit_text(data.model.written(&parameter.path)?);
        let unit = parameter.kind.unit_of(name).unwrap_or(parameter.kind.canonical());
        let value = (estimate.value - unit.offset) / unit.factor;
        let std = fit.birge_ratio() * estimate.std / unit.factor;
        let text = format!("{} {name}", uncertain_beside(value, std, *alone));
        Some(Edit::Set { path: parameter.path.clone(), entry: Entry::Text(text.trim_end().into()) })
    });
    let known = fit.estimates.iter().zip(&fit.known.jointly).zip(&fit.known.spreads);
    let of: Vec<(Parameter, f64, Spread)> = known
        .map(|((own, part), spread)| (own.parameter.clone(), fit.birge_ratio() * part * own.std, *spread))
        .collect();
    // Tests of one machine have no file in which they could stand.
    let correlations = match data.model.campaign() {
        Some(_) => Vec::new(),
        None => data.model.together.edits(
            &of,
            &fit.known.correlation,
            ((unexplained(data, fit), data.model.process.size_kind()), &fit.known.instead),
        ),
    };
    let sizes = fit.sizes.iter().filter(|size| size.is_told()).map(|size| sized(data, size));
    std::iter::once(Edit::Remark(remark)).chain(values).chain(sizes).chain(correlations).collect()
}

/// What the noise does not explain of lengths that were measured, as a standard deviation, m.
fn unexplained(data: &Data, fit: &Fit) -> f64 {
    if fit.birge_ratio() == 1.0 {
        return 0.0;
    }
    let is_length =
        |row: &usize| data.model.process.observables()[data.rows.observable[*row]].error_kind().unit == MICRO.unit;
    let left = data.residuals(&fit.predicted);
    let squares: Vec<f64> =
        (0..left.len()).filter(is_length).map(|row| left[row].powi(2) - fit.noise.sigma[row].powi(2)).collect();
    (squares.iter().sum::<f64>() / squares.len().max(1) as f64).max(0.0).sqrt()
}

/// The size of an effect of the measurement, in the unit that stood there, or in the usual one where it was left out.
fn sized(data: &Data, size: &EstimatedSize) -> Edit {
    let parameter = &size.estimate.parameter;
    let (kind, written) = (parameter.kind, data.model.written(&parameter.path));
    let name = written.map(unit_text).filter(|name| kind.unit_of(name).is_ok()).unwrap_or(&kind.unit);
    let factor = kind.unit_of(name).unwrap_or(kind.canonical()).factor;
    let number = five_digits(size.estimate.value / factor);
    let entry = match name.is_empty() {
        true => Entry::Number(number.parse().unwrap_or(size.estimate.value)),
        false => Entry::Text(format!("{number} {name}")),
    };
    Edit::Set { path: parameter.path.clone(), entry }
}

/// A number with five significant digits.
pub fn five_digits(value: f64) -> String {
    let place = if value == 0.0 { 0 } else { (4 - value.abs().log10().floor() as i32).clamp(0, 12) };
    format!("{value:.*}", place as usize)
}

/// Writes `59.2 +- 1.1`: the uncertainty with two digits, the value to the same place.
pub fn uncertain(value: f64, std: f64) -> String {
    uncertain_beside(value, std, 1.0)
}

/// The same of a value whose uncertainty beside known others is a part `alone` of that: with the digits that what is known of
/// all together needs.
pub fn uncertain_beside(value: f64, std: f64, alone: f64) -> String {
    if !(std.is_finite() && std > 0.0) {
        return format!("{value}");
    }
    // A value keeps three digits however uncertain it is: rounded to 0 it might leave its bounds.
    let of_value = if value == 0.0 { 0 } else { 2 - value.abs().log10().floor() as i32 };
    let of_std = 1 - (alone * std).abs().log10().floor() as i32;
    let place = if of_std < of_value && std > 0.1 * value.abs() { of_value } else { of_std };
    if (0..=12).contains(&place) {
        let digits = place as usize;
        return format!("{value:.digits$} +- {std:.digits$}");
    }
    // No more digits than a computation has.
    let [digits, of_std] =
        [2 - of_value, std.log10().floor() as i32].map(|exponent| (place + exponent).clamp(0, 12) as usize);
    format!("{value:.digits$e} +- {std:.of_std$e}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_are_written_to_their_uncertainty() {
        assert_eq!(uncertain(59.2437, 1.1432), "59.2 +- 1.1");
        assert_eq!(uncertain(59.2437, 0.0123), "59.244 +- 0.012");
        assert_eq!(uncertain_beside(59.2437, 1.1432, 0.02), "59.244 +- 1.143");
        assert_eq!(uncertain(-0.5, 0.25), "-0.500 +- 0.250");
        assert_eq!(uncertain(0.536, 700.0), "0.536 +- 700.000");
        assert_eq!(uncertain(55.030_279_105_309_21, 1.3e-13), "5.503027910531e1 +- 1.3e-13");
        assert_eq!(uncertain(3.21e-15, 1.1e-16), "3.21e-15 +- 1.1e-16");
        assert_eq!(uncertain(3.214e20, 1.1e18), "3.214e20 +- 1.1e18");
    }
}
