//! Values that were followed through time, and their reading at any time.

use crate::solve::heat::cubic;

/// A weighted sum over the nodes.
#[derive(Clone, Debug, PartialEq)]
pub struct Probe {
    /// Each node with its weight.
    pub weights: Vec<(usize, f64)>,
}

impl Probe {
    /// The sum over the values of all nodes.
    pub fn read(&self, nodes: &[f64]) -> f64 {
        self.weights.iter().map(|(node, weight)| weight * nodes[*node]).sum()
    }
}

/// Probes read at the end of every step.
#[derive(Clone, Debug, Default)]
pub struct Track {
    /// Times, s, rising.
    pub times: Vec<f64>,
    /// Positions in `times` between which all is smooth.
    pub switches: Vec<usize>,
    /// Value of every probe at every time.
    pub values: Vec<Vec<f64>>,
}

impl Track {
    /// A track of `probes` probes with nothing read yet.
    pub fn new(probes: usize) -> Self {
        Self { values: vec![Vec::new(); probes], ..Self::default() }
    }

    /// Takes one reading of every probe.
    pub fn push(&mut self, time: f64, switched: bool, values: impl Iterator<Item = f64>) {
        if switched {
            self.switches.push(self.times.len());
        }
        self.times.push(time);
        self.values.iter_mut().zip(values).for_each(|(all, value)| all.push(value));
    }

    /// Values (one for every time) at a time between: by the cubic through four times of the same smooth
    /// stretch. Before the first and after the last they stay what they are there.
    pub fn at(&self, values: &[f64], time: f64) -> f64 {
        if self.times.is_empty() {
            return f64::NAN;
        }
        let Smooth { from, times, time, cell } = Smooth::of(&self.times, &self.switches, time);
        cubic(time, cell, times.len(), |i| (times[i], values[from + i]))
    }

    /// Reads instruments with these time constants (s, one for every probe), each reading given by the position of its
    /// probe and its time (s).
    pub fn shown(mut self, lags: impl Iterator<Item = f64>, readings: &[(usize, f64)]) -> Vec<f64> {
        for (lag, values) in lags.zip(&mut self.values) {
            if lag > 0.0 {
                *values = lagged(&self.times, values, lag);
            }
        }
        readings.iter().map(|(probe, time)| self.at(&self.values[*probe], *time)).collect()
    }
}

/// The smooth stretch about a time.
struct Smooth<'t> {
    /// Position of its start in all times.
    from: usize,
    times: &'t [f64],
    /// The time, not beyond the ends.
    time: f64,
    /// The first of `times` that is not before it.
    cell: usize,
}

impl<'t> Smooth<'t> {
    /// Of times with the positions between which all is smooth; there must be one.
    fn of(times: &'t [f64], switches: &[usize], time: f64) -> Self {
        let time = time.clamp(times[0], times[times.len() - 1]);
        let stretch = switches.partition_point(|s| times[*s] < time).max(1);
        let (from, to) = (switches[stretch - 1], *switches.get(stretch).unwrap_or(&switches[stretch - 1]));
        let times = &times[from..=to];
        Self { from, times, time, cell: times.partition_point(|t| *t < time) }
    }
}

/// Positions in `times`, of which there must be one, with the weights by which [`Track::at`] reads them.
pub(super) fn weights(times: &[f64], switches: &[usize], time: f64) -> impl Iterator<Item = (usize, f64)> {
    let Smooth { from, times, time, cell } = Smooth::of(times, switches, time);
    let weight = move |own: usize| cubic(time, cell, times.len(), |i| (times[i], f64::from(u8::from(i == own))));
    // The four are among these.
    let near = cell.saturating_sub(4)..times.len().min(cell + 4);
    near.map(move |i| (from + i, weight(i))).filter(|(_, weight)| *weight != 0.0)
}

/// Values over time as an instrument with this time constant (s) shows them: τ y' = v − y, y = v at the
/// start, exactly where v is straight between the times.
pub fn lagged(times: &[f64], values: &[f64], time_constant: f64) -> Vec<f64> {
    let mut shown: Vec<f64> = values.first().copied().into_iter().collect();
    for (t, v) in times.windows(2).zip(values.windows(2)) {
        let (length, change) = (t[1] - t[0], v[1] - v[0]);
        let before = shown[shown.len() - 1];
        if length > 0.0 {
            let behind = change / length * time_constant;
            shown.push(v[1] - behind + (before - v[0] + behind) * (-length / time_constant).exp());
        } else {
            shown.push(before);
        }
    }
    shown
}
