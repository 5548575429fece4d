//! Figures of a cam: its extremes, its programme, its segments, and what the grinding point does.

use super::super::division::By;
use super::super::setup::Setup;
use super::blocks::{Block, Blocks};
use super::contact::{MOST_BLOCKS, PARTS, Removal};
use super::interpolation;
use crate::process::{Datum, Figure, range};
use crate::units::{ANGLE, FEED_RATE, Kind, LENGTH, MICRO, REMOVAL_RATE, SECONDS, SHORT_TIME};

/// Jumps and back-sweeps below this are none, m.
const STILL: f64 = 1e-9;
/// Deviations that differ by less are the same but for round-off, m.
const ROUND_OFF: f64 = 1e-13;
/// Deviations below this show no digit, and so have no sign to show, m.
const NO_DIGIT: f64 = 5e-10;

/// All of them, in the order of interest.
pub fn figures(setup: &Setup, looked: &Blocks) -> Vec<Figure> {
    let blocks = &looked.list;
    let mut figures = vec![
        extreme(setup, blocks, ("largest", "largest deviation"), |b| b.thickest, 1.0),
        extreme(setup, blocks, ("smallest", "smallest deviation"), |b| b.thinnest, -1.0),
        programme(setup),
        segments(setup, blocks),
    ];
    figures.extend(interpolation::figures(setup));
    figures.extend([grinding_point(blocks), feed(blocks)]);
    figures.extend(acceleration(setup));
    figures.extend(setup.stock.map(|stock| removal(stock, blocks)));
    figures.extend(looked.layer.map(layer));
    figures
}

fn extreme(
    setup: &Setup,
    blocks: &[Block],
    (key, label): (&'static str, &'static str),
    of: fn(&Block) -> (f64, f64),
    sign: f64,
) -> Figure {
    // Of equal ones the first is told.
    let better = |best: usize, i: usize| {
        if sign * (of(&blocks[i]).0 - of(&blocks[best]).0) > ROUND_OFF { i } else { best }
    };
    let block = (0..blocks.len()).fold(0, better);
    let (value, s) = of(&blocks[block]);
    let angle = setup.profile.angle(s);
    let (shown, at) = (MICRO.shown(value), ANGLE.shown(angle));
    Figure::new(key, label)
        .line(format!("{shown:+.3} at {at:.2}, block {}", block + 1))
        .quantity("value", MICRO, value)
        .quantity("angle", ANGLE, angle)
        .entry("block", block + 1)
}

/// "1.00 to 2.00 mm", to so many digits.
fn from_to(kind: Kind, (low, high): (f64, f64), digits: usize) -> String {
    format!("{:.digits$} to {:.digits$}", kind.from_si(low), kind.shown(high))
}

fn programme(setup: &Setup) -> Figure {
    let (program, division) = (&setup.program, &setup.division);
    let count = program.blocks();
    let time = program.axes.times[count];
    let steps = range((0..count).map(|i| program.length(i)));
    let turns = range(program.axes.turns.windows(2).map(|w| (w[1] - w[0]).abs()));
    let times = range((0..count).map(|i| program.time(i)));
    let by = match division.by {
        By::Step => format!("of {:.4} of profile at most", LENGTH.shown(division.size)),
        By::Angle => format!("of {:.4} of the cam at most", ANGLE.shown(division.size)),
        By::Blocks => "of equal turn of the cam".into(),
        By::Tolerance => format!("as few as keep {:.3}", MICRO.shown(division.size)),
    };
    let sizes = [from_to(LENGTH, steps, 4), from_to(ANGLE, turns, 4), from_to(SHORT_TIME, times, 2)].join(", ");
    Figure::new("program", "programme")
        .unit("step_unit", LENGTH)
        .unit("turn_unit", ANGLE)
        .unit("time_unit", SECONDS)
        .line(format!("{count} block(s) {by}: {sizes}; a turn in {:.3}", SECONDS.shown(time)))
        .entry("blocks", count)
        .quantity("shortest_step", LENGTH, steps.0)
        .quantity("longest_step", LENGTH, steps.1)
        .quantity("smallest_turn", ANGLE, turns.0)
        .quantity("largest_turn", ANGLE, turns.1)
        .quantity("time", SECONDS, time)
}

