//! Numbers with so many decimals. What rounds to nothing has no sign.

/// Size from which a number has an exponent: nobody reads so many digits, and few of them are known.
const LARGE: f64 = 1e12;

/// A number with so many decimals.
pub fn fixed(value: f64, decimals: usize) -> String {
    if value.is_finite() && value.abs() >= LARGE {
        return format!("{value:.2e}");
    }
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.parse() == Ok(0.0) => digits.to_string(),
        _ => text,
    }
}

/// A number with so many decimals, and its sign, `+` where it rounds to nothing.
pub fn signed(value: f64, decimals: usize) -> String {
    let text = fixed(value, decimals);
    if text.starts_with('-') { text } else { format!("+{text}") }
}

/// Metres in millimetres with so many decimals, without zeros behind.
pub fn mm(m: f64, decimals: usize) -> String {
    trimmed(1e3 * m, decimals)
}

/// A number with so many decimals at most, without zeros behind.
pub fn trimmed(value: f64, decimals: usize) -> String {
    let text = fixed(value, decimals);
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_string(),
        false => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_has_no_sign() {
        assert_eq!([-0.4, -0.6, 0.4, 0.6, -0.0].map(|v| fixed(v, 0)), ["0", "-1", "0", "1", "0"]);
        assert_eq!([-0.00004, -0.00005001, 12.34567].map(|v| fixed(v, 4)), ["0.0000", "-0.0001", "12.3457"]);
        assert_eq!([-0.04, 0.04, -0.06, 0.06].map(|v| signed(v, 1)), ["+0.0", "+0.0", "-0.1", "+0.1"]);
        assert_eq!([0.12, 0.0, -4e-8, 1.00001].map(|m| mm(m, 3)), ["120", "0", "0", "1000.01"]);
        assert_eq!([1.5e15, -3.21e300].map(|v| fixed(v, 3)), ["1.50e15", "-3.21e300"]);
        assert_eq!(fixed(-f64::INFINITY, 2), "-inf".to_string());
    }
}
