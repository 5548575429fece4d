//! Arcs of G2 and G3 in their plane: of a lathe the part lies from left to right and the tool above it, of a mill it is
//! seen from above.

use std::f64::consts::TAU;

/// A point of the plane, m: to the right, and upwards.
pub type Point = [f64; 2];

/// How far straight pieces lie off an arc, m.
const OFF: f64 = 1e-8;
/// Most pieces of an arc.
const MOST: f64 = 20_000.0;
/// How much farther one end may be from the centre than the other, m: what controls let pass.
const UNEQUAL: f64 = 30e-6;

/// The centre of the arc of a radius; a negative one means the long way round. `None` where no circle of it meets both
/// ends.
pub fn centre(from: Point, to: Point, radius: f64, is_clockwise: bool) -> Option<Point> {
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let chord = dx.hypot(dy);
    let height = radius * radius - 0.25 * chord * chord;
    // Ends are written to the increment, so that a half circle may seem a little too wide.
    if chord <= 0.0 || height < -chord * UNEQUAL {
        return None;
    }
    let side = if is_clockwise == (radius > 0.0) { -1.0 } else { 1.0 };
    let off = side * height.max(0.0).sqrt() / chord;
    Some([from[0] + 0.5 * dx - off * dy, from[1] + 0.5 * dy + off * dx])
}

/// Whether both ends are as far from the centre as one radius lets them be.
pub fn is_round(from: Point, to: Point, centre: Point) -> bool {
    let [a, b] = [from, to].map(|point| polar(point, centre).1);
    a > 0.0 && b > 0.0 && (a - b).abs() <= UNEQUAL
}

/// Angle and distance of a point from a centre.
pub fn polar(point: Point, centre: Point) -> (f64, f64) {
    let (dx, dy) = (point[0] - centre[0], point[1] - centre[1]);
    (dy.atan2(dx), dx.hypot(dy))
}

/// The angle from one to another in the sense of an arc; from a place to itself it is the whole circle.
pub fn turned(start: f64, end: f64, is_clockwise: bool) -> f64 {
    let turned = if is_clockwise { (start - end).rem_euclid(TAU) } else { (end - start).rem_euclid(TAU) };
    if turned == 0.0 { TAU } else { turned }
}

/// Points along an arc, its ends among them.
pub fn points(from: Point, to: Point, centre: Point, is_clockwise: bool) -> Vec<Point> {
    let ((start, first), (end, last)) = (polar(from, centre), polar(to, centre));
    let turned = turned(start, end, is_clockwise);
    let piece = 2.0 * (1.0 - (OFF / first.max(OFF)).min(1.0)).acos();
    let count = (turned / piece).ceil().clamp(1.0, MOST) as usize;
    let point = |i: usize| match i {
        0 => from,
        i if i == count => to,
        i => {
            let share = i as f64 / count as f64;
            let angle = start + share * if is_clockwise { -turned } else { turned };
            let radius = first + share * (last - first);
            [centre[0] + radius * angle.cos(), centre[1] + radius * angle.sin()]
        }
    };
    (0..=count).map(point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A fillet toward a shoulder: the tool comes along the part to the left and goes up, around a centre above the
    /// part.
    #[test]
    fn an_arc_turns_as_it_is_told() {
        let (from, to) = ([0.0, 20e-3], [-1e-3, 21e-3]);
        for (radius, is_clockwise, x, r) in [
            (1e-3, true, 0.0, 21e-3),
            (1e-3, false, -1e-3, 20e-3),
            (-1e-3, false, 0.0, 21e-3),
            (-1e-3, true, -1e-3, 20e-3),
        ] {
            let centre = centre(from, to, radius, is_clockwise).unwrap();
            assert!(
                (centre[0] - x).abs() < 1e-12 && (centre[1] - r).abs() < 1e-12,
                "{radius} {is_clockwise} {centre:?}"
            );
            assert!(is_round(from, to, centre));
            let middle = points(from, to, centre, is_clockwise);
            let middle = middle[middle.len() / 2];
            // The short way lies within the square of both ends, the long way beyond it.
            let is_within = middle[0] <= 0.0 && middle[0] >= -1e-3;
            assert_eq!(is_within, radius > 0.0, "{radius} {is_clockwise} {middle:?}");
        }
        assert!(centre(from, to, 0.5e-3, true).is_none());
        assert!(!is_round(from, to, [0.0, 21.1e-3]));
    }
}
