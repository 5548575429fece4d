//! Which parts of a structure give way.

use super::draft::Drawn;
use crate::input::Name;
use crate::process::Column;
use crate::solve::structure::Displaced;

/// Shares that are told, at most, and from which size on.
const MOST: usize = 6;
const LEAST: f64 = 0.005;

/// What each member and each joint adds to the compliance under forces, by its strain energy U: 2U/F², m/N.
pub struct Shares {
    names: Vec<Name>,
    /// Number of the name of each member, then of each spring.
    numbers: Vec<usize>,
    /// By name, and force by force.
    of: Vec<Vec<f64>>,
}

impl Shares {
    /// Of a structure that nothing has pushed yet.
    pub fn new(drawn: &Drawn) -> Self {
        let mut names: Vec<Name> = Vec::new();
        let number = |name: &Name| {
            names.iter().position(|own| own == name).unwrap_or_else(|| {
                names.push(name.clone());
                names.len() - 1
            })
        };
        let numbers = drawn.members.iter().chain(&drawn.joints).map(number).collect();
        let of = vec![Vec::new(); names.len()];
        Self { names, numbers, of }
    }

    /// One force more (N) that displaces it.
    pub fn add(&mut self, displaced: &Displaced, force: f64) {
        let (members, springs) = displaced.energies();
        self.of.iter_mut().for_each(|part| part.push(0.0));
        for (part, energy) in self.numbers.iter().zip(members.into_iter().chain(springs)) {
            let of = &mut self.of[*part];
            let last = of.len() - 1;
            of[last] += 2.0 * energy / force.powi(2);
        }
    }

    /// The whole compliance, force by force, m/N.
    pub fn whole(&self) -> Vec<f64> {
        let forces = self.of.first().map_or(0, Vec::len);
        (0..forces).map(|i| self.of.iter().map(|part| part[i]).sum()).collect()
    }

    /// The part of each of the whole under one of the forces, by its number, largest first; none where nothing gives way.
    pub fn under(&self, number: usize) -> Vec<(&Name, f64)> {
        let whole: f64 = self.of.iter().filter_map(|part| part.get(number)).sum();
        if whole <= 0.0 {
            return Vec::new();
        }
        let part = |(name, of): (_, &Vec<f64>)| (name, of[number] / whole);
        let mut shares: Vec<(&Name, f64)> = self.names.iter().zip(&self.of).map(part).collect();
        shares.sort_by(|a, b| b.1.total_cmp(&a.1));
        shares
    }

    /// The largest of them in words.
    pub fn told(&self, number: usize) -> String {
        let shares = self.under(number);
        let told = shares.iter().take(MOST).filter(|(_, share)| *share > LEAST);
        told.map(|(name, share)| format!("{name} {:.0} %", 100.0 * share)).collect::<Vec<_>>().join(", ")
    }

    /// The compliance of every part, force by force.
    pub fn columns(&self) -> impl Iterator<Item = Column> + use<'_> {
        let um_per_kn = |si: &[f64]| si.iter().map(|v| 1e9 * v).collect();
        let part = move |(name, of): (&Name, &Vec<f64>)| Column::numbers(name.clone(), Some("um/kN"), um_per_kn(of));
        self.names.iter().zip(&self.of).map(part)
    }
}
