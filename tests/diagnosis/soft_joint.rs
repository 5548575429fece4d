//! Which of six joints is soft: machines drawn as beams and joints, pushed and watched by dials, by another solver.

use fem::diagnose::{CERTAIN, Cause, Diagnosis, Verdict};
use generator::mill;
use generator::structure::{SoftJoint, as_written, soft_joint};

use crate::left_wrong::diagnosed;
use crate::score::class;
use crate::{every, side_by_side};

/// What a diagnosis says of a soft joint.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Told {
    /// It stands first, alone or in a class of what looks alike.
    named: bool,
    /// Nothing else is certain.
    no_other: bool,
    /// Its interval holds the true stiffness; true where it is not told.
    holds: bool,
    /// Alternatives told beside it, itself included.
    class: usize,
}

fn path(case: &SoftJoint) -> String {
    format!("structure.{}.stiffness", case.joint)
}

fn told(case: &SoftJoint, diagnosis: &Diagnosis) -> Told {
    let (path, mut told) = (path(case), Told { no_other: true, holds: true, ..Told::default() });
    for (number, missing) in diagnosis.missing.iter().enumerate() {
        let class = class(missing);
        let is_it = class.iter().any(|name| *name == path);
        told.named |= number == 0 && is_it;
        told.no_other &= is_it || missing.probability < CERTAIN;
        if number == 0 {
            told.class = class.len();
        }
        if missing.effect.name == path
            && matches!(missing.cause, Cause::Value { .. })
            && let Some(own) = missing.estimates.first()
        {
            let true_value = own.parameter.kind.to_si(case.stiffness);
            let low = own.interval.low.is_none_or(|low| low <= true_value);
            told.holds = low && own.interval.high.is_none_or(|high| true_value <= high);
        }
    }
    told
}

/// How a machine with a soft joint is made, by its seed and the length at which it is seen.
type Made = fn(u64, f64) -> SoftJoint;

fn all(made: Made, seeds: impl Iterator<Item = u64>, lambda: f64) -> Vec<(SoftJoint, Option<Told>)> {
    let cases: Vec<SoftJoint> = seeds.map(|seed| made(seed, lambda)).collect();
    let found =
        side_by_side(&cases, |case| diagnosed(case.model.clone(), &case.data).map(|diagnosis| told(case, &diagnosis)));
    cases.into_iter().zip(found).collect()
}

/// A sample: at thirty standard uncertainties the joint is named, and nothing else is certain.
#[test]
fn the_soft_one_of_six_joints_is_named() {
    let cases = all(soft_joint, 0..6, 30.0);
    for (case, told) in &cases {
        let told = told.unwrap_or_default();
        assert!(told.no_other, "{}: {told:?}", case.joint);
    }
    let named = cases.iter().filter(|(_, told)| told.is_some_and(|told| told.named)).count();
    assert!(named >= 5, "{named} of {}", cases.len());
}

/// The same of milling machines, from the tops of plates that were milled on them.
#[test]
fn the_soft_joint_under_a_milled_plate_is_named() {
    let cases = all(mill::soft_joint, 0..4, 30.0);
    for (case, told) in &cases {
        let told = told.unwrap_or_default();
        assert!(told.named && told.no_other && told.holds, "{}: {told:?}", case.joint);
    }
}

/// With every joint as it is written nothing is missing.
#[test]
fn a_machine_as_it_is_drawn_misses_nothing() {
    let case = as_written(1, 30.0);
    let diagnosis = diagnosed(case.model, &case.data).unwrap();
    assert_eq!(diagnosis.verdict, Verdict::Adequate);
}

#[test]
#[ignore = "minutes long; prints a table of README.md"]
fn the_whole_of_soft_joints() {
    println!("| machine | lambda | cases | named first | nothing else certain | interval holds it | mean class |");
    println!("|---|---|---|---|---|---|---|");
    let machines: [(&str, Made); 2] = [("pushed", soft_joint), ("milling", mill::soft_joint)];
    for (machine, made, lambda) in
        machines.into_iter().flat_map(|(name, made)| [8.0, 15.0, 30.0, 100.0].map(|lambda| (name, made, lambda)))
    {
        let cases = all(made, (0..60).step_by(every()), lambda);
        let told: Vec<Told> = cases.iter().map(|(_, told)| told.unwrap_or_default()).collect();
        let part = |of: fn(&Told) -> bool| 100.0 * told.iter().filter(|own| of(own)).count() as f64 / told.len() as f64;
        let class = told.iter().map(|own| own.class as f64).sum::<f64>() / told.len() as f64;
        println!(
            "| {machine} | {lambda} | {} | {:.0} % | {:.0} % | {:.0} % | {class:.2} |",
            told.len(),
            part(|own| own.named),
            part(|own| own.no_other),
            part(|own| own.holds)
        );
        for (case, told) in &cases {
            if !told.is_some_and(|told| told.named) {
                println!("  {} at {:.0}: {told:?}", case.joint, case.lambda);
            }
        }
    }
    let cases: Vec<SoftJoint> = (0..200).step_by(every()).map(|seed| as_written(seed, 15.0)).collect();
    let right = side_by_side(&cases, |case| {
        diagnosed(case.model.clone(), &case.data).is_some_and(|own| own.verdict == Verdict::Adequate)
    });
    println!("none soft: nothing is missing in {} of {}", right.iter().filter(|own| **own).count(), right.len());
}
