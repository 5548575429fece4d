//! What the axes make of a corrected path: what is added to it goes through their servos as the path itself does, and the slides
//! are dragged along, wherever their drives turn round now.

use super::play::Play;

/// Steps of a lap, and laps until one is as the one before: once round takes a play up wherever it is taken up at all.
pub const STEPS: usize = 7200;
const LAPS: usize = 2;

/// Where the slides stand over a lap, in the steady state, from where their drives stand on the path as it was.
pub struct Followed {
    /// s within the lap, rising.
    times: Vec<f64>,
    /// x, y at these times, m.
    off: [Vec<f64>; 2],
    /// s.
    period: f64,
}

impl Followed {
    /// That of what is added to the command of both axes (m) at times within a lap (s, rising), of drives with these gains (1/s) and
    /// plays, without it at a place on the `path` (m), and `late` by so much (m).
    pub fn new(
        commanded: &[(f64, [f64; 2])],
        period: f64,
        axes: [(f64, &Play); 2],
        path: impl Fn(usize, f64) -> f64,
        late: impl Fn(usize, f64) -> f64,
    ) -> Self {
        let off = [0, 1].map(|axis| {
            let (gain, play) = axes[axis];
            let added = behind(commanded, period, gain, axis);
            let mut slide = commanded.first().map_or(0.0, |(time, _)| path(axis, *time));
            let mut off = Vec::new();
            for _ in 0..LAPS {
                off.clear();
                for ((time, _), added) in commanded.iter().zip(&added) {
                    let stands = path(axis, *time);
                    slide = play.carry(slide, stands - late(axis, *time) + added);
                    off.push(slide - stands);
                }
            }
            off
        });
        Self { times: commanded.iter().map(|(time, _)| *time).collect(), off, period }
    }

    /// How far the slides are off at a time within the lap, m.
    pub fn at(&self, time: f64) -> [f64; 2] {
        let next = self.times.partition_point(|own| *own <= time);
        let last = self.times.len() - 1;
        let (before, after) = if next == 0 { (last, 0) } else { (next - 1, next % self.times.len()) };
        let wide = (self.times[after] - self.times[before]).rem_euclid(self.period);
        let share = if wide > 0.0 { (time - self.times[before]).rem_euclid(self.period) / wide } else { 0.0 };
        self.off.each_ref().map(|off| off[before] + share * (off[after] - off[before]))
    }
}

/// The command of an axis behind its servo 1/(1 + s/K), straight from time to time: u' = K·(c − u) with c = c₀ + v·t gives
/// u = c − v/K + (u₀ − c₀ + v/K)·e^(−Kt). Once round from nothing, and the lap that comes back to where it began is that over
/// 1 − e^(−K·period).
fn behind(commanded: &[(f64, [f64; 2])], period: f64, gain: f64, axis: usize) -> Vec<f64> {
    let count = commanded.len();
    let mut now = 0.0;
    let mut lap = Vec::with_capacity(count);
    for round in 0..2 {
        lap.clear();
        for i in 0..count {
            lap.push(now);
            let ((from, before), (to, after)) = (commanded[i], commanded[(i + 1) % count]);
            let step = (to - from).rem_euclid(period);
            if step > 0.0 {
                let lag = (after[axis] - before[axis]) / step / gain;
                now = after[axis] - lag + (now - before[axis] + lag) * (-gain * step).exp();
            }
        }
        if round == 0 {
            now /= -(-gain * period).exp_m1();
        }
    }
    lap
}
