//! One direction of dependence: a layer uses only those that stand before it in `fem/lib.rs`, and no files
//! use each other in a circle.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod uses;

use std::path::{Path, PathBuf};

/// From the ground up.
const LAYERS: &[&str] = &[
    "units",
    "progress",
    "formula",
    "input",
    "element",
    "material",
    "joint",
    "mesh",
    "series",
    "solve",
    "positioning",
    "roundness",
    "tolerance",
    "gcode",
    "process",
    "processes",
    "measure",
    "noise",
    "model",
    "compare",
    "fit",
    "compensate",
    "diagnose",
    "discover",
    "budget",
    "knowledge",
    "correct",
    "next",
    "study",
    "remedy",
    "validation",
    "output",
    "ask",
    "workbench",
    "cli",
];

/// Every Rust file under a directory.
fn sources(directory: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(directory).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(sources(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
    found
}

fn rank(layer: &str) -> Option<usize> {
    LAYERS.iter().position(|l| *l == layer)
}

#[test]
fn no_layer_uses_a_higher_one() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("fem");
    let mut uses = 0;
    for file in sources(&root) {
        let inside = file.strip_prefix(&root).unwrap();
        let own = inside.iter().next().unwrap().to_str().unwrap().trim_end_matches(".rs");
        if ["lib", "main"].contains(&own) {
            continue;
        }
        let own_rank = rank(own).unwrap_or_else(|| panic!("{own} is no known layer"));
        for line in std::fs::read_to_string(&file).unwrap().lines() {
            for used in line.split("crate::").skip(1) {
                let end = used.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(used.len());
                let Some(used_rank) = rank(&used[..end]) else { continue };
                assert!(used_rank <= own_rank, "{}: {} uses {}", inside.display(), own, &used[..end]);
                uses += 1;
            }
        }
    }
    assert!(uses > 50, "the test found only {uses} uses");
}

#[test]
fn files_and_processes_stay_apart() {
    // What is above the processes knows none by name; the validation table has a bench for each.
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("fem");
    let above = LAYERS.iter().skip_while(|layer| **layer != "processes").skip(1);
    for layer in above.filter(|layer| **layer != "validation").chain(&["input"]) {
        for file in sources(&root.join(layer)) {
            let text = std::fs::read_to_string(&file).unwrap();
            let code = text.lines().filter(|l| !l.trim_start().starts_with("//"));
            let names = |l: &&str| {
                let of = |name: &str| [format!("processes::{name}"), format!("\"{name}\""), format!("new {name}")];
                fem::processes::ALL.iter().any(|p| of(p.name()).iter().any(|word| l.contains(word.as_str())))
            };
            for line in code.filter(names) {
                // Examples in the help text name one.
                assert!(file.ends_with("cli/args.rs"), "{}: {line}", file.display());
            }
        }
    }
}

#[test]
fn no_files_use_each_other_in_a_circle() {
    let uses = uses::Sources::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("fem")).uses();
    let count: usize = uses.values().map(|used| used.len()).sum();
    assert!(count > 500, "the test found only {count} uses");
    // The layers are in it: what runs a model uses what reads it.
    assert!(uses[Path::new("model/run")].contains(Path::new("model/mod")));
    let circles = uses::circles(&uses);
    assert!(circles.is_empty(), "{circles:#?}");
}
