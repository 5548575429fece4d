//! Workpiece heating: transient conduction along the stepped shaft under a travelling point source.
//!
//! rho c A theta_t = (k A theta_x)_x - h pi D theta + power delta(x - x_tool), ends insulated, cold at the
//! start of each part. Finite volumes on a grid fine against the length k/(rho c v) of the kink ahead of
//! the tool, stepped by an L-stable second-order diagonally implicit Runge-Kutta method (the source feeds
//! the shortest waves, which Crank-Nicolson would keep).

use super::shaft::Shaft;
use std::f64::consts::PI;

/// The finite-volume shaft: nodes with capacities (J/K) and losses (W/K), cells with conductances (W/K);
/// metres inside.
struct Grid {
    x: Vec<f64>,
    capacity: Vec<f64>,
    loss: Vec<f64>,
    conductance: Vec<f64>,
}

impl Grid {
    fn new(shaft: &Shaft, convection: f64, size: f64) -> Self {
        let m = &shaft.material;
        let mut grid = Self { x: vec![0.0], capacity: vec![0.0], loss: vec![0.0], conductance: Vec::new() };
        for segment in &shaft.segments {
            let (length, d) = (segment.length * 1e-3, segment.diameter * 1e-3);
            let cells = (length / size).ceil().max(1.0);
            let h = length / cells;
            let start = grid.x[grid.x.len() - 1];
            let area = 1e-6 * segment.area();
            let (half_capacity, half_loss) =
                (m.density * m.specific_heat * area * h / 2.0, convection * PI * d * h / 2.0);
            for i in 1..=cells as usize {
                let last = grid.x.len() - 1;
                grid.capacity[last] += half_capacity;
                grid.loss[last] += half_loss;
                grid.x.push(start + i as f64 * h);
                grid.capacity.push(half_capacity);
                grid.loss.push(half_loss);
                grid.conductance.push(m.conductivity * area / h);
            }
        }
        grid
    }

    /// Heat flowing out of every node at the temperatures `t`.
    fn outflow(&self, t: &[f64], out: &mut [f64]) {
        out.iter_mut().zip(t).zip(&self.loss).for_each(|((o, t), l)| *o = l * t);
        for (i, g) in self.conductance.iter().enumerate() {
            let flow = g * (t[i] - t[i + 1]);
            out[i] += flow;
            out[i + 1] -= flow;
        }
    }

    /// Heat from a unit source at `at` inside the cell `cell`, shared between its ends by the lever rule.
    fn feed(&self, cell: usize, at: f64, power: f64, out: &mut [f64]) {
        let share = (at - self.x[cell]) / (self.x[cell + 1] - self.x[cell]);
        out[cell] += power * (1.0 - share);
        out[cell + 1] += power * share;
    }
}

/// Factored tridiagonal matrix capacity + step * (conduction + loss).
struct Implicit {
    below: Vec<f64>,
    pivot: Vec<f64>,
    above: Vec<f64>,
}

impl Implicit {
    fn new(grid: &Grid, step: f64) -> Self {
        let n = grid.x.len();
        let mut pivot: Vec<f64> = (0..n).map(|i| grid.capacity[i] + step * grid.loss[i]).collect();
        for (i, g) in grid.conductance.iter().enumerate() {
            pivot[i] += step * g;
            pivot[i + 1] += step * g;
        }
        let above: Vec<f64> = grid.conductance.iter().map(|g| -step * g).collect();
        let mut below = vec![0.0; n - 1];
        for i in 1..n {
            below[i - 1] = above[i - 1] / pivot[i - 1];
            pivot[i] -= below[i - 1] * above[i - 1];
        }
        pivot.iter_mut().for_each(|p| *p = p.recip());
        Self { below, pivot, above }
    }

    fn solve(&self, b: &mut [f64]) {
        for i in 1..b.len() {
            b[i] -= self.below[i - 1] * b[i - 1];
        }
        let last = b.len() - 1;
        b[last] *= self.pivot[last];
        for i in (0..last).rev() {
            b[i] = (b[i] - self.above[i] * b[i + 1]) * self.pivot[i];
        }
    }
}

/// Temperature rise at the tool per watt when it passes each of `at` (mm); the tool runs at `speed`
/// (mm/min) toward the tailstock when `forward`, else toward the headstock. `size` is the finer cell
/// length, mm.
///
/// The source's kink holds the method to an observed order of about 1.6 between 1 mm and 0.25 mm
/// (`examples/order.rs`), so two grids are extrapolated with that order.
pub fn tool_temperature(shaft: &Shaft, convection: f64, speed: f64, forward: bool, size: f64, at: &[f64]) -> Vec<f64> {
    let coarse = on_grid(shaft, convection, speed, forward, 2.0 * size, at);
    let fine = on_grid(shaft, convection, speed, forward, size, at);
    fine.iter().zip(coarse).map(|(f, c)| f + (f - c) / (2_f64.powf(1.6) - 1.0)).collect()
}

/// The same on one grid.
pub fn on_grid(shaft: &Shaft, convection: f64, speed: f64, forward: bool, size: f64, at: &[f64]) -> Vec<f64> {
    let grid = Grid::new(shaft, convection, size * 1e-3);
    let n = grid.x.len();
    let velocity = speed * 1e-3 / 60.0;
    let gamma = 1.0 - 0.5_f64.sqrt();
    let (mut t, mut k1, mut k2, mut middle) = (vec![0.0; n], vec![0.0; n], vec![0.0; n], vec![0.0; n]);
    let mut trace = vec![0.0; n];
    let mut implicit: Option<(f64, Implicit)> = None;
    for passed in 0..n - 1 {
        let (from, to) = if forward { (passed, passed + 1) } else { (n - 1 - passed, n - 2 - passed) };
        let cell = from.min(to);
        let dt = (grid.x[to] - grid.x[from]).abs() / velocity;
        if implicit.as_ref().is_none_or(|(step, _)| (step / dt - 1.0).abs() > 1e-9) {
            implicit = Some((dt, Implicit::new(&grid, gamma * dt)));
        }
        let Some((_, matrix)) = &implicit else { continue };
        stage(&grid, matrix, &t, &mut k1, cell, grid.x[from] + gamma * (grid.x[to] - grid.x[from]));
        middle.iter_mut().zip(t.iter().zip(&k1)).for_each(|(m, (t, k))| *m = t + (1.0 - gamma) * dt * k);
        stage(&grid, matrix, &middle, &mut k2, cell, grid.x[to]);
        t.iter_mut().zip(k1.iter().zip(&k2)).for_each(|(t, (a, b))| *t += dt * ((1.0 - gamma) * a + gamma * b));
        trace[to] = t[to];
    }
    at.iter().map(|&x| interpolate(&grid.x, &trace, x * 1e-3)).collect()
}

/// One stage: rate = (C + gamma dt M)^-1 (source - M t).
fn stage(grid: &Grid, matrix: &Implicit, t: &[f64], rate: &mut [f64], cell: usize, tool: f64) {
    grid.outflow(t, rate);
    rate.iter_mut().for_each(|r| *r = -*r);
    grid.feed(cell, tool, 1.0, rate);
    matrix.solve(rate);
}

fn interpolate(x: &[f64], y: &[f64], at: f64) -> f64 {
    let i = x.partition_point(|&v| v <= at).clamp(1, x.len() - 1);
    let share = (at - x[i - 1]) / (x[i] - x[i - 1]);
    y[i - 1] * (1.0 - share) + y[i] * share
}
