//! The elements of a rod and their matrices.

use super::tridiagonal::Tridiagonal;
use super::{Heater, Power, Probe, Rod, RodError, RodPiece};

/// Places closer than this part of the length are one: a search comes by such, and between them an element would be so
/// fast that the rates of the rod drown in its round-off.
const SAME: f64 = 1e-6;
/// Elements between two places that have a node, at least.
const LEAST: usize = 4;

/// A rod cut into elements, assembled.
#[derive(Clone, Debug)]
pub struct RodSystem {
    /// Places of the nodes, m, rising; two at a joint.
    pub x: Vec<f64>,
    /// Heat capacity, J/K.
    pub(super) capacity: Tridiagonal,
    /// Conduction and loss, W/K.
    pub(super) conductance: Tridiagonal,
    /// Heat to surroundings that are 1 K colder, W/K; of every node, then of every heater.
    pub(super) losses: Vec<f64>,
    /// The same, of every node, by the surroundings that it is lost to.
    pub(super) lost_to: Vec<Vec<f64>>,
    /// Heat capacity of every node, then of every heater, J/K.
    pub(super) stores: Vec<f64>,
    /// Powers of the sources, each with the node, or the number of nodes plus that of the heater, that it warms.
    pub(super) sources: Vec<(usize, Power)>,
    /// Heaters with the nodes that they warm.
    pub(super) heaters: Vec<(usize, Heater)>,
    /// First and last node of every stretch along which the temperature is smooth.
    stretches: Vec<[usize; 2]>,
}

impl RodSystem {
    /// Cuts a rod into elements no longer than `size` (m).
    ///
    /// # Errors
    /// A value out of range.
    pub fn new(rod: &Rod, size: f64) -> Result<Self, RodError> {
        rod.check()?;
        if !(size > 0.0 && size.is_finite()) {
            return Err(RodError::Value("the size of the elements (m)", size));
        }
        let breaks = breaks(rod);
        let slack = SAME * rod.length();
        let mut system = Nodes::default();
        for ends in breaks.windows(2) {
            system.stretch(ends[0], ends[1], size, rod.joints.iter().any(|j| (j.at - ends[0]).abs() <= slack));
        }
        Ok(system.assemble(rod, slack))
    }

    /// The rise at `x` (m); exactly at a joint that of the side of the base.
    pub fn at(&self, x: f64) -> Probe {
        let last = self.stretches.len() - 1;
        let own = self.stretches.iter().position(|s| x <= self.x[s[1]]).unwrap_or(last);
        let [first, end] = self.stretches[own];
        let cell = first + self.x[first..=end].partition_point(|node| *node < x);
        // The cubic through four nodes of the stretch, two on either side where there are two.
        let start = cell.saturating_sub(2).clamp(first, end.saturating_sub(3).max(first));
        let nodes = start..(start + 4).min(end + 1);
        let weight = |i: usize| {
            let others = nodes.clone().filter(|j| *j != i);
            (i, others.map(|j| (x - self.x[j]) / (self.x[i] - self.x[j])).product())
        };
        Probe { weights: nodes.clone().map(weight).collect() }
    }

    /// ∫ θ dx up to `x` (m), K·m.
    pub fn integral_to(&self, x: f64) -> Probe {
        let mut weights = vec![0.0; self.x.len()];
        for (i, ends) in self.x.windows(2).enumerate() {
            let length = ends[1] - ends[0];
            let part = ((x - ends[0]) / length).clamp(0.0, 1.0);
            // A joint has no length.
            if length > 0.0 {
                weights[i] += length * part * (1.0 - 0.5 * part);
                weights[i + 1] += length * 0.5 * part * part;
            }
        }
        Probe { weights: weights.into_iter().enumerate().filter(|(_, w)| *w != 0.0).collect() }
    }

    /// Times (s) at which a source is switched.
    pub(super) fn switches(&self) -> impl Iterator<Item = f64> + '_ {
        self.sources.iter().flat_map(|(_, power)| power.switches())
    }
}

