//! Jaws around a ring: where they stand, over which arc they press, and what part of the force is on each.
//!
//! Jaws that press alike at standstill form a group, which is in equilibrium by itself: what the turning chuck takes from each jaw
//! is the same force, and not the same part of it.

use std::f64::consts::TAU;

use crate::process::Failure;
use crate::solve::ring::ContactArc;
use crate::units::ANGLE;

/// A jaw of a chuck.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jaw {
    /// Angle at which it stands, rad.
    pub angle: f64,
    /// Full angle over which it presses, rad; 0 for a line load.
    pub arc: f64,
    /// Its force over that of a jaw of an even chuck.
    pub share: f64,
}

impl Jaw {
    /// Its load, `force` being that of a jaw of an even chuck, N.
    pub fn load(&self, force: f64) -> ContactArc {
        ContactArc { angle: self.angle, width: self.arc, force: force * self.share }
    }
}

/// Jaws that lighten alike while the chuck turns, their forces in equilibrium.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// The jaws, their shares those of the mean force of the group.
    pub jaws: Vec<Jaw>,
    /// Mean force of the group at standstill over that of the chuck.
    pub part: f64,
}

/// Jaws at some angles that press over `arc` each (rad), their forces in equilibrium. Of an even number the first, third … press
/// with `difference` more than the others, in parts of the mean force.
///
/// # Errors
/// The jaws stand where they cannot hold a ring, or press on each other's place.
pub fn in_equilibrium(angles: &[f64], arc: f64, difference: f64) -> Result<Vec<Group>, Failure> {
    let room = room(angles);
    if arc > room * (1.0 + 1e-12) {
        let (arc, most) = (ANGLE.shown(arc), ANGLE.shown(room));
        return Err(Failure {
            message: format!("jaws that press over {arc:.1} each overlap"),
            help: format!("the {} jaws have room for {most:.1} each where they stand", angles.len()),
        });
    }
    let group = |angles: &[f64], part: f64| {
        let jaw = |(angle, share): (&f64, f64)| Jaw { angle: *angle, arc, share };
        Ok(Group { jaws: angles.iter().zip(shares(angles)?).map(jaw).collect(), part })
    };
    if difference == 0.0 {
        return Ok(vec![group(angles, 1.0)?]);
    }
    let every_other = |first: usize| angles.iter().skip(first).step_by(2).copied().collect::<Vec<f64>>();
    [0, 1].into_iter().zip(parts(difference)).map(|(first, part)| group(&every_other(first), part)).collect()
}

/// Forces of the first, third … jaw and of the others over their mean, one `difference` apart.
pub fn parts(difference: f64) -> [f64; 2] {
    [1.0 + 0.5 * difference, 1.0 - 0.5 * difference]
}

/// The smallest angle from one jaw to the next, rad.
fn room(angles: &[f64]) -> f64 {
    let mut around: Vec<f64> = angles.iter().map(|a| a.rem_euclid(TAU)).collect();
    around.sort_by(f64::total_cmp);
    let (Some(first), Some(last)) = (around.first(), around.last()) else { return TAU };
    around.windows(2).map(|a| a[1] - a[0]).fold(first + TAU - last, f64::min)
}

/// Forces of the jaws in equilibrium over that of a jaw of an even chuck, their mean being one. Those of
/// three jaws are as the sines of the angles between the other two (Lamy's theorem); more stand evenly.
fn shares(angles: &[f64]) -> Result<Vec<f64>, Failure> {
    let [a, b, c] = angles else { return Ok(vec![1.0; angles.len()]) };
    let sines = [(c - b).sin(), (a - c).sin(), (b - a).sin()];
    let mean = sines.iter().sum::<f64>() / 3.0;
    let shares: Vec<f64> = sines.iter().map(|sine| sine / mean).collect();
    if shares.iter().all(|share| *share > 0.0) {
        return Ok(shares);
    }
    let shown: Vec<String> = angles.iter().map(|angle| format!("{:.1}", ANGLE.from_si(*angle))).collect();
    Err(Failure {
        message: format!("jaws at {} deg cannot press in equilibrium", shown.join(", ")),
        help: "three jaws hold a ring when no two neighbours stand 180 deg or more apart".into(),
    })
}
