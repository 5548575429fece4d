//! The tables of a contour model.

use std::f64::consts::PI;

use super::drive::{self, Drive, Feedback};
use super::path::{Direction, Path, dot};
use crate::input::Reader;
use crate::process::Allowed;
use crate::process::estimates::{self, CUTTING_FORCE};
use crate::tolerance::Limits;
use crate::units::{ANGLE, FEED_RATE, FORCE, FREQUENCY, GAIN, LENGTH, MICRO};

/// Most corners of a polygon: more than any has.
const MOST_CORNERS: usize = 1000;

/// Everything a contour model says but its effects. SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// Programmed path.
    pub path: Path,
    /// v, m/s.
    pub feed: f64,
    /// Ways round in which the model predicts, the first being that of rows that do not say.
    pub directions: Vec<Direction>,
    /// Kv of both servos, 1/s.
    pub gain: f64,
    /// Settings of each axis of its own.
    pub drives: [Drive; 2],
    /// Where positions are measured.
    pub feedback: Feedback,
    /// Frequency at which drives stick and slip, Hz.
    pub frequency: Option<f64>,
    /// Force of the cut on the tool: across the path, outwards positive, and against the travel, N.
    pub force: [f64; 2],
    /// Limits of the deviation, as wide to either side.
    pub allowed: Allowed,
    /// Evenly spaced points of the contour at which it is predicted.
    pub points: usize,
}

/// Shapes, before their dimensions are read.
#[derive(Clone, Copy)]
enum Shape {
    Circle,
    Rectangle,
    Polygon,
}

const SHAPES: &[(&str, Shape)] =
    &[("circle", Shape::Circle), ("rectangle", Shape::Rectangle), ("polygon", Shape::Polygon)];

impl Setup {
    /// Reads every table of a contour model but `[effects]`.
    pub fn read(model: &Reader) -> Self {
        let (path, feed, directions) = model.table("path", "what is programmed", |t| {
            let path = read_path(t);
            let feed = t.quantity("feed", FEED_RATE, "speed along the path").positive().required();
            (
                path,
                feed,
                t.choice("directions", "ways round, counter-clockwise or clockwise", Direction::WORDS).several(),
            )
        });
        let (gain, drives, feedback, frequency) = model.table("drives", "the servo drives of x and y", |t| {
            let gain = t.quantity("gain", GAIN, "Kv: speed over following error, of both axes").positive().required();
            let lead = t.quantity("lead", LENGTH, "travel in a turn of the screw or a period of the scale").positive();
            let about = "where positions are measured: on the motor, or by a scale on the slide, which sees the screw";
            let feedback = t.choice("feedback", about, Feedback::WORDS).or_first(Feedback::Motor);
            let about = "frequency at which the drives stick and slip; only for stick-slip";
            let frequency =
                t.quantity("frequency", FREQUENCY, about).estimated(estimates::FREQUENCY).positive().optional();
            (gain, drive::read(t, lead.optional()), feedback, frequency)
        });
        let force = model.optional_table("cut", "the cut, if there is one", |t| {
            let about = "force on the tool across the path, positive outwards";
            let normal = t.quantity("normal_force", FORCE, about).estimated(CUTTING_FORCE).or(0.0);
            let about = "force on the tool that holds it back along the path";
            [normal, t.quantity("tangential_force", FORCE, about).estimated(CUTTING_FORCE).or(0.0)]
        });
        let tolerance = model.optional_table("tolerance", "what the contour is held against", |t| {
            t.quantity("deviation", MICRO, "largest deviation allowed on either side").positive().required()
        });
        let points = model.optional_table("measurement", "where the contour is predicted", |t| {
            t.count("points", "evenly spaced points along the contour").between(8, 100_000).or(360)
        });
        let within = tolerance
            .map(|largest| (Limits { lower: -largest, upper: largest }, format!("±{}", MICRO.format(largest))));
        let allowed = Allowed { within, form: None };
        let setup = Self {
            path,
            feed,
            directions,
            gain,
            drives,
            feedback,
            frequency,
            force: force.unwrap_or_default(),
            allowed,
            points: points.unwrap_or(360),
        };
        if let Some(reason) = setup.too_fast(feed) {
            model.problem("path", reason, "slow down, take longer sides or a higher gain");
        }
        setup
    }

