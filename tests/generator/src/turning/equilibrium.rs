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
use super::rubbing;
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
pub struct At<'a> {
    held: &'a Held,
    carriage: &'a Carriage,
    imposed: Vec<f64>,
    mover: Mover,
    /// Friction of every support and what its joint bore before, N; none where nothing rubs.
    rubs: Option<(Vec<f64>, Vec<f64>)>,
}

impl At<'_> {
    /// The same where supports rub with up to `most` (N), the headstock first.
    pub fn rub(&mut self, most: [f64; 2]) {
        let mut all = vec![0.0; self.imposed.len()];
        all.iter_mut().zip(most).for_each(|(all, most)| *all = most);
        self.rubs = Some((all.clone(), vec![0.0; all.len()]));
    }

    /// Radius left less that of the diameter `d` to which the nose is set, um.
    fn leaves(&self, force: f64, d: f64) -> f64 {
        let goes = match &self.rubs {
            Some((most, borne)) => self.held.rubs(force, &self.imposed, most, borne).0,
            None => self.held.goes(force, &self.imposed),
        };
        let across = goes + self.carriage.gives(force) + self.mover.across;
        // R² − (D/2)² over R + D/2, which loses no digits.
        let square = across * (d + across) + self.mover.up * self.mover.up;
        square / ((0.5 * d + across).hypot(self.mover.up) + 0.5 * d)
    }

    /// Radius left less that of `d` after a cut, um; that of the blank where the nose does not reach it.
    fn after(&self, cut: &Cut, d: f64) -> f64 {
        if cut.exponent.is_some() && cut.set - self.leaves(0.0, d) <= 0.0 {
            return cut.set;
        }
        self.leaves(self.force(cut, d), d)
    }

    /// What the joints bear in a cut, N.
    fn bears(&self, cut: &Cut, d: f64) -> Vec<f64> {
        let Some((most, borne)) = &self.rubs else { return Vec::new() };
        self.held.rubs(self.force(cut, d), &self.imposed, most, borne).1
    }

    /// The force of a cut, N; none where the nose does not reach the blank.
    fn force(&self, cut: &Cut, d: f64) -> f64 {
        let Some(exponent) = cut.exponent else { return cut.force };
        if cut.set - self.leaves(0.0, d) <= 0.0 {
            return 0.0;
        }
        let makes = |force: f64| {
            let depth = (cut.set - self.leaves(force, d)).max(0.0);
            cut.force * (depth / cut.nominal).powf(exponent)
        };
        root(0.0, makes(0.0), |force| force - makes(force))
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
    let most = ["headstock-friction", "tailstock-friction"].map(|effect| value(causes, effect, "force"));
    if most != [None; 2] {
        return rubbing::errors(job, causes, most.map(|most| most.unwrap_or(0.0)));
    }
    let none = &mut Vec::new();
    at_rows(job, causes, |row, at, exponent, angle| one_side(job, row, at, exponent, (angle, none)))
}

/// Diameter error of every row, um, by what is left at it on one side.
pub fn at_rows(
    job: &Job,
    causes: &[Cause],
    mut one_side: impl FnMut(&Row, &mut At, Option<f64>, f64) -> f64,
) -> Vec<f64> {
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
        let mut at = At { held: &places[known].1, carriage: &carriage, imposed, mover, rubs: None };
        // Across a diameter the radius is what two opposite angles leave.
        let sides = if job.set_up.lobes.is_empty() { vec![0.0] } else { vec![0.0, 180.0] };
        let count = sides.len() as f64;
        let left: f64 = sides.iter().map(|turned| one_side(row, &mut at, exponent, row.angle + turned)).sum();
        errors.push(2.0 * left / count);
    }
    errors
}

/// Radius left less the set one at an angle (deg) of the part, after all passes, um. Where supports rub, `borne` is what
/// their joints bore in every pass, and bear then.
pub fn one_side(
    job: &Job,
    row: &Row,
    at: &mut At,
    exponent: Option<f64>,
    (angle, borne): (f64, &mut Vec<Vec<f64>>),
) -> f64 {
    let mut after = |at: &mut At, number: usize, cut: &Cut, d: f64| {
        if let (Some((_, before)), Some(borne)) = (&mut at.rubs, borne.get(number)) {
            before.clone_from(borne);
        }
        if let Some(borne) = borne.get_mut(number) {
            *borne = at.bears(cut, d);
        }
        at.after(cut, d)
    };
    let passes = job.set_up.passes.len();
    let finished = job.shaft.diameter(row.x);
    let last = |set: f64| Cut { set, nominal: 1e3 * job.depth, force: row.force, exponent };
    // The programme of the last pass alone is another one.
    let mover = Mover { across: at.mover.across + row.radius_change, ..at.mover };
    let (held, carriage, imposed, rubs) = (at.held, at.carriage, at.imposed.clone(), at.rubs.clone());
    let commanded = &mut At { held, carriage, imposed, mover, rubs };
    if let Some(blank) = row.blank {
        return after(commanded, passes, &last(1e3 * 0.5 * (blank - finished)), 1e3 * finished);
    }
    // By how much the radius is too large before a pass.
    let mut left = job.set_up.blank_error(row.x, job.shaft.length(), angle);
    let later = |from: usize| job.depth + job.set_up.passes[from..].iter().map(|pass| pass.depth).sum::<f64>();
    for (number, pass) in job.set_up.passes.iter().enumerate() {
        let depth = 1e3 * pass.depth;
        let cut = Cut { set: depth + left, nominal: depth, force: pass.force, exponent };
        left = after(at, number, &cut, 1e3 * (finished + 2.0 * later(number + 1)));
    }
    let set = row.depth.unwrap_or(job.depth);
    after(commanded, passes, &last(1e3 * set + left), 1e3 * finished)
}
