//! Materials: a built-in list, the names of standards, or a table of one's own.

pub mod catalogue;
mod over_temperature;
mod properties;

pub use over_temperature::OverTemperature;
pub use properties::Material;

use properties::material;

use crate::input::{Bounds, Doubt, Grows, Reader, did_you_mean};
use crate::units::{CONDUCTIVITY, CONTRACTION, EXPANSION, Kind, MASS_DENSITY, PRESSURE, SPECIFIC_HEAT};

/// Typical room-temperature values of handbooks; a part that matters deserves its own table.
const BUILT_IN: &[(&str, Material)] = &[
    ("steel", material(210e9, 0.30, 7850.0, 11.5e-6, 50.0, 470.0)),
    ("stainless-steel", material(193e9, 0.29, 8000.0, 16.5e-6, 16.0, 500.0)),
    ("cast-iron", material(110e9, 0.26, 7200.0, 10.5e-6, 50.0, 500.0)),
    ("aluminium", material(70e9, 0.33, 2700.0, 23.5e-6, 170.0, 900.0)),
    ("brass", material(105e9, 0.34, 8500.0, 19.0e-6, 120.0, 380.0)),
    ("bronze", material(110e9, 0.34, 8800.0, 17.5e-6, 60.0, 380.0)),
    ("copper", material(120e9, 0.34, 8960.0, 16.8e-6, 390.0, 385.0)),
    ("titanium", material(114e9, 0.34, 4430.0, 8.6e-6, 6.7, 526.0)),
    ("carbide", material(600e9, 0.22, 14_800.0, 5.5e-6, 85.0, 210.0)),
];

/// Doubt about a property that somebody wrote himself. The density and Poisson's ratio of a metal are known
/// better than any deflection.
const OF_AN_ALLOY: Doubt = Doubt::by_factor(
    0.05,
    1.2,
    Grows::Otherwise,
    "properties of an alloy differ from those of the one in the handbook by some percent, and by tens where it is cast",
);

impl Material {
    /// Reads a material from `key`: a name, or a table with every property, or overrides on a `base`.
    pub fn read(table: &Reader, key: &'static str) -> Self {
        Self::read_with(table, key, None)
    }

    /// The same, with conductivity, specific heat and expansion over temperature where the table names records of them.
    /// Of these the material itself has the values at 20 °C.
    pub fn read_over_temperature(table: &Reader, key: &'static str) -> (Self, OverTemperature) {
        let mut over = OverTemperature::default();
        let material = Self::read_with(table, key, Some(&mut over));
        (material, over)
    }

    fn read_with(table: &Reader, key: &'static str, over: Option<&mut OverTemperature>) -> Self {
        let names: Vec<&'static str> = BUILT_IN.iter().map(|m| m.0).collect();
        table.name_or_table(key, "a material's name, or a table of its properties", &names, |name, own| {
            let named = |name: &str| {
                let own = BUILT_IN.iter().find(|m| m.0 == name).map(|m| m.1);
                own.or_else(|| catalogue::named(name).map(|entry| entry.material))
            };
            if let Some(name) = name {
                return named(name).unwrap_or_else(|| {
                    table.problem(key, format!("`{name}` is no material known here"), listed(name));
                    Self::STEEL
                });
            }
            let base = own.text("base", "material whose other properties are taken").and_then(|base| {
                let found = named(&base);
                if found.is_none() {
                    own.problem("base", format!("`{base}` is no material known here"), listed(&base));
                }
                found.or(Some(Self::STEEL))
            });
            // With a base every property may be left out, and the schema allows it.
            Self::read_own(own, base.or(own.is_described().then_some(Self::STEEL)), over)
        })
    }

    /// The same where `key` may be left out for another material.
    pub fn read_or(table: &Reader, key: &'static str, other: &Self) -> Self {
        if !table.has(key) && !table.is_described() {
            return *other;
        }
        let own = Self::read(table, key);
        table.may_be_left_out(key);
        own
    }

    /// The `steel` of the list.
    pub const STEEL: Self = BUILT_IN[0].1;

    fn read_own(own: &Reader, base: Option<Self>, mut over: Option<&mut OverTemperature>) -> Self {
        let mut read = |key, kind: Kind, about, bounds, of: fn(&Self) -> f64| {
            let field = own.quantity(key, kind, about).bounds(bounds);
            let field = if matches!(key, "density" | "poisson_ratio") { field } else { field.estimated(OF_AN_ALLOY) };
            if let Some(over) = &mut over
                && let Some(place) = over.place(key)
            {
                return OverTemperature::read(field, place, base.as_ref().map(of));
            }
            match &base {
                Some(base) => field.or(of(base)),
                None => field.required(),
            }
        };
        // No solid is softer than 1 MPa or stiffer than 5 TPa: beyond that the unit is wrong.
        let solid = Bounds::Within(1e6, 5e12);
        let material = Self {
            youngs_modulus: read("youngs_modulus", PRESSURE, "Young's modulus", solid, |m| m.youngs_modulus),
            poisson_ratio: read("poisson_ratio", CONTRACTION, "Poisson's ratio", Bounds::Within(-1.0, 0.5), |m| {
                m.poisson_ratio
            }),
            density: read("density", MASS_DENSITY, "density", Bounds::Positive, |m| m.density),
            expansion: read("expansion", EXPANSION, "thermal expansion", Bounds::Any, |m| m.expansion),
            conductivity: read("conductivity", CONDUCTIVITY, "heat conductivity", Bounds::Positive, |m| m.conductivity),
            specific_heat: read("specific_heat", SPECIFIC_HEAT, "specific heat", Bounds::Positive, |m| m.specific_heat),
        };
        if let Some(over) = over {
            over.read_reference(own);
        }
        material
    }

    /// G = E / 2(1+ν), Pa.
    pub fn shear_modulus(&self) -> f64 {
        self.youngs_modulus / (2.0 * (1.0 + self.poisson_ratio))
    }
}

/// What to write in the place of a name that is not known.
pub fn listed(name: &str) -> String {
    let of_standards = catalogue::ALL.iter().flat_map(|entry| entry.names.iter().copied());
    let meant = did_you_mean(name, BUILT_IN.iter().map(|own| own.0).chain(of_standards), '"');
    let own: Vec<&str> = BUILT_IN.iter().map(|own| own.0).collect();
    format!(
        "{meant}known are {}, and names of standards such as {}; or give a table of its properties",
        own.join(", "),
        catalogue::ALL.iter().step_by(8).map(|entry| entry.names[0]).collect::<Vec<_>>().join(", ")
    )
}
