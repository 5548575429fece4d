//! Deviation of the cut surface in every row: what the jaws squeeze, and what the cut adds.

use super::body::Body;
use super::circle::evenly;
use super::jaws::Group;
use super::machine::{BorePoint, Machine};
use super::response::{Proportions, Response};
use super::rows::{self, ANGLE_OF_ROW, CLAMPED, JAW_FORCE, ORIENTATION, SPEED, STATE};
use crate::process::{Failure, Forward, Rows};

/// Radial displacement of the cut surface per newton of mean force of some jaws at an angle (rad), m/N, positive outwards.
type Motion = Box<dyn Fn(f64) -> f64>;

/// The cut surface under the jaws of a chuck.
pub struct Squeeze {
    /// Of each group of jaws its part of the force at standstill, and what it does.
    groups: Vec<(f64, Motion)>,
}

impl Squeeze {
    /// Radial displacement at an angle (rad), m, where `force_of` gives the force (N) of jaws of a part of that at standstill.
    pub fn at(&self, angle: f64, force_of: impl Fn(f64) -> f64) -> f64 {
        self.groups.iter().map(|(part, motion)| motion(angle) * force_of(*part)).sum()
    }
}

/// The cut surface under the machine's jaws, the ring solved once for all readings of a model.
///
/// By Betti's law the outside moves under a force on the bore as the bore under the same force on the outside, outwards both; and
/// jaws in the bore press outwards, where those around it press inwards.
///
/// # Errors
/// The jaws cannot hold the ring, or it cannot be computed.
pub fn squeezed(machine: &Machine) -> Result<Squeeze, Failure> {
    let groups = machine.groups()?;
    let is_even = machine.jaw_angles == evenly(machine.jaw_angles.len());
    let motion = |group: Group| Ok((group.part, motion(machine, &group, is_even)?));
    Ok(Squeeze { groups: groups.into_iter().map(motion).collect::<Result<_, Failure>>()? })
}

/// What a group of jaws does, which are evenly spaced or not.
fn motion(machine: &Machine, Group { jaws, .. }: &Group, is_even: bool) -> Result<Motion, Failure> {
    let setup = &machine.setup;
    let poisson_ratio = setup.material.poisson_ratio;
    // Rings are solved with E = b = 1.
    let compliance = setup.grip.inwards() / (setup.material.youngs_modulus * setup.width);
    let mesh = match &setup.body {
        Body::Cells(mesh) => *mesh,
        Body::Drawn(drawn) => {
            let shape = drawn.bore_under(poisson_ratio, jaws)?;
            return Ok(Box::new(move |angle| compliance * shape.radial(angle)));
        }
    };
    let step = if is_even { jaws.len() } else { 1 };
    let ring = Proportions { ratio: setup.inner_radius / setup.outer_radius, poisson_ratio, mesh, step };
    let series = setup.responses.get_or(ring, Response::solve)?.under(jaws);
    Ok(Box::new(move |angle| compliance * series.radial(angle)))
}

/// Deviation of every row from the set circle, m.
///
/// # Errors
/// The ring cannot be computed.
pub fn observe(machine: &Machine, rows: &Rows) -> Result<Vec<f64>, Failure> {
    let setup = &machine.setup;
    let squeeze = squeezed(machine)?;
    let one = |row: usize| {
        let value = |column| rows.get(column, row);
        let angle = value(ANGLE_OF_ROW).unwrap_or(0.0);
        let force = value(JAW_FORCE).unwrap_or(setup.jaw_force);
        if value(STATE) == Some(CLAMPED) {
            // Before it is cut, at standstill.
            return squeeze.at(angle, |part| part * force);
        }
        let speed = value(SPEED).unwrap_or(setup.speed());
        let orientation = value(ORIENTATION).unwrap_or(0.0);
        let blank = rows::blank(setup, rows, row);
        let squeezed = squeeze.at(angle, |part| machine.force_at(part * force, speed));
        machine.deviation(&BorePoint { angle, orientation, blank }, squeezed)
    };
    Ok((0..rows.len()).map(one).collect())
}

/// The same with the effects that are formulas, whatever circle deviations are measured from, m.
///
/// # Errors
/// The ring cannot be computed.
pub fn absolute(machine: &Machine, forward: &Forward, rows: &Rows) -> Result<Vec<f64>, Failure> {
    let mut deviations = observe(machine, rows)?;
    forward.add_formulas(rows, &mut deviations);
    Ok(deviations)
}
