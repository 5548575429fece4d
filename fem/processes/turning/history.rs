//! What the joints have been through when the tool reaches a place.
//!
//! Where friction holds a joint, where it stands depends on the way there: the tool enters and the force rises; the tool
//! travels, and what each support bears rises or falls; it leaves, and the next pass begins with what has stuck. From where a
//! reaction turns to where it turns again the way between does not count, so that a few places along the pass are enough:
//! its ends, those of segments, rests, and some between, for a blank or a force may change along it.

use super::elastic::{Borne, Cutting, Elastic, condense};
use super::machine::Machine;
use crate::process::Failure;

/// Places between the ends of a pass beside those of segments and rests.
const PLACES: usize = 100;

/// The passes over a part as its joints feel them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct History {
    /// Places along the pass as the tool comes to them, m.
    places: Vec<f64>,
    /// Whether x falls along the pass.
    falls: bool,
    /// What the joints bear in every pass before the tool reaches the first place, and at each place.
    borne: Vec<Vec<[f64; 2]>>,
}

impl History {
    /// Of the passes on a part by the schedule and the settings of the model, on the mean of the blank or at an angle (rad)
    /// around it.
    ///
    /// # Errors
    /// No equilibrium at some place.
    pub fn on_part(machine: &Machine, part: usize, angle: Option<f64>) -> Result<Self, Failure> {
        Self::of(machine, angle, &[], |x| Cutting::on_part(machine, part, x))
    }

    /// Of passes of which the last is given by its cut at x (m), where the work is as it is meant, and to be met at some
    /// places (m) as well.
    ///
    /// # Errors
    /// No equilibrium at some place.
    pub fn of(
        machine: &Machine,
        angle: Option<f64>,
        also: &[f64],
        last: impl Fn(f64) -> Cutting,
    ) -> Result<Self, Failure> {
        if !machine.rubs() {
            return Ok(Self::default());
        }
        let (places, falls) = places(machine, also);
        let mut rising = places.clone();
        rising.sort_unstable_by(f64::total_cmp);
        let shaft = condense(machine, &rising)?;
        let elastic = Elastic::new(machine, &shaft);
        let passes = machine.setup.passes.len() + 1;
        let mut history = Self { places, falls, borne: vec![vec![[0.0; 2]; passes]] };
        // The machine has turned such a part before: the first pass begins with what the last left.
        for _ in 0..2 {
            let mut borne = history.begun(machine);
            history.borne = vec![borne.clone()];
            for (k, x) in history.places.iter().enumerate() {
                let (i, mut error) = (if falls { rising.len() - 1 - k } else { k }, elastic.met(*x, angle));
                let last = last(*x);
                for number in 0..passes {
                    let cut = elastic.pass(number, (i, *x), error, &last, &borne)?;
                    borne[number] = cut.borne;
                    error = if machine.feeds_back() { cut.error } else { 0.0 };
                }
                history.borne.push(borne.clone());
            }
        }
        Ok(history)
    }

    /// What the joints bear in every pass once the pass before it has ended and the tool has left the work, N.
    fn begun(&self, machine: &Machine) -> Vec<[f64; 2]> {
        let mut left = self.borne.last().cloned().unwrap_or_default();
        left.rotate_right(1);
        let keep = |(bears, most): (&mut f64, f64)| *bears = bears.clamp(-most, most);
        left.iter_mut().for_each(|pass| pass.iter_mut().zip(machine.friction).for_each(keep));
        left
    }

    /// What the joints bore in every pass before the tool reached x (m), N; nothing where nothing rubs.
    pub fn at(&self, x: f64) -> &Borne {
        let passed = self.places.partition_point(|place| if self.falls { *place > x } else { *place < x });
        self.borne.get(passed).map_or(&[], Vec::as_slice)
    }
}

/// Places along the pass as the tool comes to them (m), and whether x falls along it.
fn places(machine: &Machine, also: &[f64]) -> (Vec<f64>, bool) {
    let setup = &machine.setup;
    let pass = setup.schedule.pass;
    let (falls, (low, high)) = (pass.to < pass.from, pass.ends());
    let between = (0..=PLACES).map(|i| low + (high - low) * (i as f64 / PLACES as f64));
    let known = setup.ends().iter().chain(also).copied().chain(setup.steady_rests.iter().map(|rest| rest.at));
    let mut places: Vec<f64> = between.chain(known).filter(|x| (low..=high).contains(x)).collect();
    places.sort_unstable_by(f64::total_cmp);
    places.dedup();
    if falls {
        places.reverse();
    }
    (places, falls)
}
