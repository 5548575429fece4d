//! A mill's control: a program in, the way of its cutter out.

use crate::words::{PARTS, bare, mm, words};

/// A motion: whether it cuts, and where it begins and ends (X, Y, Z), in parts of a millimetre; of an arc its centre
/// (X, Y) in mm and whether it turns clockwise seen from above.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    pub line: usize,
    pub cuts: bool,
    pub from: [i128; 3],
    pub to: [i128; 3],
    pub arc: Option<([f64; 2], bool)>,
}

/// The motions of a program, from where it first knows all of its axes.
pub fn motions(text: &[u8]) -> Vec<Motion> {
    let (mut all, mut code, mut is_absolute, mut inch) = (Vec::new(), 0, true, false);
    let mut at: [Option<i128>; 3] = [None; 3];
    for (number, line) in text.split(|byte| *byte == b'\n').enumerate() {
        let line = bare(line);
        if line.starts_with(['%', 'O']) {
            continue;
        }
        let words = words(&line);
        let of = |letter: char| words.iter().find(|own| own.0 == letter).map(|own| own.1);
        let codes: Vec<i128> = words.iter().filter(|own| own.0 == 'G').map(|own| own.1 * 10 / PARTS).collect();
        for order in &codes {
            match order {
                0 | 10 | 20 | 30 => code = *order,
                200 | 210 => inch = *order == 200,
                900 | 910 => is_absolute = *order == 900,
                _ => {}
            }
        }
        // The length of a new tool is another; a way to the machine's places leads nobody knows where.
        if codes.contains(&430) {
            at[2] = None;
        }
        if of('M') == Some(6 * PARTS) || codes.contains(&280) {
            at = [None; 3];
        }
        let path = ['X', 'Y', 'Z'].map(of);
        if codes.contains(&40) || codes.contains(&280) || path == [None; 3] {
            continue;
        }
        let length = |size: i128| if inch { size * 254 / 10 } else { size };
        let before = at;
        for (at, word) in at.iter_mut().zip(path) {
            let Some(word) = word.map(length) else { continue };
            *at = if is_absolute { Some(word) } else { at.map(|at| at + word) };
        }
        let (cuts, is_round) = (code != 0, code >= 20);
        match (before, at) {
            ([Some(x0), Some(y0), Some(z0)], [Some(x), Some(y), Some(z)]) => {
                let arc = is_round.then(|| {
                    let lengths = ['I', 'J', 'R'].map(|letter| of(letter).map(|size| mm(length(size))));
                    (centre([mm(x0), mm(y0)], [mm(x), mm(y)], lengths, code == 20), code == 20)
                });
                all.push(Motion { line: number + 1, cuts, from: [x0, y0, z0], to: [x, y, z], arc });
            }
            _ => assert!(!cuts, "a cut from nowhere: {line}"),
        }
    }
    all
}

/// The centre of an arc: from its start by I and J, or by R where the short way round turns as it should.
fn centre(from: [f64; 2], to: [f64; 2], [i, j, r]: [Option<f64>; 3], clockwise: bool) -> [f64; 2] {
    let Some(r) = r else { return [from[0] + i.unwrap_or(0.0), from[1] + j.unwrap_or(0.0)] };
    let (middle, way) = ([(from[0] + to[0]) / 2.0, (from[1] + to[1]) / 2.0], [to[0] - from[0], to[1] - from[1]]);
    let half = way[0].hypot(way[1]) / 2.0;
    let off = (r * r - half * half).max(0.0).sqrt() / (2.0 * half);
    // Clockwise the centre lies on the right of the way.
    let side = if clockwise { off } else { -off };
    [middle[0] + side * way[1], middle[1] - side * way[0]]
}

/// The share of a motion at which the middle of the cutter passes a place (mm), if it does to the tenth of a
/// micrometre.
fn passes(motion: &Motion, [x, y]: [f64; 2]) -> Option<f64> {
    let [from, to] = [motion.from, motion.to].map(|spot| [mm(spot[0]), mm(spot[1])]);
    match motion.arc {
        None => {
            let way = [to[0] - from[0], to[1] - from[1]];
            let square = way[0] * way[0] + way[1] * way[1];
            let share = ((x - from[0]) * way[0] + (y - from[1]) * way[1]) / square;
            let off = ((x - from[0]) * way[1] - (y - from[1]) * way[0]).abs() / square.sqrt();
            (square > 0.0 && off < 1e-4 && (-1e-9..=1.0 + 1e-9).contains(&share)).then_some(share)
        }
        Some((centre, clockwise)) => {
            let polar = |spot: [f64; 2]| {
                let (dx, dy) = (spot[0] - centre[0], spot[1] - centre[1]);
                (if clockwise { -dy.atan2(dx) } else { dy.atan2(dx) }, dx.hypot(dy))
            };
            let ((start, radius), (end, _), (angle, own)) = (polar(from), polar(to), polar([x, y]));
            let around = |angle: f64| (angle - start).rem_euclid(std::f64::consts::TAU);
            let whole = if around(end) == 0.0 { std::f64::consts::TAU } else { around(end) };
            ((own - radius).abs() < 1e-4 && around(angle) <= whole).then(|| around(angle) / whole)
        }
    }
}

/// The height (mm) that the middle of the cutter leaves at a place (mm) that it passes, and the line of the last cut
/// that reaches it.
pub fn height(motions: &[Motion], place: [f64; 2]) -> Option<(f64, usize)> {
    let mut least: Option<(f64, usize)> = None;
    for motion in motions.iter().filter(|motion| motion.cuts) {
        let Some(share) = passes(motion, place) else { continue };
        let [from, to] = [motion.from, motion.to].map(|spot| mm(spot[2]));
        let z = from + share * (to - from);
        if least.is_none_or(|(other, _)| z <= other + 1e-4) {
            least = Some((z, motion.line));
        }
    }
    least
}
