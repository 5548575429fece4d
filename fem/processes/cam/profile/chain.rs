//! A profile drawn as a closed chain of lines and arcs.

use std::cell::RefCell;
use std::f64::consts::TAU;

use super::closed::Profile;
use super::curve::Curve;
use super::plane::{Vector, left, turn};
use crate::input::Reader;
use crate::units::{ANGLE, LENGTH};

/// Most blocks of a programme, a minute of arc each. The shorter they are, the more of them a wheel cuts in at once, so
/// that what a run holds grows with their square.
pub const MOST_BLOCKS: usize = 20_000;
/// A chain that ends beside its start by more than this, m, is open. Less cannot be seen in a deviation.
const OPEN: f64 = 1e-7;
/// Segments that meet at more than this angle, rad, are not tangent. At less, a wheel of 1 m leaves or takes
/// R·δ²/8 = 4 nm.
const KINK: f64 = 1.75e-4;
/// A tangent that passes nearer to the axis than this part of the profile's size points at it.
const RADIAL: f64 = 1e-3;

/// A line or an arc of the model file.
#[derive(Clone, Debug, PartialEq)]
pub struct Segment {
    /// Its name, for people.
    pub name: String,
    /// Number of its blocks, where it says so itself.
    pub blocks: Option<usize>,
}

/// A profile with the segments it was drawn from.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawn {
    /// The curve.
    pub profile: Profile,
    /// The segments in the order of the file.
    pub segments: Vec<Segment>,
}

/// The chain as it is drawn so far.
struct Pen {
    at: Vector,
    /// Direction in which the last segment ends.
    along: Option<Vector>,
    first: Option<Vector>,
    curves: Vec<(usize, Curve)>,
}

/// Reads `start` and `segments`; `None` where they make no profile, with the problems noted.
pub fn read_chain(t: &Reader) -> Option<Drawn> {
    let start = t.pair("start", LENGTH, "where the chain begins: x and y from the cam's axis");
    let at = Vector::from(start.unwrap_or([f64::NAN; 2]));
    let pen = RefCell::new(Pen { at, along: None, first: None, curves: Vec::new() });
    let segments = t.list("segments", "lines and arcs from `start` on, each tangent to the one before", |t, i| {
        let line = t.optional_table("line", "a straight line from where the chain stands", |t| {
            t.pair("to", LENGTH, "its end: x and y")
        });
        let arc = t.optional_table("arc", "an arc from where the chain stands", |t| {
            let centre = t.pair("centre", LENGTH, "its centre: x and y");
            (
                centre,
                t.quantity("sweep", ANGLE, "how far it turns about its centre, counter-clockwise positive").required(),
            )
        });
        let blocks = t.count("blocks", "into how many blocks, whatever [program] says").between(1, MOST_BLOCKS);
        let blocks = blocks.optional();
        let name = match (line, arc) {
            (Some(to), None) => pen.borrow_mut().line(t, i, to),
            (None, Some((centre, sweep))) => pen.borrow_mut().arc(t, i, centre, sweep),
            _ => {
                let help = "write { line = { to = [\"14 mm\", \"0 mm\"] } }";
                t.problem("", "a segment is either a line or an arc", help);
                None
            }
        };
        Segment { name: name.unwrap_or_default(), blocks }
    });
    let pen = pen.into_inner();
    let is_whole =
        !t.is_described() && segments.iter().all(|s| !s.name.is_empty()) && pen.at.iter().all(|v| v.is_finite());
    if !is_whole {
        return None;
    }
    pen.close(t, at).map(|profile| Drawn { profile, segments })
}

impl Pen {
    fn line(&mut self, t: &Reader, segment: usize, to: Option<[f64; 2]>) -> Option<String> {
        let to = Vector::from(to?);
        let length = (to - self.at).norm();
        if length < OPEN {
            t.problem("line", "the line has no length", "it begins where it ends: leave it out");
            return None;
        }
        if !length.is_finite() {
            return None;
        }
        self.draw(t, segment, vec![Curve::line(self.at, to)], "line");
        self.at = to;
        Some(format!("line of {} mm", figure(length)))
    }

