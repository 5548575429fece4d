//! The pass before, where its programme was another.
//!
//! A finishing pass usually takes an even layer: the turn before has run the same programme. After
//! roughing in other blocks, or with a wheel of another size, it comes upon the waves which that has left,
//! `[cut] stock` farther out: the layer is stock + left before − left now, and where that is below zero
//! the old surface stays.

use super::division::{Division, Speed};
use super::profile::Drawn;
use super::program::Program;
use crate::input::Reader;
use crate::units::{LENGTH, MICRO};

/// The pass before.
#[derive(Clone, Debug, PartialEq)]
pub struct Before {
    /// Its programme.
    pub program: Program,
    /// Radius of the wheel for which that was made, m.
    pub wheel_radius: f64,
    /// Thickness of the even layer that it took off, m; zero where its force is not asked for.
    pub stock: f64,
}

impl Before {
    /// Reads `[before]` for a profile, a wheel (m) and a pace that are those of the model; `None` where
    /// one of them is missing or the profile cannot be divided so, with the problem noted.
    pub fn read(t: &Reader, drawn: Option<&Drawn>, wheel: f64, speed: Option<Speed>, has_stock: bool) -> Option<Self> {
        let division = Division::read(t, speed.map(|s| s.pace));
        let about = "of the wheel for which it was programmed, if not that of [wheel]";
        let radius = t.quantity("wheel_radius", LENGTH, about).positive().optional();
        let about = "thickness of the layer that it took off, for what grinding-deflection left of it";
        let stock = t.quantity("stock", MICRO, about).positive().optional();
        if !t.is_described() && !has_stock {
            t.problem("", "the layer between the two passes is not known", "add stock = \"20 um\" in [cut]");
        }
        let (drawn, division, speed) = (drawn?, division?, speed?);
        let wheel_radius = radius.unwrap_or(wheel);
        let own = vec![None; drawn.segments.len()];
        division.check(t, &drawn.profile, &own, wheel_radius).then(|| Self {
            program: Program::new(&drawn.profile, wheel_radius, &division, &own, &speed),
            wheel_radius,
            stock: stock.unwrap_or(0.0),
        })
    }
}
