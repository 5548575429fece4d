//! Effects that meet in one machine: any of a process's catalogue in any of its scenes, as model and
//! measurements without noise that a test can hand to the program.

use crate::job::{Job, difference};
use crate::law::{Cause, scaled};
use crate::random::Random;
use crate::{Process, writing};

/// An effect that alone would change more than this, in the unit of its observable, is drawn smaller, so that
/// none hides what another does: a tool that has broken down leaves millimetres.
const LARGEST: f64 = 60.0;

/// Effects of which no machine has both: a chuck has three jaws or an even number of them.
const STRANGERS: &[[&str; 2]] = &[["jaw-position", "jaw-imbalance"]];

/// A machine with its effects, and what it makes.
#[derive(Debug, Clone)]
pub struct Meeting {
    /// Where they meet.
    pub scene: &'static str,
    /// The effects that were asked for, as drawn; the scene may have further ones in its model.
    pub causes: Vec<Cause>,
    /// The model file, all of it known.
    pub model: String,
    /// The measurement file without noise, to all digits.
    pub data: String,
    /// What it measures, row by row, each in the unit of its observable (um, degC).
    pub exact: Vec<f64>,
    /// The same without the effects that were asked for.
    pub without: Vec<f64>,
}

impl Process {
    /// The small job of a scene, measured without noise and without stated uncertainties; None where the scene
    /// does not admit the effects.
    pub fn pair_job(&self, effects: &[&'static str], scene: usize, random: &mut Random) -> Option<Box<dyn Job>> {
        (self.draw_scene)(scene, effects, random)
    }

    /// Effects (one, two or more, of the catalogue) that meet in a scene; None where they cannot.
    pub fn meeting(&self, effects: &[&'static str], scene: usize, seed: u64) -> Option<Meeting> {
        let name = self.scenes[scene];
        let mut random = Random::new(&format!("{}meet {name} {}", self.name, effects.join(" ")), seed);
        let job = self.pair_job(effects, scene, &mut random)?;
        let values: Vec<f64> = job.shown().iter().map(|shown| shown.written).collect();
        let mut causes = job.causes(&values);
        let company = causes.len();
        for effect in effects {
            let drawn = job.draw(effect, &mut random);
            causes.push(bounded(&*job, &causes[..company], drawn));
        }
        // An effect that the scene does not admit has nothing to act on.
        if effects.iter().any(|effect| !job.admits(effect, &causes)) {
            return None;
        }
        let exact = job.predict(&causes);
        Some(Meeting {
            scene: name,
            model: writing::model(&*job, Some(&values), &causes[company..]),
            data: job.data(&exact, 0.0),
            without: job.predict(&causes[..company]),
            exact,
            causes: causes.split_off(company),
        })
    }

    /// Every pair of the catalogue that a machine may have, in its order.
    pub fn pairs(&self) -> Vec<[&'static str; 2]> {
        let names: Vec<&'static str> = self.catalogue.iter().map(|law| law.0).collect();
        let can =
            |pair: &[&'static str; 2]| !STRANGERS.iter().any(|own| own.iter().all(|effect| pair.contains(effect)));
        let with = |(i, first): (usize, &&'static str)| {
            let first = *first;
            names[i + 1..].iter().map(move |other| [first, *other]).collect::<Vec<_>>()
        };
        names.iter().enumerate().flat_map(with).filter(can).collect()
    }
}

/// The effect, smaller if beside the company alone it changes more than [`LARGEST`].
fn bounded(job: &dyn Job, company: &[Cause], drawn: Cause) -> Cause {
    let without = job.predict(company);
    let mut cause = drawn;
    // What is not proportional takes more than one step.
    for _ in 0..6 {
        let with = job.predict(&[company, std::slice::from_ref(&cause)].concat());
        let change = difference(&with, &without, 1.0).into_iter().fold(0.0, |most: f64, off| most.max(off.abs()));
        if change <= LARGEST {
            break;
        }
        cause = scaled(job.laws(), &cause, 0.9 * LARGEST / change);
    }
    cause
}