/// Places that need a node: ends of pieces, sources and joints, rising.
fn breaks(rod: &Rod) -> Vec<f64> {
    let mut ends = vec![0.0];
    for piece in &rod.pieces {
        ends.push(ends[ends.len() - 1] + piece.length);
    }
    let length = rod.length();
    let places = rod.joints.iter().map(|j| j.at).chain(rod.sources.iter().map(|s| s.at));
    ends.extend(places.chain(rod.films.iter().flat_map(|f| f.ends)).map(|at| at.min(length)));
    ends.sort_by(f64::total_cmp);
    ends.dedup_by(|b, a| *b - *a <= SAME * length);
    ends
}

#[derive(Default)]
struct Nodes {
    x: Vec<f64>,
    stretches: Vec<[usize; 2]>,
}

impl Nodes {
    /// Adds a stretch with its own first node where a joint parts it from the one before.
    fn stretch(&mut self, from: f64, to: f64, size: f64, parted: bool) {
        let count = ((to - from) / size).ceil().max(LEAST as f64) as usize;
        if self.x.is_empty() || parted {
            self.x.push(from);
        }
        let first = self.x.len() - 1;
        self.x.extend((1..=count).map(|i| if i == count { to } else { from + (to - from) * i as f64 / count as f64 }));
        self.stretches.push([first, self.x.len() - 1]);
    }

    fn assemble(self, rod: &Rod, slack: f64) -> RodSystem {
        let size = self.x.len();
        let (mut capacity, mut conductance) = (Tridiagonal::zeros(size), Tridiagonal::zeros(size));
        let surroundings = 1 + rod.films.iter().map(|f| f.around).fold(rod.base_around, usize::max);
        let mut losses = vec![Tridiagonal::zeros(size); surroundings];
        let near = |at: f64, node: usize| (at - self.x[node]).abs() <= slack;
        for i in 0..size - 1 {
            let length = self.x[i + 1] - self.x[i];
            if length == 0.0 {
                // Several joints at one place resist one after another.
                let resistance: f64 = rod.joints.iter().filter(|j| near(j.at, i)).map(|j| 1.0 / j.conductance).sum();
                conductance.add_pair(i, 1.0 / resistance, -1.0 / resistance);
                continue;
            }
            let piece = piece_at(rod, 0.5 * (self.x[i] + self.x[i + 1]));
            let stored = piece.heat_capacity * length;
            capacity.add_pair(i, stored * 5.0 / 12.0, stored / 12.0);
            conductance.add_pair(i, piece.conductance / length, -piece.conductance / length);
            let middle = 0.5 * (self.x[i] + self.x[i + 1]);
            let own = rod.films.iter().filter(|f| f.ends[0] <= middle && middle < f.ends[1]);
            for (around, loss) in own.map(|f| (f.around, f.loss)).chain([(0, piece.loss)]) {
                losses[around].add_pair(i, loss * length * 5.0 / 12.0, loss * length / 12.0);
            }
        }
        losses[rod.base_around].diagonal[0] += rod.base;
        for losses in &losses {
            conductance.diagonal.iter_mut().zip(&losses.diagonal).for_each(|(own, loss)| *own += loss);
            conductance.beside.iter_mut().zip(&losses.beside).for_each(|(own, loss)| *own += loss);
        }
        let node = |at: f64| (0..size).find(|i| near(at.min(self.x[size - 1]), *i)).unwrap_or(size - 1);
        let lost_to: Vec<Vec<f64>> = losses.iter().map(Tridiagonal::row_sums).collect();
        let of_node = |i: usize| lost_to.iter().map(|losses| losses[i]).sum();
        let (mut losses, mut stores): (Vec<f64>, _) = ((0..size).map(of_node).collect(), capacity.row_sums());
        let (mut sources, mut heaters) = (Vec::new(), Vec::new());
        for source in &rod.sources {
            let own = node(source.at);
            let Some(heater) = source.heater else {
                sources.push((own, source.power.clone()));
                continue;
            };
            sources.push((size + heaters.len(), source.power.clone()));
            heaters.push((own, heater.no_faster_than_seen()));
            losses.push(0.0);
            stores.push(heater.heat_capacity);
        }
        let Self { x, stretches } = self;
        RodSystem { x, capacity, conductance, losses, lost_to, stores, sources, heaters, stretches }
    }
}

fn piece_at(rod: &Rod, x: f64) -> &RodPiece {
    let mut end = 0.0;
    let inside = |p: &&RodPiece| {
        end += p.length;
        x < end
    };
    rod.pieces.iter().find(inside).unwrap_or(&rod.pieces[rod.pieces.len() - 1])
}
