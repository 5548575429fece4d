//! The plain finite-element solve, which checks the fast sweep: closed forms, joints, loose shafts, and the
//! sweep itself.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod beam_element;
mod closed_forms;
mod contact_joints;
mod frames;
mod residual;
mod stepped_shaft;
mod sweep;
mod table;

use fem::joint::{Contact, Joint};

/// A contact y = c·Qⁿ in series with a spring of stiffness k (N/m, may be infinite).
fn power_joint(stiffness: f64, coefficient: f64, exponent: f64) -> Joint {
    Joint { spring_compliance: 1.0 / stiffness, contacts: vec![Contact { coefficient, exponent }] }
}
