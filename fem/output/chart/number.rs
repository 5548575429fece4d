//! Numbers as figures and pages write them.

/// A number to five digits, without zeros that say nothing.
pub fn number(value: f64) -> String {
    if !value.is_finite() {
        return "unknown".into();
    }
    let short: f64 = format!("{value:.4e}").parse().unwrap_or(value);
    match short.abs() {
        a if a != 0.0 && !(1e-4..1e7).contains(&a) => minus(format!("{short:e}")),
        _ => minus(format!("{short}")),
    }
}

/// A minus sign in the place of a hyphen, and none before zero.
pub fn minus(text: String) -> String {
    match text.strip_prefix('-') {
        Some(zero) if zero.chars().all(|c| "0.".contains(c)) => zero.to_string(),
        Some(rest) => format!("\u{2212}{rest}"),
        None => text,
    }
}

/// Largest of 1, 2 and 5 times a power of ten that is not above `value`.
pub fn round_below(value: f64) -> f64 {
    let power = 10f64.powf(value.log10().floor());
    let digit = value / power;
    // The comparison allows for round-off, so that 2 stays 2.
    power * [5.0, 2.0].into_iter().find(|d| digit * (1.0 + 1e-12) >= *d).unwrap_or(1.0)
}

/// Writes a round number with its thousands apart.
pub fn grouped(value: f64) -> String {
    if value < 1.0 {
        return format!("{value}");
    }
    let digits = format!("{value:.0}");
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i) % 3 == 0 {
            text.push('\u{202f}');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        for (value, text) in [
            (12.345678, "12.346"),
            (-0.5, "\u{2212}0.5"),
            (0.0, "0"),
            (-0.0, "0"),
            (1234567.0, "1234600"),
            (2e-9, "2e-9"),
        ] {
            assert_eq!(number(value), text);
        }
    }

    #[test]
    fn round_numbers_are_not_above() {
        for (value, round) in [(2.0, 2.0), (1.99, 1.0), (4.9e3, 2e3), (5.0e-7, 5e-7), (9.99, 5.0)] {
            assert!((round_below(value) / round - 1.0).abs() < 1e-12, "{value}");
        }
    }
}
