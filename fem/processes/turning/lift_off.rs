//! Where parts leave each other: a support that would have to pull, a tool that does not touch. The equilibrium holds
//! all the same, for supports are springs that yield both ways, but such a machine does not exist.

use super::elastic::Deflection;
use super::forward::rest_forces;
use super::machine::Machine;
use super::setup::Workholding;
use crate::process::Failure;
use crate::units::{FORCE, LENGTH};

/// Part of the largest cutting force beyond which a support pulls: the round-off of an equilibrium is far below it.
const PULLS: f64 = 1e-4;

/// Where parts leave each other at some tool positions.
#[derive(Default)]
pub struct LiftOff {
    /// Supports that would have to pull, each with the position (m) and the force (N) of the worst.
    supports: Vec<(String, f64, f64)>,
    /// Number of positions at which the tool does not touch though it should.
    untouched: usize,
    /// Number of positions.
    positions: usize,
}

impl LiftOff {
    /// Looks for lift-off in the equilibrium at each of these positions (m).
    ///
    /// # Errors
    /// The shaft cannot be condensed.
    pub fn of(machine: &Machine, positions: &[f64], deflections: &[Deflection]) -> Result<Self, Failure> {
        let setup = &machine.setup;
        let load = deflections.iter().map(|d| d.force).fold(0.0, f64::max);
        let mut supports = Vec::new();
        let mut pulls = |who: String, forces: &mut dyn Iterator<Item = f64>| {
            let worst = positions.iter().zip(forces).min_by(|a, b| a.1.total_cmp(&b.1));
            supports.extend(worst.filter(|w| w.1 < -PULLS * load).map(|(x, force)| (who, *x, -force)));
        };
        // A chuck can pull, unless its joint is a contact.
        if setup.workholding == Workholding::Centres || !machine.headstock.contacts.is_empty() {
            pulls("the headstock".into(), &mut deflections.iter().map(|d| d.supports.forces[0]));
        }
        if setup.workholding.has_tailstock() {
            pulls("the tailstock".into(), &mut deflections.iter().map(|d| d.supports.forces[1]));
        }
        for (rest, forces) in setup.steady_rests.iter().zip(rest_forces(machine, positions, deflections)?) {
            pulls(format!("the steady rest at {:.1}", LENGTH.shown(rest.at)), &mut forces.into_iter());
        }
        let idle = |(d, x): &(&Deflection, &f64)| d.force <= 0.0 && setup.nominal_force(**x) > 0.0;
        let untouched = deflections.iter().zip(positions).filter(idle).count();
        Ok(Self { supports, untouched, positions: positions.len() })
    }

    /// The same of further positions as well.
    pub fn add(&mut self, other: Self) {
        for (who, x, force) in other.supports {
            match self.supports.iter_mut().find(|known| known.0 == who) {
                Some(known) if known.2 < force => *known = (who, x, force),
                Some(_) => {}
                None => self.supports.push((who, x, force)),
            }
        }
        self.untouched += other.untouched;
        self.positions += other.positions;
    }

    /// Warnings, as sentences; `positions` is the word for the tool positions.
    pub fn warnings(&self, positions: &str) -> Vec<String> {
        let pulls = |(who, x, force): &(String, f64, f64)| {
            format!(
                "{who} would have to pull with {:.1} while the tool is at x = {:.1}; it can only press, and the shaft \
                 would lift off there: set it into line, or hold the shaft otherwise",
                FORCE.shown(*force),
                LENGTH.shown(*x)
            )
        };
        let untouched = (self.untouched > 0).then(|| {
            format!("the tool does not touch the work at {} of {} {positions}", self.untouched, self.positions)
        });
        self.supports.iter().map(pulls).chain(untouched).collect()
    }
}
