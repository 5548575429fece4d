//! How the steps of a programme act at the points of a contour: the same for every rod and input.

use nalgebra::Complex;

use super::Scheme;
use super::contour::{Contour, Reach};
use super::lanes::{LANES, Lanes};
use super::run::{Steps, is_same};
use super::track::weights;

/// Steps and reading times of a run, whatever the rod and the input.
#[derive(Clone, Debug, PartialEq)]
pub struct Programme {
    /// Scheme of every step.
    pub scheme: Scheme,
    /// Longest step, s.
    pub step: f64,
    /// Times 0, of switches, and of the end, s.
    pub intervals: Vec<f64>,
    /// The contour.
    pub reach: Reach,
    /// When it is read, s, rising.
    pub times: Vec<f64>,
}

/// Most stages of a scheme.
pub const STAGES: usize = 2;

/// The steps of a programme with what they do to z of z′ = s·z + u.
#[derive(Debug)]
pub struct Laws {
    pub contour: Contour,
    pub steps: Steps,
    /// Lengths that steps have, s.
    pub lengths: Vec<f64>,
    /// Position in `lengths` of every step.
    pub of_step: Vec<usize>,
    /// For every length those of all points.
    pub laws: Vec<Vec<Law>>,
    /// Numbers of steps (0 is the start) whose ends are read, rising.
    pub marks: Vec<usize>,
    /// For every time the marks by which it is read, with their weights.
    pub looks: Vec<Vec<(usize, f64)>>,
    /// The equal steps of every interval.
    pub stretches: Vec<Stretch>,
}

/// How a step of one length acts on z, at some points.
#[derive(Debug)]
pub struct Law {
    /// On z before.
    pub kept: Lanes,
    /// Of the input at every stage.
    pub driven: [Lanes; STAGES],
}

/// Equal steps.
#[derive(Debug)]
pub struct Stretch {
    /// Number of steps before them.
    pub from: usize,
    /// Number of steps.
    pub steps: usize,
    /// Marks within.
    pub marks: std::ops::Range<usize>,
    /// Factor by which the z at the beginning has decayed at every mark: for each all points.
    pub left: Vec<Lanes>,
    /// The same at the end.
    pub left_in_the_end: Vec<Lanes>,
}

impl Laws {
    /// Number of groups of points that are worked on side by side.
    pub fn groups(&self) -> usize {
        self.contour.points.len() / LANES
    }

    pub fn new(programme: &Programme) -> Self {
        let contour = programme.reach.contour();
        let steps = Steps::between(&programme.intervals, programme.step);
        let read = |time: &f64| weights(&steps.times, &steps.switches, *time).collect::<Vec<_>>();
        let mut looks: Vec<Vec<(usize, f64)>> = programme.times.iter().map(read).collect();
        let mut marks: Vec<usize> = looks.iter().flatten().map(|look| look.0).collect();
        marks.sort_unstable();
        marks.dedup();
        looks.iter_mut().flatten().for_each(|look| look.0 = marks.partition_point(|mark| *mark < look.0));
        let (mut lengths, mut of_step) = (Vec::<f64>::new(), Vec::new());
        for length in &steps.lengths {
            of_step.push(lengths.iter().rposition(|known| is_same(*known, *length)).unwrap_or_else(|| {
                lengths.push(*length);
                lengths.len() - 1
            }));
        }
        let groups = contour.points.as_chunks().0;
        let law = |length: &f64| groups.iter().map(|points| Law::new(programme.scheme, *length, points)).collect();
        let laws: Vec<Vec<Law>> = lengths.iter().map(law).collect();
        let stretch = |ends: &[usize]| {
            // The first step is halved towards the switch.
            let (last, end) = (of_step[ends[1] - 1], ends[1]);
            let from = (ends[0]..end).find(|step| of_step[*step] == last).unwrap_or(end);
            Stretch::new(from, end - from, &marks, &laws[last])
        };
        let stretches = steps.switches.windows(2).map(stretch).collect();
        Self { contour, stretches, steps, lengths, of_step, laws, marks, looks }
    }
}

impl Stretch {
    fn new(from: usize, steps: usize, marks: &[usize], laws: &[Law]) -> Self {
        let own = marks.partition_point(|mark| *mark <= from)..marks.partition_point(|mark| *mark <= from + steps);
        let mut left = Vec::with_capacity(own.len() * laws.len());
        let mut now = vec![Lanes::ONE; laws.len()];
        let mut at = from;
        let mut forward = |to: usize| {
            now.iter_mut().zip(laws).for_each(|(now, law)| *now = now.times(&law.kept.power(to - at)));
            at = to;
            now.clone()
        };
        marks[own.clone()].iter().for_each(|mark| left.extend(forward(*mark)));
        Self { from, steps, marks: own, left, left_in_the_end: forward(from + steps) }
    }
}

impl Law {
    fn new(scheme: Scheme, length: f64, points: &[Complex<f64>; LANES]) -> Self {
        let stepped = |z: f64, inputs: [f64; STAGES]| {
            Lanes::new(points.map(|s| scheme.step_of_one(s, length, z.into(), &inputs)))
        };
        let driven = [stepped(0.0, [1.0, 0.0]), stepped(0.0, [0.0, 1.0])];
        Self { kept: stepped(1.0, [0.0; STAGES]), driven }
    }
}

impl Scheme {
    /// A step of z′ = s·z + u, with u at the places of the stages.
    fn step_of_one(self, s: Complex<f64>, length: f64, z: Complex<f64>, inputs: &[f64]) -> Complex<f64> {
        let mut base = z;
        for (weight, input) in self.weights().iter().zip(inputs) {
            let rate = (s * base + input) / (Complex::new(1.0, 0.0) - s * (self.gamma() * length));
            base += rate * (length * weight);
        }
        base
    }
}
