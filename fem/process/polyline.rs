//! Straight lines through points.

/// The value at `x` on straight lines through `count` points (place, value), places rising, of which that numbered `next` is the
/// first beyond `x`; beyond the ends that of the end, and 0 where there are no points.
pub fn on_lines(next: usize, count: usize, point: impl Fn(usize) -> (f64, f64), x: f64) -> f64 {
    match next {
        _ if count == 0 => 0.0,
        0 => point(0).1,
        next if next == count => point(next - 1).1,
        next => {
            let ((a, before), (b, after)) = (point(next - 1), point(next));
            before + (after - before) * (x - a) / (b - a)
        }
    }
}
