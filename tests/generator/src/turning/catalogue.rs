//! The 28 effects of turning: their parameters, plausible sizes, and which lathe and workholding admits them.

use super::job::{Holding, Job};
use crate::law::{Law, Parameter, Role};

const STIFFNESS: &[Parameter] = &[Parameter("stiffness", "N/um", 15.0, 150.0, Role::Stiffness)];
const CONTACT: &[Parameter] =
    &[Parameter("c", "um/N^n", 0.15, 0.4, Role::Amplitude), Parameter("n", "", 0.35, 0.7, Role::Shape)];
const TILT: &[Parameter] = &[Parameter("stiffness", "kN*m/rad", 200.0, 900.0, Role::Stiffness)];
const FEEDBACK: &[Parameter] = &[Parameter("exponent", "", 0.6, 1.0, Role::Amplitude)];
const WEAR: &[Parameter] = &[
    Parameter("run_in", "um", 1.0, 4.0, Role::Amplitude),
    Parameter("run_in_path", "m", 300.0, 900.0, Role::Shape),
    Parameter("rate", "um/km", 3.0, 15.0, Role::Amplitude),
];
const BREAKDOWN: &[Parameter] = &[
    Parameter("wear", "um", 20.0, 200.0, Role::Amplitude),
    Parameter("onset", "m", 200.0, 1500.0, Role::Shape),
    Parameter("exponent", "", 1.2, 2.5, Role::Shape),
];
const GROWTH: &[Parameter] = &[
    Parameter("elongation", "um", 5.0, 15.0, Role::Amplitude),
    Parameter("time_constant", "min", 10.0, 40.0, Role::Shape),
];
const HEATING: &[Parameter] = &[
    Parameter("power", "W", 30.0, 150.0, Role::Amplitude),
    Parameter("convection", "W/m^2/K", 5.0, 30.0, Role::Shape),
];
const DRIFT: &[Parameter] =
    &[Parameter("drift", "um", 4.0, 15.0, Role::Amplitude), Parameter("time_constant", "min", 30.0, 90.0, Role::Shape)];
const TAPER: &[Parameter] = &[Parameter("slope", "um/m", 10.0, 60.0, Role::Signed)];
const HEIGHT: &[Parameter] = &[Parameter("slope", "mm/m", 1.0, 4.0, Role::Root)];
/// The centre's range is a share of the shaft's length here; it becomes mm when drawn.
const HOLLOW: &[Parameter] = &[
    Parameter("depth", "um", 3.0, 20.0, Role::Amplitude),
    Parameter("centre", "mm", 0.15, 0.85, Role::Shape),
    Parameter("width", "mm", 25.0, 90.0, Role::Shape),
];
const TAILSTOCK: &[Parameter] = &[Parameter("offset", "um", 4.0, 40.0, Role::Signed)];
const SETTING: &[Parameter] = &[Parameter("offset", "um", 5.0, 30.0, Role::Signed)];

const LAND: &[Parameter] = &[Parameter("share", "", 0.6, 1.6, Role::Amplitude)];
const FRONT: &[Parameter] = &[
    Parameter("wear", "um", 3.0, 40.0, Role::Amplitude),
    Parameter("centre", "mm", 0.15, 0.85, Role::Shape),
    Parameter("width", "mm", 25.0, 90.0, Role::Shape),
];
const TWIST: &[Parameter] = &[Parameter("twist", "um/m/m", 10.0, 120.0, Role::Signed)];

const SAG: &[Parameter] =
    &[Parameter("front", "um", 5.0, 60.0, Role::Signed), Parameter("rear", "um", 5.0, 60.0, Role::Signed)];

const REST: &[Parameter] = &[Parameter("offset", "um", 5.0, 30.0, Role::Signed)];

const PLAY: &[Parameter] = &[Parameter("gap", "um", 2.0, 20.0, Role::Amplitude)];

const FRICTION: &[Parameter] = &[Parameter("force", "N", 10.0, 60.0, Role::Amplitude)];

/// The number of the part is drawn from those of the batch.
const CORRECTION: &[Parameter] =
    &[Parameter("after", "", 1.0, 7.0, Role::Shape), Parameter("diameter", "um", 5.0, 40.0, Role::Signed)];

