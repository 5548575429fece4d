//! The remainder of the rise: what the ends of the pieces send back.

use std::f64::consts::SQRT_2;
use std::ops::Range;

use super::wave::{Side, Wave};
use super::{Knot, RodPiece, Stretch, cubic};

/// Length of a cell over its distance from the nearest end of the piece, on the coarsest mesh.
const GROWTH: f64 = 3.5;
/// Smallest cell on the coarsest mesh over the natural length of the problem.
const SMALLEST: f64 = 20.0;
/// Pieces farther than this many diffusivity / speed from the stretch do not change it: exp(-20) of the heat there
/// can still reach the tool.
const REACH: f64 = 12.0;
/// Stretches shorter than this part of the pass are left out.
const NEGLIGIBLE: f64 = 1e-9;
/// First stage of TR-BDF2, as a part of the step.
const STAGE: f64 = 2.0 - SQRT_2;
/// Weight of the end of the first stage in the second.
const WEIGHT: f64 = 0.5 * SQRT_2 / STAGE;

/// A linear element.
struct Element {
    /// A sixth of its heat capacity, J/K.
    mass: f64,
    /// W/K
    stiffness: f64,
    /// A sixth of its loss, W/K.
    loss: f64,
}

impl Element {
    /// Diagonal and other entry of mass + `tau` (s) times conductance, J/K.
    fn system(&self, tau: f64) -> (f64, f64) {
        (2.0 * self.mass + tau * (self.stiffness + 2.0 * self.loss), self.mass + tau * (self.loss - self.stiffness))
    }
}

/// What the wave does at the first and last node of the piece the tool is in.
#[derive(Clone, Copy)]
struct Edges {
    /// Its rise, K/W.
    rise: [f64; 2],
    /// Heat it brings to them, W/W.
    heat: [f64; 2],
}

impl Edges {
    /// `a` times this plus `b` times the other.
    fn mix(&self, a: f64, other: &Self, b: f64) -> Self {
        let mix = |x: [f64; 2], y: [f64; 2]| [a * x[0] + b * y[0], a * x[1] + b * y[1]];
        Self { rise: mix(self.rise, other.rise), heat: mix(self.heat, other.heat) }
    }
}

/// The rod, its mesh and its state, the tool going right.
///
/// `rise` is the whole rise at the nodes, less the wave inside the piece the tool is in (not at its ends).
pub(super) struct Rod<'a> {
    pieces: &'a [RodPiece],
    speed: f64,
    level: u32,
    growth: f64,
    smallest: f64,
    x: Vec<f64>,
    elements: Vec<Element>,
    /// First node of every piece, and the last node.
    ends: Vec<usize>,
    rise: Vec<f64>,
    middle: Vec<f64>,
    load: Vec<f64>,
    lower: Vec<f64>,
    pivot: Vec<f64>,
}

impl<'a> Rod<'a> {
    /// A cold rod for a pass of `distance` (m) at `speed` (m/s); every level halves the cells and steps.
    pub(super) fn new(pieces: &'a [RodPiece], distance: f64, speed: f64, tolerance: f64, level: u32) -> Self {
        let natural = |piece: &RodPiece| {
            let steady =
                speed * piece.heat_capacity / piece.conductance + 2.0 * (piece.loss / piece.conductance).sqrt();
            (piece.conductance / piece.heat_capacity * distance / speed).sqrt().min(1.0 / steady)
        };
        let growth = GROWTH * tolerance.powf(0.25).min(0.2);
        let smallest = SMALLEST * tolerance.min(1e-3) * pieces.iter().map(natural).fold(f64::INFINITY, f64::min);
        let (mut x, mut ends, mut elements) = (vec![0.0], vec![0], Vec::new());
        let mut start = 0.0;
        for piece in pieces {
            let half = graded(0.5 * piece.length, smallest, growth, level);
            let points = joined(&half, &half);
            for cell in points.windows(2) {
                let length = cell[1] - cell[0];
                elements.push(Element {
                    mass: piece.heat_capacity * length / 6.0,
                    stiffness: piece.conductance / length,
                    loss: piece.loss * length / 6.0,
                });
                x.push(start + cell[1]);
            }
            start += piece.length;
            ends.push(elements.len());
        }
        let zero = vec![0.0; x.len()];
        let [rise, middle, load, lower, pivot] = [(); 5].map(|()| zero.clone());
        Self { pieces, speed, level, growth, smallest, x, elements, ends, rise, middle, load, lower, pivot }
    }

