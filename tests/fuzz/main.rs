//! No input makes the program panic, abort, run without end, take all memory, or print what is no number.
//!
//! Good models, tables and meshes are changed by what stands in them (units, signs, magnitudes, missing and
//! empty columns, unknowns) and by bytes, and every command is run on them. A sample runs with the tests; as
//! many as one likes by
//!
//! ```sh
//! FEM_FUZZ_RUNS=20000 FEM_FUZZ_SEED=1 cargo test --release --test fuzz
//! ```
//!
//! What is found is kept in `tests/fuzz/regressions`, a folder each, and runs with the tests from then on.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod corpus;
mod mutate;
mod rng;
mod run;

use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;

use corpus::Corpus;
use run::{Case, Fault, Limits, judge};

/// Runs of the sample that goes with the tests, and its first seed.
const SAMPLE: u64 = 100;
const SEED: u64 = 1;
/// What a case of the sample may take; it is run by an unoptimised program among other tests.
const LIMITS: Limits = Limits { time: Duration::from_secs(60), memory: 1_000_000 };
/// Runs side by side.
const TOGETHER: u64 = 2;

fn said(name: &str) -> Option<u64> {
    std::env::var(name).ok().map(|text| text.parse().unwrap_or_else(|_| panic!("{name} is no whole number")))
}

fn regressions() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fuzz/regressions")
}

#[test]
fn no_changed_file_breaks_anything() {
    let corpus = Corpus::load();
    let (runs, seed) = (said("FEM_FUZZ_RUNS"), said("FEM_FUZZ_SEED").unwrap_or(SEED));
    // Searches of the sample are cut short; those of a long run have more time.
    let limit = Some(if runs.is_none() { "500 ms" } else { "10 s" });
    let time = said("FEM_FUZZ_SECONDS").map_or(LIMITS.time, Duration::from_secs);
    let limits = Limits { time, ..LIMITS };
    let (next, accepted, found) = (AtomicU64::new(0), AtomicU64::new(0), Mutex::new(Vec::new()));
    let work = || {
        loop {
            let number = next.fetch_add(1, Ordering::Relaxed);
            if number >= runs.unwrap_or(SAMPLE) {
                return;
            }
            let case = corpus.case(seed + number, limit);
            let outcome = case.run(limits);
            if outcome == Ok(0) {
                accepted.fetch_add(1, Ordering::Relaxed);
            }
            if let Err(fault) = outcome {
                let name = format!("seed-{}", seed + number);
                eprintln!("{name}: {fault:?}: fem {}", case.command.join(" "));
                if runs.is_some() {
                    case.keep(&regressions().join(&name));
                }
                found.lock().unwrap().push((name, fault));
            }
        }
    };
    std::thread::scope(|scope| (0..TOGETHER).for_each(|_| drop(scope.spawn(work))));
    let found = found.into_inner().unwrap();
    let (runs, accepted) = (runs.unwrap_or(SAMPLE), accepted.into_inner());
    println!("{accepted} of {runs} runs came to an answer, {} to a fault", found.len());
    assert!(found.is_empty(), "{} of {runs} runs: {found:#?}", found.len());
    // Changes that nothing gets past the reader with would look for nothing behind it.
    assert!(runs < SAMPLE || accepted * 10 > runs, "{accepted} of {runs}");
}

#[test]
fn what_was_found_once_is_mended() {
    let mut folders: Vec<_> = std::fs::read_dir(regressions()).unwrap().map(|e| e.unwrap().path()).collect();
    folders.retain(|folder| folder.is_dir());
    folders.sort();
    assert!(!folders.is_empty());
    let faults: Vec<(String, Fault)> = folders
        .iter()
        .filter_map(|folder| {
            Some((folder.file_name()?.to_string_lossy().into_owned(), Case::load(folder).run(LIMITS).err()?))
        })
        .collect();
    assert!(faults.is_empty(), "{faults:#?}");
}

#[test]
fn faults_are_told_from_answers() {
    assert_eq!(judge(Some(0), "noise 0.3 um", ""), None);
    assert_eq!(judge(Some(2), "", "error: `NaN` is no finite number"), None);
    assert_eq!(judge(Some(0), "infinite stiffness, nanometres, info", ""), None);
    assert!(matches!(judge(Some(0), "lost motion NaN +- NaN um", ""), Some(Fault::NoNumber(_))));
    assert!(matches!(judge(Some(0), "rms inf", ""), Some(Fault::NoNumber(_))));
    assert!(matches!(judge(Some(101), "", "thread 'main' panicked at x.rs:1:2"), Some(Fault::Status(_))));
    assert!(matches!(judge(None, "", "memory allocation of 4 bytes failed"), Some(Fault::Status(_))));
    assert!(matches!(judge(Some(2), "", &"x".repeat(100_000)), Some(Fault::Told(_))));
}

#[test]
fn the_same_seed_makes_the_same_case_and_others_make_others() {
    let corpus = Corpus::load();
    let case = |seed| format!("{:?}", corpus.case(seed, None));
    assert_eq!(case(7), case(7));
    let all: std::collections::BTreeSet<String> = (0..100).map(case).collect();
    assert_eq!(all.len(), 100);
}
