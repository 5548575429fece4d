//! Supports that rub, hidden in turned shafts by code that follows the tool in steps of its own.

use fem::diagnose::CERTAIN;
use generator::{Case, RUBBING_TURNING};

use crate::score::{class, diagnosis};
use crate::{every, side_by_side};

const SUPPORTS: [&str; 2] = ["headstock-friction", "tailstock-friction"];

/// What a diagnosis says of friction that is hidden.
#[derive(Clone, Copy, Debug, Default)]
struct Told {
    /// It is named, or stands in the class of what is.
    named: bool,
    /// Nothing else is certain.
    no_other: bool,
}

fn told(case: &Case, effect: &str) -> Option<Told> {
    let diagnosis = diagnosis(case).ok()?;
    let is_it = |own: &&fem::diagnose::Missing| class(own).contains(&effect);
    let others = diagnosis.missing.iter().filter(|own| !is_it(own));
    let no_other = others.clone().all(|own| own.probability < CERTAIN);
    Some(Told { named: diagnosis.missing.iter().any(|own| is_it(&own)), no_other })
}

fn all(effect: &'static str, lambda: f64, seeds: impl Iterator<Item = u64>) -> Vec<Told> {
    let cases: Vec<Case> = seeds.filter_map(|seed| RUBBING_TURNING.single(effect, lambda, seed)).collect();
    side_by_side(&cases, |case| told(case, effect)).into_iter().map(Option::unwrap_or_default).collect()
}

/// A sample: at thirty standard uncertainties friction is named, and nothing else is certain.
#[test]
fn the_support_that_rubs_is_named() {
    let found: Vec<Told> = SUPPORTS.into_iter().flat_map(|effect| all(effect, 30.0, 0..2)).collect();
    let count = |of: fn(&Told) -> bool| found.iter().filter(|own| of(own)).count();
    assert!(found.len() >= 3, "{}", found.len());
    assert!(count(|own| own.named) + 1 >= found.len(), "{found:?}");
    assert!(count(|own| own.no_other) + 1 >= found.len(), "{found:?}");
}

#[test]
#[ignore = "minutes long; prints a table of README.md"]
fn the_whole_of_rubbing() {
    println!("| support | lambda | cases | named | nothing else certain |");
    println!("|---|---|---|---|---|");
    for (effect, lambda) in SUPPORTS.into_iter().flat_map(|effect| [8.0, 15.0, 30.0].map(|lambda| (effect, lambda))) {
        let found = all(effect, lambda, (0..60).step_by(every()));
        let part =
            |of: fn(&Told) -> bool| 100.0 * found.iter().filter(|own| of(own)).count() as f64 / found.len() as f64;
        let [named, no_other] = [part(|own| own.named), part(|own| own.no_other)];
        println!("| {effect} | {lambda} | {} | {named:.0} % | {no_other:.0} % |", found.len());
    }
}