fn segments(setup: &Setup, blocks: &[Block]) -> Figure {
    let mut figure = Figure::new("segments", "along the profile");
    let mut list = Vec::new();
    for (i, segment) in setup.segments.iter().enumerate() {
        let own: Vec<&Block> = blocks.iter().filter(|b| setup.profile.segment(b.middle()) == i).collect();
        let (thin, thick) = (range(own.iter().map(|b| b.thinnest.0)).0, range(own.iter().map(|b| b.thickest.0)).1);
        let [thin, thick] = [thin, thick].map(|v| if v.abs() < NO_DIGIT { 0.0 } else { v });
        let numbers = match own.len() {
            0 => "in no block of its own".into(),
            count => format!("{count:>5} block(s) {:>+10.3} to {:>+10.3}", MICRO.from_si(thin), MICRO.shown(thick)),
        };
        figure = figure.line(format!("{:>2} {:<26} {numbers}", i + 1, segment.name));
        list.push(Datum::record([
            ("segment", (i + 1).into()),
            ("name", segment.name.clone().into()),
            ("blocks", own.len().into()),
            ("smallest", Datum::of(MICRO, thin)),
            ("largest", Datum::of(MICRO, thick)),
        ]));
    }
    figure.entry("list", Datum::List(list))
}

fn grinding_point(blocks: &[Block]) -> Figure {
    let moves = |way: f64| blocks.iter().map(|b| way * b.jump).filter(|j| *j > STILL).collect::<Vec<f64>>();
    let (jumps, sweeps) = (moves(1.0), moves(-1.0));
    let largest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
    let told = |values: &[f64], what: &str| match values.len() {
        0 => format!("no {what}"),
        n => format!("{n} {what}(s) up to {:.3}", LENGTH.shown(largest(values))),
    };
    let imprint: f64 = blocks.iter().map(|b| b.imprint).sum();
    let shaped: f64 = blocks.iter().map(|b| b.shaped).sum();
    let part = 100.0 * imprint / (imprint + shaped);
    let moved = [told(&jumps, "jump"), told(&sweeps, "back-sweep")].join(", ");
    Figure::new("grinding_point", "grinding point")
        .line(format!("{moved}; {part:.1} % of the profile is imprint of the standing wheel"))
        .entry("jumps", jumps.len())
        .quantity("largest_jump", LENGTH, largest(&jumps))
        .entry("back_sweeps", sweeps.len())
        .quantity("largest_back_sweep", LENGTH, largest(&sweeps))
        .quantity("imprint", LENGTH, imprint)
        .quantity("envelope", LENGTH, shaped)
}

fn feed(blocks: &[Block]) -> Figure {
    let mean = range(blocks.iter().map(Block::mean_feed));
    let within = (range(blocks.iter().map(|b| b.feed.0)).0, range(blocks.iter().map(|b| b.feed.1)).1);
    let envelope = range(blocks.iter().map(Block::envelope_feed));
    let [by_block, of_point, along] = [mean, within, envelope].map(|feeds| from_to(FEED_RATE, feeds, 1));
    let figure = Figure::new("feed", "feed along the cam")
        .line(format!("{by_block} by block; {of_point} of the grinding point within blocks"))
        .quantity("least_mean", FEED_RATE, mean.0)
        .quantity("greatest_mean", FEED_RATE, mean.1)
        .quantity("least", FEED_RATE, within.0)
        .quantity("greatest", FEED_RATE, within.1)
        .quantity("least_of_envelope", FEED_RATE, envelope.0)
        .quantity("greatest_of_envelope", FEED_RATE, envelope.1);
    match blocks.iter().any(|b| b.tenths.is_empty()) {
        true => figure.line(format!("along the envelope {along} by block")),
        false => {
            let tenths = range(blocks.iter().flat_map(|b| b.tenths.iter().copied()));
            let told = from_to(FEED_RATE, tenths, 1);
            figure
                .line(format!("along the envelope {along} by block, {told} by tenths of their time"))
                .quantity("least_of_a_tenth", FEED_RATE, tenths.0)
                .quantity("greatest_of_a_tenth", FEED_RATE, tenths.1)
        }
    }
}

