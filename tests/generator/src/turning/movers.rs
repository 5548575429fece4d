//! What moves nose and work apart but by force, each by its formula in the physics page's table: across, up,
//! and at the headstock's support.

use std::cell::RefCell;

use super::heat::tool_temperature;
use super::job::{Job, Row};
use super::shaft::Shaft;
use crate::law::{Cause, value};

/// At one row, um.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Mover {
    /// Away from the work, of the radius.
    pub across: f64,
    /// The nose above the axis.
    pub up: f64,
    /// The headstock's support away from the tool.
    pub headstock: f64,
}

/// At every row.
pub fn movers(job: &Job, causes: &[Cause]) -> Vec<Mover> {
    let mut names: Vec<&str> = causes.iter().map(|cause| cause.effect).collect();
    names.dedup();
    let mut movers = vec![Mover::default(); job.rows.len()];
    let edge =
        Edge { job, change: value(causes, "insert-change", "after").zip(value(causes, "insert-change", "share")) };
    for effect in names {
        let size = |parameter: &str| value(causes, effect, parameter).unwrap_or(0.0);
        let law = law(job, &edge, effect, &size);
        for (mover, row) in movers.iter_mut().zip(&job.rows) {
            let more = law(row);
            mover.across += more.across;
            mover.up += more.up;
            mover.headstock += more.headstock;
        }
    }
    movers
}

/// The edge that cuts, and that in its place beyond a part.
struct Edge<'a> {
    job: &'a Job,
    /// The part after which it is another, and the share of its wear that goes.
    change: Option<(f64, f64)>,
}

impl Edge<'_> {
    /// What a wear that follows the path (m) has taken off it at a row.
    fn worn(&self, row: &Row, wear: impl Fn(f64) -> f64) -> f64 {
        let path = self.job.path(row.part, row.x);
        match self.change {
            Some((after, share)) if row.part as f64 > after => {
                // The first part of the new edge begins where the other ended.
                let first = if self.job.forward { 0.0 } else { self.job.shaft.length() };
                let begun = self.job.path(after as usize + 1, first);
                (1.0 - share) * wear(path) + share * wear(path - begun)
            }
            _ => wear(path),
        }
    }
}

/// A law of the rows.
type OfRow<'a> = Box<dyn Fn(&Row) -> Mover + 'a>;

/// A law that moves the nose across.
fn across<'a>(law: impl Fn(&Row) -> f64 + 'a) -> OfRow<'a> {
    Box::new(move |row| Mover { across: law(row), ..Mover::default() })
}

/// The law of an effect; of what yields, of feedback and of a centre out of line nothing moves without force.
fn law<'a>(job: &'a Job, edge: &'a Edge, effect: &str, size: &'a dyn Fn(&str) -> f64) -> OfRow<'a> {
    let length = job.shaft.length();
    match effect {
        // [002 (31)(32)]: run-in that saturates, then a rate; the blunt tool leaves more.
        "tool-wear" => across(move |row| {
            edge.worn(row, |path| {
                // An edge that does not run in has no path on which it does.
                let run_in = size("run_in");
                let ran_in = if run_in == 0.0 { 0.0 } else { run_in * (1.0 - (-path / size("run_in_path")).exp()) };
                ran_in + size("rate") * path * 1e-3
            })
        }),
        // The third period: nothing up to its onset, then a power of the path beyond, in km.
        "tool-breakdown" => across(move |row| {
            edge.worn(row, |path| {
                let beyond = 1e-3 * (path - size("onset"));
                if beyond > 0.0 { size("wear") * (size("exponent") * beyond.ln()).exp() } else { 0.0 }
            })
        }),
        "tool-thermal-growth" => across(move |row| -growth(job, size("elongation"), size("time_constant"), row)),
        "workpiece-heating" => heating(job, size("power"), size("convection")),
        // A headstock that warms up moves its support and does not tilt.
        "spindle-thermal-drift" => Box::new(move |row| {
            // The spindle has turned through the passes before as well.
            let time = job.start(row.part) + job.before_last() + job.into_cut(row.x);
            Mover { headstock: size("drift") * (1.0 - (-time / size("time_constant")).exp()), ..Mover::default() }
        }),
        "guideway-taper" => across(move |row| size("slope") * row.x * 1e-3),
        // mm/m are um/mm.
        "guideway-height" => Box::new(move |row| Mover { up: size("slope") * row.x, ..Mover::default() }),
        "guideway-wear" => across(move |row| size("depth") * bell(row.x, size)),
        "setting-error" => across(move |_| size("offset")),
        // The nose is moved by half of what the operator enters for the diameter.
        "offset-correction" => {
            across(move |row| if row.part as f64 > size("after") { 0.5 * size("diameter") } else { 0.0 })
        }
        // The screw has crossed its play after a climb, and the nose stands deeper by it.
        "cross-slide-play" => across(move |row| if job.has_climbed(row.x) { -size("gap") } else { 0.0 }),
        "wear-land" | "front-guideway-wear" | "bed-twist" | "bed-sag" => surveyed(job, edge, effect, length, size),
        _ => across(|_| 0.0),
    }
}

