//! Contours with what they are off by, to be drawn magnified. Plain data, SI units, no knowledge of any
//! file format.

/// A contour in a plane and the curves that stand beside it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// File stem.
    pub name: &'static str,
    /// What is drawn, in a few words.
    pub title: String,
    /// The contour as it should be, its pieces one after the other; their deviations are zero.
    pub nominal: Vec<Vec<Spot>>,
    /// What it is instead, in the order in which people should read it.
    pub curves: Vec<Curve>,
}

/// A curve beside a contour.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// In the legend.
    pub label: String,
    /// Curves of one family share a colour: what is measured and what is predicted of it.
    pub family: usize,
    /// Whether its spots were measured, and stand alone, or are joined to lines.
    pub is_measured: bool,
    /// Lines, one after the other.
    pub pieces: Vec<Vec<Spot>>,
}

/// A place on a contour, and how far off it is there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// (x, y) on the contour, m.
    pub at: [f64; 2],
    /// Along which the deviation is positive: a unit vector, or at a corner of a contour as it should be
    /// what moves both of its sides by one.
    pub outward: [f64; 2],
    /// m.
    pub deviation: f64,
}

impl Spot {
    /// A circle about the origin, closed; radius in m.
    pub fn circle(radius: f64) -> Vec<Self> {
        let spot = |degrees: u32| {
            let outward = [f64::from(degrees).to_radians().cos(), f64::from(degrees).to_radians().sin()];
            Self { at: outward.map(|c| radius * c), outward, deviation: 0.0 }
        };
        (0..=360).map(spot).collect()
    }

    /// Where the spot is drawn when deviations are magnified, m.
    pub fn magnified(&self, magnification: f64) -> [f64; 2] {
        [0, 1].map(|i| self.at[i] + magnification * self.deviation * self.outward[i])
    }

    /// The same place with another deviation (m).
    #[must_use]
    pub fn off_by(self, deviation: f64) -> Self {
        Self { deviation, ..self }
    }
}
