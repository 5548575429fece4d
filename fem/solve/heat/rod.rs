//! The remainder of the rise, which has no source: what the ends of the pieces send back.

use std::f64::consts::SQRT_2;
use std::ops::Range;

use super::RodPiece;
use super::mesh::{Element, Grading, graded, joined};
use super::rise::{Knot, Stretch, cubic};
use super::wave::{Side, Wave};

/// Stretches shorter than this part of the pass are left out.
const NEGLIGIBLE: f64 = 1e-9;
/// First stage of TR-BDF2, as a part of the step.
const STAGE: f64 = 2.0 - SQRT_2;
/// Weight of the end of the first stage in the second.
const WEIGHT: f64 = 0.5 * SQRT_2 / STAGE;

/// The wave at the first and last node of the piece the tool is in.
#[derive(Clone, Copy)]
struct Edges {
    /// Its rise there, K/W.
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

/// A rod with its mesh and its state; the tool moves to the right.
///
/// `rise` (K/W) is the whole rise at the nodes, but without the wave inside the piece the tool is in, where
/// it is the remainder. The ends of that piece hold the whole rise, so its elements subtract the wave there.
pub(super) struct Rod<'a> {
    pieces: &'a [RodPiece],
    speed: f64,
    grading: Grading,
    /// Heat farther from the tool than this does not change the rise at it, m.
    reach: f64,
    x: Vec<f64>,
    elements: Vec<Element>,
    /// First node of every piece, and the last node. Every piece has an even number of elements.
    ends: Vec<usize>,
    rise: Vec<f64>,
    middle: Vec<f64>,
    load: Vec<f64>,
    lower: Vec<f64>,
    pivot: Vec<f64>,
}

impl<'a> Rod<'a> {
    /// A cold rod for a pass of `distance` (m) at `speed` (m/s); every level halves the cells and the steps.
    pub(super) fn new(pieces: &'a [RodPiece], distance: f64, speed: f64, tolerance: f64, level: u32) -> Self {
        let waves = || pieces.iter().map(|piece| Wave::new(piece, 0.0, speed));
        let natural = waves().map(|wave| wave.front().min(wave.spread(distance / speed))).fold(f64::INFINITY, f64::min);
        let grading = Grading::new(natural, tolerance, level);
        let (mut x, mut ends, mut elements) = (vec![0.0], vec![0], Vec::new());
        let mut start = 0.0;
        for piece in pieces {
            let half = graded(0.5 * piece.length, grading.smallest, grading.growth, level);
            for cell in joined(&half, &half).windows(2) {
                elements.push(Element::new(piece, cell[1] - cell[0]));
                x.push(start + cell[1]);
            }
            start += piece.length;
            ends.push(elements.len());
        }
        let reach = grading.reach * waves().map(|wave| wave.front()).fold(0.0, f64::max);
        let [rise, middle, load, lower, pivot] = [(); 5].map(|()| vec![0.0; x.len()]);
        Self { pieces, speed, grading, reach, x, elements, ends, rise, middle, load, lower, pivot }
    }

    /// The rise at the tool on its way from `from` to `to` (m), one stretch for every piece.
    pub(super) fn pass(&mut self, from: f64, to: f64) -> Vec<Stretch> {
        let mut stretches = Vec::new();
        for (index, piece) in self.pieces.iter().enumerate() {
            let nodes = [self.ends[index], self.ends[index + 1]];
            let [left, right] = nodes.map(|node| self.x[node]);
            let begin = if from - left > NEGLIGIBLE * (to - from) { from } else { left };
            let end = to.min(right);
            if end - begin > NEGLIGIBLE * (to - from) {
                let wave = Wave::new(piece, begin, self.speed);
                let knots = self.stretch(&wave, nodes, (end - begin) / self.speed);
                stretches.push(Stretch { start: (begin - from).max(0.0), knots });
            }
        }
        stretches
    }

    /// Follows the tool for `duration` (s) in the piece between `nodes`; then the wave joins the rise at the
    /// nodes.
    fn stretch(&mut self, wave: &Wave, nodes: [usize; 2], duration: f64) -> Vec<Knot> {
        let [first, last] = nodes;
        let (left, right) = (self.x[first], self.x[last]);
        let edges = |time: f64| {
            let (a, b) = (wave.at(left, Side::Left, time), wave.at(right, Side::Right, time));
            Edges { rise: [a.0, b.0], heat: [a.1, -b.1] }
        };
        let mut now = edges(0.0);
        let mut knots = vec![Knot { root: 0.0, rise: self.remainder(nodes, &now, wave.tool(0.0)) }];
        for step in self.grading.times(wave, duration).windows(2) {
            let (dt, time) = (step[1] - step[0], step[1]);
            let window = self.window(nodes, wave.tool(step[0]), wave.tool(time));
            let end = edges(time);
            self.step(nodes, &window, dt, [&now, &edges(step[0] + STAGE * dt), &end]);
            now = end;
            let rise = wave.rise_at_tool(time) + self.remainder(nodes, &now, wave.tool(time));
            knots.push(Knot { root: (self.speed * time).sqrt(), rise });
        }
        for node in first + 1..last {
            let side = if self.x[node] < wave.tool(duration) { Side::Left } else { Side::Right };
            self.rise[node] += wave.at(self.x[node], side, duration).0;
        }
        knots
    }

