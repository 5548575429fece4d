//! The work heats where it is cut, and is cold again when it is measured.
//!
//! ρcA·θ_t = (kA·θ_x)_x − h·πD·θ + power·δ(x − x_tool(t)), ends insulated, every part cold when its pass begins; ΔD −= α·D·θ at the tool: what is turned hot
//! and to size is too thin when cold [seed 002 (35)-(39)]. power in W is the part of the cutting power that enters the work; convection h in W/(m² K).
//! θ at the tool depends on its position alone. Left out: the rise beyond the one-dimensional mean of the section, and elongation along x.

use std::sync::{Arc, Mutex, PoisonError};

use super::super::Machine;
use crate::process::{Description, Effect, Failure, Parameter, Values};
use crate::solve::heat::{HeatError, Pass, RodPiece, ToolTemperature, moving_source};
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
        Parameter::amplitude("convection", CONVECTION, "heat transfer to the air", (5.0, 100.0)).or(0.0),
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
            loss: convection * std::f64::consts::PI * s.section.diameter,
        };
        let pieces: Vec<RodPiece> = setup.segments.iter().map(piece).collect();
        let pass = setup.schedule.pass;
        let pass = Pass { from: pass.from, to: pass.to, speed: pass.speed() };
        match rise_per_watt(pieces, pass) {
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

/// The last rises that were computed, the newest last. A search tries many values of everything else for one shaft, pass and
/// convection, and the rise is by far the dearest part of a prediction.
static RECENT: Mutex<Vec<Recent>> = Mutex::new(Vec::new());
const MOST_RECENT: usize = 32;

struct Recent {
    pieces: Vec<RodPiece>,
    pass: Pass,
    rise: Arc<ToolTemperature>,
}

/// The rise at the tool per watt, K/W, computed once for the same rod and pass.
fn rise_per_watt(pieces: Vec<RodPiece>, pass: Pass) -> Result<Arc<ToolTemperature>, HeatError> {
    // A panic while the list was held leaves it whole: entries are added and removed in one step each.
    let recent = || RECENT.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(known) = recent().iter().find(|r| r.pass == pass && r.pieces == pieces) {
        return Ok(known.rise.clone());
    }
    let rise = Arc::new(moving_source(&pieces, &pass, TOLERANCE)?);
    let mut recent = recent();
    if recent.len() == MOST_RECENT {
        recent.remove(0);
    }
    recent.push(Recent { pieces, pass, rise: rise.clone() });
    Ok(rise)
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