    /// The rise at the tool on its way from `from` to `to` (m), one stretch for every piece.
    pub(super) fn pass(mut self, from: f64, to: f64) -> Vec<Stretch> {
        let mut stretches = Vec::new();
        for (index, piece) in self.pieces.iter().enumerate() {
            let nodes = [self.ends[index], self.ends[index + 1]];
            let (begin, end) = (from.max(self.x[nodes[0]]), to.min(self.x[nodes[1]]));
            if end - begin > NEGLIGIBLE * (to - from) {
                let wave = Wave::new(piece, begin, self.speed);
                let knots = self.stretch(&wave, nodes, end - begin);
                stretches.push(Stretch { start: begin - from, knots });
            }
        }
        stretches
    }

    /// The elements of the pieces near enough to a stretch from `begin` to `end` (m).
    fn window(&self, begin: f64, end: f64) -> Range<usize> {
        let diffusivity = |piece: &RodPiece| piece.conductance / piece.heat_capacity;
        let reach = REACH * self.pieces.iter().map(diffusivity).fold(0.0, f64::max) / self.speed;
        let behind = self.ends.iter().rev().find(|&&node| begin - self.x[node] >= reach);
        let ahead = self.ends.iter().find(|&&node| self.x[node] - end >= reach);
        behind.copied().unwrap_or(0)..ahead.copied().unwrap_or(self.elements.len())
    }

    /// Follows the tool over `distance` (m) in the piece between `nodes`; then the wave joins the rise at the nodes.
    fn stretch(&mut self, wave: &Wave, nodes: [usize; 2], distance: f64) -> Vec<Knot> {
        let [first, last] = nodes;
        let ends = [(self.x[first], Side::Left), (self.x[last], Side::Right)];
        let edges = |time: f64| {
            let [(a, out), (b, heat)] = ends.map(|(x, side)| wave.at(x, side, time));
            Edges { rise: [a, b], heat: [out, -heat] }
        };
        let duration = distance / self.speed;
        let times = self.times(wave.diffusivity(), duration);
        let mut now = edges(0.0);
        let mut knots = vec![Knot::new(0.0, self.remainder(nodes, &now, wave.tool(0.0)))];
        for step in times.windows(2) {
            let (dt, time) = (step[1] - step[0], step[1]);
            let end = edges(time);
            let window = self.window(wave.tool(step[0]), wave.tool(time));
            self.step(nodes, &window, dt, [&now, &edges(step[0] + STAGE * dt), &end]);
            now = end;
            let rise = wave.rise_at_tool(time) + self.remainder(nodes, &now, wave.tool(time));
            knots.push(Knot::new((self.speed * time).sqrt(), rise));
        }
        for node in first + 1..last {
            let side = if self.x[node] < wave.tool(duration) { Side::Left } else { Side::Right };
            self.rise[node] += wave.at(self.x[node], side, duration).0;
        }
        knots
    }

    /// Times (s) of the steps in a stretch. The rise begins with a root of the time and ends like
    /// exp(speed^2 t / `diffusivity`).
    fn times(&self, diffusivity: f64, duration: f64) -> Vec<f64> {
        let half = 0.5 * duration;
        let root = graded(half.sqrt(), self.smallest / diffusivity.sqrt(), 0.5 * self.growth, self.level);
        let first: Vec<f64> = root.iter().map(|r| r * r).collect();
        let last = graded(half, (0.25 * diffusivity / self.speed.powi(2)).min(duration), self.growth, self.level);
        joined(&first, &last)
    }

    /// A step of TR-BDF2 over `dt` (s); the wave at its start, after its first stage and at its end.
    fn step(&mut self, nodes: [usize; 2], window: &Range<usize>, dt: f64, [now, stage, end]: [&Edges; 3]) {
        let (tau, from) = (0.5 * STAGE * dt, window.start);
        self.factor(window, tau);
        // System (stage + now) = mass (2 now) + loads: the conductance times `now` drops out.
        self.weigh(window, 2.0, 0.0);
        self.add(nodes, tau, &now.mix(1.0, stage, 1.0), &now.mix(2.0, now, 0.0));
        solve(&self.lower[window.clone()], &self.pivot[from..], &mut self.load[from..], &mut self.middle[from..]);
        self.weigh(window, 1.0 - 2.0 * WEIGHT, WEIGHT);
        self.add(nodes, tau, end, &now.mix(1.0 - WEIGHT, stage, WEIGHT));
        solve(&self.lower[window.clone()], &self.pivot[from..], &mut self.load[from..], &mut self.rise[from..]);
    }

