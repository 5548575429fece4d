//! Contours with what they are off by, to be drawn magnified. Plain data, SI units, no knowledge of any
//! file format.

/// A contour in a plane and the curves that stand beside it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Drawing {
    /// File stem.
    pub name: &'static str,
    /// Subject, in a few words.
    pub title: String,
    /// The contour as it should be, its pieces one after the other; their deviations are zero.
    pub nominal: Vec<Vec<Spot>>,
    /// The contour as predicted or measured, in the order in which people should read the curves.
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

/// Chords over which a contour is asked whether it folds back, as a part of half of its size.
const CHORD: f64 = 0.04;
/// Smallest cosine of the turn within a chord: sharper corners are corners, whose sides may cross.
const CORNER: f64 = 0.5;

impl Drawing {
    /// The magnification at which what is drawn begins to fold back: where a deviation reaches the centre of
    /// curvature. Lines of equal deviation on either side, as far off as the largest, count too.
    pub fn folds_at(&self) -> f64 {
        let spots = || self.nominal.iter().chain(self.curves.iter().flat_map(|c| &c.pieces)).flatten();
        let largest = spots().fold(0.0f64, |most, s| most.max(s.deviation.abs()));
        let reach = |i: usize| {
            let [low, high] = [f64::min, f64::max].map(|pick| spots().map(|s| s.at[i]).reduce(pick).unwrap_or(0.0));
            0.5 * (high - low)
        };
        let chord = CHORD * reach(0).max(reach(1));
        let beside = self
            .nominal
            .iter()
            .flat_map(|piece| [-largest, largest].map(|off| piece.iter().map(|s| s.off_by(off)).collect::<Vec<_>>()));
        let curves = self.curves.iter().filter(|c| !c.is_measured).flat_map(|c| c.pieces.iter().cloned());
        beside.chain(curves).map(|piece| folds_at(&piece, chord)).fold(f64::INFINITY, f64::min)
    }
}

/// The magnification at which a line folds back over some chord of such a length (m).
fn folds_at(line: &[Spot], chord: f64) -> f64 {
    let mut least = f64::INFINITY;
    let mut ahead = 0;
    for (i, a) in line.iter().enumerate() {
        let apart = |b: &Spot| (b.at[0] - a.at[0]).hypot(b.at[1] - a.at[1]);
        ahead = ahead.max(i);
        while ahead < line.len() && apart(&line[ahead]) < chord {
            ahead += 1;
        }
        let Some(b) = line.get(ahead) else { break };
        let turn = a.outward[0] * b.outward[0] + a.outward[1] * b.outward[1];
        if turn < CORNER {
            continue;
        }
        // d·(d + M·e) = 0, with e by what the ends move apart for each time of magnification.
        let d = [0, 1].map(|c| b.at[c] - a.at[c]);
        let e = [0, 1].map(|c| b.deviation * b.outward[c] - a.deviation * a.outward[c]);
        let closing = d[0] * e[0] + d[1] * e[1];
        if closing < 0.0 {
            least = least.min(-(d[0] * d[0] + d[1] * d[1]) / closing);
        }
    }
    least
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

/// Largest of 1, 2 and 5 times a power of ten that is not above `value`.
pub fn round_below(value: f64) -> f64 {
    let power = 10f64.powf(value.log10().floor());
    let digit = value / power;
    // The comparison allows for round-off, so that 2 stays 2.
    power * [5.0, 2.0].into_iter().find(|d| digit * (1.0 + 1e-12) >= *d).unwrap_or(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_circle_folds_where_its_deviation_reaches_the_centre() {
        let nominal = Spot::circle(0.05);
        let inwards = nominal.iter().map(|s| s.off_by(-20e-6)).collect();
        let curve = Curve { label: String::new(), family: 0, is_measured: false, pieces: vec![inwards] };
        let mut drawing = Drawing { nominal: vec![nominal], curves: vec![curve], ..Drawing::default() };
        assert!((drawing.folds_at() / (0.05 / 20e-6) - 1.0).abs() < 1e-9, "{}", drawing.folds_at());
        // A square has corners and does not fold; without deviations nothing does.
        let corner = |x: f64, y: f64| Spot { at: [x, y], outward: [x, y], deviation: -0.1 };
        drawing.nominal = vec![vec![corner(1.0, 1.0), corner(-1.0, 1.0), corner(-1.0, -1.0), corner(1.0, -1.0)]];
        drawing.curves.clear();
        assert_eq!(drawing.folds_at(), f64::INFINITY);
    }

    #[test]
    fn round_numbers_are_not_above() {
        for (value, round) in [(2.0, 2.0), (1.99, 1.0), (4.9e3, 2e3), (5.0e-7, 5e-7), (9.99, 5.0)] {
            assert!((round_below(value) / round - 1.0).abs() < 1e-12, "{value}");
        }
    }
}
