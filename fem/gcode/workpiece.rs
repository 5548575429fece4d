//! How the words of a program lie on the part: which axes, which zero, diameters or radii, and what the part is.

use super::axes::{Across, Axes};
use super::fineness::Fineness;
use super::spot::Spot;

/// A uniform length of the part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// Where it begins, m.
    pub from: f64,
    /// Where it ends, m.
    pub to: f64,
    /// Its level: the radius of a shaft, the height of a top, m.
    pub level: f64,
}

/// The breadth of a top, and of the cutter that mills it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Breadth {
    /// From the middle to either edge of the top, m.
    pub half: f64,
    /// How far beside its middle the cutter reaches, m.
    pub reach: f64,
}

/// Where a program lies on a part, and how finely it is written.
#[derive(Clone, Debug, PartialEq)]
pub struct Workpiece {
    /// The axes.
    pub axes: Axes,
    /// The place on the part at which words are 0; both grow the same way.
    pub zero: Spot,
    /// What words across say before the program says it itself.
    pub across: Across,
    /// How finely words are written.
    pub fineness: Fineness,
    /// How far the level of a block may lie off that of the part where it is still the finished surface, m.
    pub agreement: f64,
    /// The finished part, from its zero.
    pub stretches: Vec<Stretch>,
    /// Its breadth, if its surface is made by tracks beside each other; a turned one has none.
    pub breadth: Option<Breadth>,
    /// Where the finishing pass begins and ends, m, in the way of the tool.
    pub pass: [f64; 2],
    /// Its feed, m per revolution, where it is known.
    pub feed: Option<f64>,
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
/// Least and greatest distance of a finished level from that of the drawing, m.
const AGREEMENT: (f64, f64) = (20e-6, 100e-6);
/// How far a step of a program may lie off that of the model, m: lengths are rounded, and have tolerances of their own.
const STEP_OFF: f64 = 0.2e-3;
/// Most decimals that are written.
const MOST_DECIMALS: f64 = 7.0;

impl Workpiece {
    /// How far a finished level may lie off that of the drawing: half of the last depth of cut (m), for what is left to
    /// cut is no finished surface, within limits of its own; the widest where no depth is known.
    pub fn agreement(depth: Option<f64>) -> f64 {
        depth.map_or(AGREEMENT.1, |depth| (0.5 * depth).clamp(AGREEMENT.0, AGREEMENT.1))
    }

    /// The increment of words in a unit of so many metres.
    pub fn increment(&self, unit: f64) -> Increment {
        let usual = USUAL[usize::from(unit == INCH)];
        let size = self.fineness.increment.map_or(usual, |size| size / unit);
        let decimals = (-size.log10() - 1e-9).ceil().clamp(0.0, MOST_DECIMALS);
        let least = 10f64.powi(-(decimals as i32));
        let times = (size / least).round().max(1.0);
        // What decimals cannot write is written to the next finer of them.
        let size = if (size - times * least).abs() < 1e-6 * size { times * least } else { least };
        Increment { size, decimals: decimals as usize }
    }

    /// Nominal level at a place (m) on the part, m; on a step that of the stretch toward its end.
    pub fn level(&self, x: f64) -> Option<f64> {
        let at = self.stretches.partition_point(|own| own.to <= x).min(self.stretches.len().checked_sub(1)?);
        Some(self.stretches[at].level)
    }

    /// The nominal level next to a given one at a place, m, where a step may stand a little elsewhere than in the
    /// model.
    pub fn level_near(&self, x: f64, r: f64) -> Option<f64> {
        let near = self.stretches.iter().filter(|own| own.from - STEP_OFF <= x && x <= own.to + STEP_OFF);
        near.map(|own| own.level).min_by(|a, b| (a - r).abs().total_cmp(&(b - r).abs()))
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
    use super::super::axes::LATHE;
    use super::*;

    #[test]
    fn increments_are_those_of_the_unit_that_is_written() {
        let of = |increment: Option<f64>, unit: f64| {
            let work = Workpiece {
                axes: LATHE,
                zero: Spot::default(),
                across: Across::Diameter,
                fineness: Fineness { increment, ..Fineness::default() },
                agreement: 1e-4,
                stretches: Vec::new(),
                breadth: None,
                pass: [0.0; 2],
                feed: None,
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
