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
}
