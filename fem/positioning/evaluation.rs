//! The statistics of a positioning test by ISO 230-2: means and scatter of every target from either side.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::{Approach, Direction, Measures};

/// The edition whose names are used; the formulas have been the same since 1997 (coverage factor 2, s with n
/// − 1).
pub const EDITION: &str = "ISO 230-2:2014";

/// Targets nearer than this (m, or rad: 0.0002 arcsec) are one.
const SAME: f64 = 1e-9;

/// The approaches to a target from one side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Side {
    /// Mean x̄ of the deviations, m.
    pub mean: f64,
    /// Standard deviation s with n − 1, m; `None` of a single approach.
    pub scatter: Option<f64>,
    /// Number n of approaches.
    pub count: usize,
}

/// A target with what was found there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Target {
    /// Commanded position, m.
    pub position: f64,
    /// Approached forwards.
    pub forward: Option<Side>,
    /// Approached backwards.
    pub backward: Option<Side>,
}

/// A positioning test by its targets, in rising order.
#[derive(Clone, Debug, PartialEq)]
pub struct Evaluation {
    /// Targets with their deviations.
    pub targets: Vec<Target>,
}

/// Whether rising angles (rad) go round a whole turn: from the last to the first, a turn on, is no further than from one to the
/// next.
pub fn goes_around(angles: &[f64]) -> bool {
    let widest = angles.windows(2).map(|two| two[1] - two[0]).fold(0.0, f64::max);
    let left = angles.first().zip(angles.last()).map_or(f64::INFINITY, |(first, last)| first + TAU - last);
    (-SAME..=widest * (1.0 + 1e-6)).contains(&left)
}

/// Whether two targets or more stand apart by multiples of a period alone (m or rad): what comes back with it is at all of them
/// the same, and taken for a shift, wherever the first stands.
pub fn stand_apart_by(period: f64, targets: &[f64]) -> bool {
    let is_whole = |n: f64| (n - n.round()).abs() < 1e-6;
    targets.len() > 1 && targets.iter().all(|x| is_whole((x - targets[0]) / period))
}

impl Side {
    fn of(deviations: &[f64]) -> Option<Self> {
        let count = deviations.len();
        let mean = deviations.iter().sum::<f64>() / count as f64;
        let squares: f64 = deviations.iter().map(|d| (d - mean).powi(2)).sum();
        let scatter = (count > 1).then(|| (squares / (count - 1) as f64).sqrt());
        (count > 0).then_some(Self { mean, scatter, count })
    }

    /// Unidirectional repeatability R_i = 4 s_i, m.
    pub fn repeatability(&self) -> Option<f64> {
        Some(4.0 * self.scatter?)
    }

    /// x̄ − 2s and x̄ + 2s, m.
    pub fn band(&self) -> Option<(f64, f64)> {
        let s = self.scatter?;
        Some((self.mean - 2.0 * s, self.mean + 2.0 * s))
    }
}

impl Target {
    /// Statistics of the approaches from one side; `None` where there were none.
    pub fn side(&self, direction: Direction) -> Option<&Side> {
        match direction {
            Direction::Forward => self.forward.as_ref(),
            Direction::Backward => self.backward.as_ref(),
        }
    }

    /// The sides from which it was approached.
    pub fn sides(&self) -> impl Iterator<Item = &Side> {
        self.forward.iter().chain(&self.backward)
    }

    /// B_i = x̄_i↑ − x̄_i↓, m.
    pub fn reversal(&self) -> Option<f64> {
        Some(self.forward?.mean - self.backward?.mean)
    }

    /// x̄_i = (x̄_i↑ + x̄_i↓)/2, m.
    pub fn mean(&self) -> Option<f64> {
        Some(0.5 * (self.forward?.mean + self.backward?.mean))
    }

    /// R_i = max(2s_i↑ + 2s_i↓ + |B_i|, R_i↑, R_i↓), m.
    pub fn repeatability(&self) -> Option<f64> {
        let (forward, backward) = (self.forward?, self.backward?);
        let both = 2.0 * forward.scatter? + 2.0 * backward.scatter? + self.reversal()?.abs();
        Some(both.max(forward.repeatability()?).max(backward.repeatability()?))
    }
}

impl Evaluation {
    /// The evaluation of approaches and the deviation of each, in any order.
    pub fn of(approaches: &[Approach], deviations: &[f64]) -> Self {
        let mut order: Vec<usize> = (0..approaches.len()).collect();
        order.sort_by(|a, b| approaches[*a].position.total_cmp(&approaches[*b].position));
        let mut groups: Vec<(f64, [Vec<f64>; 2])> = Vec::new();
        for row in order {
            let Approach { position, direction, .. } = approaches[row];
            if groups.last().is_none_or(|(at, _)| position - at > SAME) {
                groups.push((position, Default::default()));
            }
            if let Some((_, sides)) = groups.last_mut() {
                sides[usize::from(direction == Direction::Backward)].push(deviations[row]);
            }
        }
        let target = |(position, [forward, backward]): &(f64, [Vec<f64>; 2])| Target {
            position: *position,
            forward: Side::of(forward),
            backward: Side::of(backward),
        };
        Self { targets: groups.iter().map(target).collect() }
    }

