//! The kinds of quantity that models and effects are written in, each with its canonical unit.

use std::fmt;

use super::{Dimension, Unit, UnitError, UnitSymbol};

/// A kind of quantity: what it is called and the canonical unit in which results and JSON give it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Kind {
    /// Name with its article, as in "expected a length".
    pub name: &'static str,
    /// Canonical unit; empty for a pure number.
    pub unit: UnitSymbol,
    /// A usual value in that unit, for examples.
    pub usual: &'static str,
}

macro_rules! kinds {
    ($($constant:ident = $name:literal in $unit:literal, as $usual:literal;)*) => {
        $(#[doc = concat!("Canonical unit `", $unit, "`.")] pub const $constant: Kind = Kind::new($name, $unit, $usual);)*
        /// Every kind, for whole-table tests.
        pub const ALL: &[Kind] = &[$($constant),*];
    };
}

kinds! {
    NUMBER = "a pure number" in "", as "0.5";
    CONTRACTION = "a pure number" in "", as "0.3";
    LENGTH = "a length" in "mm", as "40";
    MICRO = "a small length" in "um", as "5";
    PATH = "a cutting path" in "m", as "400";
    TIME = "a time" in "min", as "5";
    FORCE = "a force" in "N", as "450";
    MASS_DENSITY = "a density" in "kg/m^3", as "7850";
    PRESSURE = "a modulus" in "GPa", as "210";
    STRESS = "a stress" in "MPa", as "100";
    STIFFNESS = "a stiffness" in "N/um", as "60";
    ROTATIONAL_STIFFNESS = "a rotational stiffness" in "kN*m/rad", as "400";
    COMPLIANCE = "a compliance" in "um/kN", as "10";
    CONTACT_COEFFICIENT = "a contact coefficient" in "um/N^n", as "0.2";
    SLOPE = "a slope" in "um/m", as "20";
    STEEP_SLOPE = "a slope" in "mm/m", as "1";
    TWIST = "a twist" in "um/m/m", as "20";
    WEAR_RATE = "a wear rate" in "um/km", as "8";
    WEAR_PER_PART = "a wear per part" in "um/1000", as "40";
    FEED = "a feed per revolution" in "mm/rev", as "0.2";
    SPINDLE_SPEED = "a spindle speed" in "rpm", as "600";
    POWER = "a power" in "W", as "80";
    CONVECTION = "a heat transfer coefficient" in "W/m^2/K", as "20";
    EXPANSION = "a thermal expansion" in "/K", as "11.5e-6";
    CONDUCTIVITY = "a conductivity" in "W/m/K", as "50";
    ANGLE = "an angle" in "deg", as "10";
    JAW_MOMENT = "a moment of mass" in "kg*mm", as "30";
    TEMPERATURE_RISE = "a temperature rise" in "K", as "10";
    TEMPERATURE = "a temperature" in "degC", as "20";
    HEAT_FLUX = "a heat flux" in "kW/m^2", as "50";
    CONDUCTANCE = "a thermal conductance" in "W/K", as "0.5";
    PERIOD = "a period" in "h", as "4";
    SECONDS = "a time" in "s", as "30";
    SPEED = "a speed" in "m/min", as "1";
    FORCE_PER_DEPTH = "a force per depth" in "kN/mm", as "1";
    FEED_RATE = "a feed rate" in "mm/min", as "1000";
    ACCELERATION = "an acceleration" in "m/s^2", as "2";
    ANGULAR_ACCELERATION = "an angular acceleration" in "rad/s^2", as "100";
    FREQUENCY = "a frequency" in "Hz", as "5";
    GAIN = "a servo gain" in "/s", as "50";
    SHORT_TIME = "a short time" in "ms", as "100";
    FORCE_PER_RATE = "a force per removal rate" in "N/(mm^2/s)", as "10";
    HEAT = "a heat" in "kJ", as "10";
    WORK = "a work" in "uJ", as "10";
    ENERGY = "an energy" in "J", as "10";
    AREA = "an area" in "mm^2", as "10";
    REMOVAL_RATE = "a removal rate" in "mm^2/s", as "10";
    SPECIFIC_HEAT = "a specific heat" in "J/kg/K", as "470";
    HEAT_CAPACITY = "a heat capacity" in "J/K", as "10";
    VOLUME = "a volume" in "cm^3", as "400";
    FACTOR = "a factor" in "", as "1";
    PERCENT = "a percentage" in "%", as "10";
    MOMENT = "a moment" in "N*m", as "50";
    SMALL_ANGLE = "a small angle" in "arcsec", as "5";
    ANGLE_SLOPE = "an angle per angle" in "arcsec/deg", as "0.5";
    TORQUE = "a torque" in "N*m", as "20";
    TORSIONAL_STIFFNESS = "a torsional stiffness" in "N*m/arcsec", as "5";
}

/// A number with its unit, to be written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shown {
    number: f64,
    unit: UnitSymbol,
}

impl fmt::Display for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.number, f)?;
        if self.unit.is_empty() { Ok(()) } else { write!(f, " {}", self.unit) }
    }
}

