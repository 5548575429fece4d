//! The programme as a table of points, and what each block does, for other programs.

use super::model::Setup;
use super::report::{Block, Report};
use crate::process::{Column, Table};
use crate::units::SPINDLE_SPEED;

/// The programme: a row per point, the first before the first block. Angles and speeds are those of the axes, feeds those of the grinding point.
pub fn program(setup: &Setup) -> Table {
    let (program, profile) = (&setup.program, &setup.profile);
    let axes = &program.axes;
    let points = 0..=program.blocks();
    // Of the block that ends at the point.
    let over =
        |of: &dyn Fn(usize) -> f64| points.clone().map(|i| if i == 0 { 0.0 } else { of(i - 1) }).collect::<Vec<f64>>();
    let change = |values: &[f64], i: usize| values[i + 1] - values[i];
    let time = |i: usize| change(&axes.times, i);
    let speed = |i: usize| SPINDLE_SPEED.from_si((change(&axes.turns, i) / time(i)).abs());
    let number = |name, unit, values| Column::numbers(name, Some(unit), values);
    Table {
        columns: vec![
            Column::numbers("block", None, points.clone().map(|i| i as f64).collect()),
            number("cam_angle", "deg", axes.turns.iter().map(|t| (axes.turns[0] - t).to_degrees()).collect()),
            number("wheel_centre_radius", "mm", axes.slides.iter().map(|x| 1e3 * x).collect()),
            number("profile_angle", "deg", program.places.iter().map(|s| profile.angle(*s).to_degrees()).collect()),
            number("step", "mm", over(&|i| 1e3 * change(&program.places, i))),
            number("time", "s", over(&time)),
            number("cam_speed", "rpm", over(&speed)),
            number("slide_feed", "mm/min", over(&|i| 6e4 * change(&axes.slides, i) / time(i))),
            number("feed", "mm/min", over(&|i| 6e4 * change(&program.places, i) / time(i))),
        ],
    }
}

/// What each block does.
pub fn blocks(setup: &Setup, report: &Report) -> Table {
    let all = |of: &dyn Fn(&Block) -> f64| report.blocks.iter().map(of).collect::<Vec<f64>>();
    let number = |name, unit, values| Column::numbers(name, Some(unit), values);
    let segment = |b: &Block| setup.profile.segment(0.5 * (b.places.0 + b.places.1)) as f64 + 1.0;
    let mut columns = vec![
        Column::numbers("block", None, (1..=report.blocks.len()).map(|i| i as f64).collect()),
        Column::numbers("segment", None, all(&segment)),
        number("step", "mm", all(&|b| 1e3 * (b.places.1 - b.places.0))),
        number("time", "s", all(&|b| b.time)),
        number("thickest", "um", all(&|b| 1e6 * b.thickest.0)),
        number("thinnest", "um", all(&|b| 1e6 * b.thinnest.0)),
        number("own_overcut", "um", all(&|b| 1e6 * b.overcut.max(0.0))),
        number("envelope", "mm", all(&|b| 1e3 * b.envelope)),
        number("shaped", "mm", all(&|b| 1e3 * b.shaped)),
        number("imprint_at_end", "mm", all(&|b| 1e3 * b.imprint)),
        number("jump_at_end", "mm", all(&|b| 1e3 * b.jump)),
        number("mean_feed", "mm/min", all(&|b| 6e4 * (b.places.1 - b.places.0) / b.time)),
        number("least_feed", "mm/min", all(&|b| 6e4 * b.feed.0)),
        number("greatest_feed", "mm/min", all(&|b| 6e4 * b.feed.1)),
    ];
    if setup.stock.is_some() {
        let area = |b: &Block| b.removal.as_ref().map_or(0.0, |r| r.area);
        columns.push(number("removed", "mm^2", all(&|b| 1e6 * area(b))));
        columns.push(number("removal_rate", "mm^2/s", all(&|b| 1e6 * area(b) / b.time)));
        for (k, name) in TENTHS.iter().enumerate() {
            let of = |b: &Block| b.removal.as_ref().and_then(|r| r.tenths.get(k)).map(|a| 1e6 * a);
            if report.blocks.iter().all(|b| of(b).is_some()) {
                columns.push(number(name, "mm^2", all(&|b| of(b).unwrap_or(0.0))));
            }
        }
    }
    Table { columns }
}

const TENTHS: [&str; super::contact::PARTS] = [
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
