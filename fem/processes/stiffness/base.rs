//! A whole machine under test: a structure, the places at which it is pushed, and the dials that watch it.

use crate::input::Reader;
use crate::process::Failure;
use crate::process::structure::{Draft, Drawn, Place, Places, Port};
use crate::solve::structure::Displaced;

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
    places: Places,
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
        let forces = |ports: &[Port]| ports.iter().map(|own| own.forces(1.0)).collect::<Vec<Place>>();
        let places = Places::new(&drawn, &forces(&loads), &forces(&dials));
        Some(Self { drawn, loads, dials, places })
    }

    /// Readings of all dials under a force (N) at a place, by its number from 0, m.
    ///
    /// # Errors
    /// The joints found no equilibrium.
    pub fn readings(&self, load: usize, force: f64) -> Result<Vec<f64>, Failure> {
        let pushed = self.places.under(&[(load, force)]).map_err(|error| self.drawn.failure(error))?;
        Ok(pushed.moved().as_slice().to_vec())
    }

    /// Whether a dial watches the very place that is pushed, and sees the joint that passes the force on.
    pub fn watches(&self, load: usize, dial: usize) -> bool {
        self.dials[dial].at == self.loads[load].at
    }

    /// The structure pushed with a force (N) at a place.
    ///
    /// # Errors
    /// The joints found no equilibrium.
    pub fn pushed(&self, load: usize, force: f64) -> Result<Displaced<'_>, Failure> {
        let seats = self.places.under(&[(load, force)]).map_err(|error| self.drawn.failure(error))?.seats;
        Ok(self.drawn.factored.displaced(&self.loads[load].forces(force), &[], &self.drawn.feet(&seats)))
    }
}
