//! Deviations as they are measured: where along the contour, which way round, at which feed.

use std::f64::consts::TAU;

use super::path::{Direction, Path};
use super::setup::Setup;
use crate::process::{
    Absent, AllowedWords, CandidateExperiment, Coordinate, Holds, Misplaced, Observable, Places, Rows, Values,
};
use crate::units::{ANGLE, FEED_RATE, LENGTH, MICRO};

/// No part is as far off, m.
const FAR_OFF: f64 = 5e-3;

/// The deviation of the tool from its path, positive outwards.
pub const OBSERVABLES: &[Observable] = &[Observable::within("deviation", "the contour", MICRO, FAR_OFF).traced()];

/// What a drawing allows it.
pub const ALLOWED: AllowedWords =
    AllowedWords { within: "deviation", about: "limits of the deviation from the path", form: None, kind: MICRO };

/// Positions in [`COORDINATES`]: the polar angle of the commanded point.
pub const ANGLE_OF_ROW: usize = 0;
/// The way round.
pub const DIRECTION: usize = 1;
/// The feed along the path.
pub const FEED: usize = 2;

/// In the order of their positions.
pub const COORDINATES: &[Coordinate] = &[
    Coordinate::new(
        "angle",
        "of the commanded point about the centre, from x",
        Holds::Quantity(ANGLE),
        Absent::Refused,
    ),
    Coordinate::new("direction", "counter-clockwise or clockwise", Holds::word(Direction::NAMES), Absent::Model),
    Coordinate::new("feed", "speed along the path", Holds::Quantity(FEED_RATE), Absent::Model),
];

/// The direction and the feed (m/s) of a row.
pub fn way(setup: &Setup, rows: &Rows, row: usize) -> (Direction, f64) {
    let direction = rows.get(DIRECTION, row).map_or(setup.directions[0], Direction::at);
    (direction, rows.get(FEED, row).unwrap_or(setup.feed))
}

/// Rows that stand still, and rows of straight sides at their corners, which the lag of the servos rounds.
pub fn misplaced(setup: &Setup, rows: &Rows) -> Vec<Misplaced> {
    let check = |row: usize| {
        let (direction, feed) = way(setup, rows, row);
        let refuse = |coordinate, message| Some(Misplaced { row, coordinate, message });
        if feed <= 0.0 {
            return refuse(FEED, "`feed` is not above zero".to_string());
        }
        if let Some(reason) = setup.too_fast(feed) {
            return refuse(FEED, reason);
        }
        let [mut behind, mut ahead] = setup.path.at(rows.get(ANGLE_OF_ROW, row)?).from_ends;
        if direction == Direction::Clockwise {
            std::mem::swap(&mut behind, &mut ahead);
        }
        let (before, after) = setup.corner(feed);
        (behind < after || ahead < before).then(|| Misplaced {
            row,
            coordinate: ANGLE_OF_ROW,
            message: {
                let [away, before, after] = [behind.min(ahead), before, after].map(|l| LENGTH.shown(l));
                format!(
                    "{away:.3} from a corner, which the lag of the servos rounds from {before:.3} before it to \
                     {after:.3} behind it: its side has no offset there"
                )
            },
        })
    };
    (0..rows.len()).filter_map(check).collect()
}

/// Angles at which the model predicts in a direction, rad, rising: evenly around a circle; evenly along
/// each straight side, without its corners.
pub fn angles(setup: &Setup, direction: Direction) -> Vec<f64> {
    if let Path::Circle { .. } = setup.path {
        return (0..setup.points).map(|i| TAU * i as f64 / setup.points as f64).collect();
    }
    let (before, after) = setup.corner(setup.feed);
    let [begin, end] = match direction {
        Direction::CounterClockwise => [after, before],
        Direction::Clockwise => [before, after],
    };
    let mut angles = Vec::new();
    for side in setup.path.sides() {
        let count = (setup.points as f64 * side.length / setup.path.length()).round().max(3.0) as usize;
        // A hair inside, so that what is written reads back as no corner.
        let [low, high] = [begin * (1.0 + 1e-6), side.length - end * (1.0 + 1e-6)];
        angles.extend((0..count).map(|i| {
            let along = low + (high - low) * i as f64 / (count - 1) as f64;
            let at = [0, 1].map(|c| side.from[c] + along * side.along[c]);
            at[1].atan2(at[0]).rem_euclid(TAU)
        }));
    }
    angles.sort_by(f64::total_cmp);
    angles
}

/// The model's own programme: once round in each of its directions.
pub fn programme(setup: &Setup) -> Rows {
    let laps = setup.directions.iter().map(|direction| lap(setup, *direction, angles(setup, *direction)));
    laps.reduce(|all, lap| all.and(&lap)).unwrap_or_default()
}

