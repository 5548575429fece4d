//! Properties over temperature.
//!
//! ```text
//!   C₀ u̇ + K₀ θ + H T = f,   u = ∫ c dT / c₀,   θ = ∫ k dT / k₀
//! ```
//!
//! u is the enthalpy in kelvin of the capacity at the start, θ Kirchhoff's transformed temperature. Both are taken at the
//! nodes and interpolated like the temperature itself (product approximation, Christie et al. 1981), which keeps the order of
//! the elements: the matrices stay those of the start, and no heat is lost.

use super::ThermalError;

/// The integral of a property over temperature, by its value at the start: the rise itself where the property does not
/// change.
#[derive(Clone, Debug, PartialEq)]
pub struct Potential {
    /// Value of the property at the start.
    scale: f64,
    pieces: Vec<Piece>,
    /// Rises between which the property is known, K.
    span: [f64; 2],
}

/// A stretch of rises from `from` on: own + slope s + curvature s²/2, s the way from there.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Piece {
    from: f64,
    own: f64,
    slope: f64,
    curvature: f64,
}

impl Potential {
    /// Of a property that does not change.
    pub fn constant(value: f64) -> Self {
        let piece = Piece { from: 0.0, own: 0.0, slope: 1.0, curvature: 0.0 };
        Self { scale: value, pieces: vec![piece], span: [f64::NEG_INFINITY, f64::INFINITY] }
    }

    /// Of a property at rises (K, growing), straight between them and the same beyond the ends.
    pub fn of(points: &[[f64; 2]]) -> Self {
        Self::joined(points, |[from, slope], steepness| Piece { from, own: 0.0, slope, curvature: steepness })
    }

    /// Of a property that is given by its means from `reference` to rises (K, growing): mean times way is the integral.
    pub fn of_means(points: &[[f64; 2]], reference: f64) -> Self {
        Self::joined(points, |[from, mean], steepness| {
            let slope = mean + steepness * (from - reference);
            Piece { from, own: 0.0, slope, curvature: 2.0 * steepness }
        })
    }

    /// Pieces from point to point, each made of its first point and of how steeply the values rise to the next; by the slope
    /// at the start, where the sum is zero.
    fn joined(points: &[[f64; 2]], piece: impl Fn([f64; 2], f64) -> Piece) -> Self {
        let steepness = |i: usize| {
            let next = points.get(i + 1);
            next.map_or(0.0, |next| (next[1] - points[i][1]) / (next[0] - points[i][0]))
        };
        let mut pieces: Vec<Piece> = (0..points.len()).map(|i| piece(points[i], steepness(i))).collect();
        for i in 1..pieces.len() {
            pieces[i].own = pieces[i - 1].at(pieces[i].from).0;
        }
        // Before the first point as at it.
        let first = Piece { curvature: 0.0, ..pieces[0] };
        pieces.insert(0, first);
        let mut all = Self { scale: 1.0, pieces, span: [points[0][0], points[points.len() - 1][0]] };
        let (own, slope) = all.at(0.0);
        // Only an expansion can be none at the start: it is left by kelvin then.
        all.scale = if slope == 0.0 { 1.0 } else { slope };
        for piece in &mut all.pieces {
            *piece = Piece {
                own: (piece.own - own) / all.scale,
                slope: piece.slope / all.scale,
                curvature: piece.curvature / all.scale,
                ..*piece
            };
        }
        all
    }

    /// Value of the property at the start.
    pub fn scale(&self) -> f64 {
        self.scale
    }

    /// Rises between which the property is known, K.
    pub fn span(&self) -> [f64; 2] {
        self.span
    }

    /// At a rise (K): the integral (K), and the property by its value at the start.
    pub fn at(&self, rise: f64) -> (f64, f64) {
        let next = self.pieces[1..].partition_point(|piece| piece.from <= rise);
        self.pieces[next].at(rise)
    }

    /// The rise (K) at which the integral has a value (K), and what a kelvin of that adds to it. The property is above zero.
    pub fn inverse(&self, own: f64) -> (f64, f64) {
        let next = self.pieces[1..].partition_point(|piece| piece.own <= own);
        let Piece { from, own: start, slope, curvature } = self.pieces[next];
        // The root that stays good where the curvature is none.
        let steepness = (slope * slope + 2.0 * curvature * (own - start)).max(0.0).sqrt();
        (from + 2.0 * (own - start) / (slope + steepness), steepness.recip())
    }

