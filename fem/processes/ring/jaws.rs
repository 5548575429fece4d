//! Jaws around a ring: where they stand, over which arc they press, and what part of the force is on each.

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

/// Jaws at some angles that press over `arc` each (rad), their forces in equilibrium.
///
/// # Errors
/// The jaws stand where they cannot hold a ring, or press on each other's place.
pub fn in_equilibrium(angles: &[f64], arc: f64) -> Result<Vec<Jaw>, Failure> {
    let room = room(angles);
    if arc > room * (1.0 + 1e-12) {
        let (arc, most) = (ANGLE.shown(arc), ANGLE.shown(room));
        return Err(Failure {
            message: format!("jaws that press over {arc:.1} each overlap"),
            help: format!("the {} jaws have room for {most:.1} each where they stand", angles.len()),
        });
    }
    let shares = shares(angles)?;
    Ok(angles.iter().zip(shares).map(|(angle, share)| Jaw { angle: *angle, arc, share }).collect())
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
