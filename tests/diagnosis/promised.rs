//! Whether the intervals of a prediction hold what they promise: machines of the generator, diagnosed from their measurements,
//! predicted where they were measured and one force level beyond, and made there by the generator, which shares nothing with the
//! program.

use fem::model::Model;
use fem::process::{Holds, Rows};
use fem::progress::Progress;
use generator::asked::Asked;
use generator::dense::Basis;
use generator::job::Job;
use generator::{AXIS, CONTOUR, FIXTURE, Hidden, Process, RING, THERMAL, TURNING, Whole};

use crate::arrived::{Arrived, named};
use crate::{every, side_by_side};

/// Processes, and of those that have one the force of which one level more is asked.
const PREDICTED: [(&Process, Option<&str>); 6] = [
    (&TURNING, Some("radial_force")),
    (&RING, Some("jaw_force")),
    (&FIXTURE, Some("clamp_force")),
    (&AXIS, None),
    (&CONTOUR, None),
    (&THERMAL, None),
];

/// How many times the largest force that was measured stands one level beyond.
const BEYOND: f64 = 1.3;

/// Places of a machine, and those of them whose truth lies in the interval.
#[derive(Clone, Copy, Debug, Default)]
struct Held {
    held: usize,
    of: usize,
    /// Root mean square of the error of the prediction, in promised standard uncertainties.
    of_promised: f64,
}

/// A machine: whether its diagnosis leaves nothing, and how its intervals hold in the data and beyond.
#[derive(Clone, Copy, Debug)]
struct Promised {
    is_adequate: bool,
    within: Held,
    beyond: Option<Held>,
}

/// What a generator is asked to make again of a row.
fn asked(model: &Model, rows: &Rows, row: usize) -> Asked {
    let observable = model.process.observables()[rows.observable[row]].name.to_string();
    let mut asked = Asked { observable, numbers: Vec::new(), words: Vec::new() };
    for (column, coordinate) in model.process.coordinates().iter().enumerate() {
        let Some(value) = rows.get(column, row) else { continue };
        let name = coordinate.name.to_string();
        match &coordinate.holds {
            Holds::Word(words) => asked.words.push((name, words.of_value(value).unwrap().to_string())),
            _ => asked.numbers.push((name, value)),
        }
    }
    asked
}

/// How the intervals of a prediction hold what is made.
fn held(model: &Model, rows: &Rows, (job, hidden): (&dyn Job, &[Hidden])) -> Option<Held> {
    // What is known too roughly is told so.
    let (predicted, band) = fem::ask::predict(model, rows, &Progress::default()).ok()?;
    let mut made = job.predict(hidden);
    // The generator's temperatures are in degC.
    let observables = model.process.observables();
    let zero = |row: usize| if observables[rows.observable[row]].name == "temperature" { 273.15 } else { 0.0 };
    made.iter_mut().enumerate().for_each(|(row, own)| *own += zero(row));
    assert_eq!(made.len(), predicted.len(), "a row of the generator is a row of the program");
    let si = job.si();
    let errors: Vec<f64> = made.iter().zip(&si).zip(&predicted).map(|((made, si), own)| made - own / si).collect();
    // What the way of measuring does not show.
    let mut blind = Basis::default();
    job.blind().iter().for_each(|direction| blind.add(direction));
    let errors = blind.remainder(&errors);
    // The interval about the prediction, in the units of the generator.
    let about = |row: usize| band.interval[row].map(|end| (end - predicted[row]) / si[row]);
    let is_held = |row: &usize| {
        let [low, high] = about(*row);
        (low..=high).contains(&errors[*row])
    };
    let of_promised = |row: usize| {
        let [low, high] = about(row);
        (errors[row] / (0.5 * (high - low) / 1.96)).powi(2)
    };
    Some(Held {
        held: (0..errors.len()).filter(is_held).count(),
        of: errors.len(),
        of_promised: ((0..errors.len()).map(of_promised).sum::<f64>() / errors.len() as f64).sqrt(),
    })
}

/// A machine predicted by the model that a diagnosis arrives at; `None` where it leaves a value unknown.
fn promised((process, force): (&Process, Option<&str>), seed: u64) -> Option<Promised> {
    let Arrived { whole: Whole { case, job }, model: better, rows: measured, is_adequate } =
        Arrived::at(process, seed)?;
    let hidden = &case.truth.hidden;
    let beyond = force.map(|force| {
        let column = better.process.coordinates().iter().position(|own| own.name == force).unwrap();
        let most = (0..measured.len()).filter_map(|row| measured.get(column, row)).fold(0.0, f64::max);
        let highest: Vec<usize> = (0..measured.len()).filter(|row| measured.get(column, *row) == Some(most)).collect();
        let mut rows = measured.some(&highest);
        rows.columns[column].fill(BEYOND * most);
        let all: Vec<Asked> = (0..rows.len()).map(|row| asked(&better, &rows, row)).collect();
        let again = job.asked(&all)?;
        held(&better, &rows, (&*again, hidden))
    });
    Some(Promised { is_adequate, within: held(&better, &measured, (&*job, hidden))?, beyond: beyond.flatten() })
}

#[test]
#[ignore = "minutes long; prints a table of README.md"]
fn the_whole_of_predictions_of_machines() {
    println!(
        "| | machines | in the data: in the 95 % interval | error, of what was promised, median | one level beyond: machines | in the 95 % interval | error, of what was promised, median |\n|---|---|---|---|---|---|---|"
    );
    for process in PREDICTED {
        let seeds: Vec<u64> = (0..60).step_by(every()).collect();
        let all: Vec<_> = side_by_side(&seeds, |seed| (*seed, promised(process, *seed)));
        if std::env::var_os("FEM_MISSES").is_some() {
            all.iter().for_each(|(seed, own)| println!("{} {seed}: {own:?}", process.0.name));
        }
        let found: Vec<Promised> = all.iter().filter_map(|(_, own)| *own).filter(|own| own.is_adequate).collect();
        let column = |own: &[Held]| {
            let mut errors: Vec<f64> = own.iter().map(|own| own.of_promised).collect();
            errors.sort_by(f64::total_cmp);
            let sum = |of: &dyn Fn(&Held) -> usize| own.iter().map(of).sum::<usize>() as f64;
            match errors.get(errors.len() / 2) {
                Some(middle) => format!("{:.1} % | {middle:.2}", 100.0 * sum(&|own| own.held) / sum(&|own| own.of)),
                None => "- | -".to_string(),
            }
        };
        let within: Vec<Held> = found.iter().map(|own| own.within).collect();
        let beyond: Vec<Held> = found.iter().filter_map(|own| own.beyond).collect();
        println!(
            "| {} | {} of {} | {} | {} | {} |",
            named(process.0),
            found.len(),
            seeds.len(),
            column(&within),
            beyond.len(),
            column(&beyond)
        );
    }
}

#[test]
fn a_sample_of_predicted_machines() {
    for process in PREDICTED.iter().filter(|(_, force)| force.is_some()) {
        let all: Vec<_> = side_by_side(&[0], |seed| promised(*process, *seed));
        for own in all.into_iter().flatten().filter(|own| own.is_adequate) {
            let beyond = own.beyond.expect("the generator makes it");
            assert!(beyond.of_promised < 4.0 && own.within.of_promised < 4.0, "{}: {own:?}", process.0.name);
        }
    }
}
