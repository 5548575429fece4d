//! A rod through time.

use super::tridiagonal::{Factor, dot};
use super::{Energy, Heater, History, RodError, RodSystem, Scheme};

/// Halvings of the first step after a switch: a jump acts as the root of time.
const HALVINGS: i32 = 5;

/// How a run steps through time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stepping {
    /// Scheme of every step.
    pub scheme: Scheme,
    /// Longest step, s.
    pub step: f64,
    /// End of the run, s; it starts at 0.
    pub end: f64,
}

impl RodSystem {
    /// Runs from no rise anywhere and shows the start and the end of every step to `observe`: the time (s),
    /// the rises of all nodes (K), and whether a source may be switched there. `around` are the rises of the
    /// surroundings over time, by their numbers; those that are left out stay as all is at the start.
    ///
    /// # Errors
    /// A step or an end out of range.
    pub fn run(
        &self,
        stepping: &Stepping,
        around: &[History],
        mut observe: impl FnMut(f64, &[f64], bool),
    ) -> Result<Energy, RodError> {
        let steps = Steps::new(self, stepping)?;
        let nodes = self.x.len();
        let mut state = vec![0.0; self.stores.len()];
        let mut energy = Energy::default();
        let mut stepper: Option<Stepper<'_>> = None;
        observe(0.0, &state[..nodes], true);
        for (i, length) in steps.lengths.iter().copied().enumerate() {
            let mut own = match stepper.take() {
                Some(own) if is_same(own.length, length) => own,
                _ => Stepper::new(self, stepping.scheme, length),
            };
            own.step(steps.times[i], around, &mut state, &mut energy);
            observe(steps.times[i + 1], &state[..nodes], steps.switches.binary_search(&(i + 1)).is_ok());
            stepper = Some(own);
        }
        Ok(energy)
    }

    /// The times 0, of the switches, and of the end.
    pub(super) fn intervals(&self, end: f64) -> Vec<f64> {
        let mut times: Vec<f64> = self.switches().filter(|time| *time > 0.0 && *time < end).collect();
        times.extend([0.0, end]);
        times.sort_by(f64::total_cmp);
        times.dedup_by(|b, a| *b - *a <= 1e-12 * end);
        times
    }
}

impl Stepping {
    pub(super) fn check(&self) -> Result<(), RodError> {
        let Self { step, end, .. } = *self;
        if !(step > 0.0 && step.is_finite()) {
            return Err(RodError::Value("the time step (s)", step));
        }
        if !(end >= 0.0 && end.is_finite()) {
            return Err(RodError::Value("the end of the run (s)", end));
        }
        Ok(())
    }
}

/// The steps of a run.
#[derive(Clone, Debug, Default)]
pub(super) struct Steps {
    /// Times of the start and of the end of every step, s.
    pub times: Vec<f64>,
    /// Length of every step, s.
    pub lengths: Vec<f64>,
    /// Positions in `times` between which all is smooth.
    pub switches: Vec<usize>,
}

impl Steps {
    /// Of a system with its switches.
    pub fn new(system: &RodSystem, stepping: &Stepping) -> Result<Self, RodError> {
        stepping.check()?;
        Ok(Self::between(&system.intervals(stepping.end), stepping.step))
    }

    /// No longer than `step` (s), from each of these times to the next.
    pub fn between(intervals: &[f64], step: f64) -> Self {
        let mut all = Self { times: vec![0.0], switches: vec![0], ..Self::default() };
        for ends in intervals.windows(2) {
            let lengths = lengths(ends[1] - ends[0], step);
            let mut time = ends[0];
            for length in &lengths {
                time += length;
                all.times.push(time);
            }
            let last = all.times.len() - 1;
            all.times[last] = ends[1];
            all.switches.push(last);
            all.lengths.extend(lengths);
        }
        all
    }
}

/// Steps that fill `whole`: equal and no longer than `step`, the first of them halved again and again towards
/// its start.
fn lengths(whole: f64, step: f64) -> Vec<f64> {
    let count = (whole / step - 1e-9).ceil().max(1.0);
    let length = whole / count;
    let halved = (1..=HALVINGS).rev().map(|k| length * 0.5f64.powi(k));
    let first = length * 0.5f64.powi(HALVINGS);
    std::iter::once(first).chain(halved).chain(std::iter::repeat_n(length, count as usize - 1)).collect()
}

