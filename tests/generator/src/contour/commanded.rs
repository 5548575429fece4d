//! Laps whose command stands farther out than the circle, by a table over the angle. What is added goes through the servo as the
//! circle does; the slide is dragged along, whatever its drive does.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::axis::{Axis, State};

/// Steps of a lap, and laps until it repeats itself.
const STEPS: usize = 14_400;
const LAPS: usize = 3;

/// An axis on such a lap: where its slide is at every step of the last lap.
pub struct Lap {
    axis: Axis,
    slide: Vec<f64>,
}

/// What a table (deg, um; rising) adds at an angle (rad), mm; straight between, over the end too.
fn added(table: &[(f64, f64)], angle: f64) -> f64 {
    let at = angle.to_degrees().rem_euclid(360.0);
    let next = table.partition_point(|(own, _)| *own <= at);
    let [before, after] = [(next + table.len() - 1) % table.len(), next % table.len()].map(|i| table[i]);
    let wide = (after.0 - before.0).rem_euclid(360.0);
    let share = if wide > 0.0 { (at - before.0).rem_euclid(360.0) / wide } else { 0.0 };
    1e-3 * (before.1 + (after.1 - before.1) * share)
}

impl Lap {
    /// That of axis x (`quarter` 0) or y (1), which runs round ±1.
    pub fn new(axis: Axis, table: &[(f64, f64)], quarter: f64, round: f64) -> Self {
        let step = TAU / STEPS as f64;
        let keeps = (-axis.gain * step / axis.speed).exp();
        // The own phase of an axis is that of its cosine.
        let out = |phase: f64| {
            let angle = round * (phase + quarter * round * FRAC_PI_2);
            added(table, angle) * if quarter == 0.0 { angle.cos() } else { angle.sin() }
        };
        let (mut behind, mut slide) = (0.0, axis.drive_at(0.0));
        let mut last = Vec::with_capacity(STEPS);
        for lap in 0..LAPS {
            for k in 0..STEPS {
                let phase = step * k as f64;
                if lap + 1 == LAPS {
                    last.push(slide);
                }
                let goal = out(phase + 0.5 * step);
                behind = goal + (behind - goal) * keeps;
                slide = axis.lost.dragged(slide, axis.drive_at(phase + step) + behind);
            }
        }
        Self { axis, slide: last }
    }

    /// Where it is at a phase of its own.
    pub fn at(&self, phase: f64) -> State {
        let at = phase.rem_euclid(TAU) / TAU * STEPS as f64;
        let (below, share) = (at as usize % STEPS, at.fract());
        let place = self.slide[below] + share * (self.slide[(below + 1) % STEPS] - self.slide[below]);
        State { place, ..self.axis.at(phase) }
    }
}
