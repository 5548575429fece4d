//! The report of a run: figures, the profile, and shapes for people.

mod circle;
mod reversing;
mod sampled;
mod shapes;
mod sides;

use self::sampled::Sampled;
use super::forward::Lap;
use super::machine::Machine;
use super::path::{AXES, Direction, Path};
use super::rows::{ANGLE_OF_ROW, COORDINATES, DIRECTION, FEED, OBSERVABLES};
use super::setup::Setup;
use crate::process::{Failure, Figure, Forward, Plot, Rows, RunReport, Table, extremes};
use crate::units::{ANGLE, FEED_RATE, LENGTH, MICRO};

/// Points along a contour of which the largest and the smallest are told, at least: a spike lasts some
/// milliseconds, a hundredth of a degree.
const FINE: usize = 36_000;
/// Lags above this, in rad, are no small ones: the first-order formulas are then wrong by as much.
const LARGE_LAG: f64 = 0.1;

/// Everything that a run reports.
///
/// # Errors
/// The contour cannot be computed.
pub fn report(machine: &Machine, forward: &Forward) -> Result<RunReport, Failure> {
    let setup = &Setup { points: machine.setup.points.max(FINE), ..(*machine.setup).clone() };
    let fine = Sampled::of(setup, forward)?;
    let Sampled { rows, deviations } = &Sampled::with_peaks(setup, forward, &fine);
    Ok(RunReport {
        profile: Table::of_rows((COORDINATES, &[DIRECTION, FEED, ANGLE_OF_ROW]), rows, &OBSERVABLES[0], deviations),
        figures: figures(machine, setup, forward, &fine)?,
        plots: vec![plot(&machine.setup, forward.programme, forward.prediction)],
        drawings: vec![shapes::drawing(&machine.setup, rows, deviations)],
        warnings: warnings(machine),
        animations: vec![shapes::animation(machine, rows, deviations)],
        ..RunReport::default()
    })
}

/// Figures of the contour at so many points that no spike falls between two of them.
fn figures(machine: &Machine, setup: &Setup, forward: &Forward, fine: &Sampled) -> Result<Vec<Figure>, Failure> {
    let Sampled { rows, deviations } = fine;
    let told = (COORDINATES, &[ANGLE_OF_ROW, DIRECTION][..]);
    let mut figures = extremes("deviation", &OBSERVABLES[0], told, rows, deviations);
    match setup.path {
        Path::Circle { .. } => {
            figures.extend(circle::figures(setup, forward, deviations)?);
            figures.push(reversing::reversals(machine));
        }
        Path::Rectangle { .. } | Path::Polygon { .. } => figures.extend(sides::figures(machine, setup, deviations)),
    }
    figures.extend(reversing::lost_motion(machine));
    figures.extend(reversing::advice(machine));
    figures.push(servo(setup));
    figures.extend(stick_slip(setup));
    figures.extend(tolerance(machine, deviations));
    Ok(figures)
}

/// Figure of two equal servos by themselves: they follow at a distance, and a circle shrinks.
fn servo(setup: &Setup) -> Figure {
    let lag = setup.feed / setup.gain;
    let figure = Figure::new("servo", "servos alone").unit("unit", MICRO).quantity("lag", LENGTH, lag);
    let text = format!("each axis follows {:.3} (v/Kv) behind its command", LENGTH.shown(lag));
    let Path::Circle { radius } = setup.path else { return figure.line(text) };
    let [once, twice] = [1.0, 2.0].map(|times| contraction(radius, times * setup.feed, setup.gain));
    let [shown, shown_twice] = [once, twice].map(|c| MICRO.shown(-c));
    figure
        .quantity("contraction", MICRO, once)
        .quantity("contraction_at_twice_the_feed", MICRO, twice)
        .line(format!("{text}: of the radius {shown:+.3}, at twice the feed {shown_twice:+.3}"))
}

/// Length along the path of what sticks and slips at one frequency: λ = v/f.
fn stick_slip(setup: &Setup) -> Option<Figure> {
    let length = setup.feed / setup.frequency?;
    let [shown, twice] = [length, 2.0 * length].map(|length| LENGTH.shown(length));
    Some(
        Figure::new("stick_slip", "waves of stick-slip")
            .line(format!("{shown:.3} along the path (v/f), at twice the feed {twice:.3}"))
            .quantity("length", LENGTH, length),
    )
}

/// Contraction of a circle R(1 − 1/√(1 + (v/RKv)²)), m.
fn contraction(radius: f64, feed: f64, gain: f64) -> f64 {
    let ratio = feed / (radius * gain);
    // The same without the difference of nearly equal numbers.
    let root = ratio.hypot(1.0);
    radius * ratio * ratio / (root * (1.0 + root))
}

