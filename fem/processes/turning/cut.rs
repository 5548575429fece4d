//! The cut: its depth, its force, and the pass of the tool.

use std::f64::consts::PI;

use super::schedule::Pass;
use crate::input::{Along, Field, Reader, Varying};
use crate::material::{catalogue, listed};
use crate::process::NoLaw;
use crate::process::estimates::CUTTING_FORCE;
use crate::units::{ANGLE, FEED, FORCE, LENGTH, NUMBER, SPINDLE_SPEED, STRESS};

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

/// Reads the law of Kienzle, P = share·kc1.1·b·h^(1−mc) with b = t/sin κ and h = s·sin κ in mm [O. Kienzle, VDI-Z 94 (1952)
/// 299], if the table names a material or the specific force. The share is that of the radial in the cutting force: some
/// 0.2 to 0.3 for approach angles about 90°, 0.4 to 0.5 for 45°, and nearly 1 where the nose cuts alone.
fn kienzle(t: &Reader) -> Option<ForceLaw> {
    let material = t.text("material", "material whose kc1.1 and mc are taken, in place of C, x and y");
    let kc =
        t.quantity("kc", STRESS, "specific cutting force kc1.1, on a chip 1 mm thick and wide").positive().optional();
    let mc = t.quantity("mc", NUMBER, "exponent mc of the chip's thickness").within(0.0, 1.0).optional();
    let angle =
        t.quantity("approach_angle", ANGLE, "of the cutting edge to the axis").positive().or(90f64.to_radians());
    let share =
        t.quantity("radial_share", NUMBER, "radial force in parts of the cutting force").estimated(CUTTING_FORCE);
    if material.is_none() && kc.is_none() {
        share.optional();
        return None;
    }
    let share = share.positive().required();
    if angle >= PI {
        t.problem("approach_angle", "`approach_angle` is 180 deg or more", "it lies between the edge and the axis");
    }
    let (specific, exponent) = match (&material, kc, mc) {
        (Some(_), None, None) => {
            let cutting = material.as_deref().and_then(|name| catalogue::named(name));
            match cutting.map(|entry| (entry.names[0], entry.cutting)) {
                Some((_, Some(cutting))) => (cutting.specific_force, cutting.exponent),
                Some((name, None)) => {
                    t.problem("material", format!("no specific cutting force of {name} is known here"), GIVE_KC);
                    (1e9, 0.25)
                }
                None => {
                    let name = material.as_deref().unwrap_or_default();
                    t.problem("material", format!("`{name}` is no material known here"), listed(name));
                    (1e9, 0.25)
                }
            }
        }
        (None, Some(kc), Some(mc)) => (kc, mc),
        (Some(_), ..) => {
            t.problem("material", "the specific cutting force is given twice", "keep the material, or `kc` and `mc`");
            (1e9, 0.25)
        }
        (None, ..) => {
            t.problem("kc", "`mc` is missing", "add mc = 0.25: `kc` and `mc` come from one table");
            (1e9, 0.25)
        }
    };
    // In N, mm and mm/rev, as tables have it.
    let units = FEED.from_si(1.0).powf(1.0 - exponent) * LENGTH.from_si(1.0);
    let coefficient = share * STRESS.from_si(specific) * angle.sin().powf(-exponent) * units;
    Some(ForceLaw { coefficient, depth_exponent: 1.0, feed_exponent: 1.0 - exponent })
}

const GIVE_KC: &str = "write kc = \"1500 MPa\" and mc = 0.25 from a table of your tool's maker";

/// Reads the force of a cut over a stretch of the shaft, m.
fn read_force(t: &Reader, needed: [f64; 2]) -> Force {
    let given = t.quantity("radial_force", FORCE, "radial force of the cut").estimated(CUTTING_FORCE).not_negative();
    let given = given.optional_varying(Along { name: "x", kind: LENGTH, needed });
    let about = "P = C·s^y·t^x·HB^n in N, s in mm/rev, t in mm; or Kienzle's law by a material or by kc1.1 and mc";
    let law = t.optional_table("force", about, |t| {
        let by_kienzle = kienzle(t);
        if let Some(law) = by_kienzle.filter(|_| !t.is_described()) {
            return law;
        }
        let number = |key, about| t.quantity(key, NUMBER, about);
        // The schema knows both laws.
        let required = |field: Field<'_, '_>| if t.is_described() { field.or(0.0) } else { field.required() };
        let coefficient = required(number("C", "coefficient C").estimated(CUTTING_FORCE).positive());
        let depth_exponent = required(number("x", "exponent of the depth").within(0.0, 1.0));
        let feed_exponent = number("y", "exponent of the feed; 0 where the force does not depend on it");
        let feed_exponent = required(feed_exponent.not_negative());
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
            let help = "add radial_force = \"450 N\", or force = { C = 1250.0, x = 0.9, y = 0.75 }, or \
                        force = { material = \"42CrMo4\", radial_share = 0.3 }";
            t.problem("", "the force of the cut is missing", help);
            Force::Given(Varying::Constant(0.0))
        }
    }
}
