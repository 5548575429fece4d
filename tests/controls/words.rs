//! Words of programs, as the manuals of controls have them, for the interpreters of lathes and mills.

/// Parts of a millimetre in which places are whole numbers: a hundred-millionth of a micrometre, and tenths of a millionth of an
/// inch come out even.
pub const PARTS: i128 = 100_000_000_000;

pub fn mm(parts: i128) -> f64 {
    parts as f64 / PARTS as f64
}

/// A line without its comments, in capitals and without blanks.
pub fn bare(line: &[u8]) -> String {
    let (mut kept, mut is_comment) = (String::new(), false);
    for byte in line {
        match byte {
            b'(' => is_comment = true,
            b')' => is_comment = false,
            b';' if !is_comment => break,
            _ if is_comment || !byte.is_ascii_graphic() => {}
            byte => kept.push(char::from(*byte).to_ascii_uppercase()),
        }
    }
    kept
}

/// Letters with their numbers, in parts of one.
pub fn words(line: &str) -> Vec<(char, i128)> {
    let mut all = Vec::new();
    let mut rest = line.trim_start_matches('/');
    rest = rest.trim_start_matches(|c: char| c.is_ascii_digit());
    while let Some(letter) = rest.chars().next() {
        let end = rest[1..].find(|c: char| c.is_ascii_alphabetic()).map_or(rest.len(), |at| at + 1);
        let number = &rest[1..end];
        let (whole, decimals) = number.split_once('.').unwrap_or((number, ""));
        let digits = format!("{}{decimals:0<11}", whole.trim_start_matches(['+', '-']));
        let size: i128 = digits.parse().unwrap_or_else(|_| panic!("{line}: {number}"));
        all.push((letter, if whole.starts_with('-') { -size } else { size }));
        rest = &rest[end..];
    }
    all
}

/// A program without the numbers of words with some letters, but for those in comments.
pub fn without(text: &[u8], letters: &str) -> Vec<u8> {
    let (mut kept, mut is_comment, mut is_own) = (Vec::new(), false, false);
    for byte in text {
        match byte {
            b'\n' | b'\r' => (is_comment, is_own) = (false, false),
            b';' | b'(' => is_comment = true,
            b')' => is_comment = false,
            _ => {}
        }
        if !is_comment && byte.is_ascii_alphabetic() {
            is_own = letters.contains(char::from(byte.to_ascii_uppercase()));
        }
        let is_number = byte.is_ascii_digit() || matches!(byte, b'.' | b'-' | b'+');
        if !(is_own && is_number && !is_comment) {
            kept.push(*byte);
        }
    }
    kept
}
