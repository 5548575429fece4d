//! How the steps of a programme act at the points of a contour: the same for every rod and input.

use std::iter::Sum;
use std::ops::{Mul, Range};

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

/// A mark, by its position, and the weight with which it is read.
type Mark = (usize, f64);

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
    pub looks: Vec<Vec<Mark>>,
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
    pub marks: Range<usize>,
    /// Times that are read by marks within.
    pub looks: Vec<Look>,
    /// Factor by which the z at the beginning has decayed as each of `looks` reads it: for each all points.
    pub left: Vec<Lanes>,
    /// The same at the end.
    pub left_in_the_end: Vec<Lanes>,
}

/// A time that is read by marks of a stretch.
#[derive(Debug)]
pub struct Look {
    /// Position among the times.
    pub time: usize,
    /// Positions among the marks of the stretch, with their weights.
    marks: Vec<Mark>,
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
        let mut looks: Vec<Vec<Mark>> = programme.times.iter().map(read).collect();
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
            Stretch::new(from, end - from, (&marks, &looks), &laws[last])
        };
        let stretches = steps.switches.windows(2).map(stretch).collect();
        Self { contour, stretches, steps, lengths, of_step, laws, marks, looks }
    }
}

impl Stretch {
    fn new(from: usize, steps: usize, (marks, looks): (&[usize], &[Vec<Mark>]), laws: &[Law]) -> Self {
        let own = marks.partition_point(|mark| *mark <= from)..marks.partition_point(|mark| *mark <= from + steps);
        let mut now = vec![Lanes::ONE; laws.len()];
        let mut at = from;
        let mut forward = |to: usize| {
            now.iter_mut().zip(laws).for_each(|(now, law)| *now = now.times(&law.kept.power(to - at)));
            at = to;
            now.clone()
        };
        let at_marks: Vec<Vec<Lanes>> = marks[own.clone()].iter().map(|mark| forward(*mark)).collect();
        let looks: Vec<Look> = (0..).zip(looks).filter_map(|(time, look)| Look::new(time, look, &own)).collect();
        let left = looks.iter().flat_map(|look| (0..laws.len()).map(|group| look.read(|mark| at_marks[mark][group])));
        Self { from, steps, left: left.collect(), marks: own, looks, left_in_the_end: forward(from + steps) }
    }
}

impl Look {
    /// What a time is read by within a stretch of these marks, if it is.
    fn new(time: usize, look: &[Mark], stretch: &Range<usize>) -> Option<Self> {
        let within = look.iter().filter(|(mark, _)| stretch.contains(mark));
        let marks: Vec<_> = within.map(|(mark, weight)| (mark - stretch.start, *weight)).collect();
        (!marks.is_empty()).then_some(Self { time, marks })
    }

    /// Reads what is known at the marks of the stretch.
    pub fn read<T: Sum + Mul<f64, Output = T>>(&self, at: impl Fn(usize) -> T) -> T {
        self.marks.iter().map(|(mark, weight)| at(*mark) * *weight).sum()
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
