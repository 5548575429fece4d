//! Values left wrong: a whole machine whose model states one of its effects as a template would, with a value that nobody
//! measured. The value is to be told, and no effect in its stead.

use fem::diagnose::{CERTAIN, Cause, Diagnosis, MOST_EFFECTS, Missing};
use fem::input::{Parameter, Source};
use fem::measure::Measurements;
use fem::model::{Data, Model};
use fem::progress::Progress;
use generator::random::Random;
use generator::{Hidden, Process, RING, Whole, writing};
use nalgebra::{DMatrix, DVector};

use crate::score::{class, diagnose};
use crate::{PROCESSES, every};

/// How many times too large or too small a value is written.
const OFF: (f64, f64) = (1.5, 3.0);

/// Least length of the change that a wrong value makes in the rows, in standard uncertainties, what all hidden effects can
/// imitate taken out, from which it is visible.
pub const VISIBLE: f64 = 10.0;

/// What is said of a value that is wrong.
#[derive(Clone, Copy, Debug, Default)]
pub struct Told {
    /// Length of the change that it makes beside all hidden effects, in standard uncertainties.
    pub length: f64,
    /// The value is told, alone or in a class.
    pub named: bool,
    /// It is told with certainty.
    pub certain: bool,
    /// The true value lies in its interval; `None` where the value itself is not told.
    pub right: Option<bool>,
    /// A cause is certain that is neither hidden nor the value.
    pub false_cause: bool,
}

impl Told {
    /// What a diagnosis says of wrong values, which begin with `value`, where `hidden` effects are missing too; `truth` is a true
    /// value by its path, in SI.
    pub fn of(diagnosis: &Diagnosis, value: &str, hidden: &[&str], truth: impl Fn(&str) -> Option<f64>) -> Self {
        let is_there = |name: &&str| name.starts_with(value) || hidden.contains(name);
        let mut told = Self::default();
        for missing in &diagnosis.missing {
            let class = class(missing);
            told.named |= class.iter().any(|name| name.starts_with(value));
            if missing.probability >= CERTAIN && !missing.describes() {
                told.false_cause |= !class.iter().any(is_there);
            }
            if missing.effect.name.starts_with(value) && matches!(missing.cause, Cause::Value { .. }) {
                told.certain |= missing.probability >= CERTAIN;
                let holds = holds(missing, &truth);
                told.right = Some(told.right.unwrap_or(false) | holds);
            }
        }
        told
    }
}

/// Length of the difference between two models that know a machine, in standard uncertainties of the rows, with what the
/// parameters that are `free` can imitate taken out; `None` where one cannot be computed.
pub fn length_beside(
    (right, off): (&Model, &Model),
    free: impl Fn(&str) -> bool,
    sigma: &[f64],
    data: &str,
) -> Option<f64> {
    let rows = Measurements::parse(Source::new("case.csv", data), &*right.process).ok()?.rows;
    let predicted = |model: &Model| {
        let shown = model.forward().observe(&rows).ok()?;
        Some(DVector::from_iterator(shown.len(), shown.iter().zip(sigma).map(|(v, s)| v / s)))
    };
    let base = predicted(right)?;
    let slope = |quantity: &Parameter| {
        let value = quantity.quantity.value;
        let there = if value == 0.0 { 1e-9 } else { value * 1.001 };
        let column = predicted(&right.with_values(&[(&*quantity.path, there)]).ok()?)? - &base;
        (column.norm() > 1e-9).then(|| column.normalize())
    };
    let columns: Vec<DVector<f64>> = right.quantities.iter().filter(|q| free(&q.path)).filter_map(slope).collect();
    let mut left = predicted(off)? - &base;
    if !columns.is_empty() {
        let basis = DMatrix::from_columns(&columns).svd(true, false);
        let (u, sizes) = (basis.u?, basis.singular_values);
        let whole = left.clone();
        for (column, _) in u.column_iter().zip(&sizes).filter(|(_, size)| **size > 1e-6 * sizes.max()) {
            left -= column * column.dot(&whole);
        }
    }
    Some(left.norm())
}

/// Whether the interval of a value that is told holds the true one.
fn holds(missing: &Missing, truth: &impl Fn(&str) -> Option<f64>) -> bool {
    let path = &*missing.effect.name;
    let Some(e) = missing.estimates.iter().find(|e| e.parameter.path == *path) else { return false };
    let Some(si) = truth(path) else { return false };
    e.interval.contains(si)
}

/// What is said, with each cause and its probability.
pub fn said(diagnosis: &Diagnosis) -> String {
    let tell = |m: &Missing| {
        let value = m.estimates.first().map_or(String::new(), |e| {
            let end = |v: Option<f64>| v.map_or("-".into(), |v| format!("{:.4}", e.parameter.kind.from_si(v)));
            let value = e.parameter.kind.from_si(e.value);
            format!(" = {value:.4} ({} to {})", end(e.interval.low), end(e.interval.high))
        });
        format!("{} {:.2}{value}", class(m).join("|"), m.probability)
    };
    diagnosis.missing.iter().map(tell).collect::<Vec<_>>().join(", ")
}

/// Writes the files of a machine into the folder `FEM_KEEP`, if there is one.
pub fn keep(name: &str, model: &str, data: &str, revealed: &str) {
    let Some(folder) = std::env::var_os("FEM_KEEP") else { return };
    let place = std::path::Path::new(&folder).join(name);
    std::fs::create_dir_all(&place).unwrap();
    for (file, text) in [("model.toml", model), ("measured.csv", data), ("revealed.toml", revealed)] {
        std::fs::write(place.join(file), text).unwrap();
    }
}