    /// The test between two places, both included.
    pub fn within(&self, from: f64, to: f64) -> Self {
        let inside = |t: &&Target| (from - SAME..=to + SAME).contains(&t.position);
        Self { targets: self.targets.iter().filter(inside).copied().collect() }
    }

    /// The same with what lies between targets at both ends, as on straight lines.
    pub fn stretch(&self, from: f64, to: f64) -> Self {
        let inside = self.within(from, to).targets;
        let mut targets: Vec<Target> = self.between(from).into_iter().chain(inside).collect();
        targets.extend(self.between(to));
        Self { targets }
    }

    /// The same with the targets of the first `angle` (rad) once more a turn on, where the last stands no further before the first
    /// than targets stand apart: the way around is closed there.
    #[must_use]
    pub fn around(&self, angle: f64) -> Self {
        let (first, _) = self.ends();
        let mut targets = self.targets.clone();
        if goes_around(&self.targets.iter().map(|t| t.position).collect::<Vec<_>>()) {
            let last = targets.len() - 1;
            let again = self.targets.iter().take(last).filter(|t| t.position <= first + angle + SAME);
            let on = again.map(|t| Target { position: t.position + TAU, ..*t });
            targets.extend(on.filter(|t| t.position > self.targets[last].position + SAME));
        }
        Self { targets }
    }

    /// The target that would be found at a place between two others, on straight lines between them; `None`
    /// at a target and beyond the last.
    fn between(&self, position: f64) -> Option<Target> {
        let pair =
            self.targets.windows(2).find(|p| p[0].position + SAME < position && position < p[1].position - SAME)?;
        let part = (position - pair[0].position) / (pair[1].position - pair[0].position);
        let straight = |a: f64, b: f64| a + part * (b - a);
        let side = |direction: Direction| {
            let (a, b) = (pair[0].side(direction)?, pair[1].side(direction)?);
            Some(Side {
                mean: straight(a.mean, b.mean),
                scatter: a.scatter.zip(b.scatter).map(|(a, b)| straight(a, b)),
                count: a.count.min(b.count),
            })
        };
        Some(Target { position, forward: side(Direction::Forward), backward: side(Direction::Backward) })
    }

    /// Fewest approaches to any target from any side.
    pub fn runs(&self) -> usize {
        self.targets.iter().flat_map(Target::sides).map(|s| s.count).min().unwrap_or(0)
    }

    /// First and last target, m.
    pub fn ends(&self) -> (f64, f64) {
        let at = |t: Option<&Target>| t.map_or(f64::NAN, |t| t.position);
        (at(self.targets.first()), at(self.targets.last()))
    }

    /// Largest standard uncertainty of a mean, s/√n, m; 0 where no target was approached twice from a side.
    pub fn uncertainty(&self) -> f64 {
        let of = |side: &Side| Some(side.scatter? / (side.count as f64).sqrt());
        self.targets.iter().flat_map(Target::sides).filter_map(of).fold(0.0, f64::max)
    }

    /// Departures of this test from the standard, as sentences.
    pub fn departures(&self, measures: Measures) -> Vec<String> {
        let mut departures = Vec::new();
        let (from, to) = self.ends();
        let (wanted, asked) = if measures.is_rotary() {
            (targets_of_a_turn(to - from), "three up to 90 deg, five up to 180 deg and eight beyond")
        } else {
            (5.0f64.max(5.0 * (to - from).min(2.0)).ceil() as usize, "five a metre and five at least")
        };
        if self.targets.len() < wanted {
            let given = self.targets.len();
            departures.push(format!("{given} targets: the standard asks for {asked}, here {wanted}"));
        }
        if self.runs() < 5 {
            let runs = self.runs();
            departures
                .push(format!("{runs} approaches from a side where there are fewest: the standard asks for five"));
        }
        let one_sided = self.targets.iter().filter(|t| t.forward.is_none() || t.backward.is_none()).count();
        if one_sided == self.targets.len() {
            departures.push("all targets were approached from one side only: there is neither B nor R".into());
        } else if one_sided > 0 {
            departures.push("some targets were approached from one side only: B and R are of the others".into());
        }
        departures
    }
}

/// Fewest targets of a rotary axis that turns by so much (rad) [ISO 230-2].
fn targets_of_a_turn(range: f64) -> usize {
    match range * (1.0 - 1e-9) {
        range if range <= FRAC_PI_2 => 3,
        range if range <= PI => 5,
        _ => 8,
    }
}
