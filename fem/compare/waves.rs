//! Waves along a coordinate or along both of a pair: they show what goes up and down from level to level,
//! which bins average out. There are half waves from end to end (discrete cosine transform), whole waves of
//! any phase, and whole waves at a single level of the other coordinate.

/// Waves cos(πk(i + ½)/m) over the m levels i of a coordinate, k = 1 … m − 1; along a pair the products of
/// two such.
pub struct Waves {
    /// Cell of each row: a level, or a pair of levels.
    cell: Vec<u8>,
    cells: usize,
    waves: Vec<Wave>,
    /// Cosine and sine of each whole wave, orthonormal.
    whole: Vec<[Wave; 2]>,
}

/// Wave with the largest coefficient.
#[derive(Clone, Debug, PartialEq)]
pub struct Largest {
    /// Square of its coefficient, or sum of both squares: χ² under the null hypothesis.
    pub square: f64,
    /// Degrees of freedom of that χ².
    pub freedom: f64,
    /// Number of waves among which it is the largest.
    pub among: usize,
    /// Half periods along each coordinate.
    pub halves: Vec<usize>,
}

struct Wave {
    /// Half periods k along each coordinate.
    halves: Vec<usize>,
    /// Values over the cells, of length one over the rows.
    values: Vec<f64>,
}

/// Most levels of a coordinate at whose single levels whole waves are sought.
const FEW: usize = 6;
/// Least relative length of a wave when others are taken out of it; below it the rows do not tell them
/// apart.
const DEPENDENT: f64 = 1e-3;

impl Waves {
    /// Makes the waves from the level of each row and the number of levels, along one coordinate or two.
    pub fn new(along: &[(Vec<u8>, usize)]) -> Self {
        let rows = along.first().map_or(0, |a| a.0.len());
        let of_row = |row: usize| along.iter().fold(0, |c, (of, count)| c * *count as u8 + of[row]);
        let cell: Vec<u8> = (0..rows).map(of_row).collect();
        let cells = along.iter().map(|a| a.1).product();
        let mut counts = vec![0.0; cells];
        cell.iter().for_each(|c| counts[usize::from(*c)] += 1.0);
        let mut halves: Vec<Vec<usize>> = vec![Vec::new()];
        for (_, count) in along {
            let more = |h: &Vec<usize>| (1..*count).map(|k| [&h[..], &[k]].concat()).collect::<Vec<_>>();
            halves = halves.iter().flat_map(more).collect();
        }
        let wave = |halves: Vec<usize>| {
            let value = |cell: usize| {
                let mut rest = cell;
                let parts = along.iter().zip(&halves).rev().map(|((_, count), k)| {
                    let level = rest % count;
                    rest /= count;
                    (std::f64::consts::PI * *k as f64 * (level as f64 + 0.5) / *count as f64).cos()
                });
                parts.product::<f64>()
            };
            let mut values: Vec<f64> = (0..cells).map(value).collect();
            let mean = values.iter().zip(&counts).map(|(v, n)| v * n).sum::<f64>() / rows.max(1) as f64;
            values.iter_mut().for_each(|v| *v -= mean);
            let length = values.iter().zip(&counts).map(|(v, n)| v * v * n).sum::<f64>().sqrt();
            // A wave that the rows do not resolve shows nothing.
            (length > 1e-6).then(|| {
                values.iter_mut().for_each(|v| *v /= length);
                Wave { halves, values }
            })
        };
        let waves = halves.into_iter().filter_map(wave).collect();
        Self { whole: whole(along, &counts), cell, cells, waves }
    }

    /// Finds the largest half wave and the largest whole wave.
    pub fn largest(&self, z: &[f64], mean: f64) -> impl Iterator<Item = Largest> {
        let mut sums = vec![0.0; self.cells];
        self.cell.iter().zip(z).for_each(|(c, z)| sums[usize::from(*c)] += z - mean);
        let square = |wave: &Wave| wave.values.iter().zip(&sums).map(|(v, s)| v * s).sum::<f64>().powi(2);
        let halves = self.waves.iter().map(|w| (square(w), w)).max_by(|a, b| a.0.total_cmp(&b.0));
        let whole = self.whole.iter().map(|[c, s]| (square(c) + square(s), c)).max_by(|a, b| a.0.total_cmp(&b.0));
        let among = self.waves.len() + self.whole.len();
        [(halves, 1.0), (whole, 2.0)].into_iter().filter_map(move |(largest, freedom)| {
            let (square, wave) = largest?;
            Some(Largest { square, freedom, among, halves: wave.halves.clone() })
        })
    }
}

