//! Which cut makes the surface at a place: that with the smallest radius there, of equal ones the last.

use super::spot::Spot;
use super::steps::{Cut, Step};
use super::wanted::{SAME, Wanted};
use super::workpiece::Workpiece;

/// Radii nearer than this are equal, m: less than any increment.
const EQUAL: f64 = 0.2e-6;
/// Places at least over the pass.
const LEAST: usize = 400;
/// Where in an interval its two places stand, by which straight lines and parabolas are weighed exactly.
pub const GAUSS: [f64; 2] = [0.211_324_865_405_187_1, 0.788_675_134_594_812_9];

/// A place at which surfaces are looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// m.
    pub x: f64,
    /// Length for which it stands, m.
    pub weight: f64,
}

/// The surface that a program leaves at some places.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// At each place the step that makes it, by its position, and its radius, m.
    pub made: Vec<Option<(usize, f64)>>,
}

/// Places of the pass, two between any two ends of cuts, of stretches and of straight pieces of what is wanted.
pub fn samples(steps: &[Step], work: &Workpiece, wanted: &Wanted) -> Vec<Sample> {
    let Some((low, high)) = wanted.ends() else { return Vec::new() };
    let cuts = steps.iter().filter_map(|step| step.cut).flat_map(|cut| [cut.from.x, cut.to.x]);
    let stretches = work.stretches.iter().flat_map(|own| [own.from, own.to]);
    let nodes = wanted.between(low, high).into_iter().map(|node| node.0);
    let grid = (0..=LEAST).map(|i| low + (high - low) * i as f64 / LEAST as f64);
    let mut borders: Vec<f64> = cuts.chain(stretches).chain(nodes).chain(grid).collect();
    borders.retain(|x| (low..=high).contains(x));
    borders.sort_unstable_by(f64::total_cmp);
    borders.dedup_by(|a, b| *a - *b < SAME);
    let two = |pair: &[f64]| {
        let length = pair[1] - pair[0];
        GAUSS.map(|at| Sample { x: pair[0] + at * length, weight: 0.5 * length })
    };
    borders.windows(2).flat_map(two).collect()
}

impl Surface {
    /// The surface at some places, rising.
    pub fn of(steps: &[Step], places: &[f64]) -> Self {
        let mut made = vec![None; places.len()];
        for (number, step) in steps.iter().enumerate() {
            for pair in step.cut.iter().flat_map(Cut::spots).collect::<Vec<_>>().windows(2) {
                lay(&mut made, places, number, pair);
            }
        }
        Self { made }
    }
}

/// Lets a straight piece of a cut take away what is left at the places that it passes.
fn lay(made: &mut [Option<(usize, f64)>], places: &[f64], number: usize, pair: &[Spot]) {
    let (a, b) = (pair[0], pair[1]);
    if (b.x - a.x).abs() < SAME {
        return;
    }
    let (low, high) = (a.x.min(b.x), a.x.max(b.x));
    let first = places.partition_point(|x| *x < low - SAME);
    for (place, x) in made[first..].iter_mut().zip(&places[first..]).take_while(|(_, x)| **x <= high + SAME) {
        let r = a.r + (b.r - a.r) * (x - a.x) / (b.x - a.x);
        if place.is_none_or(|(_, other)| r <= other + EQUAL) {
            *place = Some((number, r));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::steps::Shape;
    use super::*;

    fn cut(from: (f64, f64), to: (f64, f64)) -> Step {
        let [from, to] = [from, to].map(|(x, r)| Spot { x, r });
        let cut = Some(Cut { from, to, shape: Shape::Line });
        let (x, r) = (Some(to.x), Some(to.r));
        Step { block: 0, word: None, is_on: false, unit: 1e-3, scale: 5e-4, x, r, cut, is_plain: true }
    }

    #[test]
    fn the_deepest_cut_makes_the_surface_and_of_equal_ones_the_last() {
        let steps = [
            cut((5.0, 3.0), (0.0, 3.0)), // roughing
            cut((5.0, 2.0), (1.0, 2.0)), // finishing
            cut((1.0, 2.0), (1.0, 4.0)), // a face
            cut((1.0, 4.0), (5.0, 4.0)), // a way back
            cut((5.0, 2.0), (3.0, 2.0)), // once more
        ];
        let made = Surface::of(&steps, &[0.5, 2.0, 4.0, 6.0]).made;
        assert_eq!(made, [Some((0, 3.0)), Some((1, 2.0)), Some((4, 2.0)), None]);
    }
}
