//! Laws that are in no catalogue: found or not by `fem discover`, on data that the program did not make.

use std::time::Instant;

use fem::discover::discover;
use fem::input::Source;
use fem::measure::Measurements;
use fem::model::{Data, Draft, Model};
use fem::progress::Progress;
use generator::{AXIS, Beside, FIXTURE, HiddenLaw, Process, RING, TURNING};

use crate::{PROCESSES, every, side_by_side};

/// What was said of a case.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Said {
    /// A law is told.
    told: bool,
    /// It is made of the columns of which the hidden one is made.
    right_variables: bool,
    /// What it says of rows that were never shown is right: within the ranges, and beyond them.
    fresh: bool,
    far: bool,
    /// Laws that fit as well are told beside it.
    rivals: bool,
    seconds: f64,
}

/// Standard uncertainties up to which rows that were never shown are foreseen, within the ranges and beyond.
const FRESH: f64 = 1.3;
const FAR: f64 = 1.5;

fn read(model: &str, data: &str) -> (Model, Measurements) {
    let draft = Draft::parse(Source::new("case.toml", model.to_string())).expect("the model is right");
    let data =
        Measurements::parse(Source::new("case.csv", data.to_string()), draft.process()).expect("so are the data");
    (draft.with(&data.recorded).expect("the model is right"), data)
}

/// Root mean square of the residuals of other rows, in standard uncertainties.
fn unseen(model: &str, data: &str) -> f64 {
    let (model, data) = read(model, data);
    let Some(u) = data.uncertainty.clone() else { return f64::INFINITY };
    let Ok(data) = Data::of(&model, data) else { return f64::INFINITY };
    let Ok(predicted) = model.forward().observe(&data.rows) else { return f64::INFINITY };
    let left = data.residuals(&predicted);
    let squares: f64 = left.iter().zip(u.iter()).map(|(left, u)| (left / u).powi(2)).sum();
    (squares / left.len() as f64).sqrt()
}

fn said(case: &HiddenLaw, label: &str) -> Said {
    let (model, data) = read(&case.model, &case.data);
    let data = Data::of(&model, data).expect("every row lies in the model");
    let start = Instant::now();
    let found = discover(&data, &[], &Progress::default());
    let seconds = start.elapsed().as_secs_f64();
    let found = match found {
        Ok(found) => found,
        Err(failure) => {
            println!("{label}: {}", failure.message);
            keep(case, label);
            return Said { seconds, ..Said::default() };
        }
    };
    let law = found.told();
    let model = law.and_then(|law| law.model.as_ref());
    let names = |law: &fem::discover::Law| {
        let mut names: Vec<String> = law.ranked.variables.iter().flat_map(|name| words(name)).collect();
        names.sort();
        names.dedup();
        names
    };
    let mut wanted = case.variables.clone();
    wanted.sort();
    let text = model.map(|model| model.text_at(std::path::Path::new("case.toml")));
    let of = |rows: &str| text.as_ref().map_or(f64::INFINITY, |text| unseen(text, rows));
    let (fresh, far) = if case.law.is_empty() { (f64::NAN, f64::NAN) } else { (of(&case.fresh), of(&case.far)) };
    let said = Said {
        told: law.is_some(),
        right_variables: law.is_some_and(|law| names(law) == wanted),
        fresh: fresh <= FRESH,
        far: far <= FAR,
        rivals: found.laws.len() > 1,
        seconds,
    };
    if std::env::var_os("FEM_MISSES").is_some() && (law.is_some() == case.law.is_empty() || !said.far || !said.fresh) {
        let formula = found.laws.first().map_or("none", |law| law.ranked.written.formula.as_str());
        let held = if law.is_some() { "told" } else { "held back" };
        println!("{label}: {} | {held}: {formula} | fresh {fresh:.2} far {far:.2} {seconds:.1} s", case.law);
        keep(case, label);
    }
    said
}

/// Writes the files of a case into the folder `FEM_MISSES`, if there is one.
fn keep(case: &HiddenLaw, label: &str) {
    let Some(directory) = std::env::var_os("FEM_MISSES").filter(|own| !own.is_empty()) else { return };
    let stem = std::path::Path::new(&directory).join(label);
    std::fs::write(stem.with_extension("toml"), &case.model).unwrap();
    std::fs::write(stem.with_extension("csv"), &case.data).unwrap();
    std::fs::write(stem.with_extension("fresh.csv"), &case.fresh).unwrap();
    std::fs::write(stem.with_extension("far.csv"), &case.far).unwrap();
}

