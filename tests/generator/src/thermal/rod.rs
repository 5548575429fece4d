//! A heated rod by finite volumes in space and a diagonally implicit Runge-Kutta method (Alexander's,
//! second order, L-stable) in time.
//!
//! ρ c A T' = (k A T_x)_x − h p (T − T_a) + Σ Q δ(x − x_Q): cells end where the section changes and where a
//! joint is, and steps end where a source is switched.

/// What is heated and how. SI units; temperatures are rises over that of the start.
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
    /// What the first source warms before it warms the rod.
    pub heater: Option<Heater>,
    /// Rise of the surroundings: amplitude K, angular frequency 1/s, phase.
    pub surroundings: (f64, f64, f64),
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
const CELLS: f64 = 110.0;
/// Longest time step, s.
const STEP: f64 = 12.0;
/// Alexander's γ = 1 − 1/√2.
const GAMMA: f64 = 1.0 - std::f64::consts::FRAC_1_SQRT_2;

/// The discretised rod.
struct Cells {
    /// Middles, m.
    x: Vec<f64>,
    /// Sizes, m.
    size: Vec<f64>,
    /// Heat capacities, J/K.
    capacity: Vec<f64>,
    /// Conductances between neighbours, W/K.
    between: Vec<f64>,
    /// To the surroundings, W/K.
    loss: Vec<f64>,
    /// Beside the rod; its own rise stands behind those of the cells.
    heater: Option<Held>,
}

/// A heater and where it sits.
struct Held {
    capacity: f64,
    /// To the middle of a cell at an end, or to a place between two middles.
    contact: f64,
    /// Cells about its place, with their shares.
    about: Vec<(usize, f64)>,
}

/// Rises at every place `at` (m) and the integral of the rise over the rod (K m), at each of the rising
/// `times` (s).
pub fn histories(rod: &Rod, at: &[f64], times: &[f64]) -> Vec<(Vec<f64>, f64)> {
    let cells = Cells::of(rod);
    let heat = |t: f64| cells.heat(rod, t);
    let mut stops: Vec<f64> = rod.sources.iter().flat_map(|s| [s.2, s.3]).chain(times.iter().copied()).collect();
    stops.sort_by(f64::total_cmp);
    let unknowns = cells.x.len() + usize::from(cells.heater.is_some());
    let (mut rises, mut now, mut found) = (vec![0.0; unknowns], 0.0, Vec::new());
    for stop in stops.into_iter().filter(|s| *s >= 0.0) {
        let steps = ((stop - now) / STEP).ceil();
        for k in 0..steps as usize {
            let step = (stop - now) / steps;
            cells.step(&mut rises, now + k as f64 * step, step, &heat);
        }
        now = now.max(stop);
        while found.len() < times.len() && times[found.len()] <= now {
            let places = at.iter().map(|x| cells.at(&rises, *x)).collect();
            found.push((places, rises.iter().zip(&cells.size).map(|(r, s)| r * s).sum()));
        }
        if found.len() == times.len() {
            break;
        }
    }
    found
}

impl Cells {
    fn of(rod: &Rod) -> Self {
        let whole: f64 = rod.segments.iter().map(|s| s.0).sum();
        let (mut x, mut size, mut diameters, mut borders) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let mut from = 0.0;
        for (length, diameter) in &rod.segments {
            let joint = rod.joint.map(|j| j.0).filter(|j| *j > from && *j < from + length);
            let mut ends = vec![from];
            ends.extend(joint);
            ends.push(from + length);
            for pair in ends.windows(2) {
                let count = ((pair[1] - pair[0]) / whole * CELLS).ceil().max(2.0);
                let own = (pair[1] - pair[0]) / count;
                for k in 0..count as usize {
                    x.push(pair[0] + (k as f64 + 0.5) * own);
                    size.push(own);
                    diameters.push(*diameter);
                    borders.push(pair[0] + (k as f64 + 1.0) * own);
                }
            }
            from += length;
        }
        let area = |d: f64| 0.25 * std::f64::consts::PI * d * d;
        let half = |i: usize| 0.5 * size[i] / (rod.conductivity * area(diameters[i]));
        let between = (0..x.len() - 1).map(|i| {
            let resists = rod.joint.filter(|j| (j.0 - borders[i]).abs() < 1e-9 * whole);
            let joint = resists.map_or(0.0, |j| 1.0 / (j.1 * area(diameters[i].min(diameters[i + 1]))));
            1.0 / (half(i) + half(i + 1) + joint)
        });
        let between = between.collect();
        let capacity = (0..x.len()).map(|i| rod.capacity * area(diameters[i]) * size[i]).collect();
        let mut loss: Vec<f64> =
            (0..x.len()).map(|i| rod.convection * std::f64::consts::PI * diameters[i] * size[i]).collect();
        // The base is half a cell away.
        if rod.base > 0.0 {
            loss[0] += 1.0 / (1.0 / rod.base + half(0));
        }
        let heater = rod.heater.zip(rod.sources.first()).map(|(heater, source)| {
            let about = shares(&x, source.0);
            // At an end the face is half a cell away.
            let apart = if about.len() == 1 { half(about[0].0) } else { 0.0 };
            Held { capacity: heater.capacity, contact: 1.0 / (1.0 / heater.contact + apart), about }
        });
        Self { x, size, capacity, between, loss, heater }
    }

