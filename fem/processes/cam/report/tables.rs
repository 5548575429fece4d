//! The programme as a table of points, and what each block does, for other programs.

use super::super::setup::Setup;
use super::blocks::Block;
use super::contact::PARTS;
use crate::process::{Column, Table};
use crate::units::{ANGLE, AREA, FEED_RATE, LENGTH, MICRO, REMOVAL_RATE, SECONDS, SPINDLE_SPEED};

/// The programme: a row per point, the first before the first block. Angles and speeds are those of the axes,
/// feeds those of the grinding point.
pub fn program(setup: &Setup) -> Table {
    let (program, axes) = (&setup.program, &setup.program.axes);
    // Of the block that ends at the point.
    let over = |of: &dyn Fn(usize) -> f64| [0.0].into_iter().chain((0..program.blocks()).map(of)).collect::<Vec<f64>>();
    let rate = |values: &[f64], i: usize| (values[i + 1] - values[i]) / program.time(i);
    let turned: Vec<f64> = axes.turns.iter().map(|t| axes.turns[0] - t).collect();
    let angles: Vec<f64> = program.places.iter().map(|s| setup.profile.angle(*s)).collect();
    Table {
        columns: vec![
            Column::numbers("block", None, (0..=program.blocks()).map(|i| i as f64).collect()),
            Column::quantities("cam_angle", ANGLE, &turned),
            Column::quantities("wheel_centre_radius", LENGTH, &axes.slides),
            Column::quantities("profile_angle", ANGLE, &angles),
            Column::quantities("step", LENGTH, &over(&|i| program.length(i))),
            Column::quantities("time", SECONDS, &over(&|i| program.time(i))),
            Column::quantities("cam_speed", SPINDLE_SPEED, &over(&|i| rate(&axes.turns, i).abs())),
            Column::quantities("slide_feed", FEED_RATE, &over(&|i| rate(&axes.slides, i))),
            Column::quantities("feed", FEED_RATE, &over(&|i| rate(&program.places, i))),
            Column::quantities("shift", MICRO, &program.shifts),
        ],
    }
}

/// A row per block.
pub fn blocks(setup: &Setup, blocks: &[Block]) -> Table {
    let of_all = |name, kind, of: &dyn Fn(&Block) -> f64| {
        Column::quantities(name, kind, &blocks.iter().map(of).collect::<Vec<f64>>())
    };
    let segments = blocks.iter().map(|b| setup.profile.segment(b.middle()) as f64 + 1.0).collect();
    let mut columns = vec![
        Column::numbers("block", None, (1..=blocks.len()).map(|i| i as f64).collect()),
        Column::numbers("segment", None, segments),
        of_all("step", LENGTH, &Block::length),
        of_all("time", SECONDS, &|b| b.time),
        of_all("thickest", MICRO, &|b| b.thickest.0),
        of_all("thinnest", MICRO, &|b| b.thinnest.0),
        of_all("own_overcut", MICRO, &|b| b.overcut.max(0.0)),
        of_all("envelope", LENGTH, &|b| b.envelope),
        of_all("shaped", LENGTH, &|b| b.shaped),
        of_all("imprint_at_end", LENGTH, &|b| b.imprint),
        of_all("jump_at_end", LENGTH, &|b| b.jump),
        of_all("mean_feed", FEED_RATE, &Block::mean_feed),
        of_all("least_feed", FEED_RATE, &|b| b.feed.0),
        of_all("greatest_feed", FEED_RATE, &|b| b.feed.1),
    ];
    if blocks.iter().all(|b| b.removal.is_some()) {
        let area = |b: &Block| b.removal.as_ref().map_or(0.0, |r| r.area);
        columns.push(of_all("removed", AREA, &area));
        columns.push(of_all("removal_rate", REMOVAL_RATE, &|b| area(b) / b.time));
    }
    for (k, name) in TENTHS.iter().enumerate() {
        let tenth = |b: &Block| b.removal.as_ref().and_then(|r| r.tenths.get(k).copied());
        if blocks.iter().all(|b| tenth(b).is_some()) {
            columns.push(of_all(name, AREA, &|b| tenth(b).unwrap_or(0.0)));
        }
    }
    columns.push(of_all("envelope_feed", FEED_RATE, &Block::envelope_feed));
    if blocks.iter().all(|b| !b.tenths.is_empty()) {
        columns.extend(FEEDS.iter().enumerate().map(|(k, name)| of_all(*name, FEED_RATE, &|b| b.tenths[k])));
    }
    Table { columns }
}

const TENTHS: [&str; PARTS] = [
    "removed_1",
    "removed_2",
    "removed_3",
    "removed_4",
    "removed_5",
    "removed_6",
    "removed_7",
    "removed_8",
    "removed_9",
    "removed_10",
];
const FEEDS: [&str; PARTS] =
    ["feed_1", "feed_2", "feed_3", "feed_4", "feed_5", "feed_6", "feed_7", "feed_8", "feed_9", "feed_10"];
