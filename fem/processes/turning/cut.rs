//! The cut: its depth, its force, and the pass of the tool.

use super::schedule::Pass;
use crate::input::{Along, Reader, Varying};
use crate::process::NoLaw;
use crate::process::estimates::CUTTING_FORCE;
use crate::units::{FEED, FORCE, LENGTH, NUMBER, SPINDLE_SPEED};

/// Depth and force of the cut.
#[derive(Clone, Debug, PartialEq)]
pub struct Cut {
    /// t₀, m.
    pub depth: f64,
    /// Radial force.
    pub force: Force,
}

/// Where the radial force comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum Force {
    /// Given directly, N, the same everywhere or recorded along the shaft.
    Given(Varying),
    /// From the empirical law.
    Law(ForceLaw),
}

/// P = C·s^y·t^x·HBⁿ with s in mm/rev, t in mm, P in N [seed law (16)].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ForceLaw {
    /// C·HBⁿ, for feed and depth in SI units.
    coefficient: f64,
    /// x.
    pub depth_exponent: f64,
    /// y.
    feed_exponent: f64,
}

/// The settings of the cut at one point, which set its force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conditions {
    /// Force at the set depth, which acts where the deflection is not fed back, N.
    pub force: f64,
    /// Force P₀ at the depth t₀, which the feedback starts from, N.
    pub nominal: f64,
    /// t₀, m: the model's own depth, or that of an earlier pass.
    pub nominal_depth: f64,
    /// Depth t that the tool is set to there, m; below zero where the blank is smaller than the set
    /// diameter.
    pub set_depth: f64,
}

impl ForceLaw {
    /// Radial force in N at a depth in m and a feed in m/rad.
    pub fn force(&self, depth: f64, feed: f64) -> f64 {
        self.coefficient * feed.powf(self.feed_exponent) * depth.max(0.0).powf(self.depth_exponent)
    }
}

impl Force {
    /// Radial force in N at a place (m), a depth (m) and a feed (m/rad).
    pub fn at(&self, x: f64, depth: f64, feed: f64) -> f64 {
        match self {
            Self::Given(force) => force.at(x),
            Self::Law(law) => law.force(depth, feed),
        }
    }
}

impl Cut {
    /// Reads `[cut]`: the cut and the pass along a shaft of `length` m.
    pub fn read(model: &Reader, length: f64) -> (Self, Pass) {
        model.table("cut", "what the tool is set to", |t| {
            let depth = t.quantity("depth", LENGTH, "set depth of cut").positive().required();
            let feed = t.quantity("feed", FEED, "feed per revolution").positive().required();
            let speed = t.quantity("spindle_speed", SPINDLE_SPEED, "spindle speed").positive().required();
            let from = t.quantity("from", LENGTH, "where the cut begins; the tailstock end if left out").or(length);
            let to = t.quantity("to", LENGTH, "where it ends; the headstock end if left out").or(0.0);
            for (key, x) in [("from", from), ("to", to)] {
                if x < 0.0 || x > length * (1.0 + 1e-12) {
                    let help = format!("the shaft reaches from 0 mm to {}", LENGTH.format(length));
                    t.problem(key, format!("the tool would stand outside the shaft, at {}", LENGTH.format(x)), help);
                }
            }
            if from == to {
                t.problem("to", "the pass is empty: it ends where it begins", "let `to` differ from `from`");
            }
            let to = to.min(length);
            let from = from.min(length);
            let force = read_force(t, [from.min(to), from.max(to)]);
            (Self { depth, force }, Pass { from, to, feed, spindle_speed: speed })
        })
    }
}

/// Why nobody can say what another depth or feed does: where the force is given, it is that of the depth and the feed that
/// stand there.
pub fn no_law(cut: &Cut, path: &str) -> Option<NoLaw> {
    let is_of_pass = path.starts_with("pass[") && (path.ends_with("].depth") || path.ends_with("].feed"));
    let is_one = matches!(path, "cut.depth" | "cut.feed") || is_of_pass;
    (is_one && matches!(cut.force, Force::Given(_))).then_some(NoLaw {
        reason: "`radial_force` stays what it is, whatever depth and feed are",
        help: "write force = { C = 1250.0, x = 0.9, y = 0.75 } in [cut], with the values of your material, instead of it",
    })
}

/// Reads the force of a cut over a stretch of the shaft, m.
fn read_force(t: &Reader, needed: [f64; 2]) -> Force {
    let given = t.quantity("radial_force", FORCE, "radial force of the cut").estimated(CUTTING_FORCE).not_negative();
    let given = given.optional_varying(Along { name: "x", kind: LENGTH, needed });
    let law = t.optional_table("force", "P = C·s^y·t^x·HB^n in N, s in mm/rev, t in mm", |t| {
        let number = |key, about| t.quantity(key, NUMBER, about);
        let coefficient = number("C", "coefficient C").estimated(CUTTING_FORCE).positive().required();
        let depth_exponent = number("x", "exponent of the depth").within(0.0, 1.0).required();
        let feed_exponent = number("y", "exponent of the feed; 0 where the force does not depend on it");
        let feed_exponent = feed_exponent.not_negative().required();
        if feed_exponent > 1.0 {
            t.problem("y", format!("`y` is {feed_exponent}"), "it must be from 0 to 1");
        }
        let hardness_exponent = number("n", "exponent of the hardness").not_negative().or(0.0);
        let hardness = number("HB", "Brinell hardness").positive();
        let hardness = if hardness_exponent == 0.0 { hardness.or(1.0) } else { hardness.required() };
        let units = FEED.from_si(1.0).powf(feed_exponent) * LENGTH.from_si(1.0).powf(depth_exponent);
        let coefficient = coefficient * hardness.powf(hardness_exponent) * units;
        ForceLaw { coefficient, depth_exponent, feed_exponent }
    });
    match (given, law) {
        (Some(force), None) => Force::Given(force),
        (None, Some(law)) => Force::Law(law),
        (Some(_), Some(_)) => {
            t.problem("force", "the force is given twice", "keep either `radial_force` or `force`");
            Force::Given(Varying::Constant(0.0))
        }
        (None, None) => {
            let help = "add radial_force = \"450 N\", or force = { C = 1250.0, x = 0.9, y = 0.75 }";
            t.problem("", "the force of the cut is missing", help);
            Force::Given(Varying::Constant(0.0))
        }
    }
}
