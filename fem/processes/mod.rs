//! Processes: the ways in which the system makes or moves something, each a module of its own. To add one,
//! write its module and one line in [`ALL`].

pub mod axis;
pub mod cam;
pub mod contour;
pub mod fixture;
pub mod ring;
pub mod rotary;
pub mod stiffness;
pub mod thermal;
pub mod turning;

use crate::process::Process;

/// Every process, in the order in which people meet them.
pub const ALL: &[&dyn Process] = &[
    &turning::Turning,
    &ring::Ring,
    &thermal::Thermal,
    &fixture::Fixture,
    &stiffness::Stiffness,
    &axis::Axis,
    &rotary::Rotary,
    &contour::Contour,
    &cam::CamGrinding,
];
