//! What a material resists with.

/// An isotropic, linear material. SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Young's modulus E, Pa.
    pub youngs_modulus: f64,
    /// Poisson's ratio ν.
    pub poisson_ratio: f64,
    /// Density ρ, kg/m³.
    pub density: f64,
    /// Thermal expansion α, 1/K.
    pub expansion: f64,
    /// Conductivity k, W/(m K).
    pub conductivity: f64,
    /// Specific heat c, J/(kg K).
    pub specific_heat: f64,
}

/// A material in SI units.
pub const fn material(
    youngs_modulus: f64,
    poisson_ratio: f64,
    density: f64,
    expansion: f64,
    conductivity: f64,
    specific_heat: f64,
) -> Material {
    Material { youngs_modulus, poisson_ratio, density, expansion, conductivity, specific_heat }
}
