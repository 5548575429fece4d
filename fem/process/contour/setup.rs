//! The tables of a contour model.

use super::drive::{self, Drive, Feedback};
use super::path::{Direction, Path};
use crate::input::Reader;
use crate::units::{ANGLE, FEED_RATE, FORCE, FREQUENCY, GAIN, LENGTH, MICRO};

/// Everything a contour model says but its effects. SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// What is programmed.
    pub path: Path,
    /// v, m/s.
    pub feed: f64,
    /// Ways round in which the model predicts, the first being that of rows that do not say.
    pub directions: Vec<Direction>,
    /// Kv of both servos, 1/s.
    pub gain: f64,
    /// What each axis has of its own.
    pub drives: [Drive; 2],
    /// Where positions are measured.
    pub feedback: Feedback,
    /// Frequency at which drives stick and slip, Hz.
    pub frequency: Option<f64>,
    /// Force of the cut on the tool: across the path, outwards positive, and against the travel, N.
    pub force: [f64; 2],
    /// Largest deviation that is allowed, m.
    pub tolerance: Option<f64>,
    /// Evenly spaced points of the contour at which it is predicted.
    pub points: usize,
}

/// Shapes, before their dimensions are read.
#[derive(Clone, Copy)]
enum Shape {
    Circle,
    Rectangle,
}

const SHAPES: &[(&str, Shape)] = &[("circle", Shape::Circle), ("rectangle", Shape::Rectangle)];

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
            let frequency = t.quantity("frequency", FREQUENCY, about).positive().optional();
            (gain, drive::read(t, lead.optional()), feedback, frequency)
        });
        let force = model.optional_table("cut", "the cut, if there is one", |t| {
            let about = "force on the tool across the path, positive outwards";
            let normal = t.quantity("normal_force", FORCE, about).or(0.0);
            let about = "force on the tool that holds it back along the path";
            [normal, t.quantity("tangential_force", FORCE, about).or(0.0)]
        });
        let tolerance = model.optional_table("tolerance", "what the contour is held against", |t| {
            t.quantity("deviation", MICRO, "largest deviation allowed on either side").positive().required()
        });
        let points = model.optional_table("measurement", "where the contour is predicted", |t| {
            t.count("points", "evenly spaced points along the contour").between(8, 100_000).or(360)
        });
        let setup = Self {
            path,
            feed,
            directions,
            gain,
            drives,
            feedback,
            frequency,
            force: force.unwrap_or_default(),
            tolerance,
            points: points.unwrap_or(360),
        };
        if let Some(reason) = setup.too_fast(feed) {
            model.problem("path", reason, "slow down, take longer sides or a higher gain");
        }
        setup
    }

    /// Why nothing steady is left of the sides of a rectangle at this feed (m/s), if so.
    pub fn too_fast(&self, feed: f64) -> Option<String> {
        let (before, after) = self.corner(feed);
        let Path::Rectangle { width, height, .. } = self.path else { return None };
        let shorter = width.min(height);
        (shorter < 2.0 * (before + after)).then(|| {
            format!(
                "a side of {:.3} is too short: at {} its corners are felt over {:.3}",
                LENGTH.shown(shorter),
                FEED_RATE.told(feed),
                LENGTH.shown(before + after)
            )
        })
    }

    /// How far before and behind a corner of a rectangle its rounding by the servos' lag reaches at a feed
    /// (m/s), m: what is left of it then is e⁻¹⁰ of the lag v/Kv.
    pub fn corner(&self, feed: f64) -> (f64, f64) {
        let lag = feed / self.gain;
        (lag, 10.0 * lag)
    }
}

fn read_path(t: &Reader) -> Path {
    let shape = t.choice("shape", "circle, or rectangle about its centre", SHAPES).required(Shape::Circle);
    let described = t.is_described();
    let length = |key, about| t.quantity(key, LENGTH, about).positive();
    match shape {
        Shape::Circle if !described => Path::Circle { radius: length("radius", "of a circle").required() },
        Shape::Circle => {
            // What the schema tells of: the keys of every shape.
            let _ = (length("width", "of a rectangle").optional(), length("height", "of a rectangle").optional());
            let _ = t.quantity("angle", ANGLE, "of a rectangle's width from the x axis").optional();
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
    }
}
