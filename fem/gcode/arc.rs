//! Arcs of G2 and G3 in the plane of a lathe, the part lying from left to right and the tool above it.

use std::f64::consts::TAU;

use super::spot::Spot;

/// How far straight pieces lie off an arc, m.
const OFF: f64 = 1e-8;
/// Most pieces of an arc.
const MOST: f64 = 20_000.0;
/// How much farther one end may be from the centre than the other, m: what controls let pass.
const UNEQUAL: f64 = 30e-6;

/// The centre of the arc of a radius; a negative one means the long way round. `None` where no circle of it meets both ends.
pub fn centre(from: Spot, to: Spot, radius: f64, is_clockwise: bool) -> Option<Spot> {
    let (dx, dr) = (to.x - from.x, to.r - from.r);
    let chord = dx.hypot(dr);
    let height = radius * radius - 0.25 * chord * chord;
    // Ends are written to the increment, so that a half circle may seem a little too wide.
    if chord <= 0.0 || height < -chord * UNEQUAL {
        return None;
    }
    let side = if is_clockwise == (radius > 0.0) { -1.0 } else { 1.0 };
    let off = side * height.max(0.0).sqrt() / chord;
    Some(Spot { x: from.x + 0.5 * dx - off * dr, r: from.r + 0.5 * dr + off * dx })
}

/// Whether both ends are as far from the centre as one radius lets them be.
pub fn is_round(from: Spot, to: Spot, centre: Spot) -> bool {
    let [a, b] = [from, to].map(|spot| (spot.x - centre.x).hypot(spot.r - centre.r));
    a > 0.0 && b > 0.0 && (a - b).abs() <= UNEQUAL
}

/// Spots along an arc, its ends among them.
pub fn spots(from: Spot, to: Spot, centre: Spot, is_clockwise: bool) -> Vec<Spot> {
    let polar =
        |spot: Spot| ((spot.r - centre.r).atan2(spot.x - centre.x), (spot.x - centre.x).hypot(spot.r - centre.r));
    let ((start, first), (end, last)) = (polar(from), polar(to));
    let turned = if is_clockwise { (start - end).rem_euclid(TAU) } else { (end - start).rem_euclid(TAU) };
    let turned = if turned == 0.0 { TAU } else { turned };
    let piece = 2.0 * (1.0 - (OFF / first.max(OFF)).min(1.0)).acos();
    let count = (turned / piece).ceil().clamp(1.0, MOST) as usize;
    let spot = |i: usize| match i {
        0 => from,
        i if i == count => to,
        i => {
            let share = i as f64 / count as f64;
            let angle = start + share * if is_clockwise { -turned } else { turned };
            let radius = first + share * (last - first);
            Spot { x: centre.x + radius * angle.cos(), r: centre.r + radius * angle.sin() }
        }
    };
    (0..=count).map(spot).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(x: f64, r: f64) -> Spot {
        Spot { x, r }
    }

    /// A fillet toward a shoulder: the tool comes along the part to the left and goes up, around a centre above the part.
    #[test]
    fn an_arc_turns_as_it_is_told() {
        let (from, to) = (at(0.0, 20e-3), at(-1e-3, 21e-3));
        for (radius, is_clockwise, x, r) in [
            (1e-3, true, 0.0, 21e-3),
            (1e-3, false, -1e-3, 20e-3),
            (-1e-3, false, 0.0, 21e-3),
            (-1e-3, true, -1e-3, 20e-3),
        ] {
            let centre = centre(from, to, radius, is_clockwise).unwrap();
            assert!((centre.x - x).abs() < 1e-12 && (centre.r - r).abs() < 1e-12, "{radius} {is_clockwise} {centre:?}");
            assert!(is_round(from, to, centre));
            let middle = spots(from, to, centre, is_clockwise);
            let middle = middle[middle.len() / 2];
            // The short way lies within the square of both ends, the long way beyond it.
            let is_within = middle.x <= 0.0 && middle.x >= -1e-3;
            assert_eq!(is_within, radius > 0.0, "{radius} {is_clockwise} {middle:?}");
        }
        assert!(centre(from, to, 0.5e-3, true).is_none());
        assert!(!is_round(from, to, at(0.0, 21.1e-3)));
    }
}