    /// Eliminates mass + `tau` (s) times conductance from both ends of the window towards its middle.
    fn factor(&mut self, window: &Range<usize>, tau: f64) {
        let (mut left, mut right) = (0.0, 0.0);
        let middle = window.start + window.len() / 2;
        for (i, j) in (window.start..middle).zip((middle..window.end).rev()) {
            let ((on_left, off_left), (on_right, off_right)) =
                (self.elements[i].system(tau), self.elements[j].system(tau));
            self.pivot[i] = 1.0 / (left + on_left);
            self.pivot[j + 1] = 1.0 / (right + on_right);
            self.lower[i] = off_left * self.pivot[i];
            self.lower[j] = off_right * self.pivot[j + 1];
            left = on_left - self.lower[i] * off_left;
            right = on_right - self.lower[j] * off_right;
        }
        self.pivot[middle] = 1.0 / (left + right);
    }

    /// Sets the load to mass times (`a` rise + `b` middle).
    fn weigh(&mut self, window: &Range<usize>, a: f64, b: f64) {
        let value = |i: usize| a * self.rise[i] + b * self.middle[i];
        let mut left = value(window.start);
        let mut carried = 0.0;
        for i in window.clone() {
            let right = value(i + 1);
            let mass = self.elements[i].mass;
            self.load[i] = carried + mass * (2.0 * left + right);
            carried = mass * (left + 2.0 * right);
            left = right;
        }
        self.load[window.end] = carried;
    }

    /// Adds what the wave does to the load: `new` goes with the system, `old` with the mass.
    fn add(&mut self, [first, last]: [usize; 2], tau: f64, new: &Edges, old: &Edges) {
        for (i, node, next, element) in [(0, first, first + 1, first), (1, last, last - 1, last - 1)] {
            let element = &self.elements[element];
            let (on, off) = element.system(tau);
            self.load[node] += on * new.rise[i] - 2.0 * element.mass * old.rise[i] + tau * new.heat[i];
            self.load[next] += off * new.rise[i] - element.mass * old.rise[i];
        }
    }

    /// The rise at `x` (m) between `nodes` less the wave, K/W.
    fn remainder(&self, [first, last]: [usize; 2], edges: &Edges, x: f64) -> f64 {
        let nodes = &self.x[first..=last];
        let count = nodes.len();
        cubic(x, nodes.partition_point(|&node| node < x), count, |i| {
            let wave = if i == 0 {
                edges.rise[0]
            } else if i + 1 == count {
                edges.rise[1]
            } else {
                0.0
            };
            (nodes[i], self.rise[first + i] - wave)
        })
    }
}

/// Solves for `out` in the window from what `factor` left; the two halves are independent, which hides their latency.
fn solve(lower: &[f64], pivot: &[f64], load: &mut [f64], out: &mut [f64]) {
    let last = lower.len();
    let middle = last / 2;
    let (pivot, load, out) = (&pivot[..=last], &mut load[..=last], &mut out[..=last]);
    let (mut left, mut right) = (load[0], load[last]);
    for i in 0..middle {
        let j = last - 1 - i;
        left = load[i + 1] - lower[i] * left;
        right = load[j] - lower[j] * right;
        if i + 1 < middle {
            load[i + 1] = left;
            load[j] = right;
        }
    }
    let mut left = (left + right - load[middle]) * pivot[middle];
    let mut right = left;
    out[middle] = left;
    for i in (0..middle).rev() {
        let j = last - 1 - i;
        left = load[i] * pivot[i] - lower[i] * left;
        right = load[j + 1] * pivot[j + 1] - lower[j] * right;
        out[i] = left;
        out[j + 1] = right;
    }
}

/// Points from 0 (left out) to `length`, the first cell about `growth` times `smallest`, every next one larger by
/// `growth` of itself; every level halves the cells.
fn graded(length: f64, smallest: f64, growth: f64, level: u32) -> Vec<f64> {
    let stretch = (growth * length / smallest).ln_1p();
    let count = (stretch / growth).ceil().max(2.0) * f64::from(1_u32 << level);
    (1..=count as u32).map(|i| length * (stretch * f64::from(i) / count).exp_m1() / stretch.exp_m1()).collect()
}

/// Points from 0 to twice the last of each half, which are measured from the two ends.
fn joined(from_start: &[f64], from_end: &[f64]) -> Vec<f64> {
    let length = 2.0 * from_end.last().copied().unwrap_or(0.0);
    let start = std::iter::once(0.0).chain(from_start.iter().copied());
    start.chain(from_end.iter().rev().skip(1).map(|y| length - y)).chain([length]).collect()
}