/// The diagnosis of a model by measurements; `None` where there is no such model, or no answer.
pub fn diagnosed(model: String, data: &str) -> Option<Diagnosis> {
    let model = Model::parse(Source::new("case.toml", model)).ok()?;
    let data = Measurements::parse(Source::new("case.csv", data), &*model.process).expect("the data are right");
    let data = Data::of(&model, data).ok()?;
    diagnose(&data, MOST_EFFECTS, &Progress::default()).ok()
}

/// A machine of which the first hidden effect stands in the model, with its first value off; `None` where no model can
/// have the value.
fn told(process: &Process, seed: u64) -> Option<(Told, String)> {
    let Whole { case, job } = process.whole_machine(seed);
    let mut random = Random::new(&format!("{} left wrong", job.process()), seed);
    let truth = &case.truth.hidden[0];
    let mut stated: Hidden = truth.clone();
    let factor = random.log_uniform(OFF.0, OFF.1);
    stated.parameters[0].1 *= if random.chance(0.5) { factor } else { 1.0 / factor };
    let text = writing::model(&*job, None, std::slice::from_ref(&stated));
    let model = Model::parse(Source::new("case.toml", &*text)).ok()?;
    keep(&format!("{} {seed}", job.process()), &text, &case.data, &case.revealed);
    let diagnosis = diagnosed(text, &case.data)?;
    let hidden: Vec<&str> = case.truth.hidden[1..].iter().map(|h| h.effect).collect();
    let true_value = |path: &str| {
        let entry = model.effect_parameter(path)?;
        let (_, value) = truth.parameters.iter().find(|p| entry.name == p.0)?;
        Some(entry.kind.to_si(*value))
    };
    let parse = |text: &str| Model::parse(Source::new("case.toml", text)).ok();
    let right = parse(&case.revealed)?;
    let own = format!("effects.{}.", truth.effect);
    let path = model.quantities.iter().map(|q| &*q.path).find(|path| path.starts_with(&own))?;
    let value = model.quantities.iter().find(|q| q.path == *path)?.quantity.value;
    let off = right.with_values(&[(path, value)]).ok()?;
    let is_free = |path: &str| path.starts_with("effects.") && !path.starts_with(&own);
    let length = length_beside((&right, &off), is_free, &case.truth.noise_of_rows, &case.data).unwrap_or(0.0);
    let told = Told { length, ..Told::of(&diagnosis, &own, &hidden, true_value) };
    let said = said(&diagnosis);
    Some((told, format!("{stated:?}, truth {:?}, beside {hidden:?}: told {said}", truth.parameters)))
}

/// Machines of a kind with one value wrong each.
#[derive(Default)]
pub struct Tally {
    machines: usize,
    /// Those whose value is visible, and of these those of which it is told.
    visible: usize,
    named: usize,
    certain: usize,
    /// Values that are told themselves, and those of them whose interval holds the truth.
    values: usize,
    right: usize,
    clean: usize,
}

impl Tally {
    /// Counts what is told of machines; `None` of a machine that has no such value.
    pub fn of(process: &Process, seeds: impl Iterator<Item = u64>, tell: TellOne) -> Self {
        let mut tally = Self::default();
        for (seed, (told, said)) in seeds.filter_map(|seed| Some((seed, tell(process, seed)?))) {
            let is_right = told.right.unwrap_or(true);
            if std::env::var_os("FEM_MISSES").is_some() && (!told.named || told.false_cause || !is_right) {
                println!("{}{seed} {told:?}: {said}", process.name);
            }
            let is_visible = told.length >= VISIBLE;
            tally.machines += 1;
            tally.visible += usize::from(is_visible);
            tally.named += usize::from(is_visible && told.named);
            tally.certain += usize::from(is_visible && told.certain);
            tally.values += usize::from(told.right.is_some());
            tally.right += usize::from(told.right == Some(true));
            tally.clean += usize::from(!told.false_cause);
        }
        tally
    }
}

/// What is told of one machine of a process, drawn by a seed, and the same in words.
pub type TellOne = fn(&Process, u64) -> Option<(Told, String)>;

impl std::fmt::Display for Tally {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { machines, visible, named, certain, values, right, clean } = self;
        write!(f, "{machines} | {visible} | {named} | {certain} | {right} of {values} | {clean} |")
    }
}

/// Prints a table of all processes; those without such a value are left out.
pub fn print_table(tell: TellOne) {
    println!("| | machines | visible | told | certain | interval holds the truth | nothing false |");
    println!("|---|---|---|---|---|---|---|");
    let is_left_out = |name: &str| std::env::var("FEM_GROUP").is_ok_and(|word| !name.contains(&word));
    for (name, process) in PROCESSES.into_iter().filter(|(name, _)| !is_left_out(name)) {
        println!("| {name} | {}", Tally::of(process, (2000..2040).step_by(every()), tell));
    }
}

#[test]
#[ignore = "minutes long; prints a table of README.md"]
fn the_whole_of_values_left_wrong() {
    print_table(told);
}

/// By the rates of the whole, less would be told by chance in less than one sample of a hundred.
#[test]
fn a_sample_of_values_left_wrong() {
    let Tally { machines, visible, named, clean, .. } = Tally::of(&RING, 0..8, told);
    assert!(
        visible > 4 && named + 1 >= visible && clean + 1 >= machines,
        "{named} named of {visible}, {clean} without a false cause of {machines}"
    );
}
