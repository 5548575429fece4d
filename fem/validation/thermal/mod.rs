//! The validation table of heated bodies: closed forms and series of conduction, published benchmarks,
//! growth and bow, cooling, recorded inputs and heaters, bodies of revolution.

mod benchmarks;
mod cooling;
mod effects;
mod inputs;
mod over_temperature;
mod plates;
mod revolved;
mod rig;
mod series;
mod surfaces;
mod surroundings;
mod tubes;

use crate::validation::Case;

/// Every case.
pub fn cases() -> Vec<Case> {
    let all = [series::cases(), effects::cases(), benchmarks::cases(), plates::cases(), cooling::cases()];
    [
        all.concat(),
        inputs::cases(),
        surroundings::cases(),
        revolved::cases(),
        tubes::cases(),
        surfaces::cases(),
        over_temperature::cases(),
    ]
    .concat()
}