/// Whether two steps have the same length but for rounding.
pub(super) fn is_same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * b
}

/// Steps of one length.
struct Stepper<'s> {
    system: &'s RodSystem,
    scheme: Scheme,
    length: f64,
    factor: Factor,
    /// Rates of the stages, K/s.
    rates: Vec<Vec<f64>>,
    base: Vec<f64>,
}

impl<'s> Stepper<'s> {
    fn new(system: &'s RodSystem, scheme: Scheme, length: f64) -> Self {
        let (size, reach) = (system.stores.len(), scheme.gamma() * length);
        let mut capacity = system.capacity.clone();
        for (node, heater) in &system.heaters {
            capacity.diagonal[*node] += heater.heat_capacity * heater.passed(reach);
        }
        Self {
            factor: Factor::of_sum(&capacity, reach, &system.conductance),
            rates: vec![vec![0.0; size]; scheme.weights().len()],
            base: vec![0.0; size],
            system,
            scheme,
            length,
        }
    }

    /// One step, as in `conduction`: (C + γΔt K)·kᵢ = f(t + cᵢΔt) − K·(θ + Δt Σ aᵢⱼkⱼ).
    fn step(&mut self, time: f64, around: &[History], state: &mut [f64], energy: &mut Energy) {
        let (system, length, gamma) = (self.system, self.length, self.scheme.gamma());
        let (weights, whole) = (self.scheme.weights(), [time, time + length]);
        for (stage, place) in self.scheme.places().iter().enumerate() {
            self.base.copy_from_slice(state);
            for (rates, weight) in self.rates[..stage].iter().zip(weights) {
                self.base.iter_mut().zip(rates).for_each(|(base, rate)| *base += length * weight * rate);
            }
            let at = time + place * length;
            let rates = &mut self.rates[stage];
            rates.fill(0.0);
            for (losses, level) in system.lost_to.iter().zip(around) {
                let level = level.within(at, whole);
                rates.iter_mut().zip(losses).for_each(|(rate, loss)| *rate += loss * level);
            }
            let back: f64 = rates.iter().sum();
            let mut supplied = 0.0;
            for (warmed, power) in &system.sources {
                let power = power.within(at, whole);
                rates[*warmed] += power;
                supplied += power;
            }
            self.solve(stage);
            let rates = &self.rates[stage];
            let lost = dot(&system.losses, &self.base) + gamma * length * dot(&system.losses, rates) - back;
            let span = weights[stage] * length;
            energy.add(0.0, span * supplied, span * lost, 0.0);
        }
        for (rates, weight) in self.rates.iter().zip(weights) {
            state.iter_mut().zip(rates).for_each(|(own, rate)| *own += length * weight * rate);
            energy.add(length * weight * dot(&system.stores, rates), 0.0, 0.0, 0.0);
        }
    }

    /// Solves a stage: from the heat that comes in its rates. A heater is a node that only one node of the
    /// rod touches, so that it is eliminated first, exactly, and found again from that node's rate: what is
    /// left is tridiagonal.
    fn solve(&mut self, stage: usize) {
        let (system, base) = (self.system, &self.base);
        let (reach, nodes) = (self.scheme.gamma() * self.length, system.x.len());
        let (rates, heated) = self.rates[stage].split_at_mut(nodes);
        system.conductance.subtract_product(&base[..nodes], rates);
        for (i, (node, heater)) in system.heaters.iter().enumerate() {
            let flow = heater.contact * (base[nodes + i] - base[*node]);
            heated[i] -= flow;
            rates[*node] += flow + heater.passed(reach) * heated[i];
        }
        self.factor.solve(rates);
        for (i, (node, heater)) in system.heaters.iter().enumerate() {
            let stiffness = reach * heater.contact;
            heated[i] = (heated[i] + stiffness * rates[*node]) / (heater.heat_capacity + stiffness);
        }
    }
}

impl Heater {
    /// Part of the heat into the heater that the rod gets within a stage of γΔt (s): G γΔt / (C + G γΔt).
    fn passed(&self, reach: f64) -> f64 {
        let stiffness = reach * self.contact;
        stiffness / (self.heat_capacity + stiffness)
    }
}
