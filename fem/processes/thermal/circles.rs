//! Circles of a body of revolution whose diameters are looked at.

use super::body::Body;
use super::revolved;
use crate::input::Reader;
use crate::process::Segment;
use crate::units::LENGTH;

/// Reads the circles of a programme: distance from the left end, and radius, m.
pub fn read(t: &Reader, body: &Body) -> Vec<[f64; 2]> {
    let about = "where the outer diameter of a body of revolution is predicted, from its left end";
    let outside = t.quantities("diameters", LENGTH, about);
    let about = "where the diameter of its bore is predicted, from its left end";
    let bores = t.quantities("bores", LENGTH, about);
    if t.is_described() || (outside.is_none() && bores.is_none()) {
        return usual(body);
    }
    let Some(walls) = body.revolved() else {
        let key = if outside.is_some() { "diameters" } else { "bores" };
        let message = format!("diameters are predicted of bodies of revolution, not of {}", body.kind());
        t.problem(key, message, "leave it out, or give the body as revolved = [{ length, diameter, bore }]");
        return Vec::new();
    };
    let mut circles = Vec::new();
    for (key, side, places) in [("diameters", 1, outside), ("bores", 0, bores)] {
        for x in places.unwrap_or_default() {
            let (length, radius) = (body.length(), revolved::radii_at(walls, x)[side]);
            // A length that is still to be fitted reaches anywhere.
            if x < 0.0 || x > length * (1.0 + 1e-12) {
                let message = format!("{} is not on the body", LENGTH.format(x));
                t.problem(key, message, format!("it reaches from 0 to {}", LENGTH.format(length)));
            } else if radius == 0.0 {
                t.problem(key, format!("the body has no bore at {}", LENGTH.format(x)), "leave that place out");
            }
            circles.push([x, radius]);
        }
    }
    circles
}

/// Half way along: the outside, and the bore if there is one.
pub fn usual(body: &Body) -> Vec<[f64; 2]> {
    let Some(walls) = body.revolved() else { return Vec::new() };
    let middle = 0.5 * walls.iter().map(|wall: &Segment| wall.length).sum::<f64>();
    let [inner, outer] = revolved::radii_at(walls, middle);
    [outer, inner].into_iter().filter(|radius| *radius != 0.0).map(|radius| [middle, radius]).collect()
}
