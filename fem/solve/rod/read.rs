//! Readings of sensors on a rod at some times: by stepping through them all, or summed up on a contour.

use std::sync::Arc;

use super::contour::Reach;
use super::lanes::Lanes;
use super::laws::{Laws, Programme};
use super::response::{Input, Response};
use super::transfer::{Body, Inlet};
use super::{History, Power, Probe, RodError, RodSystem, Stepping, Track};
use crate::input::Cache;

/// A probe, and the instrument that shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensor {
    /// Quantity that is probed.
    pub probe: Probe,
    /// Time constant of the instrument, s; zero if it is instant.
    pub lag: f64,
}

/// Instruments whose time constants are more steps than this lose too many digits in closed form.
const SLOWEST: f64 = 1e5;

/// Laws, transfers and responses of the last few runs: a search asks again for the same rod under other inputs, and for
/// the same inputs to another rod.
#[derive(Debug, Default)]
pub struct Known {
    laws: Cache<Arc<Programme>, Laws, 8>,
    transfers: Cache<(Reach, Body), Vec<Lanes>, 32>,
    responses: Cache<Input, Response, 64>,
}

/// A term of what comes in through an inlet.
struct Term {
    inlet: usize,
    factor: f64,
    unit: Power,
}

impl RodSystem {
    /// Reads sensors, each reading given by the position of its sensor and its time (s), as [`Self::run`] and
    /// [`Track::at`] give it. A run of more steps than the contour has points is summed up there.
    ///
    /// # Errors
    /// A step or an end out of range.
    pub fn read(
        &self,
        stepping: &Stepping,
        around: &[History],
        sensors: &[Sensor],
        readings: &[(usize, f64)],
        known: &Known,
    ) -> Result<Vec<f64>, RodError> {
        stepping.check()?;
        let reach = Reach::new(stepping.end, self.fastest());
        let is_long = stepping.end / stepping.step > reach.count() as f64;
        let is_shown = sensors.iter().all(|sensor| sensor.lag < SLOWEST * stepping.step);
        match is_long && is_shown {
            true => self.summed(stepping, around, sensors, readings, (reach, known)),
            false => self.stepped(stepping, around, sensors, readings),
        }
    }

    /// The same by steps, however many.
    ///
    /// # Errors
    /// A step or an end out of range.
    pub fn stepped(
        &self,
        stepping: &Stepping,
        around: &[History],
        sensors: &[Sensor],
        readings: &[(usize, f64)],
    ) -> Result<Vec<f64>, RodError> {
        let mut track = Track::new(sensors.len());
        self.run(stepping, around, |time, nodes, switched| {
            track.push(time, switched, sensors.iter().map(|sensor| sensor.probe.read(nodes)));
        })?;
        Ok(track.shown(sensors.iter().map(|sensor| sensor.lag), readings))
    }

    /// Sums up on a contour.
    fn summed(
        &self,
        stepping: &Stepping,
        around: &[History],
        sensors: &[Sensor],
        readings: &[(usize, f64)],
        (reach, known): (Reach, &Known),
    ) -> Result<Vec<f64>, RodError> {
        let (inlets, terms) = self.terms(around);
        let mut times: Vec<f64> = readings.iter().map(|reading| reading.1).collect();
        times.sort_by(f64::total_cmp);
        times.dedup();
        let places: Vec<usize> = readings.iter().map(|(_, time)| times.partition_point(|t| t < time)).collect();
        let Stepping { scheme, step, end } = *stepping;
        let programme = Arc::new(Programme { scheme, step, intervals: self.intervals(end), reach, times });
        let laws = known.laws.get_or(programme.clone(), |programme| Ok(Laws::new(programme)))?;
        let probes: Vec<Probe> = sensors.iter().map(|sensor| sensor.probe.clone()).collect();
        let body = Body::new(self, inlets, probes);
        let inlets = body.inlets();
        let transfers = known.transfers.get_or((reach, body), |(_, body)| Ok(body.transfers(&laws.contour)))?;
        let groups = laws.groups();
        let mut shown: Vec<Vec<f64>> = Vec::with_capacity(sensors.len());
        for (i, sensor) in sensors.iter().enumerate() {
            let own = &transfers[groups * inlets * i..];
            let mut seen = Seen::new(&laws);
            for term in &terms {
                let input = Input { programme: programme.clone(), unit: term.unit.clone(), lag: sensor.lag };
                let response = known.responses.get_or(input, |input| Ok(input.response(&laws)))?;
                seen.add(&own[groups * term.inlet..][..groups], term.factor, &response);
            }
            shown.push(seen.at_times());
        }
        Ok(readings.iter().zip(&places).map(|((sensor, _), place)| shown[*sensor][*place]).collect())
    }

