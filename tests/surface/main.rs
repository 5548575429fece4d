//! The interface of the library is what `fem/lib.rs` offers at its root: a change of it is a change here too. Modules
//! are hidden, so that no path through them becomes part of it.

#![allow(clippy::unwrap_used)]

use std::path::Path;

/// Lists the names, in the order of the alphabet, and uses every one: what is gone does not compile.
macro_rules! offered {
    ($($name:ident)*) => {
        mod each {
            #[allow(unused_imports)]
            pub use fem::{$($name),*};
        }

        const OFFERED: &[&str] = &[$(stringify!($name)),*];
    };
}

offered! {
    Answer Budget BudgetAnswer BudgetEstimate CatalogueAnswer Comparison ComparisonAnswer Compensation
    CompensationAnswer Contribution Data Decimal Description Diagnosis DiagnosisAnswer Entry Error Estimate Failure
    Feasibility Figure Fit FitAnswer Folder GoodnessOfFit Guard InputError Interval Kind Knowledge Measurements
    Missing Model Observable OutputError PROCESSES Parameter Plan PlanAnswer Problem Process Progress Quantity Reading
    Run RunAnswer RunReport Setting Source Study StudyAnswer StudyPlan Untold Verdict add_effect catalogue command
    compare compare_all compensate completed diagnose figures fit fitted json plan revised study text
}

/// The code of `fem/lib.rs`.
fn root() -> String {
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("fem/lib.rs")).unwrap();
    text.lines().filter(|line| !line.trim_start().starts_with("//")).map(|line| format!("{line}\n")).collect()
}

/// The names that a tree such as `a::{b, c as d}` offers.
fn names(tree: &str) -> Vec<String> {
    let leaves = tree.split_once('{').map_or(tree, |(_, inside)| inside.trim_end().trim_end_matches('}'));
    let name = |leaf: &str| leaf.rsplit([':', ' ']).next().unwrap_or_default().to_string();
    leaves.split(',').map(str::trim).filter(|leaf| !leaf.is_empty()).map(name).collect()
}

#[test]
fn the_root_offers_these_names() {
    let root = root();
    let mut found: Vec<String> =
        root.split("pub use ").skip(1).flat_map(|rest| names(rest.split(';').next().unwrap())).collect();
    found.sort_unstable();
    assert_eq!(found, OFFERED);
}

#[test]
fn every_module_is_hidden() {
    let root = root();
    let mut before = "";
    let mut modules = 0;
    for line in root.lines().filter(|line| !line.is_empty()) {
        if line.starts_with("pub mod ") {
            assert_eq!(before, "#[doc(hidden)]", "{line}");
            modules += 1;
        } else {
            // Nothing else is public at the root.
            assert!(!line.starts_with("pub ") || line.starts_with("pub use "), "{line}");
        }
        before = line;
    }
    assert!(modules > 20, "the test found only {modules} modules");
}
