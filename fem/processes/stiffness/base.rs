//! A whole machine under test: a structure, the places at which it is pushed, and the dials that watch it.

use nalgebra::{DMatrix, DVector};

use crate::input::Reader;
use crate::joint::{Joint, Rubbing, Seat};
use crate::process::Failure;
use crate::process::structure::{Draft, Drawn, Port};
use crate::solve::structure::{Displaced, Freedom};
use crate::solve::{System, resisted, solve_seated};

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
    /// Reading of each dial under a unit force at each place, every joint a spring, m/N.
    compliance: DMatrix<f64>,
    seats: Seats,
}

/// Joints that are no springs.
struct Seats {
    laws: Vec<Seat>,
    /// Forces on two end joints that there are not and on every seat, place by place, per unit force.
    influence: Vec<Vec<f64>>,
    /// Forces per unit displacement of each of them, N/m.
    constraint: DMatrix<f64>,
    /// Reading of each dial per displacement of each seat.
    to_dials: DMatrix<f64>,
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
        let of = |loads: &[(Freedom, f64)], displacements: &[f64]| {
            loads.iter().map(|(at, sign)| sign * displacements[at.number()]).sum::<f64>()
        };
        let (pushes, watched): (Vec<_>, Vec<_>) =
            (loads.iter().map(|own| own.forces(1.0)).collect(), dials.iter().map(|own| own.forces(1.0)).collect());
        let pairs: Vec<Vec<(Freedom, f64)>> = drawn.seats.iter().map(|seat| drawn.pair(seat)).collect();
        let springs: Vec<f64> = drawn.seats.iter().map(|seat| drawn.stiffness(seat)).collect();
        let under: Vec<Vec<f64>> = pushes.iter().map(|push| drawn.factored.under(push)).collect();
        let under_seats: Vec<Vec<f64>> = pairs.iter().map(|pair| drawn.factored.under(pair)).collect();
        let compliance = DMatrix::from_fn(dials.len(), loads.len(), |dial, load| of(&watched[dial], &under[load]));
        let on_seats =
            |moved: &Vec<f64>| pairs.iter().zip(&springs).map(|(pair, k)| k * of(pair, moved)).collect::<Vec<_>>();
        let constraint =
            DMatrix::from_fn(2 + pairs.len(), 2 + pairs.len(), |i, j| match (i.checked_sub(2), j.checked_sub(2)) {
                (Some(i), Some(j)) => {
                    let spring = if i == j { springs[i] } else { 0.0 };
                    spring - springs[i] * of(&pairs[i], &under_seats[j]) * springs[j]
                }
                _ => 0.0,
            });
        let seats = Seats {
            laws: drawn.seats.iter().map(|seat| seat.law).collect(),
            influence: under.iter().map(|moved| [vec![0.0; 2], on_seats(moved)].concat()).collect(),
            constraint: resisted(constraint, &springs),
            to_dials: DMatrix::from_fn(dials.len(), pairs.len(), |dial, j| {
                springs[j] * of(&watched[dial], &under_seats[j])
            }),
        };
        Some(Self { drawn, loads, dials, compliance, seats })
    }

    /// Readings of all dials under a force (N) at a place, by its number from 0, m.
    ///
    /// # Errors
    /// The joints found no equilibrium.
    pub fn readings(&self, load: usize, force: f64) -> Result<Vec<f64>, Failure> {
        let moved = DVector::from_vec(self.given_way(load, force)?);
        Ok((self.compliance.column(load) * force + &self.seats.to_dials * moved).as_slice().to_vec())
    }

    /// How far its seats give way under a force (N) at a place, m.
    fn given_way(&self, load: usize, force: f64) -> Result<Vec<f64>, Failure> {
        let Seats { laws, influence, constraint, .. } = &self.seats;
        if laws.is_empty() {
            return Ok(Vec::new());
        }
        let bent_forces = vec![0.0; 2 + laws.len()];
        let system = System { influence: &influence[load], constraint, bent_forces: &bent_forces };
        let rigid = Joint::default();
        let all = solve_seated(&[Rubbing::free(&rigid); 2], laws, &system, force, None)
            .map_err(|error| self.drawn.failure(error))?;
        Ok(all.displacements[2..].to_vec())
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
        let feet = self.drawn.feet(&self.given_way(load, force)?);
        Ok(self.drawn.factored.displaced(&self.loads[load].forces(force), &[], &feet))
    }
}
