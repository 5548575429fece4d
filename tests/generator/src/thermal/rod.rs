//! A heated rod by finite volumes in space and a diagonally implicit Runge-Kutta method (Alexander's,
//! second order, L-stable) in time.
//!
//! ρ c A T' = (k A T_x)_x − h p (T − T_a) + Σ Q δ(x − x_Q): nodes stand at both ends, where the section changes,
//! where heat comes in and where it is measured, and two on either side of a joint; steps end where a source is
//! switched, and begin short.

/// What is heated and how. SI units; temperatures are rises over that of the rod at the start.
#[derive(Debug, Clone)]
pub struct Rod {
    /// (length, diameter) from the base, m.
    pub segments: Vec<(f64, f64)>,
    /// k, W/(m K).
    pub conductivity: f64,
    /// ρ c, J/(m³ K).
    pub capacity: f64,
    /// h, W/(m² K).
    pub convection: f64,
    /// Of the base to the surroundings, W/K.
    pub base: f64,
    /// (x, W/(m² K)) of a thermal joint.
    pub joint: Option<(f64, f64)>,
    /// (x, W, from, to) in m and s.
    pub sources: Vec<(f64, f64, f64, f64)>,
    /// What each of the sources warms before it warms the rod.
    pub heater: Option<Heater>,
    /// Further heat, (x, W), from the start on: of bearings, which store none.
    pub friction: Vec<(f64, f64)>,
    /// Rise of the surroundings: amplitude K, angular frequency 1/s, phase.
    pub surroundings: (f64, f64, f64),
    /// Of the surroundings over the rod at the start, K.
    pub apart: f64,
}

/// A body at one temperature between a source and the rod.
#[derive(Debug, Clone, Copy)]
pub struct Heater {
    /// Heat capacity, J/K.
    pub capacity: f64,
    /// Conductance to the rod, W/K.
    pub contact: f64,
}

/// Cells along the whole rod, about.
const CELLS: f64 = 140.0;
/// Longest and shortest time step, s, and a step's part of the time since something was switched.
const STEP: f64 = 10.0;
const FIRST: f64 = 0.5;
const GROWS: f64 = 0.1;
/// Alexander's γ = 1 − 1/√2.
const GAMMA: f64 = 1.0 - std::f64::consts::FRAC_1_SQRT_2;

/// The discretised rod.
struct Nodes {
    /// Places, m; that of a joint twice.
    x: Vec<f64>,
    /// Length of rod that belongs to each, m.
    size: Vec<f64>,
    /// Heat capacities, J/K.
    capacity: Vec<f64>,
    /// Conductances between neighbours, W/K.
    between: Vec<f64>,
    /// To the surroundings, W/K.
    loss: Vec<f64>,
    /// Nodes at which heaters sit, whose own rises stand behind those of the nodes.
    heaters: Vec<usize>,
}

/// Rises at every place `at` (m) and the integral of the rise over the rod (K m), at each of the rising
/// `times` (s).
pub fn histories(rod: &Rod, at: &[f64], times: &[f64]) -> Vec<(Vec<f64>, f64)> {
    let nodes = Nodes::of(rod, at);
    let places: Vec<usize> = at.iter().map(|x| nodes.nearest(*x)).collect();
    let switched: Vec<f64> = rod.sources.iter().flat_map(|s| [s.2, s.3]).collect();
    let mut stops: Vec<f64> = switched.iter().chain(times).copied().filter(|s| *s >= 0.0).collect();
    stops.sort_by(f64::total_cmp);
    let (mut rises, mut now) = (vec![0.0; nodes.x.len() + nodes.heaters.len()], 0.0);
    let mut found = Vec::new();
    for stop in stops {
        while stop - now > 1e-9 {
            let last = switched.iter().filter(|t| **t <= now + 1e-9).copied().fold(0.0, f64::max);
            let longest = (GROWS * (now - last)).clamp(FIRST, STEP);
            let step = (stop - now) / ((stop - now) / longest).ceil();
            nodes.step(rod, &mut rises, now, step);
            now += step;
        }
        while found.len() < times.len() && times[found.len()] <= now + 1e-9 {
            let integral = rises.iter().zip(&nodes.size).map(|(r, s)| r * s).sum();
            found.push((places.iter().map(|i| rises[*i]).collect(), integral));
        }
        if found.len() == times.len() {
            break;
        }
    }
    found
}

fn area(diameter: f64) -> f64 {
    0.25 * std::f64::consts::PI * diameter * diameter
}

impl Nodes {
    fn of(rod: &Rod, at: &[f64]) -> Self {
        let whole: f64 = rod.segments.iter().map(|s| s.0).sum();
        let mut breaks: Vec<f64> = at.iter().copied().chain(rod.sources.iter().map(|s| s.0)).collect();
        breaks.extend(rod.friction.iter().map(|f| f.0).chain(rod.joint.map(|j| j.0)));
        let mut end = 0.0;
        for (length, _) in &rod.segments {
            end += length;
            breaks.push(end);
        }
        breaks.push(0.0);
        breaks.retain(|x| (0.0..=whole * (1.0 + 1e-9)).contains(x));
        breaks.sort_by(f64::total_cmp);
        breaks.dedup_by(|a, b| (*a - *b).abs() < 1e-9 * whole);
        let mut nodes = Self {
            x: vec![0.0],
            size: vec![0.0],
            capacity: vec![0.0],
            between: Vec::new(),
            loss: vec![rod.base],
            heaters: Vec::new(),
        };
        for pair in breaks.windows(2) {
            let (from, to) = (pair[0], pair[1]);
            let diameter = rod.diameter(0.5 * (from + to));
            if let Some((_, conductance)) = rod.joint.filter(|j| from > 0.0 && (j.0 - from).abs() < 1e-9 * whole) {
                // At a step the narrower section is what touches.
                let touching = area(diameter.min(rod.diameter(from - 1e-6 * whole)));
                nodes.push(from, conductance * touching);
            }
            let count = ((to - from) / whole * CELLS).ceil().max(1.0);
            let cell = (to - from) / count;
            for k in 1..=count as usize {
                nodes.half_cell(rod, cell, diameter);
                nodes.push(from + k as f64 * cell, rod.conductivity * area(diameter) / cell);
                nodes.half_cell(rod, cell, diameter);
            }
        }
        if rod.heater.is_some() {
            nodes.heaters = rod.sources.iter().map(|source| nodes.nearest(source.0)).collect();
        }
        nodes
    }

