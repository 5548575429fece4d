//! The work heats where it is cut, and is cold again when it is measured.
//!
//! ρcA·θ_t = (kA·θ_x)_x − h·πD·θ + power·δ(x − x_tool(t)), ends insulated, every part cold when its pass begins; ΔD −= α·D·θ at the tool: what is turned hot
//! and to size is too thin when cold [seed 002 (35)-(39)]. power in W is the part of the cutting power that enters the work; convection h in W/(m² K).
//! θ at the tool depends on its position alone. Left out: the rise beyond the one-dimensional mean of the section, and elongation along x.

use std::sync::{Arc, Mutex, PoisonError};

use super::super::Machine;
use crate::input::Bounds;
use crate::process::{Description, Effect, Failure, Parameter, Values};
use crate::solve::heat::{AnyLoss, HeatError, Pass, RodPiece, ToolTemperature, cooled, moving_source};
use crate::units::{CONVECTION, POWER};

/// `workpiece-heating`.
pub struct WorkpieceHeating;

static DESCRIPTION: Description = Description {
    name: "workpiece-heating",
    about: "the cut heats the work, which is turned to size while it is expanded and thinner when cold",
    law: "dD -= expansion*D*theta(tool), rho*c*A*theta_t = (k*A*theta_x)_x - h*pi*D*theta + power*delta(x - x_tool)",
    source: "seed 002 (35)-(39)",
    parameters: &[
        Parameter::amplitude("power", POWER, "heat that enters the work", (5.0, 500.0)),
        Parameter::shape("convection", CONVECTION, "heat transfer to the air", (5.0, 100.0))
            .within(Bounds::NotNegative)
            .or(0.0),
    ],
    look_alikes: &[("guideway-taper", "the pass reversed: heating follows the tool, a taper stays")],
};

/// Error of the temperature, relative to its largest value: about a nanometre where the work is 10 um too thin.
const TOLERANCE: f64 = 1e-4;

impl Effect<Machine> for WorkpieceHeating {
    fn description(&self) -> &'static Description {
        &DESCRIPTION
    }

    fn act(&self, values: &Values, machine: &mut Machine) {
        let (power, convection) = (values["power"], values["convection"]);
        let setup = &machine.setup;
        let material = setup.material;
        let piece = |s: &super::super::Segment| RodPiece {
            length: s.length,
            heat_capacity: material.density * material.specific_heat * s.section.area(),
            conductance: material.conductivity * s.section.area(),
            loss: std::f64::consts::PI * s.section.diameter,
        };
        let pass = setup.schedule.pass;
        let rod = Rod {
            pieces: setup.segments.iter().map(piece).collect(),
            pass: Pass { from: pass.from, to: pass.to, speed: pass.speed() },
        };
        match rise_per_watt(rod, convection) {
            Ok(rise) => machine.shift(move |at| -material.expansion * at.diameter * power * rise.rise_at(at.x)),
            Err(error) => {
                machine.failure = Some(Failure {
                    message: format!("the heating of the work cannot be computed: {error}"),
                    help: "check conductivity, density, specific heat, convection and the speed of the pass".into(),
                })
            }
        }
    }
}

/// A rod under the tool; its pieces carry the loss of a convection of one.
#[derive(Clone, PartialEq)]
struct Rod {
    pieces: Vec<RodPiece>,
    pass: Pass,
}

/// What is known of the rods that were heated last, the newest last. A search tries many values of everything else for one rod, and the
/// rise is by far the dearest part of a prediction; so each convection is solved once, and when a rod is asked for yet another the rises
/// between are taken from a few.
static RECENT: Mutex<Vec<Recent>> = Mutex::new(Vec::new());
const MOST_RODS: usize = 8;
/// A run needs one convection, and a table beside it perhaps a second; who asks for a third is searching.
const SEARCHED: usize = 2;
const MOST_SOLVED: usize = 32;

struct Recent {
    rod: Rod,
    solved: Vec<(f64, Arc<ToolTemperature>)>,
    any: Option<Arc<AnyLoss>>,
}

impl Recent {
    fn rise(&self, convection: f64) -> Option<Arc<ToolTemperature>> {
        if let Some(any) = self.any.as_ref().filter(|any| convection <= any.largest()) {
            return Some(Arc::new(any.at(convection)));
        }
        self.solved.iter().find(|(known, _)| *known == convection).map(|(_, rise)| rise.clone())
    }
}

/// The rise at the tool per watt, K/W.
fn rise_per_watt(rod: Rod, convection: f64) -> Result<Arc<ToolTemperature>, HeatError> {
    // A panic while the list was held leaves it whole: entries are added and removed in one step each.
    let recent = || RECENT.lock().unwrap_or_else(PoisonError::into_inner);
    let (known, solved) = match recent().iter().find(|r| r.rod == rod) {
        Some(known) => (known.rise(convection), known.solved.len()),
        None => (None, 0),
    };
    if let Some(rise) = known {
        return Ok(rise);
    }
    // Solved without the list, which others need meanwhile; two that solve the same do no harm.
    let rise = Arc::new(moving_source(&cooled(&rod.pieces, convection), &rod.pass, TOLERANCE)?);
    let any = (solved == SEARCHED).then(|| AnyLoss::solve(&rod.pieces, &rod.pass, TOLERANCE));
    let any = any.and_then(Result::ok).map(Arc::new);
    let mut recent = recent();
    let position = recent.iter().position(|r| r.rod == rod).unwrap_or_else(|| {
        if recent.len() == MOST_RODS {
            recent.remove(0);
        }
        recent.push(Recent { rod, solved: Vec::new(), any: None });
        recent.len() - 1
    });
    let entry = &mut recent[position];
    entry.any = entry.any.take().or(any);
    if entry.solved.len() == MOST_SOLVED {
        // Not below the number at which the others were solved: that is done once.
        entry.solved.remove(SEARCHED + 1);
    }
    entry.solved.push((convection, rise.clone()));
    Ok(entry.rise(convection).unwrap_or(rise))
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_hot_tool_follows_the_quasi_steady_wave() {
        // Far from the ends θ = power/(ρcA·v): all heat goes into the work that the tool has passed. 2 mm/s, Ø50 mm of steel,
        // 100 W; x = 0.15 m is 40 diffusion lengths (k/ρcv = 6.8 mm) from the start and 22 from the end.
        let section = std::f64::consts::PI * 0.05 * 0.05 / 4.0;
        let rise = 100.0 / (7850.0 * 470.0 * section * 2e-3);
        let expected = -1e6 * 11.5e-6 * 0.05 * rise;
        let computed = shift("workpiece-heating", &[100.0, 0.0], moment());
        assert!((computed / expected - 1.0).abs() < 1e-4, "{computed} for {expected}");
    }
}
