//! Reads the tables of a budget file.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::path::Path;

use super::{Budget, Contribution, Drill, Group, Kind, Law, part, sizes};
use crate::input::{InputError, Reader, Source as File, nearest, read_tables};
use crate::units::{MICRO, NUMBER};

/// Largest budget file, bytes.
const LARGEST: u64 = 1_000_000;
/// Default numbers of samples: of laws alone, and through a model.
const SAMPLES: usize = 200_000;
const MODEL_SAMPLES: usize = 20_000;

impl Budget {
    /// Reads a budget file, and the model that it names.
    ///
    /// # Errors
    /// A file is wrong; the error lists every problem with its place and remedy.
    pub fn load(path: &Path) -> Result<Self, InputError> {
        Self::parse(File::read(path, LARGEST)?)
    }

    /// Reads a budget from its text.
    ///
    /// # Errors
    /// The text is wrong; the error lists every problem.
    pub(crate) fn parse(file: File) -> Result<Self, InputError> {
        let remedy = "a budget takes fields: write a random error of its own, or let a model's input vary";
        read_tables(&file, "a budget file", remedy, |reader, broken| read(reader, &file, broken))
    }
}

fn read(reader: &Reader, file: &File, broken: &RefCell<Option<InputError>>) -> Budget {
    let title = reader.text("title", "what is added up, for people");
    let groups = reader.list("group", "sets of errors that enter the total as one random error", |t, _| Group {
        name: named(t),
        law: Law::read(t, "law of the set's total", Law::Normal).unwrap_or(Law::Normal),
    });
    let taken = RefCell::new(BTreeSet::new());
    let errors = reader.list("error", "errors that are given", |t, _| {
        let error = read_error(t, &groups);
        if !error.name.is_empty() && !taken.borrow_mut().insert(error.name.clone()) {
            t.problem("name", format!("two errors are called `{}`", error.name), "call one of them otherwise");
        }
        error
    });
    let models = part::read(reader, broken);
    let has_model = !models.parts.is_empty();
    let rest = reader.optional_table("budget", "how the errors are added up", |t| read_rules(t, has_model));
    let (t, tolerance, samples, seed) = rest.unwrap_or((3.0, None, if has_model { MODEL_SAMPLES } else { SAMPLES }, 1));
    let drill = reader.optional_table("drill", "a hole made by a tool of its size", read_drill).flatten();
    if !["error", "model", "drill"].into_iter().any(|key| reader.has(key)) {
        let help = "add an [[error]], a [model] or a [drill]; `fem new budget` shows all";
        reader.problem("", "the budget is empty", help);
    }
    Budget { file: file.clone(), title, t, tolerance, samples, seed, errors, groups, models, drill }
}

fn named(t: &Reader) -> String {
    let name = t.text("name", "what people call it");
    if name.is_none() && !t.has("name") {
        t.problem("", "`name` is missing", "add name = \"…\"");
    }
    name.unwrap_or_default()
}

fn read_rules(t: &Reader, has_model: bool) -> (f64, Option<(f64, f64)>, usize, u64) {
    let about = "of the random total: 1, 2 or 3 for a risk of 32, 4.5 or 0.27 %";
    let coefficient = t.quantity("t", NUMBER, about).within(0.0, 6.0).or(3.0);
    let tolerance = t.optional_table("tolerance", "what the total may be", |t| {
        let lower = t.quantity("lower", MICRO, "least total that is accepted").required();
        let upper = t.quantity("upper", MICRO, "largest total that is accepted").required();
        if upper <= lower {
            t.problem("upper", "the tolerance is empty", "let `upper` be above `lower`");
        }
        (lower, upper)
    });
    let usual = if has_model { MODEL_SAMPLES } else { SAMPLES };
    let samples = t.count("samples", "draws of the Monte Carlo").between(100, 100_000_000).or(usual);
    let seed = t.count("seed", "what the draws begin from").between(0, usize::MAX).or(1);
    (coefficient, tolerance, samples, seed as u64)
}

fn read_error(t: &Reader, groups: &[Group]) -> Contribution {
    let name = named(t);
    let kind = t.choice("kind", "how the error adds", Kind::WORDS).required(Kind::Random);
    let law = Law::read(t, "law of a random error over its field; uniform if unknown", Law::Uniform);
    let (value, law, source) = sizes::read(t, kind, law);
    let group = t.text("group", "the set that it belongs to");
    if let Some(unknown) = group.as_ref().filter(|g| !groups.iter().any(|known| known.name == **g)) {
        let near = nearest(unknown, groups.iter().map(|g| g.name.as_str()));
        let help = near.map_or(format!("add [[group]] with name = \"{unknown}\""), |n| format!("did you mean `{n}`?"));
        t.problem("group", format!("`{unknown}` is no group of this budget"), help);
    }
    Contribution { name, kind, value, law, source, group }
}

fn read_drill(t: &Reader) -> Option<Drill> {
    let required = |key, about| t.quantity(key, MICRO, about).required();
    let widening_max = required("widening_max", "by how much the hole is wider than the largest drill, a_max");
    let widening_min = required("widening_min", "by how much it is wider than the smallest worn drill, a_min");
    if widening_max < widening_min {
        t.problem("widening_max", "the largest is below the least", "exchange the two");
    }
    let optional = |key, about| t.quantity(key, MICRO, about).not_negative().optional();
    let drill = optional("drill_tolerance", "tolerance of the drill, T_i");
    let wear = optional("wear", "wear that is allowed");
    let tolerance = optional("tolerance", "tolerance of the hole, T");
    let found = Drill::new((widening_max, widening_min), drill, wear, tolerance);
    if found.is_none() {
        t.problem("", "too little is known of the drill", "give two of `drill_tolerance`, `wear` and `tolerance`");
    }
    found
}
