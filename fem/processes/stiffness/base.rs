//! A whole machine under test: a structure, the places at which it is pushed, and the dials that watch it.

use nalgebra::DMatrix;

use crate::input::Reader;
use crate::process::structure::{Draft, Drawn, Port};
use crate::solve::structure::{Displaced, Freedom};

/// More places than anybody pushes at or watches.
const MOST: usize = 1000;

/// A structure with the places of forces and dials.
pub struct Base {
    /// The structure.
    pub drawn: Drawn,
    /// Places at which it is pushed, in the order of the file.
    pub loads: Vec<Port>,
    /// Places that dials watch.
    pub dials: Vec<Port>,
    /// Reading of each dial under a unit force at each place, m/N.
    compliance: DMatrix<f64>,
}

impl Base {
    /// Reads the structure, if there is one.
    pub fn read(model: &Reader) -> Option<Self> {
        let about = "the machine that is pushed: beams and joints in the plane of the forces";
        let (drawn, (loads, dials)) = Draft::read(model, about, |t, draft| {
            let ports = |key: &'static str, about: &'static str| {
                let ports: Vec<Option<Port>> = t.list(key, about, |t, _| draft.port(t));
                if ports.is_empty() {
                    t.problem("", format!("`{key}` is missing: {about}"), format!("add {key} = [{{ at = \"NODE\" }}]"));
                } else if ports.len() > MOST {
                    t.problem(key, format!("{} places are more than {MOST}", ports.len()), "take fewer");
                }
                ports.into_iter().collect::<Option<Vec<Port>>>()
            };
            let loads = ports("loads", "where it is pushed, one place at a time");
            let dials = ports("dials", "where dials watch it");
            Some((loads?, dials?))
        })?;
        let reading = |dial: &Port, displacements: &[f64]| {
            dial.forces(1.0).iter().map(|(at, sign)| sign * displacements[at.number()]).sum::<f64>()
        };
        let under: Vec<Vec<f64>> = loads.iter().map(|load| drawn.factored.under(&load.forces(1.0))).collect();
        let compliance = DMatrix::from_fn(dials.len(), loads.len(), |dial, load| reading(&dials[dial], &under[load]));
        Some(Self { drawn, loads, dials, compliance })
    }

    /// Reading of a dial under a unit force at a place, by their numbers from 0, m/N.
    pub fn compliance(&self, load: usize, dial: usize) -> f64 {
        self.compliance[(dial, load)]
    }

    /// Whether a dial watches the very place that is pushed, and sees the joint that passes the force on.
    pub fn watches(&self, load: usize, dial: usize) -> bool {
        self.dials[dial].at == self.loads[load].at
    }

    /// The structure pushed with a force (N) at a place.
    pub fn pushed(&self, load: usize, force: f64) -> Displaced<'_> {
        let forces: Vec<(Freedom, f64)> = self.loads[load].forces(force);
        self.drawn.factored.displaced(&forces, &[])
    }
}
