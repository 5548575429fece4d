//! Taper and form of a profile.

use crate::process::{Figure, first_extreme};
use crate::units::{LENGTH, MICRO};

/// A profile that varies by less than a nanometre is a cylinder.
const STRAIGHT: f64 = 1e-9;
/// A taper that three digits of a micrometre do not show, m.
const NO_TAPER: f64 = 5e-10;

/// Slope of the least-squares line through a profile (x rising), m/m, and its value at x = 0, m.
fn line(positions: &[f64], errors: &[f64]) -> (f64, f64) {
    let n = errors.len() as f64;
    let (x_mean, e_mean) = (positions.iter().sum::<f64>() / n, errors.iter().sum::<f64>() / n);
    let (mut sxx, mut sxe) = (0.0, 0.0);
    for (x, e) in positions.iter().zip(errors) {
        sxx += (x - x_mean).powi(2);
        sxe += (x - x_mean) * (e - e_mean);
    }
    let slope = sxe / sxx;
    (slope, e_mean - slope * x_mean)
}

/// The difference between the ends of a profile by its least-squares line.
pub fn taper(positions: &[f64], errors: &[f64]) -> Figure {
    let over = positions[positions.len() - 1] - positions[0];
    let rise = line(positions, errors).0 * over;
    let (size, length) = (MICRO.shown(rise.abs()), LENGTH.shown(over));
    let thick = if rise > 0.0 { "tailstock end" } else { "headstock end" };
    let text = match rise.abs() < NO_TAPER {
        true => format!("none over {length:.1}"),
        false => format!("{size:.3} over {length:.1} by the least-squares line, larger at the {thick}"),
    };
    Figure::new("taper", "taper, part 1").line(text).quantity("value", MICRO, rise).quantity("over", LENGTH, over)
}

/// The form of a profile (x rising), by how often and which way it turns.
pub fn form(positions: &[f64], errors: &[f64]) -> Figure {
    let (slope, at_zero) = line(positions, errors);
    let taper = (slope * (positions[positions.len() - 1] - positions[0])).abs();
    let bow: Vec<f64> = positions.iter().zip(errors).map(|(x, e)| e - at_zero - slope * x).collect();
    let height = bow[first_extreme(&bow, f64::gt)] - bow[first_extreme(&bow, f64::lt)];
    let (top, bottom) = (first_extreme(errors, f64::gt), first_extreme(errors, f64::lt));
    let range = errors[top] - errors[bottom];
    let ends = [errors[0], errors[errors.len() - 1]];
    let turns = extrema(errors, 0.05 * range);
    let at = |i: usize| format!("at x = {:.1}", LENGTH.shown(positions[i]));
    let mean_of_ends = 0.5 * (ends[0] + ends[1]);
    let (word, place, text) = if range < STRAIGHT {
        ("cylinder", None, "cylinder: the error is the same all along".to_string())
    } else if turns == 0 {
        let curved = if height > 0.2 * taper { ", along a curve" } else { "" };
        ("cone", None, format!("cone: the error runs from one end to the other{curved}"))
    } else if turns == 1 && errors[top] - ends[0].max(ends[1]) > 0.05 * range {
        let above = MICRO.shown(errors[top] - mean_of_ends);
        ("barrel", Some(top), format!("barrel: thickest {}, {above:.3} above the mean of its ends", at(top)))
    } else if turns == 1 {
        let below = MICRO.shown(mean_of_ends - errors[bottom]);
        // A symmetric saddle is what shops call a corset.
        let word = if (ends[0] - ends[1]).abs() < 0.1 * range { "corset" } else { "saddle" };
        (word, Some(bottom), format!("{word}: thinnest {}, {below:.3} below the mean of its ends", at(bottom)))
    } else {
        ("wavy", None, format!("wavy: it turns {turns} times within {:.3}", MICRO.shown(range)))
    };
    let figure = Figure::new("form", "form, part 1").line(text).entry("form", word).quantity("range", MICRO, range);
    figure.quantity("at", LENGTH, place.map_or(f64::NAN, |i| positions[i]))
}

/// How often a curve turns back by more than `least` between its ends.
fn extrema(curve: &[f64], least: f64) -> usize {
    let (mut turns, mut rising) = (0, None);
    let (mut low, mut high) = (curve[0], curve[0]);
    for &value in curve {
        (low, high) = (low.min(value), high.max(value));
        let turned = match rising {
            Some(true) => high - value > least,
            Some(false) => value - low > least,
            None => false,
        };
        if turned {
            turns += 1;
        }
        if turned {
            rising = rising.map(|r: bool| !r);
            (low, high) = (value, value);
        } else if rising.is_none() && high - low > least {
            rising = Some(value == high);
        }
    }
    turns
}
