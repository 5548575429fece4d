//! Quadrature over the reference triangle (0,0)–(1,0)–(0,1), the reference square [−1, 1]² and the line [−1,
//! 1].

/// A quadrature point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Reference coordinates (ξ, η).
    pub at: [f64; 2],
    /// Weight; the weights add up to the reference area (triangle ½, square 4).
    pub weight: f64,
}

const fn point(xi: f64, eta: f64, weight: f64) -> Point {
    Point { at: [xi, eta], weight }
}

/// Middles of the sides' joins to the corners: exact to degree 2 (Strang and Fix 1973).
pub const TRIANGLE_3: [Point; 3] = [
    point(1.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0),
    point(2.0 / 3.0, 1.0 / 6.0, 1.0 / 6.0),
    point(1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0),
];

const A: f64 = 0.445_948_490_915_964_9;
const WA: f64 = 0.223_381_589_678_011_47 / 2.0;
const B: f64 = 0.091_576_213_509_770_74;
const WB: f64 = 0.109_951_743_655_321_87 / 2.0;

/// Exact to degree 4 (Dunavant 1985, six points).
pub const TRIANGLE_6: [Point; 6] = [
    point(A, A, WA),
    point(1.0 - 2.0 * A, A, WA),
    point(A, 1.0 - 2.0 * A, WA),
    point(B, B, WB),
    point(1.0 - 2.0 * B, B, WB),
    point(B, 1.0 - 2.0 * B, WB),
];

/// 1/√3.
const G2: f64 = 0.577_350_269_189_625_7;
/// √(3/5).
const G3: f64 = 0.774_596_669_241_483_4;

/// Gauss 2 × 2: exact to degree 3 in each direction.
pub const SQUARE_4: [Point; 4] = [point(-G2, -G2, 1.0), point(G2, -G2, 1.0), point(G2, G2, 1.0), point(-G2, G2, 1.0)];

const SIDE: f64 = 5.0 / 9.0;
const MIDDLE: f64 = 8.0 / 9.0;

/// Gauss 3 × 3: exact to degree 5 in each direction.
pub const SQUARE_9: [Point; 9] = [
    point(-G3, -G3, SIDE * SIDE),
    point(0.0, -G3, MIDDLE * SIDE),
    point(G3, -G3, SIDE * SIDE),
    point(-G3, 0.0, SIDE * MIDDLE),
    point(0.0, 0.0, MIDDLE * MIDDLE),
    point(G3, 0.0, SIDE * MIDDLE),
    point(-G3, G3, SIDE * SIDE),
    point(0.0, G3, MIDDLE * SIDE),
    point(G3, G3, SIDE * SIDE),
];

/// Gauss on [−1, 1], (s, weight): exact to degree 5.
pub const LINE_3: [(f64, f64); 3] = [(-G3, SIDE), (0.0, MIDDLE), (G3, SIDE)];

/// Gauss on [−1, 1], (s, weight): exact to degree 9.
pub const LINE_5: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_08),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.0, 128.0 / 225.0),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
    (0.906_179_845_938_664, 0.236_926_885_056_189_08),
];

#[cfg(test)]
mod tests {
    use super::*;

    /// Σ w ξᵖ ηᵠ.
    fn moment(points: &[Point], p: i32, q: i32) -> f64 {
        points.iter().map(|point| point.weight * point.at[0].powi(p) * point.at[1].powi(q)).sum()
    }

    fn line_moment(p: i32) -> f64 {
        if p % 2 == 0 { 2.0 / f64::from(p + 1) } else { 0.0 }
    }

    #[test]
    fn triangles_are_exact_to_their_degree_and_no_further() {
        let factorial = |n: i32| (1..=n).map(f64::from).product::<f64>();
        for (points, degree) in [(&TRIANGLE_3[..], 2), (&TRIANGLE_6[..], 4)] {
            let error = |p, q| moment(points, p, q) - factorial(p) * factorial(q) / factorial(p + q + 2);
            for p in 0..=degree {
                for q in 0..=degree - p {
                    assert!(error(p, q).abs() < 1e-15, "degree {degree}: {p} {q}");
                }
            }
            assert!((0..=degree + 1).any(|p| error(p, degree + 1 - p).abs() > 1e-5));
        }
    }

    #[test]
    fn squares_and_lines_are_exact_to_their_degree_and_no_further() {
        for (points, degree) in [(&SQUARE_4[..], 3), (&SQUARE_9[..], 5)] {
            for p in 0..=degree {
                for q in 0..=degree {
                    let error = moment(points, p, q) - line_moment(p) * line_moment(q);
                    assert!(error.abs() < 1e-14, "degree {degree}: {p} {q}");
                }
            }
            assert!((moment(points, degree + 1, 0) - 2.0 * line_moment(degree + 1)).abs() > 1e-3);
        }
        for (points, degree) in [(&LINE_3[..], 5), (&LINE_5[..], 9)] {
            let error = |p| points.iter().map(|(s, w)| w * f64::powi(*s, p)).sum::<f64>() - line_moment(p);
            assert!((0..=degree).all(|p| error(p).abs() < 1e-14));
            assert!(error(degree + 1).abs() > 1e-4);
        }
    }
}
