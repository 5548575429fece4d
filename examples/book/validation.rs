//! The tables of validation: every row, and how near the rows of each source come.

use std::collections::BTreeMap;
use std::path::PathBuf;

use fem::validation::{Case, PARTS, Tolerance};

use super::chapters::Chapter;
use super::markdown::{code, plain, table};
use super::{Made, Pages};

/// The table by sources, and a page of rows for each part of the program.
pub fn all(deep: usize) -> Pages {
    let parts: Vec<(&str, Vec<Case>)> = PARTS.iter().map(|(name, cases)| (*name, cases())).collect();
    let mut pages = vec![page("by source", "sources", deep, by_source(&parts))];
    for (name, cases) in &parts {
        pages.push(page(&format!("rows of {name}"), name, deep, rows(name, cases)));
    }
    pages
}

fn page(title: &str, file: &str, deep: usize, text: String) -> (Chapter, Vec<Made>) {
    let path = PathBuf::from(format!("docs/validation/{file}.md"));
    (Chapter::new(title, &path, deep), vec![Made { path, text }])
}

/// How much of what is allowed a case uses.
fn used(case: &Case) -> f64 {
    if case.error() == 0.0 { 0.0 } else { case.error().abs() / case.allowed() }
}

fn by_source(parts: &[(&str, Vec<Case>)]) -> String {
    let all = || parts.iter().flat_map(|(_, cases)| cases);
    let mut works: BTreeMap<&str, Vec<&Case>> = BTreeMap::new();
    for case in all() {
        works.entry(case.work()).or_default().push(case);
    }
    let mut works: Vec<_> = works.into_iter().collect();
    works.sort_by_key(|(work, cases)| (std::cmp::Reverse(cases.len()), *work));
    let failed = all().filter(|case| !case.passed()).count();
    let row = |(work, cases): &(&str, Vec<&Case>)| {
        let most = cases.iter().map(|case| used(case)).fold(0.0, f64::max);
        [plain(work), cases.len().to_string(), format!("{:.1} %", 100.0 * most)]
    };
    let of_part = |(name, cases): &(&str, Vec<Case>)| {
        let failed = cases.iter().filter(|case| !case.passed()).count();
        [format!("[{name}]({name}.md)"), cases.len().to_string(), failed.to_string()]
    };
    format!(
        "# Validation by source\n\n`fem validate` computes {} cases; {failed} fail. A tolerance follows from the \
         precision of the source or from the discretisation ([validation](../validation.md)); the last column says how \
         much of it the worst row uses.\n\n{}\n## By part\n\n{}",
        all().count(),
        table(["source", "rows", "of what is allowed, at most"], works.iter().map(row)),
        table(["part", "rows", "failed"], parts.iter().map(of_part)),
    )
}

fn rows(name: &str, cases: &[Case]) -> String {
    let row = |case: &Case| {
        let (error, allowed) = match case.tolerance {
            Tolerance::Relative(allowed) => (case.error(), format!("{allowed:.1e} of it")),
            Tolerance::Absolute(allowed) => (case.error(), format!("{allowed:.1e}")),
        };
        [
            plain(&format!("{}, {}", case.name, case.quantity)),
            figure(case.expected),
            figure(case.computed),
            code(case.unit),
            format!("{error:.1e}"),
            if case.passed() { allowed } else { format!("{allowed}, failed") },
            plain(case.source),
        ]
    };
    let headings = ["case", "expected", "computed", "unit", "error", "allowed", "source"];
    format!("# Validation: {name}\n\n{}", table(headings, cases.iter().map(row)))
}

/// To seven digits, as far as a reader compares.
fn figure(value: f64) -> String {
    match value.abs() {
        a if a == 0.0 || (1e-3..1e6).contains(&a) => format!("{value:.6}"),
        _ => format!("{value:.6e}"),
    }
}
