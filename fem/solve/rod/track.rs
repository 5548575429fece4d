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
        let (Some(first), Some(last)) = (self.times.first(), self.times.last()) else { return f64::NAN };
        let time = time.clamp(*first, *last);
        let stretch = self.switches.partition_point(|s| self.times[*s] < time).max(1);
        let (from, to) =
            (self.switches[stretch - 1], *self.switches.get(stretch).unwrap_or(&self.switches[stretch - 1]));
        let times = &self.times[from..=to];
        cubic(time, times.partition_point(|t| *t < time), times.len(), |i| (times[i], values[from + i]))
    }
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
