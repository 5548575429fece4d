//! Few straight lines through many points.

/// The points, by their positions, that straight lines must turn at so that none of the others (place, value; places rising) lies
/// farther off them than a tolerance; the ends are among them. Where two points have one place, both are.
///
/// Every line is as long as it can be from where the one before ended: the cone of slopes that pass all points so far within the
/// tolerance narrows until the next point lies outside of it.
pub fn knots(points: &[(f64, f64)], tolerance: f64) -> Vec<usize> {
    let last = points.len().saturating_sub(1);
    let mut kept: Vec<usize> = points.first().map(|_| 0).into_iter().collect();
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    let (mut start, mut next) = (0, 1);
    while next <= last {
        let (dx, dy) = (points[next].0 - points[start].0, points[next].1 - points[start].1);
        let is_jump = points[next].0 <= points[next - 1].0;
        let slope = dy / dx;
        if is_jump || slope < low || slope > high {
            kept.extend((start != next - 1).then_some(next - 1));
            start = next - 1;
            if is_jump {
                kept.push(next);
                (start, next) = (next, next + 1);
            }
            (low, high) = (f64::NEG_INFINITY, f64::INFINITY);
            continue;
        }
        low = low.max(slope - tolerance / dx);
        high = high.min(slope + tolerance / dx);
        next += 1;
    }
    kept.extend((start != last && last > 0).then_some(last));
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_point_lies_farther_off_than_the_tolerance() {
        let points: Vec<(f64, f64)> = (0..=200).map(|i| (f64::from(i), (f64::from(i) * 0.05).sin())).collect();
        for tolerance in [1e-3, 1e-2, 0.1] {
            let kept = knots(&points, tolerance);
            assert!(kept[0] == 0 && kept[kept.len() - 1] == 200 && kept.is_sorted());
            let worst = kept.windows(2).flat_map(|pair| {
                let (a, b) = (points[pair[0]], points[pair[1]]);
                points[pair[0]..pair[1]].iter().map(move |p| p.1 - a.1 - (b.1 - a.1) * (p.0 - a.0) / (b.0 - a.0))
            });
            let worst = worst.fold(0.0f64, |worst, off| worst.max(off.abs()));
            assert!(worst <= tolerance * (1.0 + 1e-9) && worst > 0.1 * tolerance, "{tolerance} {worst}");
        }
        // A half of the tolerance costs not much more than the root of two more lines.
        assert!(knots(&points, 5e-4).len() < 2 * knots(&points, 1e-3).len());
    }

    #[test]
    fn straight_lines_need_their_ends_alone_and_jumps_both_sides() {
        assert_eq!(knots(&[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)], 1e-9), [0, 2]);
        assert_eq!(knots(&[(0.0, 0.0), (1.0, 0.0), (1.0, 5.0), (2.0, 5.0)], 1e-9), [0, 1, 2, 3]);
        assert_eq!(knots(&[(0.0, 3.0)], 1.0), [0]);
        assert!(knots(&[], 1.0).is_empty());
    }
}