    /// Why nothing steady is left of a straight side at this feed (m/s), if so.
    pub fn too_fast(&self, feed: f64) -> Option<String> {
        let (before, after) = self.corner(feed);
        let shortest = self.path.sides().iter().map(|side| side.length).fold(f64::INFINITY, f64::min);
        (shortest < 2.0 * (before + after)).then(|| {
            format!(
                "a side of {:.3} is too short: at {} its corners are felt over {:.3}",
                LENGTH.shown(shortest),
                FEED_RATE.format(feed),
                LENGTH.shown(before + after)
            )
        })
    }

    /// How far before and behind a corner its rounding by the servos' lag reaches at a feed
    /// (m/s), m: what is left of it then is e⁻¹⁰ of the lag v/Kv.
    pub fn corner(&self, feed: f64) -> (f64, f64) {
        let lag = feed / self.gain;
        (lag, 10.0 * lag)
    }
}

fn read_path(t: &Reader) -> Path {
    let shape =
        t.choice("shape", "circle, rectangle about its centre, or convex polygon", SHAPES).required(Shape::Circle);
    let described = t.is_described();
    let length = |key, about| t.quantity(key, LENGTH, about).positive();
    match shape {
        Shape::Circle if !described => Path::Circle { radius: length("radius", "of a circle").required() },
        Shape::Circle => {
            // What the schema tells of: the keys of every shape.
            let _ = (length("width", "of a rectangle").optional(), length("height", "of a rectangle").optional());
            let _ = t.quantity("angle", ANGLE, "of a rectangle's width from the x axis").optional();
            let _ = corners(t);
            Path::Circle { radius: length("radius", "of a circle").optional().unwrap_or(f64::NAN) }
        }
        Shape::Rectangle => {
            let (width, height) =
                (length("width", "of a rectangle").required(), length("height", "of a rectangle").required());
            Path::Rectangle {
                width,
                height,
                angle: t.quantity("angle", ANGLE, "of a rectangle's width from the x axis").or(0.0),
            }
        }
        Shape::Polygon => read_polygon(t),
    }
}

fn corners(t: &Reader) -> Vec<[f64; 2]> {
    t.list("corners", "of a polygon, counter-clockwise about the centre at 0, 0", |t, _| {
        ["x", "y"].map(|axis| t.quantity(axis, LENGTH, "of the corner").required())
    })
}

/// A convex polygon about the centre; what is none is a problem.
fn read_polygon(t: &Reader) -> Path {
    let path = Path::Polygon { corners: corners(t).into() };
    let sides = path.sides();
    let help = "give three corners or more, { x = \"40 mm\", y = \"-20 mm\" }, counter-clockwise about the centre";
    if sides.len() < 3 {
        t.problem("corners", format!("{} corners make no polygon", sides.len()), help);
        return path;
    }
    if sides.len() > MOST_CORNERS {
        t.problem("corners", format!("{} corners are more than {MOST_CORNERS}", sides.len()), "take fewer");
        return path;
    }
    let turn = |i: usize| sides[(i + sides.len() - 1) % sides.len()].turn(&sides[i]);
    // A corner that is not known is no problem of its own.
    let is_wrong = |i: &usize| turn(*i) <= 0.0 || turn(*i) >= PI * (1.0 - 1e-9);
    if let Some(i) = (0..sides.len()).find(is_wrong) {
        let message = format!("the way does not turn to the left at corner {}", i + 1);
        t.problem("corners", message, format!("{help}; the polygon must be convex"));
    } else if (0..sides.len()).map(turn).sum::<f64>() > 3.0 * PI {
        t.problem("corners", "the sides cross each other", help);
    } else if let Some(i) = sides.iter().position(|side| dot(side.from, side.outward) <= 0.0) {
        let message = format!("the centre, 0, 0, is not inside of side {}", i + 1);
        t.problem("corners", message, "angles are counted about it: move the corners until it lies inside");
    }
    path
}
