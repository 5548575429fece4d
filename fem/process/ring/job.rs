//! A chuck with its effects, at work.

use std::sync::Arc;

use super::machine::{Machine, Place};
use super::model::{Body, Setup};
use super::response::{self, BoreSeries, Jaw};
use super::{effects, findings, observe, shapes};
use crate::process::{Active, Failure, Job, Outcome, Rows, act};
use crate::progress::Progress;
use crate::solve::ring::BoreShape;

/// A chuck that predicts.
pub struct Ring {
    /// With its effects.
    pub machine: Arc<Machine>,
}

/// How the bore moves, per newton of jaw force.
#[derive(Clone, Debug)]
pub enum BoreMotion {
    /// Of a ring of equal cells.
    Waves(BoreSeries),
    /// Of a drawn ring: the shape for E = b = 1, and 1/(E b) in m/N.
    Drawn {
        /// m per newton, with E = b = 1.
        shape: BoreShape,
        /// 1/(E b), m/N.
        compliance: f64,
    },
}

impl Ring {
    /// Lets the effects act on a set-up.
    pub fn equip(setup: Arc<Setup>, active: &[Active]) -> Self {
        let mut machine = Machine::ideal(setup);
        act(effects::ALL, active, &mut machine);
        Self { machine: Arc::new(machine) }
    }

    /// What the model says.
    pub fn setup(&self) -> &Setup {
        &self.machine.setup
    }

    /// The jaws with their forces in equilibrium.
    ///
    /// # Errors
    /// The jaws stand where they cannot hold a ring, or press on each other's place.
    pub fn jaws(&self) -> Result<Vec<Jaw>, Failure> {
        let machine = &self.machine;
        let room = room(&machine.jaws);
        if machine.arc > room * (1.0 + 1e-12) {
            let (arc, most) = (machine.arc.to_degrees(), room.to_degrees());
            return Err(Failure {
                message: format!("jaws that press over {arc:.1} deg each overlap"),
                help: format!("the {} jaws have room for {most:.1} deg each where they stand", machine.jaws.len()),
            });
        }
        let shares = shares(&machine.jaws)?;
        let jaw = |(angle, share): (&f64, f64)| Jaw { angle: *angle, arc: machine.arc, share };
        Ok(machine.jaws.iter().zip(shares).map(jaw).collect())
    }

    /// The radial displacement of the bore per newton of jaw force.
    ///
    /// # Errors
    /// As [`jaws`](Self::jaws), or the ring cannot be computed.
    pub fn bore(&self) -> Result<BoreMotion, Failure> {
        let (setup, jaws) = (self.setup(), self.jaws()?);
        let size = match &setup.body {
            Body::Cells(size) => *size,
            Body::Drawn(drawn) => {
                let shape = drawn.bore_under(setup.material.poisson_ratio, &jaws)?;
                let stiffness = setup.material.youngs_modulus * setup.width;
                return Ok(BoreMotion::Drawn { shape, compliance: 1.0 / stiffness });
            }
        };
        let even = |k: usize| self.machine.jaws[k] == std::f64::consts::TAU / jaws.len() as f64 * k as f64;
        let step = if (0..jaws.len()).all(even) { jaws.len() } else { 1 };
        Ok(BoreMotion::Waves(response::response(setup, size, step)?.under(setup, &jaws)))
    }

    /// What does not depend on the jaws, m.
    pub fn marks_at(&self, place: &Place) -> f64 {
        self.machine.marks.iter().map(|mark| mark(place)).sum()
    }
}

impl BoreMotion {
    /// u_r per newton of jaw force at an angle (rad), m/N, positive outwards.
    pub fn radial(&self, angle: f64) -> f64 {
        match self {
            Self::Waves(series) => series.radial(angle),
            Self::Drawn { shape, compliance } => compliance * shape.radial(angle),
        }
    }
}

/// The smallest angle from one jaw to the next, rad.
fn room(angles: &[f64]) -> f64 {
    use std::f64::consts::TAU;
    let mut around: Vec<f64> = angles.iter().map(|a| a.rem_euclid(TAU)).collect();
    around.sort_by(f64::total_cmp);
    let (Some(first), Some(last)) = (around.first(), around.last()) else { return TAU };
    around.windows(2).map(|a| a[1] - a[0]).fold(first + TAU - last, f64::min)
}

/// Forces of the jaws in equilibrium over that of a jaw of an even chuck, their mean being one. Those of three jaws are as the sines of the angles
/// between the other two (Lamy's theorem); more stand evenly.
fn shares(angles: &[f64]) -> Result<Vec<f64>, Failure> {
    let [a, b, c] = angles else { return Ok(vec![1.0; angles.len()]) };
    let sines = [(c - b).sin(), (a - c).sin(), (b - a).sin()];
    let mean = sines.iter().sum::<f64>() / 3.0;
    let shares: Vec<f64> = sines.iter().map(|sine| sine / mean).collect();
    if shares.iter().all(|share| *share > 0.0) {
        return Ok(shares);
    }
    let shown: Vec<String> = angles.iter().map(|angle| format!("{:.1}", angle.to_degrees())).collect();
    Err(Failure {
        message: format!("jaws at {} deg cannot press in equilibrium", shown.join(", ")),
        help: "three jaws hold a ring when no two neighbours stand 180 deg or more apart".into(),
    })
}

impl Job for Ring {
    /// Deviation of the released bore in m, all around.
    fn predict(&self, progress: &Progress) -> Result<Vec<f64>, Failure> {
        progress.expect(1);
        let deviations = observe::observe(self, &observe::programme(self.setup()))?;
        progress.advance(1);
        match deviations.iter().find(|d| d.is_nan() || d.abs() >= self.setup().inner_radius) {
            None => Ok(deviations),
            Some(deviation) => Err(Failure {
                message: format!("the deviation is {deviation:.3e} m somewhere: that is no ring any more"),
                help: "check forces, dimensions and material: a unit may be wrong".into(),
            }),
        }
    }

    fn observe(&self, rows: &Rows) -> Result<Vec<f64>, Failure> {
        observe::observe(self, rows)
    }

    fn outcome(&self, prediction: Vec<f64>) -> Result<Outcome, Failure> {
        let scene = shapes::Scene::new(self)?;
        let mut outcome = findings::outcome(self, &scene, prediction)?;
        outcome.animation = Some(scene.animation());
        Ok(outcome)
    }
}
