//! Whole diagnoses of practice cases of every process, by the true noise or not, with nothing to three effects hidden:
//! how long they take, and how much of that the model itself takes.
//!
//! `cargo bench --bench diagnose`, or `-- axis` for one process. It prints a table; nothing else should run beside it.

#![allow(clippy::unwrap_used, clippy::expect_used)]
#![allow(missing_docs)]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::Instant;

use fem::diagnose::{MOST_EFFECTS, diagnose};
use fem::fit::Objective;
use fem::input::Source;
use fem::measure::Measurements;
use fem::model::{Data, Model};
use fem::progress::Progress;

/// Diagnoses of each case, of which the quickest counts.
const TIMES: usize = 3;
/// Evaluations of the model from which the time of one is told.
const TRIALS: usize = 200;

struct Timed {
    name: String,
    rows: usize,
    seconds: f64,
    evaluations: usize,
    /// Time of one evaluation of the model as it is written, s.
    trial: f64,
}

fn timed(folder: &Path) -> Timed {
    let read = |name: &str| {
        let path = folder.join(name);
        Source::new(path.display().to_string(), std::fs::read_to_string(&path).unwrap())
    };
    let model = Model::parse(read("model.toml")).unwrap();
    let data = Data::of(&model, Measurements::parse(read("measured.csv"), &*model.process).unwrap()).unwrap();
    let (mut seconds, mut evaluations) = (f64::INFINITY, 0);
    for _ in 0..TIMES {
        let start = Instant::now();
        let diagnosis = diagnose(&data, MOST_EFFECTS, &Progress::default()).unwrap();
        seconds = seconds.min(start.elapsed().as_secs_f64());
        evaluations = diagnosis.trials.1;
    }
    let objective = Objective::new(&data).unwrap();
    let first = objective.variables.iter().map(|v| v.position(v.starts.first().copied().unwrap_or(0.0)));
    let position = nalgebra::DVector::from_iterator(objective.variables.len(), first);
    let start = Instant::now();
    for trial in 0..TRIALS {
        // What was asked for before may be known.
        objective.predict(&(&position * (1.0 + 1e-9 * trial as f64))).unwrap();
    }
    let name = folder.file_name().unwrap().to_string_lossy().into_owned();
    let trial = start.elapsed().as_secs_f64() / TRIALS as f64;
    Timed { name, rows: data.len(), seconds, evaluations, trial }
}

fn main() {
    let wanted: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with('-')).collect();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/hidden");
    let mut folders: Vec<PathBuf> = std::fs::read_dir(root).unwrap().map(|f| f.unwrap().path()).collect();
    folders.retain(|f| f.is_dir());
    folders.sort();
    let mut by_process: BTreeMap<String, Vec<Timed>> = BTreeMap::new();
    for folder in folders {
        let name = folder.file_name().unwrap().to_string_lossy().into_owned();
        let process = name.split('-').next().unwrap().to_string();
        if wanted.is_empty() || wanted.contains(&process) {
            by_process.entry(process).or_default().push(timed(&folder));
        }
    }
    println!("| case | rows | evaluations | one of the bare model, us | of them in all, s | diagnosis, s |");
    println!("|---|---|---|---|---|---|");
    for (process, mut cases) in by_process {
        for c in &cases {
            let all = c.trial * c.evaluations as f64;
            println!(
                "| {} | {} | {} | {:.1} | {all:.2} | {:.2} |",
                c.name,
                c.rows,
                c.evaluations,
                1e6 * c.trial,
                c.seconds
            );
        }
        cases.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
        let (median, worst) = (cases[cases.len() / 2].seconds, cases[cases.len() - 1].seconds);
        println!("| **{process}** | | | | | median {median:.2}, worst {worst:.2} |");
    }
}
