//! Whether places go all around a body.

/// Smallest cosine between the outward directions of rows that belong to one line.
pub const BENT: f64 = 0.8;

/// Whether places in their order, by their outward directions, go all around, and not only there and back again.
pub fn goes_around<const N: usize>(outward: &[[f64; N]]) -> bool {
    let [first, .., last] = outward else { return false };
    let near = |a: &[f64; N], b: &[f64; N]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>() > BENT;
    outward.len() > 8 && near(first, last) && !near(first, &outward[outward.len() / 2])
}
