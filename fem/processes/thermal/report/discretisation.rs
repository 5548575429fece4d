//! What elements and steps leave, from longer and from shorter ones.

use super::super::forward::observe;
use super::super::machine::Machine;
use super::super::rows::{DIAMETER, ELONGATION, TEMPERATURE_OF_ROW, own};
use super::super::setup::{Setup, Time};
use crate::process::{Failure, Figure, Forward, Rows};
use crate::units::{MICRO, TEMPERATURE_RISE};

/// Errors above this part of the largest change are warned of.
const COARSE: f64 = 0.01;
/// Steps are this part longer or shorter than they are meant to be.
const ROUND_OFF: f64 = 1e-9;

/// Errors that elements and steps leave in what the programme reads.
#[derive(Clone, Copy)]
pub struct Left {
    /// Of temperatures, K.
    temperature: f64,
    /// Of the elongation and of diameters, m; none where neither is read.
    length: Option<f64>,
    /// How long the others are that were looked at.
    others: &'static str,
}

impl Left {
    /// What twice as long ones change, less what their own order leaves. Where the run or what it reads is shorter than a given step
    /// no longer one changes anything: half as long ones are looked at too.
    ///
    /// # Errors
    /// The body cannot be computed.
    pub fn by_elements_and_steps(machine: &Machine, forward: &Forward, longest: f64) -> Result<Self, Failure> {
        let order = f64::from(1 << machine.setup.time.order());
        let coarse = Self::against(&machine.coarser(2.0 * longest), forward, 1.0 / (order - 1.0))?;
        let Time { end, step, .. } = machine.setup.time;
        let is_shortened = step.is_some_and(|given| given > longest * (1.0 + ROUND_OFF));
        if !is_shortened && 2.0 * longest <= end {
            return Ok(coarse);
        }
        let fine = Self::against(&machine.with_step(0.5 * longest), forward, order / (order - 1.0))?;
        let length = coarse.length.zip(fine.length).map(|(a, b)| a.max(b));
        Ok(Self { temperature: coarse.temperature.max(fine.temperature), length, others: "twice and half as long" })
    }

    /// This part of what another machine changes.
    fn against(other: &Machine, forward: &Forward, part: f64) -> Result<Self, Failure> {
        let (rows, here) = (forward.programme, forward.prediction);
        let mut there = observe(other, rows)?;
        forward.add_formulas(rows, &mut there);
        let apart = |observables: &[usize]| {
            let rows = observables.iter().flat_map(|observable| own(rows, *observable));
            rows.map(|row| part * (here[row] - there[row]).abs()).reduce(f64::max)
        };
        Ok(Self {
            temperature: apart(&[TEMPERATURE_OF_ROW]).unwrap_or(0.0),
            length: apart(&[ELONGATION, DIAMETER]),
            others: "twice as long",
        })
    }

    /// The figure of it.
    pub fn figure(self) -> Figure {
        let length = self.length.map(|length| format!(" and {:.1e} um", MICRO.from_si(length))).unwrap_or_default();
        let text = format!("leave some {:.1e} K{length}, by what {} ones change", self.temperature, self.others);
        let figure = Figure::new("discretisation", "elements and steps").line(text);
        let figure = figure.quantity("error", TEMPERATURE_RISE, self.temperature);
        self.length.map_or(figure.clone(), |length| figure.quantity("length_error", MICRO, length))
    }

    /// That they are too long.
    pub fn warning(self, setup: &Setup, rows: &Rows, observed: &[f64]) -> Option<String> {
        let largest = |observables: &[usize], start: f64| {
            let rows = observables.iter().flat_map(|observable| own(rows, *observable));
            rows.map(|row| (observed[row] - start).abs()).fold(0.0, f64::max)
        };
        let tolerance = setup.time.tolerance;
        let warmest = largest(&[TEMPERATURE_OF_ROW], setup.start);
        let is_coarse = self.temperature > tolerance.max(COARSE * warmest);
        // The size of the body over which a tolerated error of its temperature would show.
        let grown = largest(&[ELONGATION, DIAMETER], 0.0);
        let share = COARSE.max(if warmest > 0.0 { tolerance / warmest } else { 0.0 });
        let is_off = self.length.is_some_and(|length| length > share * grown);
        (is_coarse || is_off).then(|| {
            let length = self.length.map(|length| format!(" and {:.2}", MICRO.shown(length))).unwrap_or_default();
            let temperature = TEMPERATURE_RISE.shown(self.temperature);
            let remedy = "take a smaller element_size in [mesh], and shorter steps";
            format!("elements and steps leave errors of some {temperature:.2}{length}: {remedy}")
        })
    }
}