/// A hollow of one at its `centre`, its slopes steepest a `width` away.
fn bell(x: f64, size: &dyn Fn(&str) -> f64) -> f64 {
    (-0.5 * ((x - size("centre")) / size("width")).powi(2)).exp()
}

/// What needs to know the edge or the bed: [002 (31)], and levers by the geometry of a tilting carriage.
fn surveyed<'a>(job: &'a Job, edge: &'a Edge, effect: &str, length: f64, size: &'a dyn Fn(&str) -> f64) -> OfRow<'a> {
    let Some(survey) = &job.survey else { return across(|_| 0.0) };
    let lever = survey.height / survey.spacing;
    match effect {
        "wear-land" => across(move |row| {
            let width = edge.worn(row, |path| survey.width(path));
            size("share") * 1e3 * width * survey.clearance.to_radians().tan()
        }),
        // The rear way wears a fifth; the carriage tilts by the difference.
        "front-guideway-wear" => across(move |row| 0.8 * size("wear") * bell(row.x, size) * lever),
        "bed-twist" => across(move |row| survey.height * 1e-3 * size("twist") * row.x * 1e-3),
        // A bed between two feet: the ways' difference tilts the carriage, their mean lowers the nose.
        _ => Box::new(move |row| {
            let (front, rear, part) = (size("front"), size("rear"), row.x / length);
            let bow = 4.0 * part * (1.0 - part);
            Mover { across: (front - rear) * lever * bow, up: -0.5 * (front + rear) * bow, headstock: 0.0 }
        }),
    }
}

/// xi of tau dxi/dt = elongation [cutting] - xi from xi(0) = 0, through every cut, idle time and pause
/// before.
fn growth(job: &Job, elongation: f64, tau: f64, row: &Row) -> f64 {
    let toward = |goal: f64, from: f64, minutes: f64| goal + (from - goal) * (-minutes / tau).exp();
    let mut xi = 0.0;
    for earlier in 1..row.part {
        xi = toward(elongation, xi, job.cutting_time());
        xi = toward(0.0, xi, job.start(earlier + 1) - job.start(earlier) - job.cutting_time());
    }
    toward(elongation, xi, job.into_cut(row.x))
}

/// -alpha D theta/2 at the tool, the same for every part because each starts cold.
fn heating<'a>(job: &'a Job, power: f64, convection: f64) -> OfRow<'a> {
    let mut places: Vec<f64> = job.rows.iter().map(|r| r.x).collect();
    places.sort_by(f64::total_cmp);
    places.dedup();
    let course = Course { shaft: job.shaft.clone(), convection, speed: job.tool_speed(), forward: job.forward, places };
    let rises = course.rises();
    across(move |row| {
        let rise = course.places.iter().position(|&p| p == row.x).map_or(0.0, |i| rises[i]);
        -0.5e-3 * job.shaft.material.expansion * job.shaft.diameter(row.x) * power * rise
    })
}

/// All that the rise at the tool per watt depends on.
#[derive(Debug, Clone, PartialEq)]
struct Course {
    shaft: Shaft,
    convection: f64,
    speed: f64,
    forward: bool,
    places: Vec<f64>,
}

/// How many courses are kept.
const KEPT: usize = 6;

thread_local! {
    /// Courses of late with their rises: a tangent asks for the same one again and again.
    static RISES: RefCell<Vec<(Course, Vec<f64>)>> = const { RefCell::new(Vec::new()) };
}

impl Course {
    /// Rise at the tool per watt when it passes each of the places, K/W.
    fn rises(&self) -> Vec<f64> {
        let known = RISES.with_borrow(|kept| kept.iter().find(|(course, _)| course == self).map(|(_, r)| r.clone()));
        known.unwrap_or_else(|| {
            let rises =
                tool_temperature(&self.shaft, self.convection, self.speed, self.forward, self.cell(), &self.places);
            RISES.with_borrow_mut(|kept| {
                kept.truncate(KEPT - 1);
                kept.insert(0, (self.clone(), rises.clone()));
            });
            rises
        })
    }

    /// Finer cell of the heat grid, mm: a ninth of the kink ahead of the tool, k/(rho c v); the error is then
    /// below 4e-4.
    fn cell(&self) -> f64 {
        let m = &self.shaft.material;
        let kink = 1e3 * m.conductivity / (m.density * m.specific_heat * self.speed * 1e-3 / 60.0);
        (kink / 9.0).clamp(0.2, 1.5)
    }
}
