//! Every part of a batch against what its drawing asks.

use std::collections::BTreeMap;

use super::rows::{DIAMETER, X, part};
use super::setup::Setup;
use super::tolerance::Tolerance;
use crate::process::{Characteristic, Requirement, Rows, range};
use crate::tolerance::Limits;
use crate::units::MICRO;

/// What is asked: limits of the diameter of each section, then forms.
pub fn requirements(setup: &Setup) -> Vec<Requirement> {
    let Tolerance { diameters, taper, cylindricity } = &setup.tolerance;
    let several = setup.segments.len() > 1;
    let of = |number: usize| if several { format!(" of section {}", number + 1) } else { String::new() };
    let diameter = |(number, limits): (usize, &Option<(Limits, String)>)| {
        let (limits, written) = limits.as_ref()?;
        let label = format!("diameter{}, {written}", of(number));
        Some(Requirement { key: "diameter", label, kind: MICRO, limits: *limits })
    };
    let form = |key: &'static str, width: &Option<f64>| {
        let limits = Limits::up_to((*width)?);
        Some(Requirement { key, label: key.into(), kind: MICRO, limits })
    };
    let diameters = diameters.iter().enumerate().filter_map(diameter);
    diameters.chain(form("taper", taper)).chain(form("cylindricity", cylindricity)).collect()
}

/// The limits of the diameter, or of its error, at each row, m.
pub fn limits(setup: &Setup, rows: &Rows) -> Vec<Option<Limits>> {
    let of = |row: usize| {
        let x = rows.get(X, row).unwrap_or(0.0);
        let (limits, _) = setup.tolerance.diameters.get(setup.segment(x))?.as_ref()?;
        Some(limits.about(if rows.observable[row] == DIAMETER { setup.diameter(x) } else { 0.0 }))
    };
    (0..rows.len()).map(of).collect()
}

/// What rows show of each part, section by section.
pub fn characteristics(setup: &Setup, rows: &Rows, values: &[f64]) -> Vec<Characteristic> {
    let Tolerance { diameters, taper, cylindricity } = &setup.tolerance;
    let mut sections: BTreeMap<(usize, usize), Vec<(f64, f64)>> = BTreeMap::new();
    for (row, value) in values.iter().enumerate() {
        let x = rows.get(X, row).unwrap_or(0.0);
        let set = if rows.observable[row] == DIAMETER { setup.diameter(x) } else { 0.0 };
        sections.entry((part(rows, row), setup.segment(x))).or_default().push((x, value - set));
    }
    let of_diameter = |section: usize| {
        diameters.get(section)?.as_ref()?;
        Some(diameters[..section].iter().flatten().count())
    };
    let forms = diameters.iter().flatten().count();
    let mut all = Vec::new();
    for ((part, section), mut errors) in sections {
        errors.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (low, high) = range(errors.iter().map(|(_, error)| *error));
        let mut add = |requirement: usize, range: [f64; 2]| {
            all.push(Characteristic { requirement, part: Some(part), range });
        };
        if let Some(requirement) = of_diameter(section) {
            add(requirement, [low, high]);
        }
        if taper.is_some() {
            let ends = (errors[errors.len() - 1].1 - errors[0].1).abs();
            add(forms, [ends; 2]);
        }
        if cylindricity.is_some() {
            add(forms + usize::from(taper.is_some()), [0.5 * (high - low); 2]);
        }
    }
    all
}
