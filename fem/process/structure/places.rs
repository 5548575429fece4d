//! Places of a structure under forces on others, joints that are no springs included.
//!
//! Every joint has its spring in the structure. A seat that gives way by e beside it moves the foot of that spring, so that
//! under forces P on the pushed places all seats obey F + S·e = G·P ([`solve_seated`]), and the places that are watched move
//! by C·P + B·e.

use nalgebra::{DMatrix, DVector};

use super::draft::Drawn;
use crate::joint::{Joint, Rubbing, Seat};
use crate::solve::structure::Freedom;
use crate::solve::{JointsError, System, resisted, solve_seated};

/// Forces that push a place, or motions that are summed up where one is watched: freedoms with their factors.
pub type Place = Vec<(Freedom, f64)>;

/// What moves where under forces on what.
#[derive(Clone, Debug, PartialEq)]
pub struct Places {
    /// Motion of each watched place under a unit force on each pushed one, every joint a spring, m/N.
    compliance: DMatrix<f64>,
    laws: Vec<Seat>,
    /// Forces on the seats per unit force on each pushed place. (seats, pushed)
    to_seats: DMatrix<f64>,
    /// Forces per unit displacement of two end joints that there are not and of every seat, N/m.
    constraint: DMatrix<f64>,
    /// Motion of each watched place per displacement of each seat. (watched, seats)
    from_seats: DMatrix<f64>,
}

/// Places under some forces.
pub struct Pushed<'p> {
    places: &'p Places,
    /// Forces by the numbers of the pushed places, N.
    forces: Vec<(usize, f64)>,
    /// How far each seat gives way beside its spring, m.
    pub seats: Vec<f64>,
    /// Where each seat stands on its path.
    path: Vec<f64>,
}

impl Places {
    /// Of a structure that is pushed and watched at some places.
    pub fn new(drawn: &Drawn, pushed: &[Place], watched: &[Place]) -> Self {
        let of = |place: &Place, moved: &[f64]| place.iter().map(|(at, sign)| sign * moved[at.number()]).sum::<f64>();
        let pairs: Vec<Place> = drawn.seats.iter().map(|seat| drawn.pair(seat)).collect();
        let springs: Vec<f64> = drawn.seats.iter().map(|seat| drawn.stiffness(seat)).collect();
        let under = |places: &[Place]| places.iter().map(|own| drawn.factored.under(own)).collect::<Vec<_>>();
        let (under, under_seats) = (under(pushed), under(&pairs));
        let constraint = DMatrix::from_fn(ENDS + pairs.len(), ENDS + pairs.len(), |i, j| {
            let (Some(i), Some(j)) = (i.checked_sub(ENDS), j.checked_sub(ENDS)) else { return 0.0 };
            let spring = if i == j { springs[i] } else { 0.0 };
            spring - springs[i] * of(&pairs[i], &under_seats[j]) * springs[j]
        });
        Self {
            compliance: DMatrix::from_fn(watched.len(), pushed.len(), |i, j| of(&watched[i], &under[j])),
            laws: drawn.seats.iter().map(|seat| seat.law).collect(),
            to_seats: DMatrix::from_fn(pairs.len(), pushed.len(), |i, j| springs[i] * of(&pairs[i], &under[j])),
            constraint: resisted(constraint, &springs),
            from_seats: DMatrix::from_fn(watched.len(), pairs.len(), |i, j| {
                springs[j] * of(&watched[i], &under_seats[j])
            }),
        }
    }

    /// Whether every joint is a spring: then what moves is as large as what pushes.
    pub fn are_linear(&self) -> bool {
        self.laws.is_empty()
    }

    /// Whether every joint is known: one whose values are sought gives way by nothing that could be told.
    pub fn are_known(&self) -> bool {
        self.laws.iter().all(Seat::is_known)
    }

    /// The places under forces (N) on some of those that are pushed, by their numbers.
    ///
    /// # Errors
    /// The joints found no equilibrium.
    pub fn under(&self, forces: &[(usize, f64)]) -> Result<Pushed<'_>, JointsError> {
        let (seats, path) = self.given_way(forces)?;
        Ok(Pushed { places: self, forces: forces.to_vec(), seats, path })
    }

    fn given_way(&self, forces: &[(usize, f64)]) -> Result<(Vec<f64>, Vec<f64>), JointsError> {
        if self.laws.is_empty() {
            return Ok((Vec::new(), Vec::new()));
        }
        let largest =
            forces.iter().map(|own| own.1).fold(0.0, |most: f64, own| if own.abs() > most.abs() { own } else { most });
        let unit = if largest == 0.0 { 1.0 } else { largest };
        let on_seats = forces.iter().fold(DVector::zeros(self.laws.len()), |sum, (place, force)| {
            sum + self.to_seats.column(*place) * (force / unit)
        });
        let influence: Vec<f64> = [0.0; ENDS].into_iter().chain(on_seats.iter().copied()).collect();
        let bent_forces = vec![0.0; influence.len()];
        let system = System { influence: &influence, constraint: &self.constraint, bent_forces: &bent_forces };
        let rigid = Joint::default();
        let all = solve_seated(&[Rubbing::free(&rigid); ENDS], &self.laws, &system, largest, None);
        // A joint that opens is told with the force on itself, all others as they stand.
        let told = |error| match error {
            JointsError::Open { seat, .. } => JointsError::Open { seat, load: unit * on_seats[seat] },
            other => other,
        };
        let all = all.map_err(told)?;
        Ok((all.displacements[ENDS..].to_vec(), all.path[ENDS..].to_vec()))
    }
}

impl Pushed<'_> {
    /// How far each watched place moves, m.
    pub fn moved(&self) -> DVector<f64> {
        let Places { compliance, from_seats, .. } = self.places;
        let by_springs = self
            .forces
            .iter()
            .fold(DVector::zeros(compliance.nrows()), |sum, (place, force)| sum + compliance.column(*place) * *force);
        by_springs + from_seats * DVector::from_column_slice(&self.seats)
    }

    /// How much more each watched place moves per newton more on each pushed one, m/N. (watched, pushed)
    pub fn rates(&self) -> DMatrix<f64> {
        let Places { compliance, from_seats, .. } = self.places;
        compliance + from_seats * self.seat_rates()
    }

    /// How much more each seat gives way per newton more on each pushed place, m/N. (seats, pushed)
    pub fn seat_rates(&self) -> DMatrix<f64> {
        let Places { laws, to_seats, constraint, .. } = self.places;
        let count = laws.len();
        if count == 0 {
            return DMatrix::zeros(0, to_seats.ncols());
        }
        // Along the paths s of the seats: (dF/ds + S·de/ds)·ds = G·dP.
        let states: Vec<_> = laws.iter().zip(&self.path).map(|(law, s)| law.along(*s)).collect();
        let along = DMatrix::from_fn(count, count, |i, j| {
            let own = if i == j { states[i].force_rate } else { 0.0 };
            own + constraint[(ENDS + i, ENDS + j)] * states[j].displacement_rate
        });
        // What nothing loads and nothing holds stays where it is.
        let steps = along.lu().solve(to_seats).unwrap_or_else(|| DMatrix::zeros(count, to_seats.ncols()));
        DMatrix::from_fn(count, to_seats.ncols(), |i, j| states[i].displacement_rate * steps[(i, j)])
    }
}

/// End joints of a shaft, which [`solve_seated`] has first; here nothing loads them.
const ENDS: usize = 2;
