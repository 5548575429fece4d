//! A shaft on its supports, condensed to its compliance at the tool and at the joints.
//!
//! The tool travels, so the profile is the *diagonal* of the compliance. The shaft is cut at every position;
//! the part on either side of a cut is one [`HalfPlane`], found for all cuts in one pass from each end. The
//! cost is that of pieces plus positions, and pieces of any length are exact. Headstock and tailstock stay
//! outside as rigid supports that the joints displace, so that nonlinear joints and the force's feedback are
//! a problem of two unknowns at each position (see `equilibrium`).

mod condensed;
mod cut;
mod held;

pub use condensed::Condensed;
pub use held::{Hold, Rest, Shaft, ShaftError};

use super::foundation::{Foundation, Founded};
use super::plane::{HalfPlane, Link, Turning};
use cut::Cuts;

impl Shaft {
    /// Cuts the shaft at `positions` (m, in any order) and condenses it to them and to its two end supports.
    ///
    /// # Errors
    /// A position is off the shaft, or the shaft is loose.
    pub fn condense(&self, positions: &[f64]) -> Result<Condensed, ShaftError> {
        let Cuts { links, positions: cuts, rests } = self.cut(positions)?;
        let tail = if self.tailstock { HalfPlane::held(Turning::FREE) } else { HalfPlane::FREE };
        let ahead = || planes_ahead(HalfPlane::held(self.turning()), &links);
        let behind = || planes_behind(tail, &links);
        // Two threads pay from some ten thousand cuts on.
        let (left, right) = if links.len() > 8192 { rayon::join(ahead, behind) } else { (ahead(), behind()) };
        let compliance: Vec<f64> = cuts.iter().map(|&c| left[c as usize].joined(&right[c as usize]).0).collect();
        if let Some(i) = compliance.iter().position(|c| !c.is_finite()) {
            return Err(ShaftError::Loose { at: positions[i] });
        }
        let mut condensed = Condensed {
            links,
            left,
            right,
            bent: vec![0.0; cuts.len()],
            foundation_compliance: vec![0.0; cuts.len()],
            cuts,
            rests,
            compliance,
            influence: Vec::new(),
            constraint: [[0.0; 2]; 2],
            bent_forces: [0.0; 2],
            founded: None,
        };
        if self.is_determinate() {
            let length = self.length();
            let share = |x: &f64| if self.tailstock { [1.0 - x / length, x / length] } else { [1.0, 0.0] };
            condensed.influence = positions.iter().map(share).collect();
        } else {
            condensed.displace_supports(self);
        }
        Ok(condensed)
    }

    /// The same where supports and tool stand on what yields.
    ///
    /// # Errors
    /// As [`condense`](Self::condense).
    pub fn condense_on(&self, positions: &[f64], foundation: Foundation) -> Result<Condensed, ShaftError> {
        let mut condensed = self.condense(positions)?;
        let founded = Founded::new(foundation, condensed.response(self));
        for i in 0..positions.len() {
            (condensed.influence[i], condensed.foundation_compliance[i], condensed.bent[i]) = founded.at(i);
        }
        (condensed.constraint, condensed.bent_forces) = (founded.constraint(), founded.bent_forces());
        condensed.founded = Some(founded);
        Ok(condensed)
    }
}

fn planes_ahead(start: HalfPlane, links: &[Link]) -> Vec<HalfPlane> {
    let mut planes = Vec::with_capacity(links.len() + 1);
    let mut plane = start;
    planes.push(plane);
    for link in links {
        plane = plane.beyond(link).with_rest(link);
        planes.push(plane);
    }
    planes
}

fn planes_behind(start: HalfPlane, links: &[Link]) -> Vec<HalfPlane> {
    let mut planes = vec![start; links.len() + 1];
    let mut plane = start;
    for (i, link) in links.iter().enumerate().rev() {
        plane = plane.with_rest(link).beyond(link);
        planes[i] = plane;
    }
    planes
}
