//! A profile given by a follower's lift table: radius over angle, joined by a periodic cubic spline, so that its normal turns smoothly.
//!
//! The table is of a knife-edge follower, and then the profile itself, or of the centre of a roller, and then the profile lies a roller's radius
//! inside it.

use std::f64::consts::TAU;
use std::sync::Arc;

use super::{Curve, Drawn, Place, Profile, Segment, direction, left};
use crate::input::{Problem, Reader};
use crate::units::{ANGLE, Kind, LENGTH};

/// Largest table, bytes: more than a row per arc second.
const LARGEST: u64 = 50_000_000;
/// Rows of a table, at least, and the widest gap between them, rad.
const FEWEST: usize = 12;
const WIDEST: f64 = TAU / 8.0;

/// Radius over angle, periodic.
#[derive(Clone, Debug, PartialEq)]
pub struct Lift {
    /// Rising over one turn; the first again at the end, rad.
    angles: Vec<f64>,
    /// The first again at the end, m.
    radii: Vec<f64>,
    /// Second derivatives d²r/dθ², m/rad².
    bends: Vec<f64>,
    /// Of the roller, m; 0 for a knife edge.
    roller: f64,
}

impl Lift {
    /// A spline through the rows, which rise in angle and cover less than a turn.
    pub fn new(mut angles: Vec<f64>, mut radii: Vec<f64>, roller: f64) -> Self {
        angles.push(angles[0] + TAU);
        radii.push(radii[0]);
        let bends = periodic_spline(&angles, &radii);
        Self { angles, radii, bends, roller }
    }

    /// Number of intervals.
    pub fn intervals(&self) -> usize {
        self.angles.len() - 1
    }

    /// Radius of the table and its derivatives by the angle, at u from 0 to 1 within an interval.
    fn radius(&self, i: usize, u: f64) -> [f64; 3] {
        let h = self.angles[i + 1] - self.angles[i];
        let (a, b) = (1.0 - u, u);
        let (m, n) = (self.bends[i], self.bends[i + 1]);
        let (r, s) = (self.radii[i], self.radii[i + 1]);
        let value = a * r + b * s + h * h / 6.0 * ((a * a * a - a) * m + (b * b * b - b) * n);
        let slope = (s - r) / h + h / 6.0 * ((3.0 * b * b - 1.0) * n - (3.0 * a * a - 1.0) * m);
        [value, slope, a * m + b * n]
    }

    /// The place at u from 0 to 1 within an interval.
    pub fn place(&self, i: usize, u: f64) -> Place {
        let angle = self.angles[i] + u * (self.angles[i + 1] - self.angles[i]);
        let [r, slope, bend] = self.radius(i, u);
        let radial = direction(angle);
        let speed = slope.hypot(r);
        let tangent = (radial * slope + left(&radial) * r) / speed;
        let normal = -left(&tangent);
        let curvature = (r * r + 2.0 * slope * slope - r * bend) / speed.powi(3);
        Place {
            point: radial * r - normal * self.roller,
            normal,
            curvature: curvature / (1.0 - curvature * self.roller),
        }
    }

    /// Length of an interval of the profile, m.
    pub fn length(&self, i: usize) -> f64 {
        let h = self.angles[i + 1] - self.angles[i];
        // Gauss's rule of three points.
        let at = |(x, weight): (f64, f64)| {
            let [r, slope, bend] = self.radius(i, 0.5 + 0.5 * x);
            let speed = slope.hypot(r);
            let curvature = (r * r + 2.0 * slope * slope - r * bend) / speed.powi(3);
            0.5 * h * weight * speed * (1.0 - self.roller * curvature)
        };
        let side = 0.6f64.sqrt();
        [(-side, 5.0 / 9.0), (0.0, 8.0 / 9.0), (side, 5.0 / 9.0)].map(at).iter().sum()
    }
}

/// Reads `table`, if the model has one; `Some(None)` where it makes no profile, with the problem noted.
pub fn read_lift(t: &Reader) -> Option<Option<Drawn>> {
    let file = t.file("table", "a follower's lift: a CSV file with angle [deg] and radius [mm]", LARGEST);
    let about = "radius of the follower's roller, whose centre the table gives; 0 for a knife edge";
    let roller = t.quantity("roller", LENGTH, about).not_negative().or(0.0);
    if !t.has("table") {
        if t.has("roller") {
            t.problem("roller", "`roller` belongs to a lift table", "add table = \"lift.csv\", or leave it out");
        }
        return None;
    }
    let Some(file) = file else { return Some(None) };
    let name = file.path.display().to_string();
    let drawn =
        file.text().and_then(|source| rows(&source.text)).and_then(|(angles, radii)| drawn(angles, radii, roller));
    match drawn {
        Ok(drawn) => Some(Some(drawn)),
        Err(problem) => {
            t.problem("table", format!("{name}: {}", problem.message), problem.help.unwrap_or_default());
            Some(None)
        }
    }
}

