//! Waves along a coordinate or along both of a pair: what goes up and down from level to level, which bins average out.

/// cos(πk(i + ½)/m) over the levels i of a coordinate with m of them, k = 1 … m − 1; along a pair the products of two such.
pub struct Waves {
    /// Cell of each row: a level, or a pair of levels.
    cell: Vec<usize>,
    cells: usize,
    waves: Vec<Wave>,
}

struct Wave {
    /// k along each coordinate: half periods.
    halves: Vec<usize>,
    /// Over the cells, of length one over the rows.
    values: Vec<f64>,
}

impl Waves {
    /// Over the levels of each row and how many levels there are, along one coordinate or two.
    pub fn new(along: &[(Vec<usize>, usize)]) -> Self {
        let rows = along.first().map_or(0, |a| a.0.len());
        let cell: Vec<usize> =
            (0..rows).map(|row| along.iter().fold(0, |c, (of, count)| c * count + of[row])).collect();
        let cells = along.iter().map(|a| a.1).product();
        let mut counts = vec![0.0; cells];
        cell.iter().for_each(|c| counts[*c] += 1.0);
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
        Self { cell, cells, waves: halves.into_iter().filter_map(wave).collect() }
    }

    /// The square of the largest coefficient, among how many, and its half periods; χ² with one degree of freedom by chance.
    pub fn largest(&self, z: &[f64], mean: f64) -> Option<(f64, usize, Vec<usize>)> {
        let mut sums = vec![0.0; self.cells];
        self.cell.iter().zip(z).for_each(|(c, z)| sums[*c] += z - mean);
        let square = |wave: &Wave| wave.values.iter().zip(&sums).map(|(v, s)| v * s).sum::<f64>().powi(2);
        let largest = self.waves.iter().map(|w| (square(w), w)).max_by(|a, b| a.0.total_cmp(&b.0))?;
        Some((largest.0, self.waves.len(), largest.1.halves.clone()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_alternates_is_seen_whole() {
        // Eight levels along one coordinate, nine along the other, ±1 in turn along the first: all of it in few waves, none along the second.
        let first: Vec<usize> = (0..72).map(|r| r / 9).collect();
        let second: Vec<usize> = (0..72).map(|r| r % 9).collect();
        let z: Vec<f64> = first.iter().map(|i| if i % 2 == 0 { 1.0 } else { -1.0 }).collect();
        let along = Waves::new(&[(first.clone(), 8)]).largest(&z, 0.0).unwrap();
        assert_eq!(along.2, [7]);
        assert!(along.0 > 0.75 * 72.0, "{}", along.0);
        assert!(Waves::new(&[(second.clone(), 9)]).largest(&z, 0.0).unwrap().0 < 1e-20);
        // A wave along both is seen by neither alone.
        let both: Vec<f64> = z
            .iter()
            .zip(&second)
            .map(|(z, j)| z * (std::f64::consts::PI * 3.0 * (*j as f64 + 0.5) / 9.0).cos())
            .collect();
        assert!(Waves::new(&[(first.clone(), 8)]).largest(&both, 0.0).unwrap().0 < 1e-20);
        let found = Waves::new(&[(first, 8), (second, 9)]).largest(&both, 0.0).unwrap();
        assert_eq!(found.2, [7, 3]);
    }
}
