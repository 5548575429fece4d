//! How long to wait until the rest of the growth is allowed.

use super::machine::Machine;
use super::rows::TIME_OF_ROW;
use crate::process::{Advice, Rows};
use crate::units::{MICRO, TIME};

/// The time after which the length changes by no more than the limits are apart, given growth (m) at rising times.
pub fn advice(machine: &Machine, rows: &Rows, growth: &[f64]) -> Vec<Advice> {
    let Some((limits, _)) = &machine.setup.allowed.within else { return Vec::new() };
    let width = limits.upper - limits.lower;
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    let mut from = None;
    for row in (0..rows.len()).rev() {
        (low, high) = (low.min(growth[row]), high.max(growth[row]));
        if high - low > width {
            break;
        }
        from = Some((row, high - low));
    }
    let times = &rows.columns[TIME_OF_ROW];
    let whole = MICRO.shown(growth.iter().fold(0.0f64, |most, own| most.max(own.abs())));
    let wide = MICRO.shown(width);
    match from {
        None | Some((0, _)) => Vec::new(),
        Some((row, _)) if row + 1 == rows.len() => {
            vec![Advice::new(format!("no waiting brings the rest of the growth within {wide:.1} before the run ends"))]
        }
        Some((row, rest)) => {
            let (time, rest) = (times[row], MICRO.shown(rest));
            let text = format!(
                "wait {} before the size is set: from then to the end the length changes by {rest:.1}, not {whole:.1}",
                TIME.format(time)
            );
            vec![Advice::new(text).taking(time)]
        }
    }
}
