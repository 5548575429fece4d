//! The compliance of the system along the shaft, ω(x) = Σ ωᵢ, and its stiffness j(x) = 1/ω(x) [seed 002 (9)-(11)].

use super::super::elastic::{Deflection, Elastic};
use super::super::machine::Machine;
use crate::process::{Column, Figure, Table, first_extreme};
use crate::solve::Condensed;
use crate::units::{LENGTH, STIFFNESS};

/// Parts that yield, each with a compliance of its own; the last where the model draws one.
const PARTS: [&str; 5] = ["shaft", "headstock", "tailstock", "carriage", "structure"];

/// Compliances at places under the force that acts there, m/N: secants where a joint is not a spring.
pub struct Compliance {
    /// Of each of [`PARTS`] at every place.
    parts: Vec<[f64; 5]>,
    /// Of these the machine has so many.
    count: usize,
}

impl Compliance {
    /// `None` where no force acts at some place.
    pub fn of(machine: &Machine, shaft: &Condensed, deflections: &[Deflection]) -> Option<Self> {
        let elastic = Elastic::new(machine, shaft);
        let part = |(i, d): (usize, &Deflection)| {
            // What gives way, and not what stands out of line.
            let ([head, tail], y) = (shaft.influence[i], elastic.yielding(i, d.force).ok()?.displacements);
            let all = [d.shaft, head * y[0], tail * y[1], d.carriage, d.structure];
            (d.force > 0.0).then(|| all.map(|y| y / d.force))
        };
        let is_founded = machine.setup.base.is_some() || machine.setup.imported.is_some();
        let count = if is_founded { PARTS.len() } else { PARTS.len() - 1 };
        Some(Self { parts: deflections.iter().enumerate().map(part).collect::<Option<_>>()?, count })
    }

    /// ω at every place, m/N.
    fn whole(&self) -> Vec<f64> {
        self.parts.iter().map(|parts| parts.iter().sum()).collect()
    }

    /// Where the system is weakest and where stiffest, and what gives way where it is weakest; `None` where it is
    /// rigid.
    pub fn figure(&self, positions: &[f64]) -> Option<Figure> {
        let whole = self.whole();
        let (weakest, stiffest) = (first_extreme(&whole, f64::gt), first_extreme(&whole, f64::lt));
        let most = whole[weakest];
        if most <= 0.0 {
            return None;
        }
        let shares: Vec<(&str, f64)> =
            PARTS.into_iter().zip(self.parts[weakest].map(|part| part / most)).take(self.count).collect();
        let told = shares.iter().filter(|(_, share)| *share > 0.0005);
        let told: Vec<String> = told.map(|(name, share)| format!("{name} {:.1} %", 100.0 * share)).collect();
        let weak = format!(
            "{:.3} at x = {:.1}: {}",
            STIFFNESS.shown(1.0 / most),
            LENGTH.shown(positions[weakest]),
            told.join(", ")
        );
        let mut figure = Figure::new("stiffness", "least stiffness")
            .line(weak)
            .quantity("least", STIFFNESS, 1.0 / most)
            .quantity("x", LENGTH, positions[weakest]);
        if whole[stiffest] > 0.0 {
            figure = figure.quantity("largest", STIFFNESS, 1.0 / whole[stiffest]);
        }
        Some(shares.into_iter().fold(figure, |figure, (name, share)| figure.entry(name, share)))
    }

    /// The compliances of all parts over x, with the whole and its stiffness.
    pub fn table(&self, positions: &[f64]) -> Table {
        let um_per_kn = |si: Vec<f64>| si.iter().map(|v| 1e9 * v).collect();
        let column = |name: &'static str, si: Vec<f64>| Column::numbers(name, Some("um/kN"), um_per_kn(si));
        let mut columns = vec![Column::quantities("x", LENGTH, positions)];
        for (i, name) in PARTS.into_iter().enumerate().take(self.count) {
            columns.push(column(name, self.parts.iter().map(|parts| parts[i]).collect()));
        }
        let whole = self.whole();
        columns.push(Column::quantities("stiffness", STIFFNESS, &whole.iter().map(|v| 1.0 / v).collect::<Vec<_>>()));
        columns.insert(1, column("compliance", whole));
        Table { columns }
    }
}
