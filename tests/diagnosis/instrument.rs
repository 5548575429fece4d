//! What an instrument does to readings that are right: a scale that is off, a clock that is late, parts that lie
//! askew. Each is named for what it is, at its size, and no effect of the machine in its stead.

use std::f64::consts::TAU;

use fem::diagnose::{Cause, Verdict};
use fem::input::Source;
use fem::measure::Measurements;
use fem::model::{Data, Model};
use fem::progress::Progress;
use generator::random::Random;
use generator::{AXIS, Case, Process, RING, THERMAL};

use crate::score::{self, diagnose};

/// What was done to the readings of cases in which nothing else is hidden.
struct Trial {
    process: &'static Process,
    spoil: fn(Case) -> Case,
    /// The effect of the measurement that names it, and its value, SI.
    effect: (&'static str, f64),
    seeds: std::ops::Range<u64>,
}

#[test]
fn what_an_instrument_does_is_named() {
    let trials = [
        Trial { process: &RING, spoil: |case| scaled(case, "deviation", 1.12), effect: ("gain", 1.12), seeds: 0..4 },
        Trial {
            process: &THERMAL,
            spoil: |case| scaled(case, "temperature", 1.05),
            effect: ("gain", 1.05),
            seeds: 0..3,
        },
        Trial { process: &THERMAL, spoil: |case| late(case, 3.0), effect: ("clock", 180.0), seeds: 0..3 },
        Trial { process: &AXIS, spoil: |case| askew(case, 20.0), effect: ("alignment", 20e-6), seeds: 0..4 },
    ];
    for Trial { process, spoil, effect: (effect, value), seeds } in trials {
        let (mut all, mut named, mut held) = (0, 0, 0);
        for seed in seeds {
            let diagnosis = score::diagnosis(&spoil(process.nothing(seed))).unwrap();
            let said: Vec<_> = diagnosis.missing.iter().map(|m| &*m.effect.name).collect();
            println!("{effect} {seed}: {said:?}");
            all += 1;
            let own = diagnosis.missing.first().filter(|m| m.effect.name == effect && m.cause != Cause::Physical);
            let Some(own) = own.filter(|_| diagnosis.verdict != Verdict::Unexplained) else { continue };
            named += 1;
            let interval = own.estimates[0].interval;
            held += usize::from(interval.contains(value));
        }
        assert!(named + 1 >= all && held + 1 >= named, "{effect}: {named} of {all} named, {held} of these held");
    }
}

/// A wave of 90 mm that was read every 20 mm: neighbouring rows scatter as much as all rows, as if `u` were too small.
#[test]
fn a_wave_that_is_read_coarsely_is_no_larger_uncertainty() {
    const MODEL: &str = r#"process = "turning"
[workpiece]
material = "steel"
segments = [{ length = "500 mm", diameter = "60 mm" }]
[workholding]
type = "centres"
[cut]
depth = "0.5 mm"
feed = "0.2 mm/rev"
spindle_speed = "600 rpm"
radial_force = "300 N""#;
    let model = Model::parse(Source::new("shaft.toml", MODEL)).unwrap();
    for seed in 0..6 {
        let mut random = Random::new("wave", seed);
        let phase = random.uniform(0.0, TAU);
        let rows = |value: &mut dyn FnMut(usize, f64) -> f64| {
            let line = |i: usize| format!("{},{},0.5\n", 20 * i, value(i - 1, 20.0 * i as f64));
            format!("x [mm],diameter_error [um],u [um]\n{}", (1..25).map(line).collect::<String>())
        };
        let read = |text| Measurements::parse(Source::new("rows.csv", text), &*model.process).unwrap();
        let predicted = model.forward().observe(&read(rows(&mut |_, _| 0.0)).rows).unwrap();
        let text = rows(&mut |i, x| 1e6 * predicted[i] + 4.0 * (TAU * x / 90.0 + phase).sin() + 0.5 * random.normal());
        let data = Data::of(&model, read(text)).unwrap();
        let said = diagnose(&data, 3, &Progress::default()).unwrap();
        let names: Vec<_> = said.missing.iter().map(|m| &*m.effect.name).collect();
        assert_eq!((said.verdict, &names[..]), (Verdict::Unexplained, &["wave"][..]), "{seed}");
        let Cause::Measurement { along: Some(along), period: Some((period, _)), .. } = &said.missing[0].cause else {
            panic!("{seed}: a wave along x has a period")
        };
        assert_eq!(*along, "x", "{seed}");
        // Standard uncertainty of a frequency: sqrt(6)/(pi T) sigma/a/sqrt(n), here 0.35 mm of 90 (Bretthorst 1988).
        assert!((1e3 * period - 90.0).abs() < 1.4, "{seed}: {period}");
    }
}

/// The case with the cells of its columns that begin with these words changed, record by record.
fn with_cells(case: Case, words: &[&str], change: impl Fn(&[&str]) -> Option<String>) -> Case {
    let mut lines = case.data.lines();
    let head = lines.next().unwrap_or_default();
    let places: Vec<usize> =
        words.iter().map(|w| head.split(',').position(|name| name.starts_with(w)).unwrap()).collect();
    let mut data = format!("{head}\n");
    for line in lines {
        let mut cells: Vec<String> = line.split(',').map(str::to_string).collect();
        let own: Vec<&str> = places.iter().map(|i| cells[*i].as_str()).collect();
        if let Some(changed) = change(&own) {
            cells[places[0]] = changed;
        }
        data += &(cells.join(",") + "\n");
    }
    Case { data, ..case }
}

/// Readings of an instrument whose scale is off.
fn scaled(case: Case, column: &str, factor: f64) -> Case {
    with_cells(case, &[column], |cells| cells[0].parse::<f64>().ok().map(|value| (factor * value).to_string()))
}

/// Readings with a clock that is late by so many minutes.
fn late(case: Case, minutes: f64) -> Case {
    with_cells(case, &["time [min]"], |cells| Some((cells[0].parse::<f64>().unwrap() + minutes).to_string()))
}

/// Readings of a scale that lies askew anew in every run, by this standard deviation at the ends (um).
fn askew(case: Case, size: f64) -> Case {
    let place = case.data.lines().next().and_then(|head| head.split(',').position(|name| name.starts_with("position")));
    let cells = |line: &str| line.split(',').nth(place.unwrap()).and_then(|cell| cell.parse::<f64>().ok());
    let positions: Vec<f64> = case.data.lines().filter_map(cells).collect();
    let (low, high) = positions.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(*x), h.max(*x)));
    // Drawn once: standard normal deviates.
    let normal = [0.31, -1.24, 0.87, -0.45, 1.52, -0.12, -1.9, 0.66];
    with_cells(case, &["deviation", "run", "position"], |cells| {
        let [deviation, run, position] = [0, 1, 2].map(|i| cells[i].parse::<f64>().unwrap());
        let along = (2.0 * position - low - high) / (high - low);
        Some((deviation + size * normal[run as usize % 8] * along).to_string())
    })
}