impl Kind {
    /// A kind by its name with the article, its canonical unit, and a usual value in that.
    ///
    /// # Panics
    /// The unit is longer than any symbol; a constant of it does not compile.
    pub const fn new(name: &'static str, unit: &str, usual: &'static str) -> Self {
        Self { name, unit: UnitSymbol::new(unit), usual }
    }

    /// The canonical unit, parsed. The units of [`ALL`] are checked by a test, so a failure can only come
    /// from a `Kind` made elsewhere; it then counts as a pure number.
    #[doc(hidden)]
    pub fn canonical(&self) -> Unit {
        Unit::parse(&self.unit).unwrap_or(Unit { factor: 1.0, offset: 0.0, dimension: Dimension::NONE })
    }

    /// `si` in the canonical unit.
    pub fn from_si(&self, si: f64) -> f64 {
        let unit = self.canonical();
        (si - unit.offset) / unit.factor
    }

    /// A number in the canonical unit, in SI.
    pub fn to_si(&self, canonical: f64) -> f64 {
        let unit = self.canonical();
        canonical * unit.factor + unit.offset
    }

    /// `si` as people read it, with the unit of this kind: `{:+.3}` gives `+1.234 um`. Precision, sign and
    /// width are those of the number.
    #[doc(hidden)]
    pub fn shown(&self, si: f64) -> Shown {
        Shown { number: self.from_si(si), unit: self.unit }
    }

    /// Formats `si` to six digits with its unit, as people write a dimension or a feed: `1000 mm/min`.
    pub fn format(&self, si: f64) -> String {
        let number = self.from_si(si);
        let number: f64 = format!("{number:.5e}").parse().unwrap_or(number);
        // Rows of zeros are not counted by anybody.
        match number == 0.0 || (1e-9..1e12).contains(&number.abs()) {
            true => format!("{number} {}", self.unit),
            false => format!("{number:e} {}", self.unit),
        }
        .trim_end()
        .to_string()
    }

    /// Reads a unit and checks that it measures this kind.
    ///
    /// # Errors
    /// The text is no unit, or a unit of something else.
    #[doc(hidden)]
    pub fn unit_of(&self, text: &str) -> Result<Unit, UnitError> {
        // Shops write the speed of a spindle as 1/min and mean revolutions.
        let turns = *self == SPINDLE_SPEED && matches!(text.trim(), "1/min" | "/min" | "min^-1" | "min⁻¹" | "min-1");
        let canonical = self.canonical();
        // Two strokes are an inch or a second of arc, by what is measured.
        let strokes = matches!(text.trim(), "\"" | "''");
        let text = match canonical.dimension {
            _ if turns => "rpm",
            dimension if strokes && dimension == LENGTH.canonical().dimension => "in",
            dimension if strokes && dimension == ANGLE.canonical().dimension => "arcsec",
            _ => text,
        };
        let unit = Unit::parse(text)?;
        // A slope has no dimension, yet 20 without `um/m` is a million times too much.
        let forgotten = text.trim().is_empty() && !self.unit.is_empty();
        if forgotten || unit.dimension != canonical.dimension {
            return Err(self.wrong_dimension(text, &unit));
        }
        if unit.offset != 0.0 && canonical.offset == 0.0 {
            return Err(UnitError::new("a temperature difference is not written in degC").hint("write it in K"));
        }
        Ok(unit)
    }

    fn wrong_dimension(&self, text: &str, unit: &Unit) -> UnitError {
        let error = match text.trim() {
            "" => UnitError::new("the unit is missing"),
            text => UnitError::new(format!("`{text}` measures {}, not {}", measured(unit.dimension), self.name)),
        };
        match &*self.unit {
            "" => error.hint("write the number alone"),
            canonical => error.hint(format!("write it in {canonical} or another unit of {}", self.bare_name())),
        }
    }

    /// Kind in which a difference of two such quantities is written: that of temperatures is not in degC.
    pub fn difference(&self) -> Self {
        if self.canonical().offset == 0.0 { *self } else { TEMPERATURE_RISE }
    }

    /// An example as a model file has it: `0.2 mm/rev`.
    pub fn example(&self) -> String {
        format!("{} {}", self.usual, self.unit).trim_end().to_string()
    }

    /// The name without its article.
    pub fn bare_name(&self) -> &'static str {
        self.name.split_once(' ').map_or(self.name, |(_, name)| name)
    }
}

/// The quantity that a dimension measures, in words where it is a kind we know.
fn measured(dimension: Dimension) -> String {
    match ALL.iter().find(|k| k.canonical().dimension == dimension) {
        Some(kind) => kind.name.to_string(),
        None => format!("something in {dimension}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_canonical_unit_parses_and_converts_back() {
        for kind in ALL {
            assert!(Unit::parse(&kind.unit).is_ok(), "{}", kind.unit);
            // A zero point far off costs some digits.
            let digits = 1.0 + kind.canonical().offset.abs();
            assert!((kind.from_si(kind.to_si(3.7)) - 3.7).abs() < 1e-14 * digits, "{}", kind.name);
        }
    }
}
