//! Fewer points with the same picture: what lies behind a pixel that is drawn already makes a page heavy and is not seen.

use std::collections::HashSet;

/// Points from which a line or a cloud of dots is thinned: fewer weigh nothing.
pub const FROM: usize = 4000;

/// Pixels between places at which values can be asked for.
pub const APART: f64 = 3.0;

/// Width of a column within which points follow each other unseen, pixels: a page is shown at twice its size at most.
const COLUMN: f64 = 0.5;

/// The points of a line, of those that follow each other within a column the first, the lowest, the highest and the last: what
/// is drawn is the same (Jugel et al., M4: a visualization-oriented time series data aggregation, VLDB 2014).
pub fn thinned(points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    if points.len() <= FROM {
        return points;
    }
    let column = |[x, y]: &[f64; 2]| (x.is_finite() && y.is_finite()).then(|| (x / COLUMN).floor() as i64);
    let mut left = Vec::new();
    for run in points.chunk_by(|a, b| column(a) == column(b)) {
        let by_height = |a: &usize, b: &usize| run[*a][1].total_cmp(&run[*b][1]);
        let ends = [(0..run.len()).min_by(by_height), (0..run.len()).max_by(by_height)];
        let mut kept: Vec<usize> = ends.into_iter().flatten().chain([0, run.len() - 1]).collect();
        kept.sort_unstable();
        kept.dedup();
        left.extend(kept.into_iter().map(|i| run[i]));
    }
    left
}

/// What is drawn already, by its pixels.
#[derive(Default)]
pub struct Drawn(HashSet<Vec<i32>>);

impl Drawn {
    /// Whether something with these places, pixels, is not drawn yet; it is then.
    pub fn is_new(&mut self, places: &[f64]) -> bool {
        self.0.insert(places.iter().map(|own| own.round() as i32).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_picture_of_a_long_line_is_that_of_all_its_points() {
        let all: Vec<[f64; 2]> = (0..200_000)
            .map(|i| {
                let x = f64::from(i) / 400.0;
                [x, 200.0 + 90.0 * (0.05 * x).sin() + 40.0 * f64::from((i * 7919) % 101) / 101.0]
            })
            .collect();
        let few = thinned(all.clone());
        assert!(few.len() <= 4 * 1000 && few.first() == all.first() && few.last() == all.last(), "{}", few.len());
        // Each column reaches as far down and up.
        let reach = |points: &[[f64; 2]]| {
            let mut ends = vec![[f64::INFINITY, f64::NEG_INFINITY]; 1000];
            for [x, y] in points {
                let own = &mut ends[(x / COLUMN) as usize];
                *own = [own[0].min(*y), own[1].max(*y)];
            }
            ends
        };
        assert_eq!(reach(&few), reach(&all));
        assert_eq!(thinned(all[..FROM].to_vec()).len(), FROM);
        // A gap stays one.
        let mut broken = all;
        broken[100_000] = [f64::NAN; 2];
        assert_eq!(thinned(broken).iter().filter(|[x, _]| x.is_nan()).count(), 1);
    }
}