fn drawn(angles: Vec<f64>, radii: Vec<f64>, roller: f64) -> Result<Drawn, Problem> {
    let count = angles.len();
    let lift = Arc::new(Lift::new(angles, radii, roller));
    for i in 0..lift.intervals() {
        for k in 0..4 {
            let place = lift.place(i, 0.25 * f64::from(k));
            let at = (lift.angles[i]).to_degrees();
            if !(place.point.dot(&place.normal) > 0.0 && (1.0 + place.curvature * roller) > 0.0) {
                let message = format!("the curve of the table turns back near {at:.2} deg");
                let help = match roller > 0.0 {
                    true => "the roller is too large for the curve there: its centre cannot run so",
                    false => "the profile must meet every direction from the axis once",
                };
                return Err(Problem::new(message).help(help));
            }
        }
    }
    let curves = (0..lift.intervals()).map(|i| (0, Curve::lift(&lift, i))).collect();
    let segments = vec![Segment { name: format!("lift table of {count} rows"), blocks: None }];
    Ok(Drawn { profile: Profile::new(curves, 1.0), segments })
}

/// Angles (rad) and radii (m) of a table.
fn rows(text: &str) -> Result<(Vec<f64>, Vec<f64>), Problem> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).trim(csv::Trim::All).from_reader(text.as_bytes());
    let unreadable = |e: csv::Error| Problem::new(format!("no CSV: {e}")).help("give every row one cell per column");
    let header = reader.headers().map_err(unreadable)?.clone();
    let column = |name: &'static str, kind: Kind| {
        let split = |cell: &str| {
            cell.split_once('[').map(|(n, u)| (n.trim().to_string(), u.trim_end_matches(']').trim().to_string()))
        };
        let found = header.iter().map(split).position(|c| c.is_some_and(|(n, _)| n == name));
        let help = format!("add a column {name} [{}]", kind.unit);
        let position = found.ok_or_else(|| Problem::new(format!("no column `{name} [unit]`")).help(help.clone()))?;
        let unit = split(&header[position]).map(|c| c.1).unwrap_or_default();
        let unit = kind.unit_of(&unit).map_err(|e| Problem::new(format!("`{name}`: {}", e.message)).help(help))?;
        Ok::<_, Problem>((position, unit.factor))
    };
    let (angle, radius) = (column("angle", ANGLE)?, column("radius", LENGTH)?);
    let (mut angles, mut radii): (Vec<f64>, Vec<f64>) = (Vec::new(), Vec::new());
    for record in reader.records() {
        let record = record.map_err(unreadable)?;
        let line = record.position().map_or(0, csv::Position::line);
        let number = |(position, factor): (usize, f64)| {
            let cell = record.get(position).unwrap_or_default();
            let value = cell.parse::<f64>().ok().filter(|v| v.is_finite());
            let problem = || Problem::new(format!("line {line}: `{cell}` is no finite number")).help("write a number");
            value.map(|v| v * factor).ok_or_else(problem)
        };
        let (angle, radius) = (number(angle)?, number(radius)?);
        if radius <= 0.0 {
            return Err(
                Problem::new(format!("line {line}: the radius is not above zero")).help("it is from the cam's axis")
            );
        }
        if angles.last().is_some_and(|last| angle <= *last) {
            return Err(Problem::new(format!("line {line}: the angles do not rise")).help("sort the rows by angle"));
        }
        angles.push(angle);
        radii.push(radius);
    }
    close(&mut angles, &mut radii)?;
    Ok((angles, radii))
}

/// Drops a last row that repeats the first one turn on, and checks that the rows go round.
fn close(angles: &mut Vec<f64>, radii: &mut Vec<f64>) -> Result<(), Problem> {
    let few =
        || Problem::new(format!("{} rows are too few for a cam", angles.len())).help("give at least twelve all around");
    let (Some(first), Some(last)) = (angles.first().copied(), angles.last().copied()) else { return Err(few()) };
    if angles.len() < FEWEST {
        return Err(few());
    }
    if (last - first - TAU).abs() < 1e-9 {
        if (radii[0] - radii[radii.len() - 1]).abs() > 1e-9 {
            let problem = Problem::new("the first and the last row are one turn apart and differ in radius");
            return Err(problem.help("a cam is closed: give them the same radius"));
        }
        angles.pop();
        radii.pop();
    } else if last - first > TAU {
        return Err(Problem::new("the angles go round more than once").help("give one turn"));
    }
    let ahead = angles.iter().skip(1).copied().chain([angles[0] + TAU]);
    match angles.iter().zip(ahead).find(|(a, b)| b - **a > WIDEST) {
        None => Ok(()),
        Some((angle, next)) => Err(Problem::new(format!(
            "nothing is known from {:.2} to {:.2} deg",
            angle.to_degrees(),
            next.to_degrees()
        ))
        .help("give rows all around, 45 deg apart at most")),
    }
}

