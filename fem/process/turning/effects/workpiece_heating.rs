//! The work heats where it is cut.
use super::super::Machine;
use crate::process::{Description, Effect, Parameter, Values};
use crate::units::{CONVECTION, POWER};
/// `workpiece-heating`.
pub struct WorkpieceHeating;
static DESCRIPTION: Description = Description {
    name: "workpiece-heating",
    about: "",
    law: "",
    source: "",
    parameters: &[
        Parameter::amplitude("power", POWER, "heat", (1.0, 500.0)),
        Parameter::amplitude("convection", CONVECTION, "loss", (1.0, 100.0)).or(0.0),
    ],
    look_alikes: &[],
};
impl Effect<Machine> for WorkpieceHeating {
    fn description(&self) -> &'static Description {
        &DESCRIPTION
    }
    fn act(&self, _v: &Values, _m: &mut Machine) {}
}
