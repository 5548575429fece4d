//! Effects of which nothing is known but that they are there: every value of a whole machine's hidden effects is written as
//! `?`, and the fit is to come at least as deep as the truth.

use fem::fit::fit;
use fem::input::Source;
use fem::measure::Measurements;
use fem::model::{Data, Model};
use generator::{Case, FIXTURE, Process, THERMAL};

use crate::score::between;
use crate::{PROCESSES, every};

/// A machine's fit.
struct Fitted {
    /// χ² of the rows by the true noise is no larger than that of the truth.
    is_deep: bool,
    /// Intervals that hold the true value, and intervals.
    covered: (usize, usize),
    said: String,
}

/// The model with `?` in the place of every hidden value.
fn unknown(case: &Case) -> String {
    let mut text = String::new();
    let mut is_hidden = false;
    for line in case.revealed.lines() {
        if let Some(table) = line.strip_prefix('[') {
            is_hidden = case.truth.hidden.iter().any(|h| table == format!("effects.{}]", h.effect));
        }
        match line.split_once(" = ") {
            Some((key, value)) if is_hidden => {
                let unit =
                    value.trim_matches('"').split_once(' ').map_or(String::new(), |(_, unit)| format!(" {unit}"));
                text += &format!("{key} = \"?{unit}\"\n");
            }
            _ => text += &format!("{line}\n"),
        }
    }
    text
}

fn fitted(process: &Process, seed: u64) -> Fitted {
    let case = process.whole_machine(seed).case;
    let model = Model::parse(Source::new("case.toml", unknown(&case))).expect("the model is right");
    let data =
        Measurements::parse(Source::new("case.csv", case.data.clone()), &*model.process).expect("so are the data");
    let data = Data::of(&model, data).expect("every row lies in the model");
    let hidden: Vec<&str> = case.truth.hidden.iter().map(|h| h.effect).collect();
    let fit = match fit(&data) {
        Ok(fit) => fit,
        Err(failure) => return Fitted { is_deep: false, covered: (0, 0), said: format!("{hidden:?}: {failure}") },
    };
    let noise = &case.truth.noise_of_rows;
    let left = data.residuals(&fit.predicted);
    let chi2 = left.iter().zip(noise).map(|(left, sigma)| (left / sigma).powi(2)).sum::<f64>();
    let of_truth = between(&case.revealed, &case.data, noise).powi(2);
    let mut covered = (0, 0);
    for hidden in &case.truth.hidden {
        for (name, value) in &hidden.parameters {
            let path = format!("effects.{}.{name}", hidden.effect);
            let Some(e) = fit.estimates.iter().find(|e| e.parameter.path == *path) else { continue };
            let si = e.parameter.kind.to_si(*value);
            let holds = e.interval.contains(si);
            covered = (covered.0 + usize::from(holds), covered.1 + 1);
        }
    }
    Fitted {
        is_deep: chi2 <= of_truth,
        covered,
        said: format!("{hidden:?}: chi2 {chi2:.1}, of the truth {of_truth:.1}"),
    }
}

/// Machines, those whose fit is deep, and of these the intervals that hold the truth.
fn tally(process: &Process, seeds: impl Iterator<Item = u64>) -> [usize; 4] {
    let mut counts = [0; 4];
    for (seed, own) in seeds.map(|seed| (seed, fitted(process, seed))) {
        counts[0] += 1;
        if own.is_deep {
            counts[1] += 1;
            (counts[2], counts[3]) = (counts[2] + own.covered.0, counts[3] + own.covered.1);
        } else if std::env::var_os("FEM_MISSES").is_some() {
            println!("{seed}: {}", own.said);
        }
    }
    counts
}

#[test]
#[ignore = "minutes long; prints a table of README.md"]
fn the_whole_of_unknown_values() {
    println!("| | machines | as deep as the truth | intervals that hold it |\n|---|---|---|---|");
    for (name, process) in PROCESSES {
        let [machines, deep, held, values] = tally(process, (3000..3040).step_by(every()));
        println!("| {name} | {machines} | {deep} | {held} of {values} |");
    }
}

/// A rod and a part in a fixture, whose fits from values spread evenly end beside the truth, or nowhere.
#[test]
fn a_sample_of_unknown_values() {
    for (process, seeds) in [(&THERMAL, 3000..3002), (&FIXTURE, 3000..3004)] {
        let [machines, deep, ..] = tally(process, seeds);
        assert_eq!(deep, machines);
    }
}