/// Makes the whole waves along every coordinate, and at each level of the other coordinate where that has
/// few.
fn whole(along: &[(Vec<u8>, usize)], counts: &[f64]) -> Vec<[Wave; 2]> {
    let levels: Vec<usize> = along.iter().map(|a| a.1).collect();
    let level = |cell: usize, i: usize| cell / levels[i + 1..].iter().product::<usize>() % levels[i];
    let mut found = Vec::new();
    for i in 0..levels.len() {
        // Waves along one coordinate alone are tested with that coordinate, not with a pair.
        let others: Vec<Option<(usize, usize)>> = match levels.len() {
            1 => vec![None],
            _ if levels[1 - i] > FEW => continue,
            _ => (0..levels[1 - i]).map(|l| Some((1 - i, l))).collect(),
        };
        for other in others {
            let here = |cell: usize| other.is_none_or(|(j, l)| level(cell, j) == l);
            // A period spans at least two levels.
            for periods in 1..=(levels[i] - 1) / 2 {
                let angle = |cell: usize| std::f64::consts::TAU * (periods * level(cell, i)) as f64 / levels[i] as f64;
                let one = |part: fn(f64) -> f64| -> Vec<f64> {
                    (0..counts.len()).map(|c| if here(c) { part(angle(c)) } else { 0.0 }).collect()
                };
                let within: Vec<f64> = (0..counts.len()).map(|c| f64::from(here(c))).collect();
                let mut halves = vec![0; levels.len()];
                halves[i] = 2 * periods;
                if let Some([_, cosine, sine]) = orthonormal([within, one(f64::cos), one(f64::sin)], counts) {
                    let wave = |values| Wave { halves: halves.clone(), values };
                    found.push([wave(cosine), wave(sine)]);
                }
            }
        }
    }
    found
}

/// Orthonormalises by Gram and Schmidt over the rows; `None` where the rows do not tell the vectors apart.
fn orthonormal<const N: usize>(mut vectors: [Vec<f64>; N], counts: &[f64]) -> Option<[Vec<f64>; N]> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).zip(counts).map(|((a, b), n)| a * b * n).sum::<f64>();
    for i in 0..N {
        let whole = dot(&vectors[i], &vectors[i]).sqrt();
        let (before, rest) = vectors.split_at_mut(i);
        for other in before.iter() {
            let along = dot(other, &rest[0]);
            rest[0].iter_mut().zip(other).for_each(|(v, o)| *v -= along * o);
        }
        let length = dot(&rest[0], &rest[0]).sqrt();
        if length <= DEPENDENT * whole {
            return None;
        }
        rest[0].iter_mut().for_each(|v| *v /= length);
    }
    Some(vectors)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_alternates_is_seen_whole() {
        // Eight levels along one coordinate, nine along the other, ±1 in turn along the first: few waves
        // hold all of it, and none along the second.
        let first: Vec<u8> = (0..72).map(|r| r / 9).collect();
        let second: Vec<u8> = (0..72).map(|r| r % 9).collect();
        let z: Vec<f64> = first.iter().map(|i| if i % 2 == 0 { 1.0 } else { -1.0 }).collect();
        let along = Waves::new(&[(first.clone(), 8)]).largest(&z, 0.0).next().unwrap();
        assert_eq!(along.halves, [7]);
        assert!(along.square > 0.75 * 72.0, "{}", along.square);
        assert!(Waves::new(&[(second.clone(), 9)]).largest(&z, 0.0).next().unwrap().square < 1e-20);
        // A wave along both is seen by neither alone.
        let both: Vec<f64> = z
            .iter()
            .zip(&second)
            .map(|(z, j)| z * (std::f64::consts::PI * 3.0 * (f64::from(*j) + 0.5) / 9.0).cos())
            .collect();
        assert!(Waves::new(&[(first.clone(), 8)]).largest(&both, 0.0).next().unwrap().square < 1e-20);
        let found = Waves::new(&[(first, 8), (second, 9)]).largest(&both, 0.0).next().unwrap();
        assert_eq!(found.halves, [7, 3]);
    }

    #[test]
    fn a_whole_wave_is_seen_at_any_phase_and_at_one_level() {
        // Five waves around 24 places, at any phase, on all of three runs or on one of them.
        let (run, place): (Vec<u8>, Vec<u8>) = (0..72_u8).map(|r| (r / 24, r % 24)).unzip();
        for phase in [0.0, 0.7, 1.5] {
            let wave: Vec<f64> =
                place.iter().map(|i| (std::f64::consts::TAU * 5.0 * f64::from(*i) / 24.0 - phase).cos()).collect();
            let seen = Waves::new(&[(place.clone(), 24)]).largest(&wave, 0.0).nth(1).unwrap();
            assert_eq!(seen.halves, [10]);
            assert!((seen.square - 36.0).abs() < 1e-9);
            let one: Vec<f64> = wave.iter().zip(&run).map(|(w, r)| if *r == 1 { *w } else { 0.0 }).collect();
            let seen = Waves::new(&[(place.clone(), 24), (run.clone(), 3)]).largest(&one, 0.0).nth(1).unwrap();
            assert_eq!(seen.halves, [10, 0]);
            assert!((seen.square - 12.0).abs() < 1e-9);
        }
    }
}
