//! A lathe's control: a program in, the way of its tool out.

use crate::words::{PARTS, bare, mm, words};

/// A motion: whether it cuts, and where it begins and ends (along Z, radius), in parts of a millimetre; of an arc its centre.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    pub line: usize,
    pub cuts: bool,
    pub from: (i128, i128),
    pub to: (i128, i128),
    /// Centre (Z, radius) in mm, and whether it turns clockwise seen with Z to the right and X up.
    pub arc: Option<((f64, f64), bool)>,
}

/// The motions of a program, X being a diameter at first or not.
pub fn motions(text: &[u8], mut is_diameter: bool) -> Vec<Motion> {
    let (mut all, mut code, mut is_absolute, mut inch) = (Vec::new(), 0, true, false);
    let (mut z, mut x) = (None::<i128>, None::<i128>);
    for (number, line) in text.split(|byte| *byte == b'\n').enumerate() {
        let line = bare(line);
        if line.starts_with('%') {
            continue;
        }
        let words = words(&line);
        let codes: Vec<i128> = words.iter().filter(|own| own.0 == 'G').map(|own| own.1 * 10 / PARTS).collect();
        for order in &codes {
            match order {
                0 | 10 | 20 | 30 => code = *order,
                70 | 80 => is_diameter = *order == 70,
                200 | 210 => inch = *order == 200,
                900 | 910 => is_absolute = *order == 900,
                _ => {}
            }
        }
        let dwells = codes.contains(&40);
        if codes.contains(&280) || words.iter().any(|own| own.0 == 'T') {
            (z, x) = (None, None);
        }
        if dwells || codes.contains(&280) || codes.contains(&500) {
            continue;
        }
        // A tenth of 25.4 at first, so that nothing is lost.
        let length = |size: i128| if inch { size * 254 / 10 } else { size };
        let across = |size: i128| if is_diameter { length(size) / 2 } else { length(size) };
        let of = |letter: char| words.iter().find(|own| own.0 == letter).map(|own| own.1);
        let before = (z, x);
        x = match (of('X'), of('U')) {
            (Some(to), _) if is_absolute => Some(across(to)),
            (by, None) | (None, by) => by.map_or(x, |by| x.map(|x| x + across(by))),
            _ => panic!("{line}"),
        };
        z = match (of('Z'), of('W')) {
            (Some(to), _) if is_absolute => Some(length(to)),
            (by, None) | (None, by) => by.map_or(z, |by| z.map(|z| z + length(by))),
            _ => panic!("{line}"),
        };
        if !words.iter().any(|own| "XZUW".contains(own.0)) {
            continue;
        }
        let (cuts, is_round) = (code != 0, code >= 20);
        match (before, (z, x)) {
            ((Some(z0), Some(x0)), (Some(z), Some(x))) => {
                let arc = is_round.then(|| {
                    let lengths = ['I', 'K', 'R'].map(|letter| of(letter).map(|size| mm(length(size))));
                    (centre((mm(z0), mm(x0)), (mm(z), mm(x)), lengths, code == 20), code == 20)
                });
                all.push(Motion { line: number + 1, cuts, from: (z0, x0), to: (z, x), arc });
            }
            _ => assert!(!cuts, "a cut from nowhere: {line}"),
        }
    }
    all
}

/// The centre of an arc: from its start by I and K, or by R where the short way round turns as it should.
fn centre(from: (f64, f64), to: (f64, f64), [i, k, r]: [Option<f64>; 3], clockwise: bool) -> (f64, f64) {
    let Some(r) = r else { return (from.0 + k.unwrap_or(0.0), from.1 + i.unwrap_or(0.0)) };
    let (middle, way) = (((from.0 + to.0) / 2.0, (from.1 + to.1) / 2.0), (to.0 - from.0, to.1 - from.1));
    let half = way.0.hypot(way.1) / 2.0;
    let off = (r * r - half * half).max(0.0).sqrt() / (2.0 * half);
    // Of both centres that beside which the tool passes on its left turns it clockwise: the part lies to the right of its way.
    let right = (middle.0 + off * way.1, middle.1 - off * way.0);
    let left = (middle.0 - off * way.1, middle.1 + off * way.0);
    if clockwise { right } else { left }
}

/// The radius (mm) that cuts leave at a place of Z (mm), and the line of the last that reaches it; `None` where nothing cuts.
pub fn surface(motions: &[Motion], z: f64) -> Option<(f64, usize)> {
    let mut least: Option<(f64, usize)> = None;
    for motion in motions.iter().filter(|motion| motion.cuts) {
        let ((z0, x0), (z1, x1)) = ((mm(motion.from.0), mm(motion.from.1)), (mm(motion.to.0), mm(motion.to.1)));
        if !(z0.min(z1)..=z0.max(z1)).contains(&z) || (z1 - z0).abs() < 1e-9 {
            continue;
        }
        let share = (z - z0) / (z1 - z0);
        let straight = x0 + share * (x1 - x0);
        let r = match motion.arc {
            None => straight,
            Some(((zc, xc), _)) => {
                let radius = (1.0 - share) * (z0 - zc).hypot(x0 - xc) + share * (z1 - zc).hypot(x1 - xc);
                let height = (radius * radius - (z - zc).powi(2)).max(0.0).sqrt();
                // Of both heights that on the side of the chord.
                if (xc + height - straight).abs() < (xc - height - straight).abs() { xc + height } else { xc - height }
            }
        };
        if least.is_none_or(|(other, _)| r <= other + 1e-4) {
            least = Some((r, motion.line));
        }
    }
    least
}
