//! Where the tool, the joints and the shaft come to rest: the one place where causes do not simply add.

use super::job::{Holding, Job, Row};
use crate::dense::root;
use crate::law::{Cause, value};

/// A spring in series with a contact, either of which may be rigid: gap = q/k + c q^n, pressing only [002
/// (29)].
#[derive(Debug, Clone, Copy, Default)]
struct Joint {
    spring: f64,
    c: f64,
    n: f64,
}

impl Joint {
    fn of(causes: &[Cause], compliance: &str, contact: &str) -> Self {
        Self {
            spring: value(causes, compliance, "stiffness").map_or(0.0, f64::recip),
            c: value(causes, contact, "c").unwrap_or(0.0),
            n: value(causes, contact, "n").unwrap_or(1.0),
        }
    }

    fn gap(&self, q: f64) -> f64 {
        if q <= 0.0 { 0.0 } else { q * self.spring + if self.c == 0.0 { 0.0 } else { self.c * q.powf(self.n) } }
    }
}

/// Everything that yields, N and um; `tilt` in um/(N mm^2), that is 1e3 rad/(N mm).
#[derive(Debug, Clone, Copy)]
struct Joints {
    head: Joint,
    tail: Joint,
    carriage: Joint,
    tilt: f64,
}

/// Unit-load compliances for a tool at one place, um/N.
struct Place {
    x: f64,
    length: f64,
    here: f64,
    cross: f64,
    end: f64,
}

impl Place {
    fn new(job: &Job, x: f64) -> Self {
        let length = job.shaft.length();
        let shaft = &job.shaft;
        match job.holding {
            Holding::Centres => Self { x, length, here: shaft.between_pins(x), cross: 0.0, end: 0.0 },
            Holding::Chuck => Self { x, length, here: shaft.cantilever(x, x), cross: 0.0, end: 0.0 },
            Holding::ChuckAndCentre => Self {
                x,
                length,
                here: shaft.cantilever(x, x),
                cross: shaft.cantilever(x, length),
                end: shaft.cantilever(length, length),
            },
        }
    }
}

/// Radial gap y at the tool under the force `p`, um.
fn gap(holding: Holding, place: &Place, joints: &Joints, p: f64) -> f64 {
    let Place { x, length, here, cross, end } = *place;
    let Joints { head, tail, carriage, tilt } = joints;
    let work = match holding {
        Holding::Centres => {
            let share = x / length;
            p * here + (1.0 - share) * head.gap(p * (1.0 - share)) + share * tail.gap(p * share)
        }
        Holding::Chuck => p * here + head.gap(p) + tilt * p * x * x,
        Holding::ChuckAndCentre => {
            // Force method: the tailstock's reaction r closes what the cantilever would open at L.
            let open =
                |r: f64| p * cross - r * end + head.gap(p - r) + tilt * length * (p * x - r * length) - tail.gap(r);
            let r = root(0.0, p, open);
            p * here - r * cross + head.gap(p - r) + tilt * x * (p * x - r * length)
        }
    };
    work + carriage.gap(p)
}

/// Force and gap of one row: P = P0 (t_d/t_0)^exponent with t_d = t_set - y >= 0 [002 (17)-(27)], or P0
/// without force-feedback.
fn balance(job: &Job, row: &Row, joints: &Joints, exponent: Option<f64>, place: &Place) -> f64 {
    let y = |p: f64| gap(job.holding, place, joints, p);
    let Some(exponent) = exponent else { return y(row.force) };
    let set = row.blank.map_or(job.depth, |blank| 0.5 * (blank - job.shaft.diameter(row.x)));
    let cut = |p: f64| row.force * ((set - 1e-3 * y(p)).max(0.0) / job.depth).powf(exponent);
    let most = row.force * (set.max(0.0) / job.depth).powf(exponent);
    y(root(0.0, most, |p| p - cut(p)))
}

/// Diameter error from the force deflection alone, 2y per row [002 (8)], um.
pub fn force_error(job: &Job, causes: &[Cause]) -> Vec<f64> {
    let joints = Joints {
        head: Joint::of(causes, "headstock-compliance", "headstock-contact"),
        tail: Joint::of(causes, "tailstock-compliance", "tailstock-contact"),
        carriage: Joint::of(causes, "carriage-compliance", "carriage-contact"),
        tilt: value(causes, "chuck-tilt", "stiffness").map_or(0.0, |k| 1e3 / (k * 1e6)),
    };
    let exponent = value(causes, "force-feedback", "exponent");
    let mut places: Vec<Place> = Vec::new();
    let mut errors = Vec::with_capacity(job.rows.len());
    for row in &job.rows {
        let at = places.iter().position(|p| p.x == row.x).unwrap_or_else(|| {
            places.push(Place::new(job, row.x));
            places.len() - 1
        });
        errors.push(2.0 * balance(job, row, &joints, exponent, &places[at]));
    }
    errors
}
