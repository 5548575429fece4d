//! Numbers as they are written: a new one looks like the old one.

use super::workpiece::Increment;

/// More decimals than a number has that counts in metres and is exact to its last bit.
const MOST_DECIMALS: usize = 17;

/// A number, a whole number of increments, written as another one is: with as many decimals, or as many more as it needs, up to
/// those of the increment; with its sign, its zeros in front, and its point.
pub fn like(old: &str, value: f64, increment: Increment) -> String {
    let (is_signed, digits) = (old.starts_with('+'), old.trim_start_matches(['+', '-']));
    let (whole, decimals) = digits.split_once('.').unwrap_or((digits, ""));
    let written = decimals.len().min(MOST_DECIMALS);
    let is_written = |decimals: usize| {
        let scaled = value * 10f64.powi(decimals as i32);
        (scaled - scaled.round()).abs() < 1e-4
    };
    let most = written.max(increment.decimals);
    let needed = (written..most).find(|decimals| is_written(*decimals)).unwrap_or(most);
    let mut text = format!("{:.needed$}", value.abs());
    if needed == 0 && digits.contains('.') {
        text.push('.');
    }
    let length = text.find('.').unwrap_or(text.len());
    if whole.is_empty() && needed > 0 && text.starts_with("0.") {
        text.remove(0);
    } else if whole.starts_with('0') && whole.len() > length {
        text.insert_str(0, &"0".repeat(whole.len() - length));
    }
    let is_nothing = text.bytes().all(|byte| matches!(byte, b'0' | b'.'));
    match value < 0.0 && !is_nothing {
        true => format!("-{text}"),
        false if is_signed => format!("+{text}"),
        false => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_looks_like_the_one_before() {
        let fine = Increment { size: 1e-3, decimals: 3 };
        for (old, value, new) in [
            ("40.", 40.012, "40.012"),
            ("40.", 40.0, "40."),
            ("40", 41.0, "41"),
            ("40", 40.01, "40.01"),
            ("40.00", 40.01, "40.01"),
            ("40.00", 40.012, "40.012"),
            ("40.0000", 40.012, "40.0120"),
            ("+40.0", 39.98, "+39.98"),
            ("-.5", -0.498, "-.498"),
            (".5", 0.498, ".498"),
            (".5", 1.002, "1.002"),
            ("0.5", 0.498, "0.498"),
            ("0040.5", 39.5, "0039.5"),
            ("-0.001", 0.0, "0.000"),
            ("-10", 10.5, "10.5"),
            (&*format!("0.{}", "0".repeat(70_000)), 0.5, "0.50000000000000000"),
        ] {
            assert_eq!(like(old, value, fine), new, "{old} {value}");
        }
    }
}
