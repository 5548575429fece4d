//! The least force of the jaws that still holds the ring against the cut.
//!
//! The jaws hold the moment of the cutting force by friction: n·μ·F·R ≥ S·F_c·r, R the radius that they hold and r that which is cut, while they press with F = F₀ ∓ m·r·ω² (VDI
//! 3106:2004, of a chuck that holds by its jaws alone; forces of feed and thrust are held by stops).

use super::machine::Machine;
use super::membrane::Grasp;
use super::setup::Setup;
use crate::process::Advice;
use crate::units::{FORCE, MICRO};

/// Force of each jaw at standstill that holds the cut with the margin that is asked for, N; `None` where the model does not
/// know the cut, or the friction.
pub fn least_force(machine: &Machine) -> Option<f64> {
    let setup = &machine.setup;
    let Setup { cutting_force, friction, margin, grip, .. } = &**setup;
    let jaws = machine.jaw_angles.len() as f64;
    let while_cut = margin * (*cutting_force)? * setup.cut_radius() / (jaws * (*friction)? * setup.held_radius());
    let (speed, moment) = (setup.speed(), machine.thrown_moment());
    Some((while_cut + grip.inwards() * moment * speed * speed).max(0.0))
}

/// Says that the jaws do not hold the cut, where the model knows that.
pub fn slips(machine: &Machine) -> Option<String> {
    let (force, margin) = (machine.setup.jaw_force, machine.setup.margin);
    let least = least_force(machine).filter(|least| force < *least)?;
    // Of whole newtons the next above still hold.
    let [asked, now] = [least.ceil(), force].map(|force| FORCE.shown(force));
    Some(format!(
        "the jaws do not hold the cut with a margin of {margin:.1}: each needs {asked:.0} at standstill and presses with {now:.0}"
    ))
}

/// What the jaws should press with, given the deviation of the cut surface, m.
pub fn advice(machine: &Machine, deviation: &[f64]) -> Vec<Advice> {
    let Some(least) = least_force(machine) else { return Vec::new() };
    let setup = &machine.setup;
    let (force, margin) = (setup.jaw_force, setup.margin);
    if let Some(text) = slips(machine) {
        return vec![set(setup, Advice::new(text), force, least)];
    }
    let [asked, now] = [least.ceil(), force].map(|force| FORCE.shown(force));
    let speed = machine.setup.speed();
    let [left, pressed] = [least, force].map(|force| machine.force_at(force, speed));
    let worst = deviation.iter().fold(0.0f64, |worst, own| worst.max(own.abs()));
    let gain = worst * (1.0 - left / pressed);
    let text = format!(
        "{asked:.0} at each jaw still hold the cut with a margin of {margin:.1}, not {now:.0}: what the jaws leave falls in \
         proportion, by up to {:.1}",
        MICRO.shown(gain)
    );
    vec![set(setup, Advice::new(text), force, least).gaining(gain)]
}

/// What is to be set for `least` in the place of `force` at each jaw, N: the force, or in proportion what a membrane is sprung by.
fn set(setup: &Setup, advice: Advice, force: f64, least: f64) -> Advice {
    match &setup.grasp {
        Some(Grasp { membrane, .. }) => {
            let sprung = membrane.interference;
            advice.setting("chuck.membrane.interference", sprung, sprung * least / force)
        }
        None => advice.setting("chuck.jaw_force", force, least),
    }
}
