//! How the words of a program lie on the part: which axes, which zero, diameters or radii, and what the part is.

/// Letters of the words of two axes, in capitals.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Axes {
    /// The axis whose words are corrected, and that along the part.
    pub letters: [u8; 2],
    /// Words that count on from where the tool stands, of the same two.
    pub steps: [u8; 2],
    /// Words of the centre of an arc, of the same two.
    pub centres: [u8; 2],
}

/// The axes of a lathe: X across, Z along.
pub const LATHE: Axes = Axes { letters: *b"XZ", steps: *b"UW", centres: *b"IK" };

/// What a word across the part says.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Across {
    /// A diameter.
    Diameter,
    /// A radius.
    Radius,
}

impl Across {
    /// Radius for each unit of a word.
    pub fn share(self) -> f64 {
        match self {
            Self::Diameter => 0.5,
            Self::Radius => 1.0,
        }
    }
}

/// A uniform length of the part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// Where it begins, m.
    pub from: f64,
    /// Where it ends, m.
    pub to: f64,
    /// Its radius, m.
    pub radius: f64,
}

/// Where a program lies on a part, and how finely it is written.
#[derive(Clone, Debug, PartialEq)]
pub struct Workpiece {
    /// The axes.
    pub axes: Axes,
    /// The place on the part at which the word along it is 0, m; both grow the same way.
    pub zero: f64,
    /// What words across say before the program says it itself.
    pub across: Across,
    /// How far straight lines may lie off the contour that they stand for, m.
    pub chord_tolerance: f64,
    /// Least increment of words across, m; that of most controls if none is stated.
    pub increment: Option<f64>,
    /// How far the radius of a block may lie off that of the part where it is still the finished surface, m.
    pub agreement: f64,
    /// The finished part, from its zero.
    pub stretches: Vec<Stretch>,
    /// Where the finishing pass begins and ends, m, in the way of the tool.
    pub pass: [f64; 2],
    /// Its feed, m per revolution.
    pub feed: f64,
}

/// Steps in which words are written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Increment {
    /// Size, in units of the word.
    pub size: f64,
    /// Decimals that it needs.
    pub decimals: usize,
}

/// Millimetres and inches, m.
pub const MM: f64 = 1e-3;
pub const INCH: f64 = 25.4e-3;
/// Least increment of controls in millimetres and in inches (increment system IS-B), in those units.
const USUAL: [f64; 2] = [1e-3, 1e-4];
/// How far a step of a program may lie off that of the model, m: lengths are rounded, and have tolerances of their own.
const STEP_OFF: f64 = 0.2e-3;
/// Most decimals that are written.
const MOST_DECIMALS: f64 = 7.0;

impl Workpiece {
    /// The increment of words in a unit of so many metres.
    pub fn increment(&self, unit: f64) -> Increment {
        let usual = USUAL[usize::from(unit == INCH)];
        let size = self.increment.map_or(usual, |size| size / unit);
        let decimals = (-size.log10() - 1e-9).ceil().clamp(0.0, MOST_DECIMALS);
        let least = 10f64.powi(-(decimals as i32));
        let times = (size / least).round().max(1.0);
        // What decimals cannot write is written to the next finer of them.
        let size = if (size - times * least).abs() < 1e-6 * size { times * least } else { least };
        Increment { size, decimals: decimals as usize }
    }

    /// Nominal radius at a place (m) on the part, m; on a step that of the stretch toward its end.
    pub fn radius(&self, x: f64) -> Option<f64> {
        let at = self.stretches.partition_point(|own| own.to <= x).min(self.stretches.len().checked_sub(1)?);
        Some(self.stretches[at].radius)
    }

    /// The nominal radius next to a given one at a place, m, where a step may stand a little elsewhere than in the model.
    pub fn radius_near(&self, x: f64, r: f64) -> Option<f64> {
        let near = self.stretches.iter().filter(|own| own.from - STEP_OFF <= x && x <= own.to + STEP_OFF);
        near.map(|own| own.radius).min_by(|a, b| (a - r).abs().total_cmp(&(b - r).abs()))
    }

    /// Smallest and largest place of the pass, m.
    pub fn ends(&self) -> (f64, f64) {
        (self.pass[0].min(self.pass[1]), self.pass[0].max(self.pass[1]))
    }
}

impl Increment {
    /// The nearest number that is a whole number of increments.
    pub fn round(self, value: f64) -> f64 {
        (value / self.size).round() * self.size
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn increments_are_those_of_the_unit_that_is_written() {
        let of = |increment: Option<f64>, unit: f64| {
            let work = Workpiece {
                axes: LATHE,
                zero: 0.0,
                across: Across::Diameter,
                chord_tolerance: 1e-6,
                increment,
                agreement: 1e-4,
                stretches: Vec::new(),
                pass: [0.0; 2],
                feed: 1e-4,
            };
            let found = work.increment(unit);
            (format!("{:.8}", found.size), found.decimals)
        };
        for (increment, unit, size, decimals) in [
            (None, MM, "0.00100000", 3),
            (None, INCH, "0.00010000", 4),
            (Some(0.1e-6), MM, "0.00010000", 4),
            (Some(0.5e-6), MM, "0.00050000", 4),
            (Some(10e-6), MM, "0.01000000", 2),
            // A micrometre is 0.0000394 in.
            (Some(1e-6), INCH, "0.00001000", 5),
        ] {
            assert_eq!(of(increment, unit), (size.into(), decimals), "{increment:?} {unit}");
        }
    }
}
