//! The tables of a rotary model.

use std::f64::consts::FRAC_PI_2;

use super::allowed::ALLOWED;
use super::drive::Drive;
use super::scale::{Loop, Scale};
use crate::input::Reader;
use crate::positioning::{Measures, Tolerance};
use crate::process::{Allowed, Controller};
use crate::units::{ANGLE, SMALL_ANGLE, TIME, TORQUE};

/// Most rows of a test: more than any test has.
const MOST_ROWS: usize = 500_000;
/// The test where the model does not say: a target each 30 degrees of a turn, both ends included.
const USUAL: Test = Test {
    positions: 13,
    runs: 5,
    spacing: Spacing::Even,
    reading: 20.0,
    pause: 0.0,
    torque: 0.0,
    reading_at_zero: None,
};

/// How the targets of the model's own test stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spacing {
    /// Evenly from end to end.
    Even,
    /// Evenly, and each moved on by another part of what comes back soonest, so that errors of the worm's turn show
    /// (ISO 230-2).
    Staggered,
}

/// How the axis stands in the room.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Orientation {
    /// Along gravity: a table on which the work lies.
    Vertical,
    /// Across gravity: a tilting axis, a head, a joint of a robot.
    Horizontal,
}

/// The positioning test that the model predicts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Test {
    /// Number of targets.
    pub positions: usize,
    /// Number of runs, each forwards and back.
    pub runs: usize,
    /// How the targets stand.
    pub spacing: Spacing,
    /// Time from one reading to the next, s.
    pub reading: f64,
    /// Time between runs, s.
    pub pause: f64,
    /// External torque about the axis, towards +, N·m.
    pub torque: f64,
    /// Reading of the instrument where the axis stands right, rad, if the model says it.
    pub reading_at_zero: Option<f64>,
}

/// Everything a rotary model says but its effects. SI units.
#[derive(Clone, Debug, PartialEq)]
pub struct Setup {
    /// Angle at which the range begins, rad.
    pub from: f64,
    /// Size of the range, rad.
    pub range: f64,
    /// How the axis stands in the room.
    pub orientation: Orientation,
    /// What turns the table.
    pub drive: Drive,
    /// The scale that reads the angle, if one is told.
    pub scale: Option<Scale>,
    /// The test.
    pub test: Test,
    /// Deviations that the axis is allowed.
    pub tolerance: Tolerance,
    /// What the drawing allows.
    pub allowed: Allowed,
    /// The controller's compensation.
    pub controller: Controller,
}

