//! Gains that should be alike, and the feed at which the contour is within what is allowed.

use super::forward::observe;
use super::machine::Machine;
use super::rows::FEED;
use crate::process::{Advice, Failure, Rows};
use crate::units::{FEED_RATE, GAIN, MICRO};

/// Gains that differ by less than this part are alike.
const ALIKE: f64 = 1e-3;
/// Part of the largest deviation that is worth a setting.
const TOLD: f64 = 0.05;
/// Part of the feed below which nobody goes, and steps of halving.
const SLOWEST: f64 = 0.05;
const HALVINGS: usize = 30;

/// What to set, given the deviation of every row, m.
///
/// # Errors
/// The machine cannot be computed.
pub fn advice(machine: &Machine, rows: &Rows, deviations: &[f64]) -> Result<Vec<Advice>, Failure> {
    let mut all = Vec::new();
    let worst = |values: &[f64]| values.iter().fold(0.0f64, |worst, own| worst.max(own.abs()));
    let [x, y] = machine.gains;
    if (x - y).abs() > ALIKE * x {
        let least = x.min(y);
        let alike = Machine { gains: [least; 2], ..machine.clone() };
        let gain = worst(deviations) - worst(&observe(&alike, rows)?);
        if gain.abs() > TOLD * worst(deviations) {
            let (axis, from) = if x > y { ("x", x) } else { ("y", y) };
            let [from_shown, to_shown] = [from, least].map(|own| GAIN.shown(own));
            let text = format!(
                "set the gain of {axis} to {to_shown:.2}, not {from_shown:.2}, as that of the other axis is: the largest deviation changes by {:+.2} {}",
                MICRO.from_si(-gain),
                MICRO.unit
            );
            all.push(Advice::new(text).gaining(gain));
        }
    }
    if let Some((limits, _)) = &machine.setup.allowed.within {
        all.extend(slower(machine, rows, |values| values.iter().all(|own| limits.hold([*own; 2])))?);
    }
    Ok(all)
}

/// The largest feed at which everything is within, if that is slower than the model goes.
fn slower(machine: &Machine, rows: &Rows, is_within: impl Fn(&[f64]) -> bool) -> Result<Option<Advice>, Failure> {
    let feed = machine.setup.feed;
    let at = |feed: f64| {
        let mut slow = rows.clone();
        slow.columns[FEED].fill(feed);
        observe(machine, &slow).map(|values| is_within(&values))
    };
    if at(feed)? {
        return Ok(None);
    }
    if !at(SLOWEST * feed)? {
        let text = "no feed brings the contour within what is allowed: it is not the lag that leaves it";
        return Ok(Some(Advice::new(text)));
    }
    let (mut low, mut high) = (SLOWEST * feed, feed);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if at(middle)? { low = middle } else { high = middle }
    }
    let lap = machine.setup.path.length();
    let text = format!(
        "at {:.0}, not {:.0}, the contour is within what is allowed",
        FEED_RATE.shown(low),
        FEED_RATE.shown(feed)
    );
    Ok(Some(Advice::new(text).setting("path.feed", feed, low).taking(lap / low - lap / feed)))
}