/// Rows at some angles (rad) in a direction, at the feed of the model.
pub fn lap(setup: &Setup, direction: Direction, angles: Vec<f64>) -> Rows {
    at_feed(setup.feed, direction, angles)
}

fn at_feed(feed: f64, direction: Direction, angles: Vec<f64>) -> Rows {
    let count = angles.len();
    let columns = vec![angles.into(), Values::shared(f64::from(direction as u8), count), Values::shared(feed, count)];
    Rows { columns, observable: Values::shared(0, count) }
}

/// Rows with direction and feed of the model where they have none of their own.
pub fn resolved(setup: &Setup, rows: &Rows) -> Rows {
    let mut resolved = rows.clone();
    for row in 0..rows.len() {
        let (direction, feed) = way(setup, rows, row);
        resolved.columns[DIRECTION].set(row, f64::from(direction as u8));
        resolved.columns[FEED].set(row, feed);
    }
    resolved
}

/// Further experiments: the other way round, other feeds, the neighbourhood of the reversals.
pub fn candidate_experiments(setup: &Setup, rows: &Rows) -> Vec<CandidateExperiment> {
    let ways: Vec<(Direction, f64)> = (0..rows.len()).map(|row| way(setup, rows, row)).collect();
    let first = ways.first().map_or((setup.directions[0], setup.feed), |w| *w);
    let other = match first.0 {
        Direction::CounterClockwise => Direction::Clockwise,
        Direction::Clockwise => Direction::CounterClockwise,
    };
    let experiment = |words: String,
                      coordinate: usize,
                      value: Option<f64>,
                      (direction, feed): (Direction, f64),
                      angles: Vec<f64>| {
        let values = value.map_or_else(|| angles.clone(), |v| vec![v]);
        let rows = at_feed(feed, direction, angles);
        CandidateExperiment::new(words, &COORDINATES[coordinate], values, rows)
    };
    let around = |direction, feed| {
        let all = angles(&Setup { feed, points: 72, ..setup.clone() }, direction);
        all.into_iter()
            .map(|a| (a + 0.02).rem_euclid(TAU))
            .filter(|a| steady(setup, *a, direction, feed))
            .collect::<Vec<_>>()
    };
    let mut experiments = Vec::new();
    if ways.iter().all(|w| w.0 == first.0) {
        let words = format!("go round the other way, {}", other.word());
        let value = f64::from(other as u8);
        experiments.push(experiment(words, DIRECTION, Some(value), (other, first.1), around(other, first.1)));
    }
    for (factor, words) in [(0.5, "half"), (2.0, "twice")] {
        let feed = factor * first.1;
        if setup.too_fast(feed).is_none() && ways.iter().all(|w| w.1 != feed) {
            let words = format!("go round at {words} the feed, {}", FEED_RATE.format(feed));
            experiments.push(experiment(words, FEED, Some(feed), (first.0, feed), around(first.0, feed)));
        }
    }
    if let Path::Circle { .. } = setup.path {
        // Within ten degrees behind each quadrant, where play is crossed and spikes fade.
        let behind = |i: i32| {
            (f64::from(90 * (i / 20)) + first.0.sign() * 0.5 * f64::from(1 + i % 20)).to_radians().rem_euclid(TAU)
        };
        let words = "measure every half degree behind the four reversals".to_string();
        experiments.push(experiment(words, ANGLE_OF_ROW, None, first, (0..80).map(behind).collect()));
    }
    experiments
}

/// Whether an angle lies off the corners.
fn steady(setup: &Setup, angle: f64, direction: Direction, feed: f64) -> bool {
    misplaced(setup, &at_feed(feed, direction, vec![angle])).is_empty()
}

/// On the path, lap by lap; a deviation is outwards.
pub fn places(setup: &Setup, rows: &Rows) -> Places {
    let mut ways: Vec<(Direction, f64)> = Vec::new();
    let mut places = Places { references: vec![0.0; rows.len()], ..Places::default() };
    for row in 0..rows.len() {
        let way = way(setup, rows, row);
        let frame = ways.iter().position(|w| *w == way).unwrap_or_else(|| {
            ways.push(way);
            ways.len() - 1
        });
        let point = setup.path.at(rows.get(ANGLE_OF_ROW, row).unwrap_or(0.0));
        places.points.push([point.at[0], point.at[1], 0.0]);
        places.directions.push([point.outward[0], point.outward[1], 0.0]);
        places.along.push(point.travelled);
        places.frames.push(frame as f64);
    }
    places
}
