//! Transfer of a rod at the points of a contour: (s·C + K)⁻¹ of its heat inputs, as probes see it.

use super::contour::Contour;
use super::lanes::{LANES, Lanes};
use super::tridiagonal::Tridiagonal;
use super::{Heater, Probe, RodSystem};

/// A way for heat into a rod.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Inlet {
    /// A source, by its position in the system.
    Source(usize),
    /// Surroundings that are 1 K warmer, by their number.
    Surroundings(usize),
}

/// Everything on which transfers depend but the points.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Body {
    capacity: Tridiagonal,
    conductance: Tridiagonal,
    lost_to: Vec<Vec<f64>>,
    heaters: Vec<(usize, Heater)>,
    /// Node, or number of nodes plus heater, of every source.
    warmed: Vec<usize>,
    inlets: Vec<Inlet>,
    probes: Vec<Probe>,
}

impl Body {
    pub fn new(system: &RodSystem, inlets: Vec<Inlet>, probes: Vec<Probe>) -> Self {
        Self {
            capacity: system.capacity.clone(),
            conductance: system.conductance.clone(),
            lost_to: system.lost_to.clone(),
            heaters: system.heaters.clone(),
            warmed: system.sources.iter().map(|(node, _)| *node).collect(),
            inlets,
            probes,
        }
    }

    /// Number of inlets.
    pub fn inlets(&self) -> usize {
        self.inlets.len()
    }

    /// Transfers from every inlet to every probe per unit, times the weight of each point: for each probe, for each
    /// inlet, all points.
    pub fn transfers(&self, contour: &Contour) -> Vec<Lanes> {
        let nodes = self.capacity.diagonal.len();
        let (points, weights) = (contour.points.as_chunks::<LANES>().0, contour.weights.as_chunks::<LANES>().0);
        let groups = points.len();
        let mut all = vec![Lanes::default(); groups * self.probes.len() * self.inlets.len()];
        let zeros = vec![Lanes::default(); nodes];
        let mut work = Work { carried: zeros.clone(), inverse: zeros.clone(), rises: zeros };
        for (group, (points, weights)) in points.iter().zip(weights).enumerate() {
            let (s, weight) = (Lanes::new(*points), Lanes::new(*weights));
            let heaters: Vec<[Lanes; 2]> = self.heaters.iter().map(|(_, heater)| heater.at(&s)).collect();
            self.eliminate(&s, &heaters, &mut work);
            for (i, inlet) in self.inlets.iter().enumerate() {
                self.solve(*inlet, &heaters, &mut work);
                for (p, probe) in self.probes.iter().enumerate() {
                    let mut seen = Lanes::default();
                    for (node, weight) in &probe.weights {
                        seen.add(&work.rises[*node], *weight);
                    }
                    all[(p * self.inlets.len() + i) * groups + group] = seen.times(&weight);
                }
            }
        }
        all
    }

    /// Eliminates s·C + K from the base on. Off the negative axis some turn of it has a positive definite
    /// real part, so that no pivot vanishes.
    fn eliminate(&self, s: &Lanes, heaters: &[[Lanes; 2]], work: &mut Work) {
        let last = self.capacity.diagonal.len() - 1;
        let entry = |capacity: f64, conductance: f64| {
            Lanes([s.0[0].map(|re| conductance + capacity * re), s.0[1].map(|im| capacity * im)])
        };
        let mut before = Lanes::default();
        for i in 0..=last {
            let mut pivot = entry(self.capacity.diagonal[i], self.conductance.diagonal[i]);
            for ((node, _), [_, held]) in self.heaters.iter().zip(heaters) {
                if *node == i {
                    pivot.add(held, 1.0);
                }
            }
            pivot.add(&before, -1.0);
            let inverse = pivot.inverse();
            work.inverse[i] = inverse;
            if i < last {
                let beside = entry(self.capacity.beside[i], self.conductance.beside[i]);
                let carried = beside.times(&inverse);
                before = carried.times(&beside);
                work.carried[i] = carried;
            }
        }
    }

    /// Solves for the rises of all nodes per unit of an inlet.
    fn solve(&self, inlet: Inlet, heaters: &[[Lanes; 2]], work: &mut Work) {
        let nodes = work.rises.len();
        work.rises.fill(Lanes::default());
        let first = match inlet {
            Inlet::Source(source) => {
                let warmed = self.warmed[source];
                let (node, passed) = match warmed.checked_sub(nodes) {
                    Some(heater) => (self.heaters[heater].0, heaters[heater][0]),
                    None => (warmed, Lanes::ONE),
                };
                work.rises[node] = passed;
                node
            }
            Inlet::Surroundings(around) => {
                work.rises.iter_mut().zip(&self.lost_to[around]).for_each(|(rise, loss)| rise.0[0] = [*loss; LANES]);
                0
            }
        };
        for i in first..nodes - 1 {
            let carried = work.carried[i].times(&work.rises[i]);
            work.rises[i + 1].add(&carried, -1.0);
        }
        let mut after = Lanes::default();
        for i in (0..nodes).rev() {
            let mut rise = work.inverse[i].times(&work.rises[i]);
            rise.add(&work.carried[i].times(&after), -1.0);
            work.rises[i] = rise;
            after = rise;
        }
    }
}

impl Heater {
    /// Part of its power that it passes on, G/(sC + G), and what it adds to its node, G·sC/(sC + G), W/K.
    fn at(&self, s: &Lanes) -> [Lanes; 2] {
        let stored = s.scaled(self.heat_capacity.into());
        let passed = stored.plus(self.contact).inverse().scaled(self.contact.into());
        [passed, stored.times(&passed)]
    }
}

/// Memory of a solve: multipliers to the next node, inverse pivots, and rises.
struct Work {
    carried: Vec<Lanes>,
    inverse: Vec<Lanes>,
    rises: Vec<Lanes>,
}
