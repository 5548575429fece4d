//! Properties of a material over its temperature.

use std::sync::Arc;

use crate::input::{Along, Field, Reader, Record, Varying};
use crate::units::TEMPERATURE;

/// Temperature at which a material has the properties that are not read over temperature, K.
const ROOM: f64 = 293.15;

/// Records of the properties that change with the temperature (K); `None` of those that do not.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct OverTemperature {
    /// Conductivity, W/(m K).
    pub conductivity: Option<Arc<Record>>,
    /// Specific heat, J/(kg K).
    pub specific_heat: Option<Arc<Record>>,
    /// Thermal expansion, 1/K: of the next kelvin, or where there is a reference the mean from that on.
    pub expansion: Option<Arc<Record>>,
    /// Temperature from which the expansion is a mean, K.
    pub expansion_from: Option<f64>,
}

impl OverTemperature {
    /// Whether nothing changes with the temperature.
    pub fn is_constant(&self) -> bool {
        self.conductivity.is_none() && self.specific_heat.is_none() && self.expansion.is_none()
    }

    /// Where the record of a property is kept; `None` of a property that is none.
    pub(super) fn place(&mut self, key: &str) -> Option<&mut Option<Arc<Record>>> {
        match key {
            "conductivity" => Some(&mut self.conductivity),
            "specific_heat" => Some(&mut self.specific_heat),
            "expansion" => Some(&mut self.expansion),
            _ => None,
        }
    }

    /// Reads a property, or the record of it: its value at room temperature.
    pub(super) fn read(field: Field<'_, '_>, place: &mut Option<Arc<Record>>, base: Option<f64>) -> f64 {
        // How far the body warms is not known before it is computed.
        let along = Along { name: "temperature", kind: TEMPERATURE, needed: [f64::NAN; 2] };
        let property = match base {
            Some(base) => field.optional_varying(along).unwrap_or(Varying::Constant(base)),
            None => field.varying(along),
        };
        let room = property.at(ROOM);
        if let Varying::Record(record) = property {
            *place = Some(record);
        }
        room
    }

    /// Reads from where on the expansion is a mean.
    pub(super) fn read_reference(&mut self, own: &Reader) {
        let about =
            "from where on a record of the expansion has means, as handbooks do; of the next kelvin if left out";
        self.expansion_from = own.quantity("expansion_from", TEMPERATURE, about).optional();
        // Of a record that is none its own place tells.
        let is_record = self.expansion.is_some() || own.has_table("expansion");
        if self.expansion_from.is_some() && !is_record && !own.is_described() {
            let help = "leave it out, or give the record: expansion = { file = \"expansion.csv\" }";
            own.problem("expansion_from", "the expansion is no record over temperature", help);
        }
    }
}
