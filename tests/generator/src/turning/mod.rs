//! Turned shafts, by other numerics than the program under test: unit-load integrals instead of finite
//! elements, the force method and a bracketing root search instead of a Newton iteration, a fine implicit
//! finite-volume rod for the heat.

pub mod asked;
pub mod catalogue;
pub mod changed;
pub mod corrected;
pub mod design;
pub mod equilibrium;
pub mod heat;
pub mod held;
pub mod job;
pub mod movers;
pub mod rubbing;
pub mod scenes;
pub mod set_up;
pub mod shaft;
pub mod shapes;
pub mod story;
pub mod writing;

use catalogue::{LAWS, OF_ANY, OF_RUBBING, OF_SURVEYED, admits};
use equilibrium::errors;
use job::Job;

use crate::Process;
use crate::asked::Asked;
use crate::job::{NoiseKind, Shown};
use crate::law::{self, Cause, Law};
use crate::random::Random;

/// Diameters of turned shafts, um.
pub const TURNING: Process = Process {
    name: "",
    laws: OF_ANY,
    draw_job: |hidden, random| Some(Box::new(design::draw_job(hidden, random)?)),
    // The same in diameters.
    never_together: &[["guideway-taper", "tailstock-offset"]],
    catalogue: LAWS,
    scenes: scenes::NAMES,
    draw_scene: |scene, effects, random| Some(Box::new(scenes::draw(scene, effects, random)?)),
};

/// The same on a lathe whose edge and bed were measured, with the effects that need it.
pub const SURVEYED_TURNING: Process = Process {
    name: "surveyed ",
    laws: OF_SURVEYED,
    draw_job: |hidden, random| Some(Box::new(design::draw_surveyed_job(hidden, random)?)),
    never_together: &[],
    ..TURNING
};

/// The same on a lathe with joints that rub.
pub const RUBBING_TURNING: Process = Process { name: "rubbing ", laws: OF_RUBBING, never_together: &[], ..TURNING };

impl crate::job::Job for Job {
    fn process(&self) -> &'static str {
        "turning"
    }

    fn laws(&self) -> &'static [Law] {
        if self.survey.is_some() { LAWS } else { OF_ANY }
    }

    fn shown(&self) -> &[Shown] {
        &self.shown
    }

    fn forget(&mut self) {
        self.shown.clear();
    }

    fn noise(&self) -> NoiseKind {
        self.noise
    }

    fn groups(&self) -> Vec<usize> {
        self.rows.iter().map(|row| row.part).collect()
    }

    fn rows(&self) -> usize {
        self.rows.len()
    }

    fn noise_range(&self) -> (f64, f64) {
        (0.05, 6.0)
    }

    fn admits(&self, effect: &str, causes: &[Cause]) -> bool {
        // A new insert is felt by the wear of the old one.
        let has_worn = || causes.iter().any(|cause| catalogue::WEARS.contains(&cause.effect));
        // Friction is felt by the joint beside it.
        let yields = || causes.iter().any(|cause| catalogue::yields_beside(effect, cause.effect));
        let acts = match effect {
            "insert-change" => has_worn(),
            "headstock-friction" | "tailstock-friction" => yields(),
            _ => true,
        };
        admits(self, effect) && acts
    }

    fn length(&self) -> f64 {
        self.shaft.length()
    }

    fn draw(&self, effect: &'static str, random: &mut Random) -> Cause {
        let mut cause = law::draw(LAWS, effect, self.length(), random);
        for (_, after) in cause.parameters.iter_mut().filter(|(name, _)| *name == "after") {
            *after = random.whole(1, self.parts - 1) as f64;
        }
        cause
    }

    fn least_factor(&self, effect: &str) -> f64 {
        catalogue::least_factor(effect)
    }

    fn draws(&self, effect: &str) -> usize {
        match effect {
            "workpiece-heating" => 2,
            "guideway-wear" | "front-guideway-wear" | "tool-thermal-growth" | "tool-wear" | "tool-breakdown" => 30,
            _ => 6,
        }
    }

    fn predict(&self, causes: &[Cause]) -> Vec<f64> {
        errors(self, causes)
    }

    fn shape(&self, random: &mut Random) -> (&'static str, Vec<f64>) {
        shapes::draw_shape(self, random)
    }

    fn asked(&self, rows: &[Asked]) -> Option<Box<dyn crate::job::Job>> {
        Some(Box::new(asked::asked(self, rows)?))
    }

    fn tables(&self) -> String {
        writing::tables(self)
    }

    fn data(&self, observed: &[f64], sigma: f64) -> String {
        writing::data(self, observed, sigma)
    }
}