    /// Heat into every cell at a time, W; a source is shared by the two cells about it, so that it stands
    /// where it stands.
    fn heat(&self, rod: &Rod, time: f64) -> Vec<f64> {
        let (amplitude, frequency, phase) = rod.surroundings;
        let around = amplitude * ((frequency * time + phase).sin() - phase.sin());
        let mut heat: Vec<f64> = self.loss.iter().map(|loss| loss * around).collect();
        heat.extend(self.heater.iter().map(|_| 0.0));
        for (number, (x, power, from, to)) in rod.sources.iter().enumerate() {
            // Steps begin and end at the switching, and stages lie inside them.
            if time <= *from || time > *to + 1e-9 {
                continue;
            }
            if number == 0 && self.heater.is_some() {
                heat[self.x.len()] = *power;
            } else {
                shares(&self.x, *x).into_iter().for_each(|(cell, share)| heat[cell] += share * power);
            }
        }
        heat
    }

    /// C T' = −K T + q by two stages.
    fn step(&self, rises: &mut [f64], time: f64, step: f64, heat: &dyn Fn(f64) -> Vec<f64>) {
        let first = self.slope(rises, GAMMA * step, &heat(time + GAMMA * step));
        let middle: Vec<f64> = rises.iter().zip(&first).map(|(r, k)| r + (1.0 - GAMMA) * step * k).collect();
        let second = self.slope(&middle, GAMMA * step, &heat(time + step));
        for ((rise, a), b) in rises.iter_mut().zip(first).zip(second) {
            *rise += step * ((1.0 - GAMMA) * a + GAMMA * b);
        }
    }

    /// The slope k with C k = −K (T + g k) + q, by elimination along the rod, the heater eliminated first.
    fn slope(&self, rises: &[f64], g: f64, heat: &[f64]) -> Vec<f64> {
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
        // Negative entries beside the diagonal.
        let mut beside: Vec<f64> = self.between.iter().map(|between| g * between).collect();
        let weighed = |held: &Held, values: &[f64]| held.about.iter().map(|(i, w)| w * values[*i]).sum::<f64>();
        let whole = |held: &Held| held.capacity + g * held.contact;
        if let Some(held) = &self.heater {
            let flow = held.contact * (rises[n] - weighed(held, rises));
            let comes = flow + g * held.contact * (heat[n] - flow) / whole(held);
            let resists = g * held.contact * held.capacity / whole(held);
            for (i, share) in &held.about {
                right[*i] += share * comes;
                diagonal[*i] += share * share * resists;
            }
            if let [(i, a), (_, b)] = held.about[..] {
                beside[i] -= a * b * resists;
            }
        }
        for i in 1..n {
            let factor = beside[i - 1] / diagonal[i - 1];
            diagonal[i] -= factor * beside[i - 1];
            right[i] += factor * right[i - 1];
        }
        right[n - 1] /= diagonal[n - 1];
        for i in (0..n - 1).rev() {
            right[i] = (right[i] + beside[i] * right[i + 1]) / diagonal[i];
        }
        if let Some(held) = &self.heater {
            let flow = held.contact * (rises[n] - weighed(held, rises));
            right.push((heat[n] - flow + g * held.contact * weighed(held, &right)) / whole(held));
        }
        right
    }

    /// The rise at a place, between the middles of cells along a line.
    fn at(&self, rises: &[f64], x: f64) -> f64 {
        let above = self.x.partition_point(|own| own < &x).clamp(1, self.x.len() - 1);
        let part = ((x - self.x[above - 1]) / (self.x[above] - self.x[above - 1])).clamp(0.0, 1.0);
        (1.0 - part) * rises[above - 1] + part * rises[above]
    }
}

/// The cells about a place with their shares of what happens there; one at an end.
fn shares(middles: &[f64], x: f64) -> Vec<(usize, f64)> {
    match middles.partition_point(|own| *own < x) {
        0 => vec![(0, 1.0)],
        a if a == middles.len() => vec![(a - 1, 1.0)],
        a => {
            let part = (x - middles[a - 1]) / (middles[a] - middles[a - 1]);
            vec![(a - 1, 1.0 - part), (a, part)]
        }
    }
}