/// Figure of the gain mismatch that the tolerance allows, ΔKv/Kv = 2δ·Kv/v [seed 000, turned round], and of the feed at
/// which the gains as they are would keep it.
fn tolerance(machine: &Machine, deviations: &[f64]) -> Option<Figure> {
    let setup = &machine.setup;
    let allowed = setup.allowed.within.as_ref()?.0.upper;
    // The part of δ = (v/2)·(1/Kvy − 1/Kvx)·sin 2α that shows: all of it on a circle.
    let shows = match setup.path {
        Path::Circle { .. } => 1.0,
        Path::Rectangle { angle, .. } => (2.0 * angle).sin().abs(),
        Path::Polygon { .. } => {
            let sides = setup.path.sides();
            sides.iter().map(|side| 2.0 * (side.along[0] * side.along[1]).abs()).fold(0.0, f64::max)
        }
    };
    let mismatch = 2.0 * allowed * setup.gain / (setup.feed * shows);
    let largest = deviations.iter().fold(0.0f64, |m, d| m.max(d.abs()));
    let [x, y] = machine.gains;
    let present = (x - y) / setup.gain;
    let by_mismatch = 2.0 * allowed / ((1.0 / y - 1.0 / x).abs() * shows);
    let by_contraction = match setup.path {
        Path::Circle { radius } if allowed < radius => {
            let left = 1.0 - allowed / radius;
            radius * setup.gain * (1.0 - left * left).sqrt() / left
        }
        _ => f64::INFINITY,
    };
    let word = if largest <= allowed { "kept" } else { "exceeded" };
    let [allowed_shown, largest_shown] = [allowed, largest].map(|d| MICRO.shown(d));
    let mut figure = Figure::new("tolerance", "tolerance")
        .unit("feed_unit", FEED_RATE)
        .line(format!("{allowed_shown:.3} is {word}: the largest deviation is {largest_shown:.3}"))
        .quantity("deviation", MICRO, allowed)
        .entry("kept", largest <= allowed)
        .entry("mismatch_allowed", mismatch)
        .entry("mismatch", present)
        .quantity("feed_by_mismatch", FEED_RATE, by_mismatch)
        .quantity("feed_by_contraction", FEED_RATE, by_contraction);
    if mismatch.is_finite() && mismatch < 2.0 {
        let [may, do_differ] = [mismatch, present.abs()].map(|m| 100.0 * m);
        figure = figure.line(format!(
            "gains may differ by {may:.2} % at this feed (2*deviation*Kv/v); they differ by {do_differ:.2} %"
        ));
    }
    for (cause, feed) in [("the gains as they are", by_mismatch), ("the lag of equal servos", by_contraction)] {
        if feed.is_finite() {
            figure = figure.line(format!("{cause} would alone use it up at {}", FEED_RATE.format(feed)));
        }
    }
    Some(figure)
}

fn plot(setup: &Setup, rows: &Rows, deviations: &[f64]) -> Plot {
    let direction = setup.directions[0];
    let own = (0..rows.len()).filter(|i| Direction::at(rows.columns[DIRECTION][*i]) == direction);
    let points = own.map(|i| (ANGLE.from_si(rows.columns[ANGLE_OF_ROW][i]), MICRO.from_si(deviations[i]))).collect();
    Plot { title: format!("deviation [um] over angle [deg], {}", direction.word()), x_unit: "deg", points }
}

fn warnings(machine: &Machine) -> Vec<String> {
    let setup = &machine.setup;
    let mut warnings = Vec::new();
    let lap = Lap::new(machine, setup.directions[0], setup.feed);
    for (axis, name) in AXES.iter().enumerate() {
        if !lap.axes[axis].follows() {
            warnings.push(format!("{name} does not move: its play is wider than its travel"));
        }
        let half = 0.5 * lap.axes[axis].motion.period();
        let spike = machine.spikes[axis];
        if spike.height > 0.0 && 3.0 * spike.time_constant > half {
            warnings.push(format!(
                "the spike of {name} has not faded when it turns round again, {half:.2} s later: \
                 what is left of it is not kept"
            ));
        }
    }
    if let Path::Circle { radius } = setup.path {
        let lag = setup.feed / (radius * setup.gain);
        if lag > LARGE_LAG {
            let lag = ANGLE.shown(lag.atan());
            warnings.push(format!("the axes lag by {lag:.1}: check feed, radius and gain"));
        }
    }
    warnings
}
