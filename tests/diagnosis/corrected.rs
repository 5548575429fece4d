//! What is left of a machine's errors when it is corrected: diagnosed from measurements, corrected through the model that the
//! diagnosis arrives at, and made again by the generator, which shares nothing with the program.

use fem::correct::{Correction, correct};
use fem::model::Model;
use fem::process::{Answers, Holds};
use fem::progress::Progress;
use generator::asked::Asked;
use generator::dense::Basis;
use generator::job::Job;
use generator::random::decimals;
use generator::{AXIS, CONTOUR, FIXTURE, Hidden, Process, RING, THERMAL, TURNING, Whole};

use crate::arrived::{Arrived, named, parsed};
use crate::{every, side_by_side};

/// Places of a part at which it is made again.
const PLACES: usize = 9;

/// Processes whose command is corrected.
const CORRECTED: [&Process; 6] = [&TURNING, &AXIS, &CONTOUR, &FIXTURE, &RING, &THERMAL];

/// How a corrected machine stands.
#[derive(Clone, Copy, Debug)]
struct Corrected {
    /// Whether nothing was left beyond the noise before the correction.
    adequate: bool,
    /// Root mean square of the error as it was, and with the correction, in standard deviations of the noise.
    before: f64,
    after: f64,
    /// Parts, those that are worse than they were, and places that the promised interval holds, of all.
    parts: usize,
    worse: usize,
    held: usize,
    places: usize,
    /// Root mean square of what was left, in standard uncertainties that were promised.
    of_promised: f64,
}

/// Coordinates that a machine is told when it makes something again, beside those of the contours.
const TOLD: &[&str] = &["time", "blank", "run"];

/// To what a generator knows a place (SI).
fn known(process: &str, place: f64) -> f64 {
    match process {
        "thermal" => (place / 15.0).round().max(1.0) * 15.0,
        "turning" | "axis" => 1e-3 * decimals(1e3 * place, 4),
        "fixture" => 1e-3 * decimals(1e3 * place, 3),
        _ => place,
    }
}

/// Makes again what was made, corrected or as it was: rows of a correction, with what the generator makes there, um, as errors.
fn made(job: &dyn Job, hidden: &[Hidden], (model, found): (&Model, &Correction), share: f64) -> Vec<(usize, f64)> {
    let (name, coordinates) = (model.process.name(), model.process.coordinates());
    let along = found.commanded.along;
    let of_contour = |own: &std::ops::Range<usize>| {
        let step = if name == "turning" { (own.len() - 1) / (PLACES - 1) } else { 1 };
        own.clone().step_by(step).collect::<Vec<usize>>()
    };
    let rows: Vec<usize> = found.command.contours().iter().flat_map(|(_, own)| of_contour(own)).collect();
    let asked = |row: &usize| {
        let of = |column: usize| found.rows.columns[column][*row];
        let apart: Vec<f64> = found.commanded.apart().map(of).collect();
        let place = known(name, of(along));
        let mut asked = Asked {
            observable: model.process.observables()[found.commanded.observable].name.to_string(),
            numbers: vec![(found.commanded.key.to_string(), share * found.command.at(place, &apart))],
            words: Vec::new(),
        };
        for (column, coordinate) in coordinates.iter().enumerate() {
            let is_told = found.commanded.apart().any(|own| own == column)
                || name != "turning" && TOLD.contains(&&*coordinate.name);
            match &coordinate.holds {
                _ if column == along => asked.numbers.push((coordinate.name.to_string(), place)),
                _ if !is_told || of(column).is_nan() => {}
                Holds::Word(words) => {
                    asked.words.push((coordinate.name.to_string(), words.of_value(of(column)).unwrap().to_string()));
                }
                _ => asked.numbers.push((coordinate.name.to_string(), of(column))),
            }
        }
        asked
    };
    let all: Vec<Asked> = rows.iter().map(asked).collect();
    let again = job.asked(&all).expect("the generator makes it");
    let values = again.predict(hidden);
    // What the way of measuring does not show.
    let mut blind = Basis::default();
    again.blind().iter().for_each(|direction| blind.add(direction));
    rows.into_iter().zip(blind.remainder(&values)).collect()
}

fn rms(values: impl Iterator<Item = f64>) -> f64 {
    let (count, square) = values.fold((0, 0.0), |(count, sum), value| (count + 1, sum + value * value));
    (square / f64::from(count.max(1))).sqrt()
}