    fn arc(&mut self, t: &Reader, segment: usize, centre: Option<[f64; 2]>, sweep: f64) -> Option<String> {
        let centre = Vector::from(centre?);
        let from = self.at - centre;
        let radius = from.norm();
        if !(radius.is_finite() && sweep.is_finite()) {
            return None;
        }
        if radius < OPEN || sweep == 0.0 || sweep.abs() > TAU + 1e-9 {
            let message = format!("an arc of radius {} by {} is none", LENGTH.format(radius), ANGLE.format(sweep));
            let help = "its centre lies away from where the chain stands; it sweeps up to 360 deg either way";
            t.problem("arc", message, help);
            return None;
        }
        let curves = Curve::arcs(centre, radius, from.y.atan2(from.x), sweep);
        let end = curves.last().map_or(self.at, |c| c.point(c.length));
        self.draw(t, segment, curves, "arc");
        self.at = end;
        Some(format!("R{} about ({}, {})", figure(radius), figure(centre.x), figure(centre.y)))
    }

    /// Takes curves whose first must go on in the direction of the last.
    fn draw(&mut self, t: &Reader, segment: usize, curves: Vec<Curve>, key: &str) {
        let begins = curves.first().map(|c| tangent(c, 0.0));
        if let (Some(before), Some(after)) = (self.along, begins) {
            let kink = turn(&before, &after);
            if kink.abs() > KINK {
                let message = format!("the segment turns by {:.3} where it begins", ANGLE.shown(kink));
                let help = "segments must be tangent: round the corner by an arc, or give coordinates more digits";
                t.problem(key, message, help);
            }
        }
        self.first = self.first.or(begins);
        self.along = curves.last().map(|c| tangent(c, c.length));
        self.curves.extend(curves.into_iter().map(|c| (segment, c)));
    }

    fn close(self, t: &Reader, start: Vector) -> Option<Profile> {
        let refuse = |message: String, help: &str| {
            t.problem("segments", message, help);
            None
        };
        if self.curves.is_empty() {
            return refuse(
                "the profile has no segments".into(),
                "add segments = [{ arc = { centre = …, sweep = … } }, …], or a table",
            );
        }
        let gap = (self.at - start).norm();
        if gap > OPEN {
            let [x, y, gap] = [self.at.x, self.at.y, gap].map(|length| LENGTH.shown(length));
            let message = format!("the chain is open: it ends at ({x:.6}, {y:.6}), {gap:.4} from its start");
            return refuse(message, "end it where it starts, to a ten-thousandth of a millimetre");
        }
        if let (Some(first), Some(last)) = (self.first, self.along) {
            let kink = turn(&last, &first);
            if kink.abs() > KINK {
                let message = format!("the chain turns by {:.3} where it closes", ANGLE.shown(kink));
                return refuse(message, "the last segment must be tangent to the first");
            }
        }
        let sense = self.curves.iter().map(|c| c.1.swept()).sum::<f64>().signum();
        let size = self.curves.iter().map(|c| c.1.point(0.0).norm()).fold(0.0, f64::max);
        for (segment, curve) in &self.curves {
            if curve.least_arm(sense) < RADIAL * size {
                let message = format!("segment {} runs towards the cam's axis or turns back about it", segment + 1);
                let help = "the profile must lie around the axis (0, 0), and every direction from there meet it once: \
                            a polar grinder, and the column `angle`, cannot tell its points apart otherwise";
                return refuse(message, help);
            }
        }
        let around: f64 = self.curves.iter().map(|c| turn(&c.1.point(0.0), &c.1.point(c.1.length))).sum();
        if (around.abs() - TAU).abs() > 1e-3 {
            let message = format!("the chain goes {:.2} times round the axis and crosses itself", around / TAU);
            return refuse(message, "it must go round once");
        }
        Some(Profile::new(self.curves, sense))
    }
}

fn tangent(curve: &Curve, x: f64) -> Vector {
    left(&curve.place(x, 1.0).normal)
}

/// A length (m) in mm with a few digits, for names.
fn figure(length: f64) -> f64 {
    // Not −0.
    (LENGTH.from_si(length) * 1e3).round() / 1e3 + 0.0
}