const INSERT: &[Parameter] =
    &[Parameter("after", "", 1.0, 7.0, Role::Shape), Parameter("share", "", 0.85, 1.0, Role::Amplitude)];

/// All of them: those of any lathe, those of a surveyed one, those of rests, of shoulders and of an edge that wears.
pub const LAWS: &[Law] = &[
    ("headstock-compliance", STIFFNESS),
    ("tailstock-compliance", STIFFNESS),
    ("carriage-compliance", STIFFNESS),
    ("headstock-contact", CONTACT),
    ("tailstock-contact", CONTACT),
    ("carriage-contact", CONTACT),
    ("chuck-tilt", TILT),
    ("force-feedback", FEEDBACK),
    ("tool-wear", WEAR),
    ("tool-thermal-growth", GROWTH),
    ("workpiece-heating", HEATING),
    ("spindle-thermal-drift", DRIFT),
    ("guideway-taper", TAPER),
    ("guideway-height", HEIGHT),
    ("guideway-wear", HOLLOW),
    ("tailstock-offset", TAILSTOCK),
    ("setting-error", SETTING),
    ("offset-correction", CORRECTION),
    ("tool-breakdown", BREAKDOWN),
    ("wear-land", LAND),
    ("front-guideway-wear", FRONT),
    ("bed-twist", TWIST),
    ("bed-sag", SAG),
    ("rest-offset", REST),
    ("cross-slide-play", PLAY),
    ("insert-change", INSERT),
    ("headstock-friction", FRICTION),
    ("tailstock-friction", FRICTION),
];
/// How many any lathe has.
const USUAL: usize = 19;
/// How many need what few jobs have: a rest, a shoulder, wear that is known, places where the pass begins.
const OF_SOME: usize = 5;
/// Those that any lathe has.
pub const OF_ANY: &[Law] = LAWS.split_at(USUAL).0;
/// Those of which nothing is known unless edge and bed were measured.
pub const OF_SURVEYED: &[Law] = LAWS.split_at(LAWS.len() - OF_SOME).0.split_at(USUAL).1;

/// Those of supports that rub.
pub const OF_RUBBING: &[Law] = LAWS.split_at(LAWS.len() - 2).1;

/// "tailstock-* and tailstock-offset not in `chuck`; chuck-tilt not in `centres`; the others all".
/// Those of a surveyed lathe need its survey, that of rests a rest, and the
/// play of the cross slide a shoulder that the pass climbs; a new insert needs several parts.
pub fn admits(job: &Job, effect: &str) -> bool {
    let is_known = job.survey.is_some() || OF_ANY.iter().any(|law| law.0 == effect);
    match effect {
        "rest-offset" => !job.set_up.rests.is_empty(),
        "insert-change" => job.parts > 1,
        "headstock-friction" | "tailstock-friction" => job.holding != Holding::Chuck,
        "cross-slide-play" => job.rows.iter().any(|row| job.has_climbed(row.x)),
        _ => is_known && holds(job.holding, effect),
    }
}

/// What wears the edge.
pub const WEARS: [&str; 3] = ["tool-wear", "tool-breakdown", "wear-land"];

/// Whether an effect lets the joint yield beside which another rubs.
pub fn yields_beside(friction: &str, effect: &str) -> bool {
    let yields = [effect.strip_suffix("compliance"), effect.strip_suffix("contact")];
    yields.contains(&friction.strip_suffix("friction"))
}

/// Whether a workholding admits the effect.
pub fn holds(holding: Holding, effect: &str) -> bool {
    match holding {
        Holding::Centres => effect != "chuck-tilt",
        Holding::Chuck => !effect.starts_with("tailstock-") && !effect.ends_with("-friction"),
        Holding::ChuckAndCentre => true,
    }
}

/// How far a draw may be scaled down before it is a different kind of thing: an exponent of 0.1 is no
/// cutting force.
pub fn least_factor(effect: &str) -> f64 {
    if effect == "force-feedback" { 0.25 } else { 0.04 }
}
