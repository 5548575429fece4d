//! Borders of the cells of a structured mesh along one direction.

use super::MeshError;

/// Cells that are smaller near given places. Every given place becomes a border of cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Grading {
    /// Places to grade toward, in the unit of the direction (m, or rad around a ring).
    pub toward: Vec<f64>,
    /// Size of cells far away over that at the places, ≥ 1.
    pub ratio: f64,
    /// Distance over which the size grows, in the unit of the direction.
    pub reach: f64,
}

impl Grading {
    /// Cells of one size.
    pub fn uniform() -> Self {
        Self { toward: Vec::new(), ratio: 1.0, reach: 1.0 }
    }

    fn check(&self, count: usize, stretches: usize) -> Result<(), MeshError> {
        if !(self.ratio >= 1.0 && self.ratio <= 1e6) {
            return Err(MeshError::parameter("ratio of cell sizes", "1 to 1e6", self.ratio));
        }
        if !(self.reach > 0.0 && self.reach.is_finite()) {
            return Err(MeshError::parameter("reach of the grading", "above zero", self.reach));
        }
        if let Some(&place) = self.toward.iter().find(|place| !place.is_finite()) {
            return Err(MeshError::parameter("place to grade toward", "finite", place));
        }
        if count < stretches.max(1) {
            let range = format!("at least {} for the places to grade toward", stretches.max(1));
            return Err(MeshError::parameter("number of cells", range, count as f64));
        }
        Ok(())
    }

    /// Borders of `count` cells from `from` to `to`: count + 1 ascending values.
    ///
    /// # Errors
    /// Fewer cells than stretches between the places, or a grading out of range.
    pub fn line(&self, from: f64, to: f64, count: usize) -> Result<Vec<f64>, MeshError> {
        let mut stops: Vec<f64> = self.toward.iter().copied().filter(|&x| x > from && x < to).collect();
        stops.extend([from, to]);
        let distance = |x: f64| self.toward.iter().map(|place| (x - place).abs()).fold(f64::INFINITY, f64::min);
        self.divide(stops, count, distance)
    }

    /// Borders of `count` cells around a circle (rad): count + 1 ascending values over 2π, the last being the
    /// first.
    ///
    /// # Errors
    /// As [`line`](Self::line).
    pub fn circle(&self, count: usize) -> Result<Vec<f64>, MeshError> {
        let turn = std::f64::consts::TAU;
        let start = self.toward.first().copied().filter(|place| place.is_finite()).unwrap_or(0.0);
        let mut stops: Vec<f64> = self.toward.iter().map(|place| start + (place - start).rem_euclid(turn)).collect();
        stops.extend([start, start + turn]);
        let gap = |x: f64, place: f64| {
            let angle = (x - place).rem_euclid(turn);
            angle.min(turn - angle)
        };
        let distance = |x: f64| self.toward.iter().map(|&place| gap(x, place)).fold(f64::INFINITY, f64::min);
        self.divide(stops, count, distance)
    }

    /// Divides the stretches between `stops` so that cells grow with the distance from the places.
    fn divide(&self, mut stops: Vec<f64>, count: usize, distance: impl Fn(f64) -> f64) -> Result<Vec<f64>, MeshError> {
        stops.sort_by(f64::total_cmp);
        let span = stops[stops.len() - 1] - stops[0];
        stops.dedup_by(|b, a| (*b - *a).abs() <= 1e-9 * span);
        self.check(count, stops.len() - 1)?;
        let density = |x: f64| 1.0 / (1.0 + (self.ratio - 1.0) * (distance(x) / self.reach).min(1.0));
        let stretches: Vec<Stretch> = stops.windows(2).map(|ends| Stretch::new(ends[0], ends[1], &density)).collect();
        let shares = shares(&stretches.iter().map(Stretch::weight).collect::<Vec<_>>(), count);
        let mut borders = vec![stops[0]];
        for (stretch, cells) in stretches.iter().zip(shares) {
            borders.extend((1..=cells).map(|cell| stretch.at(cell as f64 / cells as f64)));
        }
        Ok(borders)
    }
}

/// Samples per stretch of the integrated density of cells.
const SAMPLES: usize = 512;

/// The density of cells integrated along a stretch.
struct Stretch {
    from: f64,
    to: f64,
    integral: Vec<f64>,
}

impl Stretch {
    fn new(from: f64, to: f64, density: &impl Fn(f64) -> f64) -> Self {
        let step = (to - from) / SAMPLES as f64;
        let mut integral = vec![0.0];
        for sample in 0..SAMPLES {
            integral.push(integral[sample] + step * density(from + step * (sample as f64 + 0.5)));
        }
        Self { from, to, integral }
    }

    fn weight(&self) -> f64 {
        self.integral[SAMPLES]
    }

    /// The place below which the part `fraction` of the cells lies.
    fn at(&self, fraction: f64) -> f64 {
        if fraction >= 1.0 {
            return self.to;
        }
        let wanted = fraction * self.weight();
        let sample = self.integral.partition_point(|&below| below <= wanted).clamp(1, SAMPLES);
        let (low, high) = (self.integral[sample - 1], self.integral[sample]);
        let place = (sample - 1) as f64 + (wanted - low) / (high - low);
        self.from + (self.to - self.from) * place / SAMPLES as f64
    }
}

/// `count` shared out in proportion to `weights`, at least one each.
fn shares(weights: &[f64], count: usize) -> Vec<usize> {
    let mut shares = vec![1; weights.len()];
    for _ in weights.len()..count {
        let need = |index: usize| weights[index] / shares[index] as f64;
        let most = (0..weights.len()).max_by(|&a, &b| need(a).total_cmp(&need(b)).then(b.cmp(&a)));
        if let Some(most) = most {
            shares[most] += 1;
        }
    }
    shares
}

/// Stretches in one direction between borders that cells have too, each with as many equal cells.
pub(super) struct Stretches {
    /// m.
    pub borders: Vec<f64>,
    /// Number of cells in each.
    pub cells: Vec<usize>,
}

impl Stretches {
    /// Cells no longer than `size` (m) between ascending `borders` (m).
    pub fn new(borders: Vec<f64>, size: f64) -> Self {
        let cells = borders.windows(2).map(|ends| ((ends[1] - ends[0]) / size - 1e-9).ceil().max(1.0) as usize);
        Self { cells: cells.collect(), borders }
    }

    /// Parts the cells between two places until there are as many as `least`.
    pub fn refine(&mut self, [low, high]: [f64; 2], least: usize) {
        let is_between = |i: &usize| (low..high).contains(&(0.5 * (self.borders[*i] + self.borders[*i + 1])));
        let own: Vec<usize> = (0..self.cells.len()).filter(is_between).collect();
        let count: usize = own.iter().map(|i| self.cells[*i]).sum();
        if count < least && count > 0 {
            own.into_iter().for_each(|i| self.cells[i] *= least.div_ceil(count));
        }
    }

    /// All borders of cells, m.
    pub fn lines(&self) -> Vec<f64> {
        let mut lines = vec![self.borders[0]];
        for (ends, cells) in self.borders.windows(2).zip(&self.cells) {
            let step = (ends[1] - ends[0]) / *cells as f64;
            lines.extend((1..*cells).map(|i| ends[0] + step * i as f64));
            lines.push(ends[1]);
        }
        lines
    }
}
