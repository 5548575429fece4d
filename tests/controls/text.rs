//! What interpreters share: a table looked up as controls do.

/// What stands at a place of a table of rising positions, linear between them; the ends hold beyond.
pub fn linear(table: &[(f64, f64)], at: f64) -> f64 {
    let (first, last) = (table[0], table[table.len() - 1]);
    if at <= first.0 {
        return first.1;
    }
    if at >= last.0 {
        return last.1;
    }
    let next = table.iter().position(|entry| entry.0 > at).unwrap();
    let ((a, va), (b, vb)) = (table[next - 1], table[next]);
    va + (vb - va) * (at - a) / (b - a)
}

/// The values of lines `KEY value`, or `KEY=value`, whose key begins so.
pub fn value_of(text: &str, key: &str) -> f64 {
    let line = text.lines().find(|line| line.starts_with(key)).unwrap_or_else(|| panic!("no {key} in {text}"));
    let rest = line[key.len()..].trim_start_matches(['=', ' ']);
    rest.split_whitespace().next().unwrap().parse().unwrap()
}
