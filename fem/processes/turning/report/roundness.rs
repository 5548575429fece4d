//! Roundness of the turned shaft, section by section: what is left of a blank that is oval or lobed.

use std::f64::consts::TAU;

use rayon::prelude::*;

use super::super::elastic::{Cutting, Elastic, condense};
use super::super::history::History;
use super::super::machine::Machine;
use crate::process::{Column, Failure, Figure, Table, first_extreme, range, spread};
use crate::units::{LENGTH, MICRO};

/// Angles that are tried for each lobe of a turn.
const PER_LOBE: usize = 24;
/// Fewest angles in a turn.
const FEWEST: usize = 360;

/// Out-of-roundness along a shaft, m.
pub struct Roundness {
    /// Peak to valley of the radius of the blank.
    blank: f64,
    /// The same of the turned section at every place: Δ = t_rest,max − t_rest,min [seed 002 (24)].
    sections: Vec<f64>,
    /// At every place the smallest and the largest radial force around the part, N.
    forces: Vec<(f64, f64)>,
}

impl Roundness {
    /// Turns the sections at positions (m) at every angle. `None` of a blank that is round, or where nothing is copied.
    ///
    /// # Errors
    /// No equilibrium at some position.
    pub fn of(machine: &Machine, positions: &[f64]) -> Result<Option<Self>, Failure> {
        let setup = &machine.setup;
        if setup.blank.is_round() || !machine.feeds_back() {
            return Ok(None);
        }
        let count = FEWEST.max(PER_LOBE * setup.blank.most_lobes());
        let angles: Vec<f64> = (0..count).map(|i| TAU * i as f64 / count as f64).collect();
        let shaft = condense(machine, positions)?;
        let elastic = Elastic::new(machine, &shaft);
        let histories = angles.iter().map(|angle| History::on_part(machine, 1, Some(*angle)));
        let histories = histories.collect::<Result<Vec<_>, Failure>>()?;
        let section = |(i, x): (usize, &f64)| -> Result<(f64, (f64, f64)), Failure> {
            let last = Cutting::on_part(machine, 1, *x);
            let around = angles.iter().zip(&histories).map(|(angle, history)| -> Result<(f64, f64), Failure> {
                let deflection = elastic.last((i, *x), Some(*angle), &last, history.at(*x))?;
                Ok((0.5 * deflection.error, deflection.force))
            });
            let (radii, forces): (Vec<f64>, Vec<f64>) =
                around.collect::<Result<Vec<_>, Failure>>()?.into_iter().unzip();
            Ok((spread(&radii), range(forces)))
        };
        let all = positions.par_iter().enumerate().map(section).collect::<Result<Vec<_>, Failure>>()?;
        let (sections, forces) = all.into_iter().unzip();
        let blank: Vec<f64> = angles.iter().map(|angle| setup.blank.around(*angle)).collect();
        Ok(Some(Self { blank: spread(&blank), sections, forces }))
    }

    /// Says where the tool leaves the work on some side, which keeps the blank there.
    pub fn warning(&self) -> Option<String> {
        let left = self.forces.iter().filter(|forces| forces.0 <= 0.0).count();
        (left > 0).then(|| {
            let all = self.forces.len();
            format!("on some side the tool does not touch the work at {left} of {all} positions: there the blank stays")
        })
    }

    /// The smallest and the largest radial force at any angle of any section, N.
    pub fn force_range(&self) -> (f64, f64) {
        self.forces.iter().fold((f64::INFINITY, 0.0), |(low, high), f| (f64::min(low, f.0), f64::max(high, f.1)))
    }

    /// The worst section.
    pub fn figure(&self, positions: &[f64]) -> Figure {
        let worst = first_extreme(&self.sections, f64::gt);
        let (left, x) = (self.sections[worst], positions[worst]);
        let told = format!(
            "{:.3} at most, at x = {:.1}, of {:.3} of the blank",
            MICRO.shown(left),
            LENGTH.shown(x),
            MICRO.shown(self.blank)
        );
        Figure::new("roundness", "out of round by")
            .line(told)
            .quantity("largest", MICRO, left)
            .quantity("x", LENGTH, x)
            .quantity("blank", MICRO, self.blank)
            .entry("refinement", self.blank / left)
    }

    /// Section by section.
    pub fn table(&self, positions: &[f64]) -> Table {
        let columns =
            vec![Column::quantities("x", LENGTH, positions), Column::quantities("roundness", MICRO, &self.sections)];
        Table { columns }
    }
}