    /// A further node, with its conductance to the last.
    fn push(&mut self, x: f64, conductance: f64) {
        self.x.push(x);
        self.between.push(conductance);
        for list in [&mut self.size, &mut self.capacity, &mut self.loss] {
            list.push(0.0);
        }
    }

    /// Gives half of a cell to the last node.
    fn half_cell(&mut self, rod: &Rod, cell: f64, diameter: f64) {
        let last = self.x.len() - 1;
        self.size[last] += 0.5 * cell;
        self.capacity[last] += rod.capacity * area(diameter) * 0.5 * cell;
        self.loss[last] += rod.convection * std::f64::consts::PI * diameter * 0.5 * cell;
    }

    /// The node at a place; before a joint that stands there.
    fn nearest(&self, x: f64) -> usize {
        let off = |i: &usize| (self.x[*i] - x).abs();
        (0..self.x.len()).min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(0)
    }

    /// Heat into every node and heater at a time, W.
    fn heat(&self, rod: &Rod, time: f64) -> Vec<f64> {
        let (amplitude, frequency, phase) = rod.surroundings;
        let around = rod.apart + amplitude * ((frequency * time + phase).sin() - phase.sin());
        let mut heat: Vec<f64> = self.loss.iter().map(|loss| loss * around).collect();
        heat.resize(self.x.len() + self.heaters.len(), 0.0);
        for (number, (x, power, from, to)) in rod.sources.iter().enumerate() {
            // Steps begin and end at the switching, and stages lie inside them.
            if time > *from && time <= *to + 1e-9 {
                let into = if self.heaters.is_empty() { self.nearest(*x) } else { self.x.len() + number };
                heat[into] += power;
            }
        }
        rod.friction.iter().for_each(|(x, power)| heat[self.nearest(*x)] += power);
        heat
    }

    /// C T' = −K T + q by two stages.
    fn step(&self, rod: &Rod, rises: &mut [f64], time: f64, step: f64) {
        let first = self.slope(rod, rises, GAMMA * step, &self.heat(rod, time + GAMMA * step));
        let middle: Vec<f64> = rises.iter().zip(&first).map(|(r, k)| r + (1.0 - GAMMA) * step * k).collect();
        let second = self.slope(rod, &middle, GAMMA * step, &self.heat(rod, time + step));
        for ((rise, a), b) in rises.iter_mut().zip(first).zip(second) {
            *rise += step * ((1.0 - GAMMA) * a + GAMMA * b);
        }
    }

    /// The slope k with C k = −K (T + g k) + q, by elimination along the rod, heaters eliminated first.
    fn slope(&self, rod: &Rod, rises: &[f64], g: f64, heat: &[f64]) -> Vec<f64> {
        let n = self.x.len();
        let stiff = |i: usize| {
            let below = if i > 0 { self.between[i - 1] } else { 0.0 };
            below + if i + 1 < n { self.between[i] } else { 0.0 } + self.loss[i]
        };
        let mut diagonal: Vec<f64> = (0..n).map(|i| self.capacity[i] + g * stiff(i)).collect();
        let mut right: Vec<f64> = (0..n)
            .map(|i| {
                let below = if i > 0 { self.between[i - 1] * rises[i - 1] } else { 0.0 };
                let above = if i + 1 < n { self.between[i] * rises[i + 1] } else { 0.0 };
                heat[i] - stiff(i) * rises[i] + below + above
            })
            .collect();
        // C_h k_h = q − G (T_h − T) − g G (k_h − k), and as much comes into the node.
        let flow = |number: usize, contact: f64| contact * (rises[n + number] - rises[self.heaters[number]]);
        for (number, node) in self.heaters.iter().enumerate() {
            let Some(Heater { capacity, contact }) = rod.heater else { continue };
            let (flow, whole) = (flow(number, contact), capacity + g * contact);
            right[*node] += flow + g * contact * (heat[n + number] - flow) / whole;
            diagonal[*node] += g * contact * capacity / whole;
        }
        for i in 1..n {
            let factor = g * self.between[i - 1] / diagonal[i - 1];
            diagonal[i] -= factor * g * self.between[i - 1];
            right[i] += factor * right[i - 1];
        }
        right[n - 1] /= diagonal[n - 1];
        for i in (0..n - 1).rev() {
            right[i] = (right[i] + g * self.between[i] * right[i + 1]) / diagonal[i];
        }
        for (number, node) in self.heaters.iter().enumerate() {
            let Some(Heater { capacity, contact }) = rod.heater else { continue };
            let comes = heat[n + number] - flow(number, contact) + g * contact * right[*node];
            right.push(comes / (capacity + g * contact));
        }
        right
    }
}

impl Rod {
    fn diameter(&self, x: f64) -> f64 {
        let mut end = 0.0;
        let here = self.segments.iter().find(|(length, _)| {
            end += length;
            x < end
        });
        here.or(self.segments.last()).map_or(0.0, |(_, diameter)| *diameter)
    }
}
