//! The validation table: every row within its tolerance, and no row within it when its expected value is
//! shifted.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod seeds;

use std::sync::LazyLock;

use fem::validation::{Case, Tolerance};

/// Every part of the table, computed once.
static TABLES: LazyLock<Vec<(&'static str, Vec<Case>)>> =
    LazyLock::new(|| fem::validation::PARTS.iter().map(|(name, cases)| (*name, cases())).collect());

/// The same row with an expected value that is off by three tolerances (or by the smallest difference that
/// exists).
fn shifted(case: &Case) -> Case {
    let shift = match case.tolerance {
        Tolerance::Relative(allowed) => 3.0 * allowed * case.expected.abs(),
        Tolerance::Absolute(allowed) => 3.0 * allowed,
    };
    Case { expected: case.expected + shift.max(f64::MIN_POSITIVE), ..case.clone() }
}

#[test]
fn every_row_is_within_its_tolerance() {
    for (_, cases) in TABLES.iter() {
        let failed: Vec<&Case> = cases.iter().filter(|c| !c.passed()).collect();
        assert!(failed.is_empty(), "{failed:#?}");
    }
}

#[test]
fn no_row_passes_with_another_expected_value() {
    for (_, cases) in TABLES.iter() {
        for case in cases {
            let twin = shifted(case);
            assert!(!twin.passed(), "{}: {} passes for {}", case.name, case.computed, twin.expected);
        }
    }
}

#[test]
fn the_page_says_how_many_there_are() {
    let cases: usize = TABLES.iter().map(|(_, cases)| cases.len()).sum();
    assert!(
        include_str!("../../docs/validation.md").contains(&format!("computes {cases} cases")),
        "there are {cases} cases"
    );
}

#[test]
fn a_row_that_is_no_number_fails() {
    let case = Case { computed: f64::NAN, ..TABLES[0].1[0].clone() };
    assert!(!case.passed());
}

#[test]
fn rows_have_names_of_their_own_and_sources() {
    for (table, cases) in TABLES.iter() {
        assert!(cases.len() >= 20, "{table} has {} rows", cases.len());
        for (i, case) in cases.iter().enumerate() {
            assert!(!case.source.is_empty(), "{}", case.name);
            let same = |other: &&Case| (&other.name, other.quantity) == (&case.name, case.quantity);
            assert!(cases[..i].iter().find(same).is_none(), "{} stands twice", case.name);
        }
    }
}
