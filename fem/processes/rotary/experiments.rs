//! What else to measure: other parts of the worm's turn, closer targets, cold, warm, both sides, the whole range, torques.

use super::rows::{
    ANGLE_OF_ROW, BACKWARD, COORDINATES, DIRECTION, RUN, TIME_OF_ROW, TORQUE_OF_ROW, rows, targets, there_and_back,
};
use super::setup::Setup;
use crate::positioning::Direction;
use crate::process::{CandidateExperiment, Rows};
use crate::units::TORQUE;

/// Long enough for a drive to be warm through, s.
const WARM: f64 = 2.0 * 3600.0;
/// Targets of a candidate experiment, at most.
const TARGETS: usize = 12;
/// Targets within a period that show its harmonics.
const FINE: usize = 16;
/// Torques about the axis, N·m: beyond the friction of small tables and of large ones, either way.
const TORQUES: [f64; 4] = [10.0, -10.0, 100.0, -100.0];

/// Further experiments beside these rows.
pub fn candidate_experiments(setup: &Setup, of: &Rows) -> Vec<CandidateExperiment> {
    let measured = targets(of);
    let some: Vec<f64> = measured.iter().copied().step_by(measured.len().div_ceil(TARGETS).max(1)).collect();
    let last = of.columns[TIME_OF_ROW].iter().copied().fold(0.0, f64::max);
    let run = 1.0 + of.columns[RUN].iter().copied().fold(0.0, f64::max);
    let own = setup.test.torque;
    let at_once = |targets: &[f64], time: f64, torque: f64| rows(there_and_back(targets, run, |_| time), torque);
    let experiment = |words: &str, coordinate: usize, values: Vec<f64>, rows| {
        CandidateExperiment::new(words, &COORDINATES[coordinate], values, rows)
    };
    let (from, to) = (setup.from, setup.from + setup.range);
    let both_sides = rows(
        some.iter().enumerate().flat_map(|(i, x)| {
            let time = last + setup.test.reading * (2 * i + 1) as f64;
            [(*x, Direction::Forward, run, time), (*x, Direction::Backward, run, time + setup.test.reading)]
        }),
        own,
    );
    let mut experiments = vec![
        experiment(
            "let the axis stand until it is cold and measure all targets at once",
            TIME_OF_ROW,
            vec![0.0],
            at_once(&some, 0.0, own),
        )
        .taking(WARM),
        experiment(
            "keep the axis turning for two hours and measure all targets again",
            TIME_OF_ROW,
            vec![last + WARM],
            at_once(&some, last + WARM, own),
        )
        .taking(WARM),
        experiment(
            "approach each target from both sides before going on to the next",
            DIRECTION,
            vec![0.0, BACKWARD],
            both_sides,
        ),
    ];
    // Periods that come back within the range: of the gearing, of a scale's lines.
    let line =
        setup.scale.and_then(|scale| scale.lines_a_turn(&setup.drive)).map(|lines| std::f64::consts::TAU / lines);
    for (period, what) in [(setup.drive.shortest_period(), "of the gearing"), (line, "of the scale's lines")] {
        let Some(period) = period.filter(|period| *period < setup.range) else { continue };
        let fine: Vec<f64> = (0..FINE).map(|i| from + period * i as f64 / FINE as f64).collect();
        let words = format!("measure {FINE} targets within one period {what} from the begin of the range on");
        let closely = at_once(&fine, last, own);
        experiments.push(experiment(&words, ANGLE_OF_ROW, fine, closely));
        let aside = |(i, x): (usize, &f64)| {
            let by = period * (0.13 + 0.25 * i as f64);
            if x + by <= to { x + by } else { x - by }
        };
        let moved: Vec<f64> = some.iter().enumerate().map(aside).filter(|x| (from..=to).contains(x)).collect();
        let words = format!("measure at {} other targets, each at another part of the period {what}", moved.len());
        let rows = rows(moved.iter().map(|x| (*x, Direction::Forward, run, last)), own);
        experiments.push(experiment(&words, ANGLE_OF_ROW, moved, rows));
    }
    let covered = measured.last().zip(measured.first()).map_or(0.0, |(b, a)| b - a);
    if covered < 0.8 * setup.range {
        let ends: Vec<f64> = (0..TARGETS).map(|i| from + setup.range * i as f64 / (TARGETS - 1) as f64).collect();
        let rows = at_once(&ends, last, own);
        experiments.push(experiment("measure from end to end of the range, there and back", ANGLE_OF_ROW, ends, rows));
    }
    for torque in TORQUES {
        let rows = at_once(&some, last, torque);
        let (by, way) = (TORQUE.shown(torque.abs()), if torque > 0.0 { '+' } else { '-' });
        let words = format!(
            "turn the table towards {way} by a torque of {by:.0}, its play not compensated, and measure all targets again"
        );
        experiments.push(experiment(&words, TORQUE_OF_ROW, vec![torque], rows));
    }
    experiments
}