/// Second derivatives at the knots of the periodic cubic spline: hᵢ₋₁Mᵢ₋₁ + 2(hᵢ₋₁ + hᵢ)Mᵢ + hᵢMᵢ₊₁ = 6(dᵢ − dᵢ₋₁), closed by the
/// Sherman–Morrison formula.
fn periodic_spline(x: &[f64], y: &[f64]) -> Vec<f64> {
    let n = x.len() - 1;
    let h: Vec<f64> = x.windows(2).map(|w| w[1] - w[0]).collect();
    let slope: Vec<f64> = (0..n).map(|i| (y[i + 1] - y[i]) / h[i]).collect();
    let before = |i: usize| (i + n - 1) % n;
    let right: Vec<f64> = (0..n).map(|i| 6.0 * (slope[i] - slope[before(i)])).collect();
    let mut diagonal: Vec<f64> = (0..n).map(|i| 2.0 * (h[before(i)] + h[i])).collect();
    let corner = h[n - 1];
    // A = T + u·vᵀ with u = (γ, 0 … 0, c), v = (1, 0 … 0, c/γ).
    let gamma = -diagonal[0];
    diagonal[0] -= gamma;
    diagonal[n - 1] -= corner * corner / gamma;
    let mut u = vec![0.0; n];
    (u[0], u[n - 1]) = (gamma, corner);
    let (m, z) = (tridiagonal(&h, &diagonal, &right), tridiagonal(&h, &diagonal, &u));
    let along = |w: &[f64]| w[0] + corner / gamma * w[n - 1];
    let factor = along(&m) / (1.0 + along(&z));
    let mut bends: Vec<f64> = m.iter().zip(&z).map(|(m, z)| m - factor * z).collect();
    bends.push(bends[0]);
    bends
}

/// Solves the symmetric system with `h[i]` beside the diagonal between i and i + 1.
fn tridiagonal(h: &[f64], diagonal: &[f64], right: &[f64]) -> Vec<f64> {
    let n = diagonal.len();
    let (mut d, mut r) = (diagonal.to_vec(), right.to_vec());
    for i in 1..n {
        let part = h[i - 1] / d[i - 1];
        d[i] -= part * h[i - 1];
        r[i] -= part * r[i - 1];
    }
    r[n - 1] /= d[n - 1];
    for i in (0..n - 1).rev() {
        r[i] = (r[i] - h[i] * r[i + 1]) / d[i];
    }
    r
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_of_an_eccentric_circle_is_that_circle_to_the_fourth_power_of_its_step() {
        // Circle of 20 mm about (3, 0) mm: r(θ) = 3cosθ + √(400 − 9sin²θ).
        let error = |rows: usize| {
            let angles: Vec<f64> = (0..rows).map(|i| TAU * i as f64 / rows as f64).collect();
            let radius = |a: &f64| 3e-3 * a.cos() + (4e-4 - 9e-6 * a.sin().powi(2)).sqrt();
            let radii = angles.iter().map(radius).collect();
            let lift = Lift::new(angles, radii, 0.0);
            let off = |i: usize| {
                let place = lift.place(i, 0.5);
                let from_centre = place.point - super::super::Vector::new(3e-3, 0.0);
                (from_centre.norm() - 0.02).abs().max(1e-3 * (place.normal - from_centre / 0.02).norm())
            };
            (0..rows).map(off).fold(0.0, f64::max)
        };
        let (coarse, fine) = (error(36), error(72));
        assert!(fine < 1e-8 && coarse / fine > 7.5, "{coarse:e} {fine:e}");
    }

    #[test]
    fn the_profile_lies_a_rollers_radius_inside() {
        let angles: Vec<f64> = (0..36).map(|i| TAU * f64::from(i) / 36.0).collect();
        let lift = Lift::new(angles, vec![0.03; 36], 0.01);
        let place = lift.place(5, 0.3);
        assert!((place.point.norm() - 0.02).abs() < 1e-15 && (place.curvature - 50.0).abs() < 1e-9);
        let around: f64 = (0..36).map(|i| lift.length(i)).sum();
        assert!((around - TAU * 0.02).abs() < 1e-12);
    }
}
