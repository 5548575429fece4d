//! The work heats where it is cut, and is cold again when it is measured.
//!
//! ρcA·θ_t = (kA·θ_x)_x − h·πD·θ + power·δ(x − x_tool(t)), ends insulated, every part cold when its pass
//! begins; ΔD −= α·D·θ at the tool: what is turned hot and to size is too thin when cold [seed 002
//! (35)-(39)]. power in W is the part of the cutting power that enters the work; convection h in W/(m² K). θ
//! at the tool depends on its position alone. Left out: the rise beyond the one-dimensional mean of the
//! section, and elongation along x.

use std::f64::consts::PI;

use super::super::heating::{Rod, rise_per_watt};
use super::super::machine::{Effect, Machine};
use crate::input::Bounds;
use crate::process::{Belongs, Failure, Odds, Parameter, Segment, nothing};
use crate::solve::heat::{Pass, RodPiece};
use crate::units::{CONVECTION, POWER};

/// `workpiece-heating`.
pub static WORKPIECE_HEATING: Effect<2> = Effect {
    name: "workpiece-heating",
    about: "the cut heats the work, which is turned to size while it is expanded and thinner when cold",
    law: "dD -= expansion*D*theta(tool), rho*c*A*theta_t = (k*A*theta_x)_x - h*pi*D*theta + power*delta(x - x_tool)",
    source: "seed 002 (35)-(39)",
    belongs: Belongs::Test,
    odds: Odds::of(0.5, "all work warms, much of it under coolant by little"),
    parameters: [
        Parameter::amplitude("power", POWER, "heat that enters the work", (5.0, 500.0)),
        Parameter::shape("convection", CONVECTION, "heat transfer to the air", (5.0, 100.0))
            .within(Bounds::NotNegative)
            .or(0.0),
    ],
    look_alikes: &[("guideway-taper", "the pass reversed: heating follows the tool, a taper stays")],
    needs: nothing,
    act: heat,
};

fn heat([power, convection]: [f64; 2], machine: &mut Machine) {
    let setup = &machine.setup;
    let material = setup.material;
    let piece = |s: &Segment| RodPiece {
        length: s.length,
        heat_capacity: material.density * material.specific_heat * s.section.area(),
        conductance: material.conductivity * s.section.area(),
        loss: PI * s.section.diameter,
    };
    let pass = setup.schedule.pass;
    let rod = Rod {
        pieces: setup.segments.iter().map(piece).collect(),
        pass: Pass { from: pass.from, to: pass.to, speed: pass.speed() },
    };
    match rise_per_watt(&setup.heated, rod, convection) {
        Ok(rise) => machine.add_shift(move |at| -material.expansion * at.diameter * power * rise.rise_at(at.x)),
        Err(error) => {
            machine.failure = Some(Failure {
                message: format!("the heating of the work cannot be computed: {error}"),
                help: "check conductivity, density, specific heat, convection and the speed of the pass".into(),
            })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::bench::*;

    #[test]
    fn the_hot_tool_follows_the_quasi_steady_wave() {
        // Far from the ends θ = power/(ρcA·v): all heat goes into the work that the tool has passed. 2 mm/s,
        // Ø50 mm of steel, 100 W; x = 0.15 m is 40 diffusion lengths (k/ρcv = 6.8 mm) from the start and 22
        // from the end.
        let section = std::f64::consts::PI * 0.05 * 0.05 / 4.0;
        let rise = 100.0 / (7850.0 * 470.0 * section * 2e-3);
        let expected = -1e6 * 11.5e-6 * 0.05 * rise;
        let computed = shift("workpiece-heating", &[100.0, 0.0], moment());
        assert!((computed / expected - 1.0).abs() < 1e-4, "{computed} for {expected}");
    }
}
