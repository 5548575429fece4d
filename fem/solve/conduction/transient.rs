//! Stepping through time: one factor for every length of step, steps that end where a source is switched.

use super::system::{MAX_ITERATIONS, is_at_rest};
use super::varying::Slopes;
use super::{Energy, Scheme, ThermalError, ThermalSystem};
use crate::solve::sparse::{Matrix, Solver};

/// Part of a change of temperatures that the next one may be, before slopes are taken anew.
const SLOW: f64 = 0.2;

/// How a run steps through time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Run {
    /// Time stepping.
    pub scheme: Scheme,
    /// Longest step, s. Between two switches all steps are equal and not longer.
    pub step: f64,
    /// End of the run, s; it starts at 0.
    pub end: f64,
}

/// The end of a step.
#[derive(Clone, Copy, Debug)]
pub struct Instant<'t> {
    /// Time, s.
    pub time: f64,
    /// Enthalpies in the order of the matrix.
    numbered: &'t [f64],
    system: &'t ThermalSystem<'t>,
}

impl Instant<'_> {
    /// Temperature of a node.
    pub fn at(&self, node: usize) -> f64 {
        self.system.temperature(self.numbered[self.system.freedoms.number(node)])
    }

    /// Temperatures of all nodes.
    pub fn temperatures(&self) -> Vec<f64> {
        self.system.scattered(self.numbered)
    }
}

impl std::fmt::Debug for ThermalSystem<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "thermal system of {} nodes", self.freedoms.len())
    }
}

impl ThermalSystem<'_> {
    /// Runs from `initial` temperatures (of all nodes) and shows the end of every step, and the start, to
    /// `observe`.
    ///
    /// # Errors
    /// A value out of range; a step that cannot be factored.
    pub fn run(
        &self,
        initial: &[f64],
        run: &Run,
        mut observe: impl FnMut(Instant<'_>),
    ) -> Result<Energy, ThermalError> {
        ThermalError::check(run.step > 0.0, "step (s)", "above zero", run.step)?;
        ThermalError::check(run.end >= 0.0 && run.end.is_finite(), "end (s)", "zero or above", run.end)?;
        let nodes = self.freedoms.len();
        if initial.len() != nodes {
            return Err(ThermalError::Initial { given: initial.len(), nodes });
        }
        let mut state = self.freedoms.gather(initial);
        state.iter_mut().for_each(|own| *own = self.enthalpy(*own));
        let mut energy = Energy::default();
        let mut stepper: Option<Stepper<'_>> = None;
        self.jump(0.0, &mut state, &mut energy);
        self.check_known(0.0, &state)?;
        observe(Instant { time: 0.0, numbered: &state, system: self });
        for [from, to] in self.intervals(run.end) {
            let count = ((to - from) / run.step - 1e-9).ceil().max(1.0);
            let length = (to - from) / count;
            let mut own = match stepper.take() {
                // the factor serves as long as steps are equal up to rounding
                Some(last) if (last.length - length).abs() <= 1e-12 * length => last,
                _ => Stepper::new(self, run.scheme, length)?,
            };
            self.jump(from, &mut state, &mut energy);
            for step in 0..count as usize {
                let time = from + step as f64 * length;
                own.step(time, &mut state, &mut energy)?;
                let time = if step + 1 == count as usize { to } else { time + length };
                self.check_known(time, &state)?;
                observe(Instant { time, numbered: &state, system: self });
            }
            stepper = Some(own);
        }
        Ok(energy)
    }

    /// Sets the prescribed temperatures; what that stores has come in where they are prescribed.
    fn jump(&self, time: f64, state: &mut [f64], energy: &mut Energy) {
        let before: f64 = self.stores.iter().zip(&*state).map(|(store, own)| store * own).sum();
        self.set_held(time, state);
        let after: f64 = self.stores.iter().zip(&*state).map(|(store, own)| store * own).sum();
        energy.add(after - before, 0.0, 0.0, after - before);
    }

    /// The stretches from 0 to `end` between switches.
    fn intervals(&self, end: f64) -> Vec<[f64; 2]> {
        let mut times: Vec<f64> = self.switches.iter().copied().filter(|&time| time > 0.0 && time < end).collect();
        times.extend([0.0, end]);
        times.sort_by(f64::total_cmp);
        times.dedup_by(|b, a| *b - *a <= 1e-12 * end);
        times.windows(2).map(|ends| [ends[0], ends[1]]).collect()
    }
}