/// Figure of the time that starting and stopping in every block costs, where accelerations are limited.
fn acceleration(setup: &Setup) -> Option<Figure> {
    let program = &setup.program;
    let courses = || (0..program.blocks()).map(|i| (program.time(i), program.courses[i].ramps()));
    let on_ramps: f64 = courses().map(|(time, ramps)| time * ramps).sum();
    let (time, steady) = (program.axes.times[program.blocks()], program.steady_time);
    let short = courses().filter(|c| c.1 >= 1.0).count();
    let figure = || {
        let [shown, steady_shown] = [time, steady].map(|t| SECONDS.shown(t));
        let part = 100.0 * on_ramps / time;
        Figure::new("acceleration", "starts and stops")
            .unit("time_unit", SECONDS)
            .line(format!("a turn takes {shown:.3} instead of {steady_shown:.3}, {part:.1} % of it on ramps"))
            .line(format!("{short} block(s) are too short to reach their speed"))
            .quantity("time", SECONDS, time)
            .quantity("time_without", SECONDS, steady)
            .entry("part_on_ramps", on_ramps / time)
            .entry("blocks_too_short", short)
    };
    (on_ramps > 0.0).then(figure)
}

fn removal(stock: f64, blocks: &[Block]) -> Figure {
    let removals = || blocks.iter().filter_map(|b| b.removal.as_ref().map(|r| (r, b.time)));
    let rates = range(removals().map(|(r, time)| r.area / time));
    let of_tenths = removals().flat_map(|(r, time)| r.tenths.iter().map(move |a| PARTS as f64 * a / time));
    let tenths = of_tenths.reduce(f64::max).map(|most| most.max(rates.1));
    let lifted = |r: &Removal| r.cutting().len() < r.tenths.len();
    let partly = tenths.map(|_| removals().filter(|(r, _)| lifted(r)).count());
    let (by_block, layer) = (from_to(REMOVAL_RATE, rates, 4), MICRO.shown(stock));
    let at_most =
        tenths.map_or(String::new(), |most| format!(", {:.4} at most in a tenth of one", REMOVAL_RATE.from_si(most)));
    let contact = match partly {
        Some(partly) => format!("lifted off for part of {partly} block(s)"),
        None => format!("by tenths, and where it is lifted off, only of {MOST_BLOCKS} blocks or fewer"),
    };
    Figure::new("removal", "removal rate")
        .unit("stock_unit", MICRO)
        .unit("unit", REMOVAL_RATE)
        .line(format!("{by_block} by block{at_most}, of a layer of {layer:.1}; {contact}"))
        .quantity("stock", MICRO, stock)
        .quantity("least", REMOVAL_RATE, rates.0)
        .quantity("greatest", REMOVAL_RATE, rates.1)
        .entry("greatest_of_a_tenth", Datum::maybe(REMOVAL_RATE, tenths))
        .entry("blocks_partly_lifted", partly)
}

/// The layer that a pass comes upon after one of another programme.
fn layer((least, greatest, missed): (f64, f64, f64)) -> Figure {
    let told = format!("{} above the wheel after the pass before", from_to(MICRO, (least, greatest), 3));
    let reached = match missed > 0.0 {
        true => format!("{:.1} % of the profile is not reached and stays as it was", 100.0 * missed),
        false => "all of the profile is reached".into(),
    };
    Figure::new("layer", "layer to take")
        .line(format!("{told}; {reached}"))
        .quantity("least", MICRO, least)
        .quantity("greatest", MICRO, greatest)
        .entry("part_missed", missed)
}