impl Spacing {
    /// The words of the model file, the default first.
    pub const WORDS: &[(&'static str, Self)] = &[("even", Self::Even), ("staggered", Self::Staggered)];
}

impl Orientation {
    /// The words of the model file, the default first.
    pub const WORDS: &[(&'static str, Self)] = &[("vertical", Self::Vertical), ("horizontal", Self::Horizontal)];
}

impl Setup {
    /// Reads every table of a rotary model but `[effects]`.
    pub fn read(model: &Reader) -> Self {
        let (from, range, orientation) = model.table("axis", "the axis", |t| {
            let range = t.quantity("range", ANGLE, "how far the axis turns; 360 deg and beyond").positive().required();
            let from = t.quantity("from", ANGLE, "angle at which the range begins").or(0.0);
            let about = "how the axis stands in the room; only what lies across gravity can be out of balance";
            (from, range, t.choice("orientation", about, Orientation::WORDS).or_first(Orientation::Vertical))
        });
        let drive = model.table("drive", "what turns the table", Drive::read);
        let scale = model.optional_table("scale", "the scale that reads the angle", Scale::read);
        let test = model.optional_table("test", "the positioning test", read_test).unwrap_or(USUAL);
        let (tolerance, allowed) = model
            .optional_table("tolerance", "what the axis is allowed", |t| {
                (read_tolerance(t), Allowed::read(t, &ALLOWED))
            })
            .unwrap_or_else(|| (Tolerance::of_rotary_axes(), Allowed::default()));
        let about = "the controller's compensation, for `fem compensate`";
        let controller = model.optional_table("controller", about, |t| Controller::read(t, range, Measures::ROTARY));
        let controller = controller.unwrap_or_default();
        Self { from, range, orientation, drive, scale, test, tolerance, allowed, controller }
    }

    /// Whether the control positions by the scale on the table, so that nothing of the drive is left.
    pub fn is_closed(&self) -> bool {
        self.scale.is_some_and(|scale| scale.position_loop == Loop::Closed)
    }

    /// Radius on which the table is shown, m: that of its scale, or of its wheel.
    pub fn shown_radius(&self) -> f64 {
        /// Where none is told.
        const USUAL: f64 = 0.1;
        self.drive.pitch_radius.or(self.scale.and_then(|scale| scale.radius)).unwrap_or(USUAL)
    }

    /// A point of the table at an angle (rad), a radius and a height along its axis (m): about y, which is up, or about z.
    pub fn point(&self, angle: f64, radius: f64, height: f64) -> [f64; 3] {
        let (sine, cosine) = angle.sin_cos();
        match self.orientation {
            Orientation::Vertical => [radius * cosine, height, -radius * sine],
            Orientation::Horizontal => [radius * cosine, radius * sine, height],
        }
    }

    /// The way in which a point at an angle (rad) goes where the table turns towards +, of unit length.
    pub fn towards(&self, angle: f64) -> [f64; 3] {
        self.point(angle + FRAC_PI_2, 1.0, 0.0)
    }

    /// The targets of the model's own test, rising, rad; a single one stands in the middle.
    pub fn targets(&self) -> Vec<f64> {
        /// The golden ratio's part: the parts of a period that follow from it lie as evenly as any.
        const GOLDEN: f64 = 0.618_033_988_749_894_9;
        if self.test.positions == 1 {
            return vec![self.from + 0.5 * self.range];
        }
        let last = (self.test.positions - 1) as f64;
        let step = self.range / last;
        let room = self.drive.shortest_period().unwrap_or(step).min(0.5 * step);
        let at = |i: usize| match self.test.spacing {
            Spacing::Even => self.from + self.range * i as f64 / last,
            Spacing::Staggered => {
                self.from + (self.range - room) * i as f64 / last + room * (i as f64 * GOLDEN).fract()
            }
        };
        (0..self.test.positions).map(at).collect()
    }
}

impl Test {
    /// Time of one run there and back, with the pause behind it, s.
    pub fn round(&self) -> f64 {
        (2 * self.positions) as f64 * self.reading + self.pause
    }
}

fn read_test(t: &Reader) -> Test {
    let positions = t.count("positions", "targets along the range").between(1, 10_000).or(USUAL.positions);
    let runs = t.count("runs", "runs, each forwards and back").between(1, 10_000).or(USUAL.runs);
    if 2 * positions * runs > MOST_ROWS {
        let message = format!("{positions} targets in {runs} runs there and back are more than {MOST_ROWS} rows");
        t.problem("positions", message, "take fewer targets or runs");
    }
    let about = "external torque about the axis during the test, towards +";
    Test {
        positions,
        runs,
        spacing: t.choice("spacing", "how the targets stand", Spacing::WORDS).or_first(USUAL.spacing),
        reading: t.quantity("reading", TIME, "from one reading to the next").not_negative().or(USUAL.reading),
        pause: t.quantity("pause", TIME, "between runs").not_negative().or(USUAL.pause),
        torque: t.quantity("torque", TORQUE, about).or(USUAL.torque),
        reading_at_zero: t
            .quantity(
                "reading_at_zero",
                SMALL_ANGLE,
                "what the instrument shows where the axis stands right; 0 if left out",
            )
            .optional(),
    }
}

fn read_tolerance(t: &Reader) -> Tolerance {
    let usual = Tolerance::of_rotary_axes();
    let of = |key, kind, about, usual| t.quantity(key, kind, about).positive().or(usual);
    Tolerance {
        per_length: of("per_angle", SMALL_ANGLE, "allowed either way on any `angle`", usual.per_length),
        length: of("angle", ANGLE, "angle on which `per_angle` holds", usual.length),
        travel: of("range", SMALL_ANGLE, "allowed over the whole range, end to end of the band", usual.travel),
        repeatability: of(
            "repeatability",
            SMALL_ANGLE,
            "allowed scatter and reversal, either way",
            usual.repeatability,
        ),
        measures: Measures::ROTARY,
    }
}
