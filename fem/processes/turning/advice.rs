//! Where to move the tailstock, so that no correction has to follow a taper.

use std::collections::BTreeMap;

use super::machine::Machine;
use super::rows::{PART, X};
use super::setup::Workholding;
use crate::process::{Advice, Rows, spread};
use crate::units::MICRO;

/// A taper is told where it is at least this part of the spread of the mean errors.
const LEAST: f64 = 0.2;

/// The move of the tailstock that takes the straight part of the mean errors of diameters (m) away.
pub fn advice(machine: &Machine, rows: &Rows, errors: &[f64]) -> Vec<Advice> {
    let errors = about_their_parts(rows, errors);
    let (x, count) = (&rows.columns[X], rows.len() as f64);
    let middle = x.iter().sum::<f64>() / count;
    let (square, product) = (0..rows.len()).fold((0.0, 0.0), |(square, product), row| {
        (square + (x[row] - middle).powi(2), product + (x[row] - middle) * errors[row])
    });
    let length = machine.setup.length();
    if machine.setup.workholding != Workholding::Centres || square <= 0.0 {
        return Vec::new();
    }
    let slope = product / square;
    let straight: Vec<f64> = (0..rows.len()).map(|row| errors[row] - slope * (x[row] - middle)).collect();
    let [whole, left] = [&errors, &straight].map(|own| spread(own));
    // A tailstock that stands away from the tool by s leaves 2·s·x/L.
    let away = -0.5 * slope * length;
    if whole - left < LEAST * whole || !away.is_finite() {
        return Vec::new();
    }
    let way = if away > 0.0 { "away from" } else { "towards" };
    let [by, taper, whole, left] = [away.abs(), (slope * length).abs(), whole, left].map(|length| MICRO.shown(length));
    let text = format!(
        "move the tailstock by {by:.1} {way} the tool: a taper of {taper:.1} goes, and diameters differ by {left:.1}, not {whole:.1}"
    );
    vec![Advice::new(text)]
}

/// Errors less the mean of their part, which an offset takes away.
fn about_their_parts(rows: &Rows, errors: &[f64]) -> Vec<f64> {
    let mut parts: BTreeMap<u64, (f64, usize)> = BTreeMap::new();
    let part = |row: usize| rows.columns[PART][row].to_bits();
    for (row, error) in errors.iter().enumerate() {
        let (sum, count) = parts.entry(part(row)).or_default();
        (*sum, *count) = (*sum + error, *count + 1);
    }
    let mean = |row: usize| parts.get(&part(row)).map_or(0.0, |(sum, count)| sum / *count as f64);
    errors.iter().enumerate().map(|(row, error)| error - mean(row)).collect()
}
