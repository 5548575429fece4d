//! What to change at a cam grinder whose programme is not corrected place by place: blocks, wheel, angles, speed.

use rayon::prelude::*;

use super::division::{By, Division, Ends};
use super::fewest::{MOST_BLOCKS, error};
use super::forward::left;
use super::guide::Guide;
use super::machine::Machine;
use super::program::points;
use super::setup::Setup;
use crate::process::{Advice, Failure};
use crate::units::{ANGLE, LENGTH, MICRO, SECONDS, SPINDLE_SPEED};

/// Gains below this are none, m.
const NONE: f64 = 5e-8;
/// Part of the tolerance that blocks may take up: the machine needs the rest.
const FOR_BLOCKS: f64 = 0.5;
/// Halvings after which a speed is known.
const HALVINGS: usize = 12;
/// The slowest cam that is advised, as a part of its speed.
const SLOWEST: f64 = 0.05;

/// All of it, what gains most first.
///
/// # Errors
/// The wheel does not come to the cam.
pub fn advice(machine: &Machine) -> Result<Vec<Advice>, Failure> {
    let now = largest(machine)?;
    let mut all = Vec::new();
    let mut without = |text: String, without: Machine| {
        let gain = now - largest(&without)?;
        if gain > NONE {
            let text = format!("{text}; the largest error falls by {:.2}", MICRO.shown(gain));
            all.push(Advice::new(text).gaining(gain));
        }
        Ok::<(), Failure>(())
    };
    let setup = &machine.setup;
    if machine.wear != 0.0 {
        let radius = [setup.wheel_radius, setup.wheel_radius - machine.wear].map(|own| LENGTH.shown(own));
        let text =
            format!("make the programme for the wheel as it is, of {:.3} instead of {:.3}", radius[1], radius[0]);
        without(text, Machine { wear: 0.0, ..machine.clone() })?;
    }
    if machine.gap != 0.0 {
        let text = format!("reversal compensation of the slide of {:.2}", MICRO.shown(machine.gap));
        without(text, Machine { gap: 0.0, ..machine.clone() })?;
    }
    if machine.lag != 0.0 {
        let angle = ANGLE.shown(setup.program.mean_speed * machine.lag);
        let text = format!("let the cam follow the slide: take {angle:.4} off its angles at this speed");
        without(text, Machine { lag: 0.0, ..machine.clone() })?;
    }
    if machine.height != 0.0 {
        let text =
            format!("set the wheel's centre to the height of the cam's axis, by {:.1}", MICRO.shown(-machine.height));
        without(text, Machine { height: 0.0, ..machine.clone() })?;
    }
    all.sort_by(|a, b| b.gain.unwrap_or(0.0).total_cmp(&a.gain.unwrap_or(0.0)));
    all.extend(slower(&Machine { wear: 0.0, gap: 0.0, height: 0.0, ..machine.clone() })?);
    all.extend(blocks(setup));
    Ok(all)
}

/// Half of what the drawing allows, m.
fn allowed(setup: &Setup) -> Option<f64> {
    let (limits, _) = setup.allowed.within.as_ref()?;
    Some(0.5 * (limits.upper - limits.lower)).filter(|half| half.is_finite() && *half > 0.0)
}

/// The largest distance of the deviation from the middle of its limits, m.
fn largest(machine: &Machine) -> Result<f64, Failure> {
    let setup = &machine.setup;
    let aim = setup.allowed.within.as_ref().and_then(|(limits, _)| limits.middle()).unwrap_or(0.0);
    let run = machine.run(setup.program.usual());
    let of = |s: &f64| Some((left(machine, &run, *s)? - aim).abs());
    let all: Option<Vec<f64>> = setup.places().par_iter().map(of).collect();
    let all = all.ok_or_else(|| Failure {
        message: "the wheel does not come to the cam everywhere".into(),
        help: "check the wheel, the profile and the sizes of the effects: a unit may be wrong".into(),
    })?;
    Ok(all.into_iter().fold(0.0, f64::max))
}

/// The speed at which what grows with it keeps the tolerance, where a slower cam does; of a machine on which all else is set.
fn slower(machine: &Machine) -> Result<Option<Advice>, Failure> {
    let now = largest(machine)?;
    let grows = machine.lag != 0.0 || machine.compliance != 0.0;
    let Some(allowed) = allowed(&machine.setup).filter(|allowed| grows && now > *allowed) else { return Ok(None) };
    // A lag is so much shorter a part of the turn, and the force falls with the feed.
    let at = |part: f64| {
        largest(&Machine { lag: part * machine.lag, compliance: part * machine.compliance, ..machine.clone() })
    };
    let (mut good, mut bad) = (SLOWEST, 1.0);
    if at(good)? > allowed {
        return Ok(None);
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (good + bad);
        *(if at(middle)? <= allowed { &mut good } else { &mut bad }) = middle;
    }
    let speed = machine.setup.program.mean_speed;
    let turn = std::f64::consts::TAU / speed;
    let [slow, fast] = [good * speed, speed].map(|own| SPINDLE_SPEED.shown(own));
    let text = format!(
        "turn the cam at {slow:.2} instead of {fast:.2}: what grows with the speed then keeps the tolerance; a turn takes {:.2} \
         instead of {:.2}",
        SECONDS.shown(turn / good),
        SECONDS.shown(turn)
    );
    Ok(Some(Advice::new(text).taking(turn / good - turn)))
}

/// The fewest blocks that leave the machine its part of the tolerance, where those of the programme do not.
fn blocks(setup: &Setup) -> Option<Advice> {
    let allowed = allowed(setup).filter(|_| setup.program.blocks() <= MOST_BLOCKS)?;
    let guide = Guide::new(&setup.profile, setup.wheel_radius);
    let program = &setup.program;
    let end = |i: usize| (program.places[i], program.shifts[i]);
    let of = |block: usize| error(&setup.profile, &guide, end(block), end(block + 1));
    let errors: Vec<f64> = (0..program.blocks()).into_par_iter().map(of).collect();
    let worst = errors.into_iter().fold(0.0, f64::max);
    let size = FOR_BLOCKS * allowed;
    if worst <= size {
        return None;
    }
    let joints = setup.profile.joints();
    let division = Division { by: By::Tolerance, size, at_joints: true, ends: Ends::OnProfile };
    let ends: Vec<f64> = points(&guide, &setup.profile, &division, &[]).into_iter().map(|p| p.0).collect();
    let count = |range: &[f64]| ends.iter().filter(|s| **s > range[0] && **s <= range[1]).count();
    let counts: Vec<usize> = joints.windows(2).map(count).collect();
    let each: Vec<String> = counts.iter().enumerate().map(|(i, n)| format!("{n} in segment {}", i + 1)).collect();
    Some(Advice::new(format!(
        "divide the profile into {} blocks that err by no more than {:.2} ({}); those of the programme, {}, err by up to {:.2}",
        counts.iter().sum::<usize>(),
        MICRO.shown(size),
        each.join(", "),
        program.blocks(),
        MICRO.shown(worst)
    )))
}
