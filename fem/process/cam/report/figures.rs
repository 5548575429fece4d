//! Figures of a cam: its extremes, its programme, its segments, and what the grinding point does.

use super::super::division::By;
use super::super::setup::Setup;
use super::blocks::{Block, range};
use super::contact::{MOST_BLOCKS, PARTS, Removal};
use crate::process::{Datum, Figure};
use crate::units::{ANGLE, FEED_RATE, Kind, LENGTH, MICRO, REMOVAL_RATE, SECONDS, SHORT_TIME};

/// Jumps and back-sweeps below this are none, m.
const STILL: f64 = 1e-9;
/// Deviations that differ by less are the same but for round-off, m.
const ROUND_OFF: f64 = 1e-13;
/// Deviations below this show no digit, and so have no sign to show, m.
const NO_DIGIT: f64 = 5e-10;

/// All of them, in the order of interest.
pub fn figures(setup: &Setup, blocks: &[Block]) -> Vec<Figure> {
    let mut figures = vec![
        extreme(setup, blocks, ("largest", "largest deviation"), |b| b.thickest, 1.0),
        extreme(setup, blocks, ("smallest", "smallest deviation"), |b| b.thinnest, -1.0),
        programme(setup),
        segments(setup, blocks),
        grinding_point(blocks),
        feed(blocks),
    ];
    figures.extend(setup.stock.map(|stock| removal(stock, blocks)));
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
    let [by_block, of_point] = [mean, within].map(|feeds| from_to(FEED_RATE, feeds, 1));
    Figure::new("feed", "feed along the cam")
        .line(format!("{by_block} by block; {of_point} of the grinding point within blocks"))
        .quantity("least_mean", FEED_RATE, mean.0)
        .quantity("greatest_mean", FEED_RATE, mean.1)
        .quantity("least", FEED_RATE, within.0)
        .quantity("greatest", FEED_RATE, within.1)
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
