//! The effects of a joint under test. One file and one line each.

mod contact_joint;
mod datum_offset;
mod dry_friction;
mod gap;
mod preload;
mod settling;

use super::machine::Machine;
use super::setup::Setup;
use crate::process::CatalogueEffect;

/// The registry.
pub const ALL: &[&dyn CatalogueEffect<Setup, Machine>] = &[
    &gap::GAP,
    &contact_joint::CONTACT_JOINT,
    &dry_friction::DRY_FRICTION,
    &preload::PRELOAD,
    &settling::SETTLING,
    &datum_offset::DATUM_OFFSET,
];

#[cfg(test)]
mod bench {
    //! A joint to try effects on.

    use super::super::Stiffness;
    pub use super::super::curve::Branch::{self, Load, Unload};
    use crate::process::with_effect;

    /// A spring of 80 N/um under up to 1000 N.
    const MODEL: &str = r#"
        joint = { stiffness = "80 N/um" }
        test = { max_force = "1000 N" }
    "#;

    /// y in um under a force (N) with one effect of these canonical values.
    pub fn displacement(name: &str, canonical: &[f64], force: f64, branch: Branch) -> f64 {
        1e6 * with_effect::<Stiffness>(MODEL, name, canonical).machine().curve.displacement(force, branch)
    }
}
