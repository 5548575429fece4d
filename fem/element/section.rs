//! Cross-sections of beams and their shear coefficients after Cowper (1966).

use std::f64::consts::PI;

/// A round section, hollow where the bore is above zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Round {
    /// Outer diameter, m.
    pub diameter: f64,
    /// Diameter of the bore, m; 0 for a solid section.
    pub bore: f64,
}

impl Round {
    /// Area, m².
    pub fn area(&self) -> f64 {
        PI / 4.0 * (self.diameter - self.bore) * (self.diameter + self.bore)
    }

    /// Second moment of area, m⁴: π(D⁴ − d⁴)/64. (Handbooks round π/64 to 0.05, 1.9 % too much.)
    pub fn inertia(&self) -> f64 {
        let (outer, inner) = (self.diameter.powi(2), self.bore.powi(2));
        PI / 64.0 * (outer - inner) * (outer + inner)
    }

    /// κ = 6(1+ν)(1+m²)² / [(7+6ν)(1+m²)² + (20+12ν)m²], m = bore/diameter.
    pub fn shear_coefficient(&self, poisson_ratio: f64) -> f64 {
        let (nu, m2) = (poisson_ratio, (self.bore / self.diameter).powi(2));
        let square = (1.0 + m2).powi(2);
        6.0 * (1.0 + nu) * square / ((7.0 + 6.0 * nu) * square + (20.0 + 12.0 * nu) * m2)
    }
}

/// A solid rectangular section.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectangle {
    /// Width across the force, m.
    pub width: f64,
    /// Height along the force, m.
    pub height: f64,
}

impl Rectangle {
    /// Area, m².
    pub fn area(&self) -> f64 {
        self.width * self.height
    }

    /// Second moment of area, m⁴.
    pub fn inertia(&self) -> f64 {
        self.width * self.height.powi(3) / 12.0
    }

    /// κ = 10(1+ν)/(12+11ν).
    pub fn shear_coefficient(&self, poisson_ratio: f64) -> f64 {
        10.0 * (1.0 + poisson_ratio) / (12.0 + 11.0 * poisson_ratio)
    }
}

/// A rectangular tube of even wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tube {
    /// The rectangle around it.
    pub outline: Rectangle,
    /// Thickness of the wall, m.
    pub wall: f64,
}

impl Tube {
    fn hollow(&self) -> Rectangle {
        let Rectangle { width, height } = self.outline;
        Rectangle { width: width - 2.0 * self.wall, height: height - 2.0 * self.wall }
    }

    /// Area, m².
    pub fn area(&self) -> f64 {
        self.outline.area() - self.hollow().area()
    }

    /// Second moment of area, m⁴.
    pub fn inertia(&self) -> f64 {
        self.outline.inertia() - self.hollow().inertia()
    }

    /// κ of a thin-walled box: with b and h between the middles of the walls and m = n = b/h for an even wall,
    /// κ = 10(1+ν)(1+3m)² / [12+72m+150m²+90m³ + ν(11+66m+135m²+90m³) + 10n²((3+ν)m+3m²)].
    pub fn shear_coefficient(&self, poisson_ratio: f64) -> f64 {
        let (nu, m) = (poisson_ratio, (self.outline.width - self.wall) / (self.outline.height - self.wall));
        let (m2, m3) = (m * m, m * m * m);
        let across = 10.0 * m2 * ((3.0 + nu) * m + 3.0 * m2);
        let own = 12.0 + 72.0 * m + 150.0 * m2 + 90.0 * m3 + nu * (11.0 + 66.0 * m + 135.0 * m2 + 90.0 * m3);
        10.0 * (1.0 + nu) * (1.0 + 3.0 * m).powi(2) / (own + across)
    }
}
