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
    /// Rise of the surroundings: amplitude K, angular frequency 1/s, phase.
    pub surroundings: (f64, f64, f64),
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
}

/// Rises at every place `at` (m) and the integral of the rise over the rod (K m), at each of the rising
/// `times` (s).
pub fn histories(rod: &Rod, at: &[f64], times: &[f64]) -> Vec<(Vec<f64>, f64)> {
    let cells = Cells::of(rod);
    let heat = |t: f64| cells.heat(rod, t);
    let mut stops: Vec<f64> = rod.sources.iter().flat_map(|s| [s.2, s.3]).chain(times.iter().copied()).collect();
    stops.sort_by(f64::total_cmp);
    let (mut rises, mut now, mut found) = (vec![0.0; cells.x.len()], 0.0, Vec::new());
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
        Self { x, size, capacity, between, loss }
    }

    /// Heat into every cell at a time, W; a source is shared by the two cells about it, so that it stands
    /// where it stands.
    fn heat(&self, rod: &Rod, time: f64) -> Vec<f64> {
        let (amplitude, frequency, phase) = rod.surroundings;
        let around = amplitude * ((frequency * time + phase).sin() - phase.sin());
        let mut heat: Vec<f64> = self.loss.iter().map(|loss| loss * around).collect();
        for (x, power, from, to) in &rod.sources {
            // Steps begin and end at the switching, and stages lie inside them.
            if time <= *from || time > *to + 1e-9 {
                continue;
            }
            let above = self.x.partition_point(|own| own < x);
            match above {
                0 => heat[0] += power,
                a if a == self.x.len() => heat[a - 1] += power,
                a => {
                    let part = (x - self.x[a - 1]) / (self.x[a] - self.x[a - 1]);
                    heat[a - 1] += (1.0 - part) * power;
                    heat[a] += part * power;
                }
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

    /// The slope k with C k = −K (T + g k) + q, by elimination along the rod.
    fn slope(&self, rises: &[f64], g: f64, heat: &[f64]) -> Vec<f64> {
        let n = rises.len();
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
        for i in 1..n {
            let factor = g * self.between[i - 1] / diagonal[i - 1];
            diagonal[i] -= factor * g * self.between[i - 1];
            right[i] += factor * right[i - 1];
        }
        right[n - 1] /= diagonal[n - 1];
        for i in (0..n - 1).rev() {
            right[i] = (right[i] + g * self.between[i] * right[i + 1]) / diagonal[i];
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