    /// The inlets through which something comes, and what comes in through each.
    fn terms(&self, around: &[History]) -> (Vec<Inlet>, Vec<Term>) {
        let around: Vec<Power> = around.iter().map(|level| Power { level: level.clone(), on: Vec::new() }).collect();
        let sources = self.sources.iter().enumerate().map(|(i, (_, power))| (Inlet::Source(i), power));
        let is_open = |number: &usize| self.lost_to[*number].iter().any(|loss| *loss > 0.0);
        let surroundings = (0..self.lost_to.len().min(around.len())).filter(is_open);
        let surroundings = surroundings.map(|number| (Inlet::Surroundings(number), &around[number]));
        let (mut inlets, mut terms) = (Vec::new(), Vec::new());
        for (inlet, power) in sources.chain(surroundings) {
            let own = power.level.terms();
            if own.is_empty() {
                continue;
            }
            let unit = |level| Power { level, on: power.on.clone() };
            terms.extend(own.into_iter().map(|(factor, level)| Term {
                inlet: inlets.len(),
                factor,
                unit: unit(level),
            }));
            inlets.push(inlet);
        }
        (inlets, terms)
    }

    /// A bound of the rates at which temperatures even out, 1/s: of each row of K the sizes of its entries
    /// over what C has on its diagonal more than beside it.
    pub(super) fn fastest(&self) -> f64 {
        let nodes = self.x.len();
        let mut rows: Vec<[f64; 2]> = (0..nodes)
            .map(|i| {
                let beside = |all: &[f64]| {
                    let before = i.checked_sub(1).map_or(0.0, |i| all[i].abs());
                    before + all.get(i).map_or(0.0, |entry| entry.abs())
                };
                [
                    self.conductance.diagonal[i].abs() + beside(&self.conductance.beside),
                    self.capacity.diagonal[i] - beside(&self.capacity.beside),
                ]
            })
            .collect();
        for (node, heater) in &self.heaters {
            rows[*node][0] += 2.0 * heater.contact;
            rows.push([2.0 * heater.contact, heater.heat_capacity]);
        }
        rows.into_iter().map(|[flow, store]| flow / store).fold(0.0, f64::max)
    }
}

/// Readings of a sensor at all times, summed up over the inputs.
struct Seen<'l> {
    laws: &'l Laws,
    times: Vec<f64>,
    /// Coefficient, in every stretch, of the decay of the z at its beginning: for each all points.
    first: Vec<Lanes>,
}

impl<'l> Seen<'l> {
    fn new(laws: &'l Laws) -> Self {
        let first = vec![Lanes::default(); laws.groups() * laws.stretches.len()];
        Self { laws, times: vec![0.0; laws.looks.len()], first }
    }

    /// Adds a response through its transfer.
    fn add(&mut self, transfer: &[Lanes], factor: f64, response: &Response) {
        for (time, shown) in &response.stepped {
            let sum: f64 = transfer.iter().zip(shown).map(|(a, b)| a.product_sum(b)).sum();
            self.times[*time] += factor * sum;
        }
        let whole = |all: &[Lanes]| {
            let mut sum = Lanes::default();
            transfer.iter().zip(all).for_each(|(a, b)| sum.add(&a.times(b), factor));
            sum.sum()
        };
        let first = self.first.chunks_exact_mut(transfer.len());
        for ((closed, stretch), first) in response.stretches.iter().zip(&self.laws.stretches).zip(first) {
            for ((first, transfer), own) in first.iter_mut().zip(transfer).zip(&closed.first) {
                first.add(&transfer.times(own), factor);
            }
            let waves: Vec<_> = closed.waves.iter().map(|wave| whole(wave)).collect();
            let kept = whole(&closed.kept).im;
            let turns = closed.turns.chunks_exact(waves.len()).zip(&closed.left);
            for (look, (turns, left)) in stretch.looks.iter().zip(turns) {
                let turned: f64 =
                    waves.iter().zip(turns).map(|(wave, turn)| wave.re * turn.im + wave.im * turn.re).sum();
                self.times[look.time] += turned + kept * left;
            }
        }
    }

    fn at_times(mut self) -> Vec<f64> {
        let groups = self.laws.groups();
        for (stretch, first) in self.laws.stretches.iter().zip(self.first.chunks_exact(groups)) {
            for (look, left) in stretch.looks.iter().zip(stretch.left.chunks_exact(groups)) {
                self.times[look.time] += first.iter().zip(left).map(|(a, b)| a.product_sum(b)).sum::<f64>();
            }
        }
        self.times
    }
}