/// Steps of one length.
struct Stepper<'s> {
    system: &'s ThermalSystem<'s>,
    scheme: Scheme,
    length: f64,
    /// C + γ Δt K.
    matrix: Matrix,
    /// What was factored in its place, and its slopes: what surfaces and properties made of it at the time.
    tangent: Option<(Matrix, Slopes)>,
    solver: Solver,
    /// Rates k of the stages (K/s), the heat and the temperatures of a stage: kept between steps.
    rates: Vec<Vec<f64>>,
    heat: Vec<f64>,
    base: Vec<f64>,
}

impl<'s> Stepper<'s> {
    fn new(system: &'s ThermalSystem<'s>, scheme: Scheme, length: f64) -> Result<Self, ThermalError> {
        let matrix = system.capacity.combined(1.0, &system.conductance, scheme.gamma() * length);
        let solver = Solver::new(&system.analysis, &matrix, &system.freedoms, system.mesh.nodes())?;
        let size = system.freedoms.len();
        let rates = vec![vec![0.0; size]; scheme.weights().len()];
        let [heat, base] = [(); 2].map(|()| vec![0.0; size]);
        Ok(Self { system, scheme, length, matrix, tangent: None, solver, rates, heat, base })
    }

    /// Factors anew with these slopes.
    fn factor(&mut self, slopes: Slopes) -> Result<(), ThermalError> {
        let system = self.system;
        let reach = self.scheme.gamma() * self.length;
        let tangent = system.stored(&slopes).combined(1.0, &system.tangent(&slopes), reach);
        self.solver = Solver::new(&system.analysis, &tangent, &system.freedoms, system.mesh.nodes())?;
        self.tangent = Some((tangent, slopes));
        Ok(())
    }

    fn step(&mut self, time: f64, state: &mut [f64], energy: &mut Energy) -> Result<(), ThermalError> {
        let weights = self.scheme.weights();
        for stage in 0..weights.len() {
            self.stage(stage, time, state, energy)?;
        }
        let mut stored = 0.0;
        for (rates, weight) in self.rates.iter().zip(weights) {
            for ((own, rate), store) in state.iter_mut().zip(rates).zip(&self.system.stores) {
                let change = self.length * weight * rate;
                *own += change;
                stored += store * change;
            }
        }
        // free of the rounding of the sum
        self.system.set_held(time + self.length, state);
        energy.add(stored, 0.0, 0.0, 0.0);
        Ok(())
    }

