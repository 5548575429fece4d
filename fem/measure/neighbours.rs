//! Noise by the differences of neighbouring rows.

/// Estimates σ from second differences of neighbouring rows, (rᵢ₋₁ − 2rᵢ + rᵢ₊₁)²/6, which are free of every
/// trend that is straight over three rows. σ is never zero: residuals that are all alike leave their own
/// round-off.
pub fn of_neighbours(residuals: &[f64]) -> f64 {
    of_neighbours_alike(residuals, |_, _| true)
}

/// The same of neighbours that are `alike`, by their row numbers: where a pass ends and another begins, rows
/// that follow each other are no neighbours.
pub fn of_neighbours_alike(residuals: &[f64], alike: impl Fn(usize, usize) -> bool) -> f64 {
    let second = |i: usize| (residuals[i] - 2.0 * residuals[i + 1] + residuals[i + 2]).powi(2) / 6.0;
    let is_one_pass = |i: &usize| alike(*i, i + 1) && alike(i + 1, i + 2);
    let mut squares: Vec<f64> = (0..residuals.len().saturating_sub(2)).filter(is_one_pass).map(second).collect();
    let largest = residuals.iter().fold(0.0f64, |m, r| m.max(r.abs()));
    let floor = (1e-12 * largest).max(1e-15);
    if squares.is_empty() {
        return largest.max(floor);
    }
    // Steps between parts or set-ups show as outliers: the median of χ²₁ is 0.4549 of its mean.
    squares.sort_unstable_by(f64::total_cmp);
    (squares[squares.len() / 2] / 0.4549).sqrt().max(floor)
}
