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