/// The names in a difference.
fn words(name: &str) -> Vec<String> {
    name.split(|c: char| !c.is_alphanumeric() && c != '_').filter(|word| !word.is_empty()).map(String::from).collect()
}

fn all(cases: Vec<(String, HiddenLaw)>) -> Vec<Said> {
    side_by_side(&cases, |(label, case)| said(case, label))
}

fn percent(part: usize, whole: usize) -> String {
    format!("{part} of {whole}")
}

fn row(name: &str, said: &[Said]) {
    let count = |is: fn(&Said) -> bool| said.iter().filter(|own| is(own)).count();
    let learned = count(|own| own.told && own.right_variables && own.fresh && own.far);
    let told = count(|own| own.told);
    let wrong = count(|own| own.told && !(own.fresh && own.far) && !own.rivals);
    let mut seconds: Vec<f64> = said.iter().map(|own| own.seconds).collect();
    seconds.sort_by(f64::total_cmp);
    println!(
        "| {name} | {} | {} | {} | {} | {:.1} s, {:.1} s |",
        percent(learned, said.len()),
        percent(told, said.len()),
        percent(count(|own| own.told && own.right_variables), told),
        wrong,
        seconds[seconds.len() / 2],
        seconds[seconds.len() - 1]
    );
}

fn cases(
    process: &'static Process,
    name: &str,
    beside: Beside,
    size: f64,
    seeds: std::ops::Range<u64>,
) -> Vec<(String, HiddenLaw)> {
    let of = |seed| (format!("{name}-{beside:?}-{seed}"), process.hidden_law(beside, size, seed));
    seeds.step_by(every()).map(of).collect()
}

#[test]
#[ignore = "minutes long; prints a table of README.md"]
fn the_whole_of_laws() {
    println!(
        "| | learned | told | of these by the right columns | told, wrong, no rival | median, worst |\n|---|---|---|---|---|---|"
    );
    let mut whole = Vec::new();
    for (name, process) in PROCESSES {
        let own = all(cases(process, name, Beside::Law, 8.0, 5000..5024));
        row(name, &own);
        whole.extend(own);
    }
    row("all", &whole);
    for (name, beside, size) in [("3 sigma", Beside::Law, 3.0), ("a decoy", Beside::LawAndDecoy, 8.0)] {
        let own = PROCESSES.iter().flat_map(|(name, process)| cases(process, name, beside, size, 5100..5106));
        row(name, &all(own.collect()));
    }
}

#[test]
#[ignore = "minutes long; prints a table of README.md"]
fn the_whole_of_no_laws() {
    println!("| | false laws |\n|---|---|");
    for (name, beside) in
        [("white noise", Beside::Noise), ("drift", Beside::Drift), ("correlated noise", Beside::Correlated)]
    {
        let own = PROCESSES.iter().flat_map(|(name, process)| cases(process, name, beside, 0.0, 5200..5238));
        let said = all(own.collect());
        println!("| {name} | {} |", percent(said.iter().filter(|own| own.told).count(), said.len()));
    }
    let labelled: [(&str, &'static Process); 4] =
        [("turned", &TURNING), ("rings", &RING), ("axes", &AXIS), ("fixtures", &FIXTURE)];
    let own = labelled.iter().flat_map(|(name, process)| cases(process, name, Beside::Zeros, 0.0, 5200..5276));
    let said = all(own.collect());
    println!("| a zero of each part or run | {} |", percent(said.iter().filter(|own| own.told).count(), said.len()));
}

#[test]
fn a_sample_of_laws() {
    let said = all(cases(&AXIS, "axes", Beside::Law, 8.0, 5009..5012));
    assert!(said.iter().all(|own| !own.told || own.rivals || own.fresh && own.far), "{said:?}");
    let noises = [Beside::Noise, Beside::Zeros];
    let of_noises = noises.iter().flat_map(|beside| cases(&AXIS, "axes", *beside, 0.0, 5200..5201));
    let said = all(of_noises.collect());
    assert!(said.iter().all(|own| !own.told), "{said:?}");
}
