//! Which cut makes the surface at a place. Of a turned part that with the smallest radius there, of equal ones the
//! last; of a milled top see [`top`].

use super::sample::{EQUAL, Made, Sample, even, weighed};
use super::spot::Spot;
use super::steps::{Cut, Step};
use super::top::{self, Tracks};
use super::wanted::{SAME, Wanted};
use super::workpiece::Workpiece;

/// Places at least over the pass.
const LEAST: usize = 400;

/// The surface that a program leaves at some places.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// What makes it at each place.
    pub made: Vec<Option<Made>>,
}

/// How cuts make a surface.
#[derive(Clone, Debug, PartialEq)]
pub enum Makers {
    /// The deepest at every place, of equal ones the last.
    Deepest,
    /// The nearest of the tracks that finish a top.
    Tracks(Tracks),
}

impl Makers {
    /// How the cuts of a program make the surface at some places of a part.
    pub fn of(steps: &[Step], places: &[[f64; 2]], work: &Workpiece) -> Self {
        work.breadth.map_or(Self::Deepest, |breadth| Self::Tracks(Tracks::of(steps, places, (work, breadth))))
    }

    /// By how much (m) a flat cutter takes more at some places than its middle leaves there; none of a tool that makes
    /// a profile.
    pub fn deeper(&self, steps: &[Step], places: &[[f64; 2]], surface: &Surface) -> Option<Vec<f64>> {
        match self {
            Self::Deepest => None,
            Self::Tracks(tracks) => Some(tracks.deeper(steps, places, &surface.made)),
        }
    }

    /// The same for a program of which each step comes of one of these, by their positions.
    pub fn of_written(&self, origins: &[usize]) -> Self {
        match self {
            Self::Deepest => Self::Deepest,
            Self::Tracks(tracks) => Self::Tracks(tracks.of_written(origins)),
        }
    }
}

/// Places of the pass, two between any two ends of cuts, of stretches and of straight pieces of what is wanted; of a
/// top rows of them, by the tracks.
pub fn samples(steps: &[Step], work: &Workpiece, wanted: &Wanted) -> Vec<Sample> {
    let Some((low, high)) = wanted.ends() else { return Vec::new() };
    let stretches = work.stretches.iter().flat_map(|own| [own.from, own.to]);
    let nodes = wanted.between(low, high, 0.0).into_iter().map(|node| node.0);
    let grid = even(low, high, LEAST);
    let borders = stretches.chain(nodes).chain(grid);
    if let Some(breadth) = work.breadth {
        return top::samples(steps, borders.collect(), (low, high), breadth.half);
    }
    let cuts = steps.iter().filter_map(|step| step.cut).flat_map(|cut| [cut.from.x, cut.to.x]);
    let place = |(x, weight, interval)| Sample { x, y: 0.0, weight, interval };
    weighed(borders.chain(cuts).collect(), (low, high)).into_iter().map(place).collect()
}

impl Surface {
    /// The surface at some places; of a turned part they rise.
    pub fn of(steps: &[Step], places: &[[f64; 2]], makers: &Makers) -> Self {
        let mut made = vec![None; places.len()];
        match makers {
            Makers::Tracks(tracks) => tracks.lay(steps, places, &mut made),
            Makers::Deepest => {
                for (number, step) in steps.iter().enumerate() {
                    let Some(cut) = &step.cut else { continue };
                    cut.profile().windows(2).for_each(|pair| lay(&mut made, places, (number, cut), pair));
                }
            }
        }
        Self { made }
    }
}

/// Lets a straight piece of a cut take away what is left at the places that it passes.
fn lay(made: &mut [Option<Made>], places: &[[f64; 2]], (step, cut): (usize, &Cut), pair: &[Spot]) {
    let (a, b) = (pair[0], pair[1]);
    if (b.x - a.x).abs() < SAME {
        return;
    }
    let (low, high) = (a.x.min(b.x), a.x.max(b.x));
    let first = places.partition_point(|[x, _]| *x < low - SAME);
    for (place, [x, _]) in made[first..].iter_mut().zip(&places[first..]).take_while(|(_, [x, _])| *x <= high + SAME) {
        let r = a.r + (b.r - a.r) * (x - a.x) / (b.x - a.x);
        if place.is_none_or(|other| r <= other.r + EQUAL) {
            *place = Some(Made { step, share: cut.share(*x), r });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::steps::Shape;
    use super::*;

    fn cut(from: (f64, f64), to: (f64, f64)) -> Step {
        let [from, to] = [from, to].map(|(x, r)| Spot { x, y: 0.0, r });
        let cut = Some(Cut { from, to, shape: Shape::Line, is_aside: false });
        Step { block: 0, word: None, is_on: false, unit: 1e-3, scale: 5e-4, r: Some(to.r), cut, is_plain: true }
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
        let places = [0.5, 2.0, 4.0, 6.0].map(|x| [x, 0.0]);
        let made = Surface::of(&steps, &places, &Makers::Deepest).made;
        let made: Vec<_> = made.into_iter().map(|own| own.map(|own| (own.step, own.r, own.share))).collect();
        assert_eq!(made, [Some((0, 3.0, 0.9)), Some((1, 2.0, 0.75)), Some((4, 2.0, 0.5)), None]);
    }
}
