//! Values of other tables left wrong: a whole machine in whose ideal model a force, a stiffness, a power, a temperature or a
//! property of the material is off, as people misjudge them. The value is to be told, and no effect in its stead.

use fem::input::{Parameter, Source};
use fem::model::Model;
use generator::random::Random;
use generator::{Case, Process, Whole, writing};

use crate::left_wrong::{Told, VISIBLE, diagnosed, keep, length_beside, print_table, said};

/// How people misjudge a value.
#[derive(Clone, Copy)]
enum Off {
    /// By a factor between these, either way.
    Factor(f64, f64),
    /// By an amount between these in the unit of the file, either way.
    Amount(f64, f64),
}

/// Values that people measure or estimate, by their tables and keys as the generator writes them, with their paths.
const VALUES: &[(&str, &str, &str, Off)] = &[
    ("turning", "[cut]", "radial_force", Off::Factor(1.3, 2.0)),
    ("turning", "[workpiece]", "youngs_modulus", Off::Factor(1.1, 1.3)),
    ("turning", "steady_rests", "stiffness", Off::Factor(1.5, 3.0)),
    ("ring", "[cut]", "force_per_depth", Off::Factor(1.3, 2.0)),
    ("ring", "[workpiece]", "youngs_modulus", Off::Factor(1.1, 1.3)),
    ("thermal", "[[source]]", "power", Off::Factor(1.2, 2.0)),
    ("thermal", "[environment]", "temperature", Off::Amount(1.0, 5.0)),
    ("thermal", "[body]", "conductivity", Off::Factor(1.1, 1.3)),
    ("thermal", "[body]", "expansion", Off::Factor(1.1, 1.3)),
    ("axis", "[screw]", "preload", Off::Factor(1.5, 3.0)),
    ("axis", "[screw]", "stiffness", Off::Factor(1.5, 3.0)),
    ("stiffness", "[joint]", "stiffness", Off::Factor(1.5, 3.0)),
    ("contour", "[drives]", "frequency", Off::Factor(1.1, 1.3)),
    ("contour", "[cut]", "normal_force", Off::Factor(1.3, 2.0)),
    ("fixture", "[workpiece]", "youngs_modulus", Off::Factor(1.1, 1.3)),
    ("fixture", "[cutter]", "force", Off::Factor(1.3, 2.0)),
    ("cam", "[cut]", "force_per_rate", Off::Factor(1.3, 2.0)),
];

/// A machine in whose ideal model a visible value is wrong; `None` where there is none.
fn told(process: &Process, seed: u64) -> Option<(Told, String)> {
    let Whole { case, job } = process.whole_machine(seed);
    let mut random = Random::new(&format!("{} wrong in tables", job.process()), seed);
    let mut values: Vec<_> = VALUES.iter().filter(|value| value.0 == job.process()).collect();
    while !values.is_empty() {
        let own = values[random.whole(0, values.len() - 1)];
        values.retain(|other| other.1 != own.1 || other.2 != own.2);
        let times = match own.3 {
            Off::Factor(low, high) => random.log_uniform(low, high),
            Off::Amount(low, high) => random.uniform(low, high),
        };
        let is_more = random.chance(0.5);
        let change = |value: f64| match (own.3, is_more) {
            (Off::Factor(..), true) => value * times,
            (Off::Factor(..), false) => value / times,
            (Off::Amount(..), true) => value + times,
            (Off::Amount(..), false) => value - times,
        };
        let ideal = writing::model(&*job, None, &[]);
        let Some(text) = wrong(&ideal, own.1, own.2, change) else { continue };
        let Some(seen) = seen(&case, (own.1, own.2), change).filter(|seen| seen.length >= VISIBLE) else { continue };
        let hidden: Vec<&str> = case.truth.hidden.iter().map(|h| h.effect).collect();
        keep(&format!("table {} {seed}", job.process()), &text, &case.data, &case.revealed);
        let diagnosis = diagnosed(text, &case.data)?;
        let true_value = |path: &str| (path == seen.path).then_some(seen.truth);
        let told = Told { length: seen.length, ..Told::of(&diagnosis, &seen.path, &hidden, true_value) };
        let said = said(&diagnosis);
        let told_of =
            format!("{} off by {times:.2}, lambda {:.0}, beside {hidden:?}: told {said}", seen.path, seen.length);
        return Some((told, told_of));
    }
    None
}

/// A model's text with the first `key` behind a table's heading changed.
fn wrong(model: &str, table: &str, key: &str, change: impl Fn(f64) -> f64) -> Option<String> {
    let from = model.find(table)?;
    let key = format!("{key} = \"");
    let at = from + model[from..].find(&key)? + key.len();
    let next_table = from + 1 + model[from + 1..].find("\n[").unwrap_or(model.len() - from - 1);
    let end = at + model[at..].find([' ', 'e', '"'])?;
    let value: f64 = model[at..end].parse().ok().filter(|value| *value != 0.0)?;
    (at < next_table).then(|| format!("{}{}{}", &model[..at], change(value), &model[end..]))
}

/// A value that is seen.
struct Seen {
    path: String,
    /// Its true value, SI.
    truth: f64,
    /// Length of its change in standard uncertainties, hidden effects taken out.
    length: f64,
}

/// What a value does to the rows of a machine that is known but for the sizes of its effects.
fn seen(case: &Case, (table, key): (&str, &str), change: impl Fn(f64) -> f64) -> Option<Seen> {
    let parse = |text: &str| Model::parse(Source::new("case.toml", text)).ok();
    let (right, off) = (parse(&case.revealed)?, parse(&wrong(&case.revealed, table, key, change)?)?);
    let is_changed = |(a, b): &(&Parameter, &Parameter)| a.quantity.value != b.quantity.value;
    let (own, _) = right.quantities.iter().zip(off.quantities.iter()).find(is_changed)?;
    let (path, truth) = (own.path.to_string(), own.quantity.value);
    let is_free = |path: &str| path.starts_with("effects.");
    let length = length_beside((&right, &off), is_free, &case.truth.noise_of_rows, &case.data)?;
    Some(Seen { path, truth, length })
}

#[test]
#[ignore = "minutes long; prints a table of README.md"]
fn the_whole_of_values_of_tables_left_wrong() {
    print_table(told);
}