    /// Solves a stage for its rates and accounts for the heat that flows at its temperatures.
    fn stage(&mut self, stage: usize, time: f64, state: &[f64], energy: &mut Energy) -> Result<(), ThermalError> {
        let system = self.system;
        let free = system.freedoms.free();
        let (gamma, weight) = (self.scheme.gamma(), self.scheme.weights()[stage]);
        let at = time + self.scheme.places()[stage] * self.length;
        self.base.copy_from_slice(state);
        for (rates, weight) in self.rates[..stage].iter().zip(self.scheme.weights()) {
            for (base, rate) in self.base.iter_mut().zip(rates) {
                *base += self.length * weight * rate;
            }
        }
        self.heat.fill(0.0);
        let whole = [time, time + self.length];
        let supplied = system.supply(at, whole, &mut self.heat);
        let from_ambient = system.add_ambient(at, whole, &mut self.heat);
        system.conductance.multiply_add(-1.0, &self.base, &mut self.heat);
        let rates = &mut self.rates[stage];
        // the last stage ends where the prescribed temperature does; base and weights make that exact
        let last = stage + 1 == self.scheme.weights().len();
        let (reach, part) = if last { (time + self.length, weight) } else { (at, gamma) };
        system.set_held(reach, rates);
        for (rate, base) in rates[free..].iter_mut().zip(&self.base[free..]) {
            *rate = (*rate - base) / (part * self.length);
        }
        let otherwise = if system.is_linear() {
            self.matrix.add_held_columns(-1.0, rates, &mut self.heat);
            rates[..free].copy_from_slice(&self.heat[..free]);
            self.solver.solve_unchecked(&mut rates[..free]);
            0.0
        } else {
            self.balance(stage, (at, whole))?
        };
        let rates = &self.rates[stage];
        // heat into prescribed nodes: what is missing in their rows
        let mut missing = vec![0.0; rates.len()];
        self.matrix.add_held_rows(1.0, rates, &mut missing);
        let prescribed: f64 = missing[free..].iter().zip(&self.heat[free..]).map(|(row, heat)| row - heat).sum();
        let lost = |((loss, base), rate): ((&f64, &f64), &f64)| loss * (base + gamma * self.length * rate);
        let convected =
            system.losses.iter().zip(&self.base).zip(rates).map(lost).sum::<f64>() - from_ambient + otherwise;
        let span = weight * self.length;
        energy.add(0.0, span * supplied, span * convected, span * prescribed);
        Ok(())
    }

    /// The rates of a stage at `time` of a step with which the body loses and conducts what it does at the temperatures that
    /// these lead to; the sum of what it loses otherwise than in proportion to its enthalpy, W. By Newton's steps with the
    /// tangent that was factored last, and a new one where these come near too slowly.
    fn balance(&mut self, stage: usize, at: (f64, [f64; 2])) -> Result<f64, ThermalError> {
        let system = self.system;
        let (free, reach) = (system.freedoms.free(), self.scheme.gamma() * self.length);
        let supplied = self.heat.clone();
        // As they were a stage ago is near.
        let before = if stage == 0 { self.rates.len() - 1 } else { stage - 1 };
        let near: Vec<f64> = self.rates[before][..free].to_vec();
        self.rates[stage][..free].copy_from_slice(&near);
        let mut last = f64::INFINITY;
        for _ in 0..MAX_ITERATIONS {
            let own: Vec<f64> =
                self.base.iter().zip(&self.rates[stage]).map(|(base, rate)| base + reach * rate).collect();
            self.heat.copy_from_slice(&supplied);
            let (lost, slopes) = system.lose(at, &own, &mut self.heat);
            let mut change = self.heat.clone();
            self.matrix.multiply_add(-1.0, &self.rates[stage], &mut change);
            self.solver.solve_unchecked(&mut change[..free]);
            change[free..].fill(0.0);
            let solved = change.clone();
            if let Some((_, slopes)) = &self.tangent {
                slopes.to_enthalpies(&mut change);
            }
            self.rates[stage].iter_mut().zip(&change).for_each(|(rate, change)| *rate += change);
            let moved = reach * change.iter().map(|own| own.abs()).fold(0.0, f64::max);
            if is_at_rest(moved) {
                return Ok(lost + self.follow(&solved, &change));
            }
            // Nothing was compared in the first round, but that a factor without any slope is slow for sure.
            if moved > SLOW * last || self.tangent.is_none() {
                self.factor(slopes)?;
            }
            last = moved;
        }
        Err(ThermalError::NoBalance { time: at.1[0] })
    }

    /// Takes off the heat what the last change of the rates, as it was solved for and as it is, adds to losses and conduction by the tangent, so that the balance
    /// closes but for rounding. The sum, W.
    fn follow(&mut self, solved: &[f64], change: &[f64]) -> f64 {
        let Some((tangent, _)) = &self.tangent else { return 0.0 };
        let mut further = tangent.multiply(solved);
        self.matrix.multiply_add(-1.0, change, &mut further);
        self.heat.iter_mut().zip(&further).for_each(|(heat, own)| *heat -= own);
        further.iter().sum()
    }
}
