//! Where nose, work, supports and blank come to rest, row by row, in one equilibrium: what the shaft goes away
//! under the cut and with its supports, what moves the nose across, and the depth that is left between nose
//! and blank, which makes the force.
//!
//! ```text
//!   across = y(P) + movers          R = √((D/2 + across)² + z²)
//!   t_d = t_set − (R − D/2)         P = P0·(t_d/t_0)^exponent, 0 where t_d ≤ 0
//! ```

use super::held::{Held, Root, Support};
use super::job::{Holding, Job, Row};
use super::movers::{Mover, movers};
use super::set_up::Rest;
use crate::dense::root;
use crate::law::{Cause, value};

/// What presses on the nose gives way behind it: springs in series with a contact.
#[derive(Debug, Clone, Copy)]
struct Carriage {
    compliance: f64,
    contact: (f64, f64),
}

impl Carriage {
    fn gives(&self, force: f64) -> f64 {
        let (c, n) = self.contact;
        force * self.compliance + if force > 0.0 && c > 0.0 { c * force.powf(n) } else { 0.0 }
    }
}

/// Set depth (um), the depth to which a force belongs (um), that force (N) and its exponent, if it has one.
#[derive(Debug, Clone, Copy)]
struct Cut {
    set: f64,
    nominal: f64,
    force: f64,
    exponent: Option<f64>,
}

/// A row with all that moves in it but by force.
struct At<'a> {
    held: &'a Held,
    carriage: &'a Carriage,
    imposed: Vec<f64>,
    mover: Mover,
}

impl At<'_> {
    /// Radius left less that of the diameter `d` to which the nose is set, um.
    fn leaves(&self, force: f64, d: f64) -> f64 {
        let across = self.held.goes(force, &self.imposed) + self.carriage.gives(force) + self.mover.across;
        // R² − (D/2)² over R + D/2, which loses no digits.
        let square = across * (d + across) + self.mover.up * self.mover.up;
        square / ((0.5 * d + across).hypot(self.mover.up) + 0.5 * d)
    }

    /// Radius left less that of `d` after a cut, um; that of the blank where the nose does not reach it.
    fn after(&self, cut: &Cut, d: f64) -> f64 {
        let Some(exponent) = cut.exponent else { return self.leaves(cut.force, d) };
        if cut.set - self.leaves(0.0, d) <= 0.0 {
            return cut.set;
        }
        let makes = |force: f64| {
            let depth = (cut.set - self.leaves(force, d)).max(0.0);
            cut.force * (depth / cut.nominal).powf(exponent)
        };
        self.leaves(root(0.0, makes(0.0), |force| force - makes(force)), d)
    }
}

/// Supports with what the causes make of them; the headstock first.
fn supports(job: &Job, causes: &[Cause]) -> (Root, Vec<Support>) {
    let spring = |effect: &str| value(causes, effect, "stiffness").map_or(0.0, f64::recip);
    let contact = |effect: &str| value(causes, effect, "c").zip(value(causes, effect, "n"));
    let support = |at: f64, compliance: &str, joint: &str| Support {
        at,
        compliance: spring(compliance),
        contact: contact(joint),
    };
    let mut supports = vec![support(0.0, "headstock-compliance", "headstock-contact")];
    if job.holding != Holding::Chuck {
        supports.push(support(job.shaft.length(), "tailstock-compliance", "tailstock-contact"));
    }
    let rest = |rest: &Rest| Support { at: rest.at, compliance: 1.0 / rest.stiffness, contact: None };
    supports.extend(job.set_up.rests.iter().map(rest));
    // kN·m/rad are 1e6 N·mm/rad, and um/mm 1e-3 rad.
    let tilt = spring("chuck-tilt") * 1e-3;
    let root = if job.holding == Holding::Centres { Root::Pin } else { Root::Clamp(tilt) };
    (root, supports)
}

fn carriage(job: &Job, causes: &[Cause]) -> Carriage {
    let spring = value(causes, "carriage-compliance", "stiffness").map_or(0.0, f64::recip);
    let holder = job.set_up.holder.as_ref().map_or(0.0, |holder| holder.compliance(job.shaft.shear));
    let of = |parameter| value(causes, "carriage-contact", parameter);
    Carriage { compliance: spring + holder, contact: (of("c").unwrap_or(0.0), of("n").unwrap_or(1.0)) }
}

/// Diameter error of every row, um.
pub fn errors(job: &Job, causes: &[Cause]) -> Vec<f64> {
    let (root, supports) = supports(job, causes);
    let carriage = carriage(job, causes);
    let exponent = value(causes, "force-feedback", "exponent");
    let offset = value(causes, "tailstock-offset", "offset").unwrap_or(0.0);
    let out_of_line = value(causes, "rest-offset", "offset").unwrap_or(0.0);
    let mut places: Vec<(f64, Held)> = Vec::new();
    let mut errors = Vec::with_capacity(job.rows.len());
    for (row, mover) in job.rows.iter().zip(movers(job, causes)) {
        let known = places.iter().position(|(x, _)| *x == row.x).unwrap_or_else(|| {
            places.push((row.x, Held::new(&job.shaft, root, &supports, row.x)));
            places.len() - 1
        });
        let mut imposed = vec![mover.headstock];
        if job.holding != Holding::Chuck {
            imposed.push(offset);
        }
        imposed.extend(job.set_up.rests.iter().map(|rest| rest.offset + out_of_line));
        let at = At { held: &places[known].1, carriage: &carriage, imposed, mover };
        // Across a diameter the radius is what two opposite angles leave.
        let sides = if job.set_up.lobes.is_empty() { vec![0.0] } else { vec![0.0, 180.0] };
        let count = sides.len() as f64;
        let left: f64 = sides.iter().map(|turned| one_side(job, row, &at, exponent, row.angle + turned)).sum();
        errors.push(2.0 * left / count);
    }
    errors
}

/// Radius left less the set one at an angle (deg) of the part, after all passes, um.
fn one_side(job: &Job, row: &Row, at: &At, exponent: Option<f64>, angle: f64) -> f64 {
    let finished = job.shaft.diameter(row.x);
    let last = |set: f64| Cut { set, nominal: 1e3 * job.depth, force: row.force, exponent };
    // The programme of the last pass alone is another one.
    let mover = Mover { across: at.mover.across + row.radius_change, ..at.mover };
    let commanded = At { held: at.held, carriage: at.carriage, imposed: at.imposed.clone(), mover };
    if let Some(blank) = row.blank {
        return commanded.after(&last(1e3 * 0.5 * (blank - finished)), 1e3 * finished);
    }
    // By how much the radius is too large before a pass.
    let mut left = job.set_up.blank_error(row.x, job.shaft.length(), angle);
    let later = |from: usize| job.depth + job.set_up.passes[from..].iter().map(|pass| pass.depth).sum::<f64>();
    for (number, pass) in job.set_up.passes.iter().enumerate() {
        let depth = 1e3 * pass.depth;
        let cut = Cut { set: depth + left, nominal: depth, force: pass.force, exponent };
        left = at.after(&cut, 1e3 * (finished + 2.0 * later(number + 1)));
    }
    let set = row.depth.unwrap_or(job.depth);
    commanded.after(&last(1e3 * set + left), 1e3 * finished)
}
