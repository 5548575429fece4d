//! Deviation of the cut surface in every row: what the jaws squeeze, and what the cut adds.

use std::cell::RefCell;
use std::collections::HashMap;
use std::sync::Arc;

use super::body::Body;
use super::circle::evenly;
use super::grip::Grip;
use super::jaws::Group;
use super::machine::{BorePoint, Machine};
use super::response::{BoreSeries, Proportions, Response, unsolvable};
use super::rows::{self, ANGLE_OF_ROW, CLAMPED, JAW_FORCE, ORIENTATION, SECTION, SPEED, STATE};
use super::setup::Setup;
use super::tube::{Sections, Shape};
use crate::process::{Failure, Forward, Rows};

/// Radial displacement of the cut surface per newton of mean force of some jaws at an angle (rad) of a section (m, from the face at
/// the chuck), m/N, positive outwards.
type Motion = Box<dyn Fn(f64, f64) -> f64>;

/// The cut surface under the jaws of a chuck.
pub struct Squeeze {
    /// Of each group of jaws its part of the force at standstill, and what it does.
    groups: Vec<(f64, Motion)>,
}

impl Squeeze {
    /// Radial displacement at an angle (rad) of a section (m, from the face at the chuck), m, where `force_of` gives the force (N)
    /// of jaws of a part of that at standstill.
    pub fn at(&self, [angle, section]: [f64; 2], force_of: impl Fn(f64) -> f64) -> f64 {
        self.groups.iter().map(|(part, motion)| motion(angle, section) * force_of(*part)).sum()
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
            return Ok(Box::new(move |angle, _| compliance * shape.radial(angle)));
        }
    };
    let step = if is_even { jaws.len() } else { 1 };
    if let Some(reach) = setup.reach {
        let sections = sections(machine, reach)?;
        let (jaws, outer) = (jaws.clone(), setup.outer_radius);
        // Rows come section by section, or have few of them.
        let known: RefCell<HashMap<u64, BoreSeries>> = RefCell::default();
        return Ok(Box::new(move |angle, section| {
            let mut known = known.borrow_mut();
            let own = known.entry(section.to_bits()).or_insert_with(|| sections.at(section / outer).under(&jaws));
            compliance * own.radial(angle)
        }));
    }
    let ring = Proportions { ratio: setup.inner_radius / setup.outer_radius, poisson_ratio, mesh, step };
    let series = setup.responses.get_or(ring, Response::solve)?.under(jaws);
    Ok(Box::new(move |angle, _| compliance * series.radial(angle)))
}

/// Compliances of the sections of a ring that jaws press from one place to another along it, m.
///
/// # Errors
/// It cannot be computed.
pub fn sections(machine: &Machine, reach: [f64; 2]) -> Result<Arc<Sections>, Failure> {
    let setup = &machine.setup;
    let Body::Cells(mesh) = setup.body else {
        return Err(unsolvable("jaws on a part of its width press on no mesh from a file"));
    };
    let jaws = machine.jaw_angles.len();
    let step = if machine.jaw_angles == evenly(jaws) && machine.difference == 0.0 { jaws } else { 1 };
    setup.sections.get_or(shape(setup, reach, mesh.radial, step), Sections::solve)
}

/// The ring as one that jaws press on a part of its width.
fn shape(setup: &Setup, reach: [f64; 2], radial: usize, step: usize) -> Shape {
    let outer = setup.outer_radius;
    Shape {
        ratio: setup.inner_radius / outer,
        width: setup.width / outer,
        reach: reach.map(|end| end / outer),
        is_outside: setup.grip == Grip::Outside,
        poisson_ratio: setup.material.poisson_ratio,
        radial,
        step,
    }
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
        let place = [angle, value(SECTION).unwrap_or(setup.section)];
        let force = value(JAW_FORCE).unwrap_or(setup.jaw_force);
        if value(STATE) == Some(CLAMPED) {
            // Before it is cut, at standstill.
            return Ok(squeeze.at(place, |part| part * force));
        }
        let speed = value(SPEED).unwrap_or(setup.speed());
        let orientation = value(ORIENTATION).unwrap_or(0.0);
        let blank = rows::blank(setup, rows, row);
        let squeezed = squeeze.at(place, |part| machine.force_at(part * force, speed));
        machine.deviation(&BorePoint { angle, orientation, blank }, squeezed)
    };
    (0..rows.len()).map(one).collect()
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
