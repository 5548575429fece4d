//! Slips of the pen in measurements of a turned shaft: told with their lines and left out, and the causes stay.

use std::path::Path;

use fem::diagnose::Cause;
use fem::discover::diagnose;
use fem::input::Source;
use fem::measure::{Measurements, Reading};
use fem::model::{Data, Model};

fn folder() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("models/story")
}

fn model() -> Model {
    Model::load(&folder().join("rigid.toml")).unwrap()
}

/// The measurements with another text for the reading in a line.
fn mistyped(line: usize, slip: Slip) -> (String, Measurements) {
    let text = std::fs::read_to_string(folder().join("measured.csv")).unwrap();
    let mut lines: Vec<String> = text.lines().map(str::to_string).collect();
    let mut cells: Vec<String> = lines[line - 1].split(',').map(str::to_string).collect();
    cells[3] = slip(&cells[3]);
    let typed = cells[3].clone();
    lines[line - 1] = cells.join(",");
    let source = Source::new("measured.csv", lines.join("\n") + "\n");
    (typed, Measurements::parse(source, &*model().process).unwrap())
}

fn shifted(cell: &str, factor: f64) -> String {
    format!("{:.6}", cell.parse::<f64>().unwrap() * factor)
}

/// The first two digits swapped, as a typist may.
fn swapped(cell: &str) -> String {
    let mut digits: Vec<char> = cell.chars().collect();
    digits.swap(0, 1);
    digits.into_iter().collect()
}

/// What a typist makes of a text.
type Slip = fn(&str) -> String;

const SLIPS: &[(&str, Slip)] = &[
    ("two digits stand in the wrong order", swapped),
    ("the decimal point is off by one place", |cell| shifted(cell, 10.0)),
    ("it is a thousand times too small", |cell| shifted(cell, 1e-3)),
    ("it is in inches where the others are in mm", |cell| shifted(cell, 1.0 / 25.4)),
    ("its sign is wrong", |cell| format!("-{cell}")),
    ("a digit was typed twice", |cell| format!("{}{cell}", &cell[..1])),
];

#[test]
fn a_slip_is_told_with_its_line_and_left_out() {
    for (what, slip) in SLIPS {
        for line in [33, 62, 69] {
            let (typed, found) = mistyped(line, *slip);
            let note = found.notes.iter().find(|note| note.contains("left out")).cloned().unwrap_or_default();
            assert!(
                note.starts_with(&format!("line {line} is left out: `{typed}`")),
                "{what} in line {line}: {note:?}"
            );
            assert!(note.contains(what), "{what} in line {line}: {note}");
            assert_eq!(found.len(), 107);
        }
    }
}

#[test]
fn what_was_measured_stays() {
    for file in ["models/story/measured.csv", "models/stage/measured.csv"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
        let process = if file.contains("stage") { "axis" } else { "turning" };
        let process = *fem::processes::ALL.iter().find(|p| p.name() == process).unwrap();
        let found = Measurements::load(&path, process).unwrap();
        let all = Measurements::load_as(&path, process, &Reading::default().as_typed(true)).unwrap();
        assert_eq!(found.len(), all.len(), "{file}: {:?}", found.notes);
    }
}

#[test]
fn causes_are_those_of_the_data_without_the_slip() {
    let model = model();
    let causes = |measurements: Measurements| {
        let data = Data::of(&model, measurements).unwrap();
        let found = diagnose(&data, 3, &std::sync::Arc::default()).unwrap();
        let name = |cause: &Cause| format!("{cause:?}").split(['{', '(']).next().unwrap_or_default().to_string();
        found.missing.iter().map(|m| format!("{}{}", name(&m.cause), m.effect.name)).collect::<Vec<_>>()
    };
    let right = causes(Measurements::load(&folder().join("measured.csv"), &*model.process).unwrap());
    for (what, slip) in [SLIPS[0], SLIPS[1]] {
        assert_eq!(causes(mistyped(69, slip).1), right, "{what}");
    }
}

/// The process of a name, and data of it in which nothing is hidden.
fn made(name: &str, seed: u64) -> (&'static dyn fem::process::Process, String) {
    let process = *fem::processes::ALL.iter().find(|own| own.name() == name).unwrap();
    let generator = generator::BY_NAME.iter().find(|own| own.0 == name).unwrap().1;
    (process, generator.nothing(seed).data)
}

/// A slip takes no reading of another run with it.
#[test]
fn nothing_is_left_out_beside_a_slip() {
    let mut told = 0;
    for name in ["axis", "rotary", "turning"] {
        for seed in 0..6 {
            let (process, data) = made(name, seed);
            let lines: Vec<&str> = data.lines().collect();
            let header = lines.iter().position(|line| line.contains("deviation") || line.contains("diameter")).unwrap();
            let column =
                lines[header].split(',').position(|own| own.contains("deviation") || own.contains("diameter")).unwrap();
            for line in (header + 4..lines.len()).step_by(17) {
                let mut cells: Vec<String> = lines[line].split(',').map(str::to_string).collect();
                cells[column] = shifted(&cells[column], 10.0);
                let cells = cells.join(",");
                let mut typed = lines.clone();
                typed[line] = &cells;
                let found = Measurements::parse(Source::new("m.csv", typed.join("\n")), process).unwrap();
                let notes: Vec<&String> = found.notes.iter().filter(|note| note.contains("left out: `")).collect();
                let own = format!("line {} is left out", line + 1);
                assert!(notes.iter().all(|note| note.starts_with(&own)), "{name} {seed}: {notes:?}");
                told += notes.len();
            }
        }
    }
    // Small readings stay small ten times as large.
    assert!(told > 20, "{told}");
}

/// What is recorded beside readings, to a tenth, makes no slips of them; nor does what an instrument traces.
#[test]
fn readings_that_are_right_stay() {
    for name in ["thermal", "contour", "cam", "axis"] {
        for seed in 0..8 {
            let (process, data) = made(name, seed);
            let recorded = |(i, line): (usize, &str)| match i {
                0 => format!("{line},coolant [degC]"),
                _ => format!("{line},{:.1}", 20.0 + 0.1 * (i * 7 % 5) as f64),
            };
            let thinned = data.lines().filter(|line| !line.starts_with('#')).enumerate();
            let thinned = thinned.filter(|(i, _)| name != "contour" || *i == 0 || i % 6 == 3);
            let text: Vec<String> = thinned.map(|(_, line)| line).enumerate().map(recorded).collect();
            let found = Measurements::parse(Source::new("m.csv", text.join("\n")), process).unwrap();
            assert!(!found.notes.iter().any(|note| note.contains("left out: `")), "{name} {seed}: {:?}", found.notes);
        }
    }
}