/// A machine corrected by the model that a diagnosis arrives at; `None` where it leaves a value unknown, or known too roughly.
fn corrected(process: &Process, seed: u64) -> Option<Corrected> {
    let Arrived { whole: Whole { case, job }, model: better, is_adequate, .. } = Arrived::at(process, seed)?;
    // What is known too roughly is told so.
    let found = correct(&better, &Progress::default()).ok()??;
    let hidden = &case.truth.hidden;
    let again = |share: f64| made(&*job, hidden, (&better, &found), share);
    let (was, is) = (again(0.0), again(1.0));
    let noise = case.truth.sigma;
    let number = |row: usize| found.commanded.number.map_or(0, |column| found.rows.columns[column][row] as usize);
    let mut parts: Vec<usize> = is.iter().map(|(row, _)| number(*row)).collect();
    parts.sort_unstable();
    parts.dedup();
    let of_part = |all: &[(usize, f64)], part: usize| {
        rms(all.iter().filter(|(row, _)| number(*row) == part).map(|(_, value)| *value))
    };
    let is_held = |(row, value): &&(usize, f64)| {
        let [low, high] = found.band.interval[*row].map(|si| 1e6 * si);
        (low..=high).contains(value)
    };
    Some(Corrected {
        adequate: is_adequate,
        before: rms(was.iter().map(|(_, value)| *value)) / noise,
        after: rms(is.iter().map(|(_, value)| *value)) / noise,
        parts: parts.len(),
        worse: parts.iter().filter(|part| of_part(&is, **part) > of_part(&was, **part)).count(),
        held: is.iter().filter(is_held).count(),
        places: is.len(),
        of_promised: rms(is.iter().map(|(row, value)| {
            let [low, high] = found.band.interval[*row].map(|si| 1e6 * si);
            (value - 1e6 * found.left[*row]) / (0.5 * (high - low) / 1.96)
        })),
    })
}

fn all(process: &Process, seeds: impl Iterator<Item = u64>) -> Vec<(u64, Option<Corrected>)> {
    side_by_side(&seeds.collect::<Vec<_>>(), |seed| (*seed, corrected(process, *seed)))
}

/// The correction of the true model leaves nothing, whatever feeds back, copies or lifts off: it is made by other code.
#[test]
fn the_correction_of_the_true_model_leaves_nothing() {
    for process in CORRECTED {
        for seed in 0..4 {
            let Whole { case, job } = process.whole_machine(seed);
            let model = parsed(&case.revealed);
            let found = correct(&model, &Progress::default()).unwrap().unwrap();
            // Behind a jump drives stay behind.
            let behind = if found.commanded.answers == Answers::Along { found.left.len() / 50 } else { 0 };
            assert!(found.unreached <= behind, "{} {seed}: {}", process.name, found.unreached);
            let again = |share| made(&*job, &case.truth.hidden, (&model, &found), share);
            let (was, left) = (again(0.0), again(1.0));
            let was = rms(was.into_iter().map(|(_, value)| value));
            let worst = left.iter().fold(0.0f64, |worst, (_, value)| worst.max(value.abs()));
            // Tables between places; behind a jump drives stay behind, and the least share of the error is then left.
            let (left_over, fine) = match found.commanded.answers {
                Answers::Here => (worst, 0.01 * was + 0.05),
                Answers::Along => (rms(left.iter().map(|(_, value)| *value)), 0.03 * was),
            };
            println!("{} {seed}: {worst} um, rms {left_over} of {was}", process.name);
            assert!(left_over < fine, "{} {seed}: {worst} um of {was} um", process.name);
        }
    }
}

#[test]
#[ignore = "minutes long; prints a table of README.md"]
fn the_whole_of_corrections_of_machines() {
    println!(
        "| | | machines | left within 1.3 of the noise | median left | error taken away, median | worse parts | in the 95 % interval | left, of what was promised |\n|---|---|---|---|---|---|---|---|---|"
    );
    for process in CORRECTED {
        let all = all(process, (0..60).step_by(every()));
        let found: Vec<Corrected> = all.iter().filter_map(|(_, own)| *own).collect();
        if std::env::var_os("FEM_MISSES").is_some() {
            all.iter().for_each(|(seed, own)| println!("{} {seed}: {own:?}", process.name));
        }
        for (name, adequate) in [("explained", true), ("partly", false)] {
            let own: Vec<&Corrected> = found.iter().filter(|own| own.adequate == adequate).collect();
            println!("| {} | {name} {}", named(process), row(&own, all.len()));
        }
    }
}

/// A row of the table.
fn row(own: &[&Corrected], all: usize) -> String {
    let middle = |value: &dyn Fn(&Corrected) -> f64| {
        let mut values: Vec<f64> = own.iter().map(|own| value(own)).collect();
        values.sort_by(f64::total_cmp);
        values.get(values.len() / 2).copied().unwrap_or(f64::NAN)
    };
    let sum = |value: &dyn Fn(&Corrected) -> usize| own.iter().map(|own| value(own)).sum::<usize>();
    format!(
        "| {} of {all} | {} | {:.2} | {:.1} % | {} of {} | {:.1} % | {:.2} |",
        own.len(),
        own.iter().filter(|own| own.after <= 1.3).count(),
        middle(&|own| own.after),
        100.0 * middle(&|own| 1.0 - own.after / own.before),
        sum(&|own| own.worse),
        sum(&|own| own.parts),
        100.0 * sum(&|own| own.held) as f64 / sum(&|own| own.places).max(1) as f64,
        rms(own.iter().map(|own| own.of_promised).filter(|own| own.is_finite()))
    )
}

#[test]
fn a_sample_of_corrected_machines() {
    for process in CORRECTED {
        for (seed, own) in all(process, 0..1) {
            let Some(own) = own else { continue };
            assert!(!own.adequate || own.after < 1.3 && own.worse == 0, "{} {seed}: {own:?}", process.name);
        }
    }
}