    /// The elements of the piece between `nodes` and of those near a tool that goes from `begin` to `end`
    /// (m).
    fn window(&self, [first, last]: [usize; 2], begin: f64, end: f64) -> Range<usize> {
        let behind = self.ends.iter().rev().find(|&&node| begin - self.x[node] >= self.reach);
        let ahead = self.ends.iter().find(|&&node| self.x[node] - end >= self.reach);
        behind.map_or(0, |&node| node.min(first))..ahead.map_or(self.elements.len(), |&node| node.max(last))
    }

    /// A step of TR-BDF2 over `dt` (s); the wave at its start, after its first stage and at its end.
    fn step(&mut self, nodes: [usize; 2], window: &Range<usize>, dt: f64, [now, stage, end]: [&Edges; 3]) {
        let (tau, from) = (0.5 * STAGE * dt, window.start);
        let lower = from..window.end;
        self.factor(window, tau);
        // System times (stage + now) = mass times 2 now + loads: the conductance times `now` drops out.
        self.weigh(window, 2.0, 0.0);
        self.add(nodes, tau, &now.mix(1.0, stage, 1.0), &now.mix(2.0, now, 0.0));
        solve(&self.lower[lower.clone()], &self.pivot[from..], &mut self.load[from..], &mut self.middle[from..]);
        self.weigh(window, 1.0 - 2.0 * WEIGHT, WEIGHT);
        self.add(nodes, tau, end, &now.mix(1.0 - WEIGHT, stage, WEIGHT));
        solve(&self.lower[lower], &self.pivot[from..], &mut self.load[from..], &mut self.rise[from..]);
    }

    /// Eliminates mass + `tau` (s) times conductance from both ends of the window towards its middle.
    fn factor(&mut self, window: &Range<usize>, tau: f64) {
        let (mut left, mut right) = (0.0, 0.0);
        let middle = window.start + window.len() / 2;
        for (i, j) in (window.start..middle).zip((middle..window.end).rev()) {
            let ((on_i, off_i), (on_j, off_j)) = (self.elements[i].system(tau), self.elements[j].system(tau));
            self.pivot[i] = 1.0 / (left + on_i);
            self.pivot[j + 1] = 1.0 / (right + on_j);
            self.lower[i] = off_i * self.pivot[i];
            self.lower[j] = off_j * self.pivot[j + 1];
            left = on_i - self.lower[i] * off_i;
            right = on_j - self.lower[j] * off_j;
        }
        self.pivot[middle] = 1.0 / (left + right);
    }

    /// Sets the load to mass times (`a` rise + `b` middle).
    fn weigh(&mut self, window: &Range<usize>, a: f64, b: f64) {
        let nodes = window.start..=window.end;
        let mut values =
            self.rise[nodes.clone()].iter().zip(&self.middle[nodes]).map(|(rise, middle)| a * rise + b * middle);
        let (mut left, mut carried) = (values.next().unwrap_or(0.0), 0.0);
        let loads = &mut self.load[window.clone()];
        for ((load, element), right) in loads.iter_mut().zip(&self.elements[window.clone()]).zip(values) {
            *load = carried + element.mass * (2.0 * left + right);
            carried = element.mass * (left + 2.0 * right);
            left = right;
        }
        self.load[window.end] = carried;
    }

    /// Adds to the load what the wave does: `new` goes with the system, `old` with the mass.
    fn add(&mut self, [first, last]: [usize; 2], tau: f64, new: &Edges, old: &Edges) {
        for (i, node, next, element) in [(0, first, first + 1, first), (1, last, last - 1, last - 1)] {
            let element = &self.elements[element];
            let (on, off) = element.system(tau);
            self.load[node] += on * new.rise[i] - 2.0 * element.mass * old.rise[i] + tau * new.heat[i];
            self.load[next] += off * new.rise[i] - element.mass * old.rise[i];
        }
    }

    /// The remainder at `x` (m) between `nodes`, K/W.
    fn remainder(&self, [first, last]: [usize; 2], edges: &Edges, x: f64) -> f64 {
        let nodes = &self.x[first..=last];
        cubic(x, nodes.partition_point(|&node| node < x), nodes.len(), |i| {
            let wave = match i {
                0 => edges.rise[0],
                i if i == last - first => edges.rise[1],
                _ => 0.0,
            };
            (nodes[i], self.rise[first + i] - wave)
        })
    }

    /// Heat in the rod after the pass, J per W.
    #[cfg(test)]
    pub(super) fn heat(&self) -> f64 {
        let mean = |i: usize| self.rise[i] + self.rise[i + 1];
        self.elements.iter().enumerate().map(|(i, element)| 3.0 * element.mass * mean(i)).sum()
    }
}

/// Solves what `factor` left. The halves do not depend on each other, so the processor works on both at once.
fn solve(lower: &[f64], pivot: &[f64], load: &mut [f64], out: &mut [f64]) {
    let last = lower.len();
    let middle = last / 2;
    let (pivot, load, out) = (&pivot[..=last], &mut load[..=last], &mut out[..=last]);
    for i in 1..middle {
        let j = last - i;
        load[i] -= lower[i - 1] * load[i - 1];
        load[j] -= lower[j] * load[j + 1];
    }
    let both = lower[middle - 1] * load[middle - 1] + lower[middle] * load[middle + 1];
    let mut left = (load[middle] - both) * pivot[middle];
    let mut right = left;
    out[middle] = left;
    for i in (0..middle).rev() {
        let j = last - i;
        left = load[i] * pivot[i] - lower[i] * left;
        right = load[j] * pivot[j] - lower[j - 1] * right;
        out[i] = left;
        out[j] = right;
    }
}