    /// Whether the property is above zero wherever it is known, and finite: it is so at both ends of every piece.
    fn is_positive(&self) -> bool {
        let ends = self.pieces.windows(2).map(|pair| pair[0].at(pair[1].from).1);
        let mut all = self.pieces.iter().map(|piece| piece.slope).chain(ends);
        self.scale > 0.0 && all.all(|slope| slope > 0.0 && slope.is_finite())
    }
}

impl Piece {
    /// Value and slope at a rise.
    fn at(&self, rise: f64) -> (f64, f64) {
        let way = rise - self.from;
        (self.own + way * (self.slope + 0.5 * self.curvature * way), self.slope + self.curvature * way)
    }
}

/// What a body's heat follows where its properties change with its temperature.
#[derive(Clone, Debug, PartialEq)]
pub struct Properties {
    /// ∫ k dT / k₀.
    pub conductivity: Potential,
    /// ∫ c dT / c₀.
    pub heat_capacity: Potential,
    /// Rises between which all that follows the temperature is known, K.
    pub known: [f64; 2],
}

impl Properties {
    /// # Errors
    /// A property that is zero or below somewhere.
    pub(super) fn check(&self) -> Result<(), ThermalError> {
        for (potential, quantity) in
            [(&self.conductivity, "conductivity (W/(m K))"), (&self.heat_capacity, "heat capacity (J/(m³ K))")]
        {
            ThermalError::check(potential.is_positive(), quantity, "above zero", potential.scale())?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::Potential;

    /// Simpson's rule over many pieces, which shares nothing with the sums above.
    fn integral(property: impl Fn(f64) -> f64, to: f64) -> f64 {
        let count = 20_000;
        let step = to / f64::from(count);
        let own = |i: i32| {
            let x = f64::from(i) * step;
            (property(x) + 4.0 * property(x + 0.5 * step) + property(x + step)) * step / 6.0
        };
        (0..count).map(own).sum()
    }

    fn straight(points: &[[f64; 2]], x: f64) -> f64 {
        let next = points.iter().position(|p| p[0] > x).unwrap_or(points.len() - 1).max(1);
        let [[x0, y0], [x1, y1]] = [points[next - 1], points[next]];
        y0 + (y1 - y0) * ((x - x0) / (x1 - x0)).clamp(0.0, 1.0)
    }

    const POINTS: [[f64; 2]; 4] = [[-20.0, 52.0], [80.0, 50.0], [180.0, 44.0], [480.0, 38.0]];

    #[test]
    fn a_potential_is_the_integral_of_its_property() {
        let potential = Potential::of(&POINTS);
        let start = straight(&POINTS, 0.0);
        for rise in [-60.0, -20.0, -7.0, 0.0, 33.0, 80.0, 130.0, 480.0, 700.0] {
            let (own, slope) = potential.at(rise);
            let expected = integral(|x| straight(&POINTS, x) / start, rise);
            assert!((own - expected).abs() < 1e-6, "{rise}: {own} {expected}");
            assert!((slope - straight(&POINTS, rise) / start).abs() < 1e-12, "{rise}");
            let (back, inverse) = potential.inverse(own);
            assert!((back - rise).abs() < 1e-9, "{rise}: {back}");
            assert!((inverse * slope - 1.0).abs() < 1e-9, "{rise}");
        }
    }

    #[test]
    fn means_from_a_reference_times_the_way_are_the_integral() {
        let means = [[0.0, 11.1e-6], [80.0, 12.1e-6], [180.0, 12.9e-6]];
        let potential = Potential::of_means(&means, -20.0);
        let whole = |rise: f64| straight(&means, rise) * (rise + 20.0);
        for rise in [0.0, 40.0, 80.0, 150.0, 180.0] {
            let grown = potential.scale() * potential.at(rise).0;
            assert!((grown - (whole(rise) - whole(0.0))).abs() < 1e-15, "{rise}: {grown}");
        }
    }
}
