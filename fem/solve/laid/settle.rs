//! The choice of the supports that carry the part.

use std::sync::Arc;

use super::carried::{Carried, acting, carry};
use super::{Flexible, LaidError, Load, Reaction, Settled, Support, Supports};

/// Reactions, and depths pressed into supports, that are this small against the loads count as zero.
const NOTHING: f64 = 1e-11;

/// Lays a part on two or more supports at different places under loads of zero or more.
///
/// The support that would pull most is taken away, the one that the part would sink into most is put back,
/// until there is neither: the forces and displacements so found are unique, for they make the complementary
/// energy least.
///
/// # Errors
/// The loads press outside the supports, or no equilibrium was found.
pub fn settle(part: &Arc<Flexible>, on: Supports, loads: &[Load]) -> Result<Settled, LaidError> {
    let supports = on.all;
    let total: f64 = loads.iter().map(|l| l.force).sum();
    if total == 0.0 {
        let reactions = vec![Reaction { force: 0.0, displacement: 0.0, friction: 0.0 }; supports.len()];
        return Ok(Settled { part: part.clone(), forces: Vec::new(), rigid: laid(supports), reactions });
    }
    let resultant = loads.iter().map(|l| l.force * l.spot.at).sum::<f64>() / total;
    let from = supports.iter().map(|s| s.spot.at).fold(f64::INFINITY, f64::min);
    let to = supports.iter().map(|s| s.spot.at).fold(f64::NEG_INFINITY, f64::max);
    let slack = 1e-12 * to.abs().max(from.abs());
    if !(from - slack..=to + slack).contains(&resultant) {
        return Err(LaidError::Tips { at: resultant, from, to });
    }
    let mut carrying = vec![true; supports.len()];
    for round in 0..20 * supports.len() {
        let carried = carry(part, on, &carrying, loads)?;
        let wrong = wrong(on, &carrying, &carried, total)?;
        // The worst first, which is quick; by position later on, which cannot go in circles.
        let worst = match round < 4 * supports.len() {
            true => wrong.into_iter().max_by(|a, b| a.1.total_cmp(&b.1)),
            false => wrong.into_iter().next(),
        };
        let Some((changed, _)) = worst else {
            let settled = finish(part, on, &carrying, loads, &carried)?;
            return rocks(supports, &settled, total).map_or(Ok(settled), |at| Err(LaidError::Rocks { at }));
        };
        carrying[changed] = !carrying[changed];
        if carrying.iter().filter(|c| **c).count() < 2 {
            let beyond = beyond(supports, changed, &carrying, resultant);
            carrying[beyond.ok_or(LaidError::NoEquilibrium { load: total })?] = true;
        }
    }
    Err(LaidError::NoEquilibrium { load: total })
}

/// The rigid displacement of a part that nothing presses: as the first and the last support have it.
fn laid(supports: &[Support]) -> (f64, f64) {
    let by_place = |a: &&Support, b: &&Support| a.spot.at.total_cmp(&b.spot.at);
    let (Some(first), Some(last)) = (supports.iter().min_by(by_place), supports.iter().max_by(by_place)) else {
        return (0.0, 0.0);
    };
    let slope = if last.spot.at > first.spot.at {
        (last.lowered - first.lowered) / (last.spot.at - first.spot.at)
    } else {
        0.0
    };
    (first.lowered - slope * first.spot.at, slope)
}

/// Supports that pull, and supports that the part sinks into though they carry nothing; each with how much,
/// as a part of what acts.
fn wrong(on: Supports, carrying: &[bool], carried: &Carried, total: f64) -> Result<Vec<(usize, f64)>, LaidError> {
    let (supports, stand) = (on.all, on.stand(&carried.forces)?);
    let size = supports.iter().map(|s| carried.part.deflection_at(&s.spot).abs()).fold(f64::MIN_POSITIVE, f64::max);
    let of = |i: usize| match carrying[i] {
        true => -carried.forces[i] / total,
        false => (carried.part.deflection_at(&supports[i].spot) - stand[i]) / size,
    };
    Ok((0..supports.len()).map(|i| (i, of(i))).filter(|(_, by)| *by > NOTHING).collect())
}

/// The place of the one support that carries all, where the part has left another on one side of it and could as well leave those on
/// the other: which of them it leans on is then open.
fn rocks(supports: &[Support], settled: &Settled, total: f64) -> Option<f64> {
    let own = || supports.iter().zip(&settled.reactions);
    let (alone, _) = own().find(|(_, reaction)| reaction.force >= (1.0 - NOTHING) * total)?;
    let at = alone.spot.at;
    let has_left = |side: f64| own().any(|(s, r)| (s.spot.at - at) * side > 0.0 && r.displacement < 0.0);
    let leans = |side: f64| own().any(|(s, r)| (s.spot.at - at) * side > 0.0 && r.displacement == 0.0);
    [1.0, -1.0].into_iter().any(|side| has_left(side) && leans(-side)).then_some(at)
}

/// The support to put back where one of two was taken away because the resultant acts beyond the other: the
/// nearest one there.
fn beyond(supports: &[Support], gone: usize, carrying: &[bool], resultant: f64) -> Option<usize> {
    let left = carrying.iter().position(|c| *c)?;
    let side = (supports[left].spot.at - supports[gone].spot.at).signum();
    let distance = |i: &usize| (supports[*i].spot.at - resultant) * side;
    let others = (0..supports.len()).filter(|i| *i != left && *i != gone && distance(i) >= 0.0);
    others.min_by(|a, b| distance(a).total_cmp(&distance(b)))
}

fn finish(
    part: &Arc<Flexible>,
    on: Supports,
    carrying: &[bool],
    loads: &[Load],
    carried: &Carried,
) -> Result<Settled, LaidError> {
    let (supports, stand) = (on.all, on.stand(&carried.forces)?);
    let reaction = |(i, support): (usize, &Support)| match carrying[i] {
        true => {
            let force = carried.forces[i].max(0.0);
            Reaction { force, displacement: support.joint.displacement(force), friction: carried.friction[i] }
        }
        false => {
            let displacement = (carried.part.deflection_at(&support.spot) - stand[i]).min(0.0);
            Reaction { force: 0.0, displacement, friction: 0.0 }
        }
    };
    let reactions: Vec<Reaction> = supports.iter().enumerate().map(reaction).collect();
    let forces: Vec<f64> = reactions.iter().map(|r| r.force).collect();
    let forces = acting(supports, loads, &forces, &carried.friction);
    Ok(Settled { part: part.clone(), forces, rigid: carried.part.rigid, reactions })
}
