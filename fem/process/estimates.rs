//! What people measure or estimate for the tables of a model, and how often and how far it is off.
//!
//! On trial are forces, stiffnesses, powers, films, temperatures and what else a person reads off an instrument, looks up in a
//! table or takes from another machine. Not on trial is what a drawing states (lengths, diameters, places, the lead of a screw), what
//! a programme or a control sets (depth, feed, speeds, times, gain) and what whoever computes chooses (meshes, steps): where such a
//! value is wrong the machine is another, and that is an effect of the catalogue. Properties of a named material are
//! not on trial either, those that somebody wrote himself are.

use crate::input::{Doubt, Grows};

/// A force of cutting or grinding.
pub const CUTTING_FORCE: Doubt = Doubt::by_factor(
    0.15,
    1.5,
    Grows::Linearly,
    "handbooks give forces of cutting for a sharp edge and an average material, and real ones are off by tens of percent",
);

/// Force of a clamp or a jaw.
pub const CLAMPING_FORCE: Doubt = Doubt::by_factor(
    0.15,
    1.5,
    Grows::Linearly,
    "friction in threads and wedges makes clamping forces scatter by 30 % about what torque or pressure says",
);

/// By how much a part is larger than what is sprung open for it.
pub const INTERFERENCE: Doubt = Doubt::by_factor(
    0.15,
    1.5,
    Grows::Linearly,
    "an interference is the small difference of two diameters, of which pads wear and parts vary within their tolerance",
);

/// Preload of a nut.
pub const PRELOAD: Doubt =
    Doubt::by_factor(0.15, 2.0, Grows::Otherwise, "a preload is set when a nut is assembled, and wears off");

/// Stiffness of a unit, a joint or a contact.
pub const STIFFNESS: Doubt = Doubt::by_factor(
    0.3,
    3.0,
    Grows::Inversely,
    "stiffnesses are taken from other machines more often than measured, and joints take most of them",
);

/// Compliance of a machine that was measured.
pub const COMPLIANCE: Doubt = Doubt::by_factor(
    0.1,
    1.3,
    Grows::Linearly,
    "a load cell and a dial are each off by percents, and joints settle between one pull and the next",
);

/// Coefficient of a contact.
pub const CONTACT: Doubt =
    Doubt::by_factor(0.3, 3.0, Grows::Linearly, "coefficients of contacts are of surfaces that somebody else prepared");

/// Clearance of a joint.
pub const CLEARANCE: Doubt = Doubt::by_factor(
    0.3,
    3.0,
    Grows::Otherwise,
    "a clearance is set when a machine is assembled, and grows as it wears",
);

/// Coefficient of friction.
pub const FRICTION: Doubt = Doubt::by_factor(
    0.3,
    3.0,
    Grows::Linearly,
    "coefficients of friction differ by a factor of two between dry and oiled pads of one kind",
);

/// Free length of a tool holder.
pub const OVERHANG: Doubt =
    Doubt::by_factor(0.05, 1.3, Grows::Otherwise, "an overhang is set by hand and read off a ruler");

/// How far something that was set up by hand stands out of line, m.
pub const ALIGNMENT: Doubt = Doubt::by_amount(0.2, 50e-6, "a steady rest is set by feel");

/// How far what is exchanged or mounted anew stands high, m.
pub const SEATING: Doubt = Doubt::by_amount(0.2, 20e-6, "chips and burrs lie under what is exchanged");

/// How far it lies out of level, m/m.
pub const LEVELLING: Doubt = Doubt::by_amount(0.2, 50e-6, "a fixture is levelled with a dial from end to end");

/// Power or heat of a source.
pub const POWER: Doubt = Doubt::by_factor(
    0.2,
    1.5,
    Grows::Linearly,
    "rated powers are of the drive or the plug, and what reaches the body is a part of it",
);

/// Heat capacity of a heater.
pub const HEATER: Doubt =
    Doubt::by_factor(0.15, 2.0, Grows::Otherwise, "nobody weighs a heater, and what it is filled with is not known");

/// Conductance of a contact.
pub const CONDUCTANCE: Doubt =
    Doubt::by_factor(0.2, 3.0, Grows::Otherwise, "conductances of contacts depend on pressure, roughness and paste");

/// A film coefficient.
pub const FILM: Doubt =
    Doubt::by_factor(0.3, 3.0, Grows::Otherwise, "film coefficients of still air are known within a factor of three");

/// An emissivity.
pub const EMISSIVITY: Doubt = Doubt::by_factor(
    0.3,
    2.0,
    Grows::Otherwise,
    "emissivities of metals are known within a factor of two: finish and oxide decide",
);

/// A temperature, K.
pub const TEMPERATURE: Doubt =
    Doubt::by_amount(0.15, 3.0, "rooms are written as 20 degC, and a few kelvin beside it is usual");

/// Frequency at which a drive sticks and slips.
pub const FREQUENCY: Doubt = Doubt::by_factor(0.1, 1.3, Grows::Otherwise, "it is counted on a trace of a few periods");
