//! The structure under the shaft: which of its members and joints give way.

use super::super::base::Base;
use super::super::elastic::Deflection;
use super::super::machine::Machine;
use crate::process::structure::Shares;
use crate::process::{Column, Figure, Table, first_extreme};
use crate::solve::Condensed;
use crate::solve::structure::Displaced;
use crate::units::{LENGTH, STIFFNESS};

/// The structure with the tool at position number `i`, x (m).
pub fn standing<'b>(base: &'b Base, shaft: &Condensed, (i, x): (usize, f64), d: &Deflection) -> Option<Displaced<'b>> {
    let reactions = shaft.reactions_under(i, d.force, &d.moved())?;
    Some(base.under(&reactions, x, d.force, &d.seats[0]))
}

/// What each part adds to the compliance under the tool at every position (m); `None` where there is no structure, or no
/// force at some position.
pub fn shares(machine: &Machine, shaft: &Condensed, positions: &[f64], deflections: &[Deflection]) -> Option<Shares> {
    let base = machine.setup.base.as_ref()?;
    let mut shares = Shares::new(&base.drawn);
    for (i, (x, d)) in positions.iter().zip(deflections).enumerate() {
        if d.force <= 0.0 {
            return None;
        }
        shares.add(&standing(base, shaft, (i, *x), d)?, d.force);
    }
    Some(shares)
}

/// Which parts give way where the structure does so most.
pub fn figure(shares: &Shares, positions: &[f64]) -> Option<Figure> {
    let whole = shares.whole();
    let most = first_extreme(&whole, f64::gt);
    let stiffness = 1.0 / whole.get(most).filter(|own| **own > 0.0)?;
    let at = LENGTH.shown(positions[most]);
    let figure = Figure::new("structure", "structure")
        .line(format!("{:.1} where it is softest, at x = {at:.1}: {}", STIFFNESS.shown(stiffness), shares.told(most)))
        .quantity("stiffness", STIFFNESS, stiffness)
        .quantity("x", LENGTH, positions[most]);
    Some(shares.under(most).into_iter().fold(figure, |figure, (name, share)| figure.entry(name.to_string(), share)))
}

/// The compliance of every part over x.
pub fn table(shares: &Shares, positions: &[f64]) -> Table {
    let x = Column::quantities("x", LENGTH, positions);
    Table { columns: std::iter::once(x).chain(shares.columns()).collect() }
}
