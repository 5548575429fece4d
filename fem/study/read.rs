//! Reads a plan.

use std::cell::RefCell;
use std::path::Path;

use super::design::{Design, Input, Points, Sampler, Spread};
use super::job;
use super::plan::{Offered, StudyPlan, Task, Wanted};
use super::quantity::{LISTED, no_quantity};
use super::sobol::MOST_DIMENSIONS;
use super::table::{self, Table};
use super::wildcard;
use crate::budget::Law;
use crate::input::{InputError, Parameter, Reader, Source, did_you_mean, read_tables};
use crate::model::Model;
use crate::process::RunReport;
use crate::progress::Progress;
use crate::units::{Knowledge, NUMBER};

/// Largest plan, bytes.
const LARGEST: u64 = 1_000_000;
/// Most points that are drawn, and points of an even list.
const MOST_SAMPLES: usize = 1_000_000_000;
const MOST_STEPS: usize = 1_000_000;
/// Points that are drawn unless the plan says otherwise.
const SAMPLES: usize = 1024;

impl StudyPlan {
    /// Reads a plan, and the model, table and names of measurements that it gives.
    ///
    /// # Errors
    /// A file is wrong; the error lists every problem with its place and remedy.
    pub fn load(path: &Path) -> Result<Self, InputError> {
        Self::parse(Source::read(path, LARGEST)?)
    }

    /// Reads a plan from its text; the paths that it names are relative to the folder of its name.
    ///
    /// # Errors
    /// As those of [`load`](Self::load).
    pub fn parse(file: Source) -> Result<Self, InputError> {
        let remedy = "a plan takes a middle and a field: value = \"60 N/um\", half_field = \"15 N/um\"";
        let plan = read_tables(&file, "a plan", remedy, |reader, broken| read(reader, &file, broken))?;
        plan.ok_or_else(|| InputError::new(file, Vec::new()))
    }
}

/// Schema of a plan, made by the function that reads it.
pub fn schema() -> serde_json::Value {
    let nowhere = Source::new("", "");
    let broken = RefCell::new(None);
    let mut shape = Reader::schema("many jobs with one model", |reader| {
        read(reader, &nowhere, &broken);
    });
    shape["$schema"] = "https://json-schema.org/draft/2020-12/schema".into();
    shape["title"] = "fem study".into();
    shape
}

/// How points are chosen, before it is known what varies.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    Drawn(Sampler),
    Grid,
    Table,
}

/// Words in a plan; the first is usual.
const WAYS: &[(&str, Way)] = &[
    ("latin-hypercube", Way::Drawn(Sampler::LatinHypercube)),
    ("random", Way::Drawn(Sampler::Random)),
    ("sobol", Way::Drawn(Sampler::Sobol)),
    ("grid", Way::Grid),
    ("table", Way::Table),
];

/// The table `[design]`.
struct Chosen {
    way: Way,
    samples: u64,
    seed: u64,
    indices: bool,
    table: Option<Source>,
}

fn read(reader: &Reader, file: &Source, broken: &RefCell<Option<InputError>>) -> Option<StudyPlan> {
    let title = reader.text("title", "what is studied, for people");
    let model = Model::named(reader, "model", "the model file", broken);
    let task = reader.choice("task", "what is done at every point", Task::WORDS).or_first(Task::Run);
    let about = "measurements of a fit or a diagnosis: a file, or several by `*`: parts/*.csv";
    let pattern = reader.text("data", about);
    let chosen = reader.optional_table("design", "how the points are chosen", read_design);
    let chosen = chosen.unwrap_or(Chosen { way: Way::Grid, samples: 0, seed: 0, indices: false, table: None });
    let own = reader.list("input", "what varies", |t, _| read_input(t, model.as_ref(), chosen.way));
    let given: Vec<Input> = own.into_iter().flatten().collect();
    let Some(model) = model else {
        reader.list("result", "what is wanted of every job; all that there is if left out", |t, _| {
            read_wanted(t, None);
        });
        return None;
    };
    for (i, input) in given.iter().enumerate() {
        if given[..i].iter().any(|other| other.path == input.path) {
            reader.problem("input", format!("`{}` stands in two inputs", input.path), "keep one of them");
        }
    }
    let inputs = complete(given, &model, task, &chosen);
    let Table { inputs, values, rows, files } = match &chosen.table {
        Some(source) => match table::read(source, &model, inputs, file.folder()) {
            Ok(table) => table,
            Err(error) => {
                broken.replace(Some(error));
                return None;
            }
        },
        None => Table { inputs, values: Vec::new(), rows: 0, files: Vec::new() },
    };
    check_design(reader, &inputs, &chosen);
    let (data, data_of_point) = match pattern {
        Some(pattern) => (wildcard::files(file.folder(), &pattern), Vec::new()),
        None => table::distinct(files),
    };
    check_data(reader, task, &data);
    let design = match chosen.way {
        Way::Drawn(sampler) => {
            Design::Drawn { sampler, samples: chosen.samples, seed: chosen.seed, indices: chosen.indices }
        }
        Way::Grid => Design::Grid,
        Way::Table => Design::Table { values, rows },
    };
    let open = unknown(&model, &inputs, task);
    for parameter in &open {
        let message = format!("`{}` is `?` in {}", parameter.path, model.source.name);
        reader.problem("model", message, "give it a value there, or add an [[input]] that varies it");
    }
    if !reader.is_sound() {
        // What is offered cannot be known yet.
        reader.list("result", "", |t, _| t.accept_any());
        return None;
    }
    let points = Points::new(inputs.clone(), design.clone());
    let offer = match offer(&model, task, &inputs, &points) {
        Ok(offer) => offer,
        Err(message) => {
            reader.list("result", "", |t, _| t.accept_any());
            let help = "mend the model, or the middles of the inputs: `fem run` shows whether it computes";
            reader.problem("model", format!("{} gives no results: {message}", model.source.name), help);
            return None;
        }
    };
    let about = "what is wanted of every job; all that there is if left out";
    let wanted = reader.list("result", about, |t, _| read_wanted(t, Some(&offer)));
    let mut results: Vec<Wanted> = wanted.into_iter().flatten().collect();
    if !reader.has("result") {
        results = offer.usual.iter().map(|o| Wanted { offered: o.clone(), tolerance: None }).collect();
    }
    let file = file.clone();
    Some(StudyPlan {
        file,
        title,
        model,
        task,
        data,
        data_of_point,
        table: chosen.table,
        inputs,
        design,
        points,
        results,
    })
}

fn read_design(t: &Reader) -> Chosen {
    let way = t.choice("type", "how points are chosen", WAYS).or_first(WAYS[0].1);
    let samples = t.count("samples", "points that are drawn").between(1, MOST_SAMPLES).optional();
    let seed = t.count("seed", "what the draws begin from").between(0, usize::MAX).optional();
    let indices = t.flag("indices", "whether Sobol' indices are wanted: samples x (inputs + 2) jobs");
    let named = t.file("file", "the table of a design of type \"table\"", table::LARGEST);
    let is_drawn = matches!(way, Way::Drawn(_));
    for (key, is_there) in [("samples", samples.is_some()), ("seed", seed.is_some()), ("indices", indices.is_some())] {
        if is_there && !is_drawn {
            t.problem(key, format!("a design that draws nothing has no `{key}`"), "remove it, or change `type`");
        }
    }
    if way == Way::Table && !t.has("file") {
        t.problem("", "a table is missing", "add file = \"points.csv\": a column per input, as `cut.depth [mm]`");
    } else if way != Way::Table && t.has("file") {
        t.problem("file", "only a design of type \"table\" has a `file`", "add type = \"table\", or remove `file`");
    }
    let table = named.filter(|_| way == Way::Table).and_then(|file| match file.text() {
        Ok(source) => Some(source),
        Err(problem) => {
            t.problem("file", problem.message, problem.help.unwrap_or_default());
            None
        }
    });
    Chosen {
        way,
        samples: samples.unwrap_or(SAMPLES) as u64,
        seed: seed.unwrap_or(1) as u64,
        indices: indices.unwrap_or(false),
        table,
    }
}

fn read_input(t: &Reader, model: Option<&Model>, way: Way) -> Option<Input> {
    let path = t.text("quantity", "path of a quantity of the model: cut.depth, effects.tool-wear.rate");
    if path.is_none() && !t.has("quantity") {
        t.problem("", "`quantity` is missing", "add quantity = \"cut.depth\", the path of a key of the model");
    }
    let known = model.zip(path.as_deref()).and_then(|(model, path)| known(t, model, path));
    if known.is_none() && !t.is_described() {
        // Nothing more can be checked without the quantity.
        t.accept_any();
        return None;
    }
    let kind = known.map_or(NUMBER, |known| known.kind);
    let bounds = known.map_or(crate::input::Bounds::Any, |known| known.bounds);
    let law = Law::read(t, "how it scatters over its field", Law::Normal);
    let centre = t.quantity("value", kind, "middle of its field; the model's if left out").bounds(bounds).optional();
    let about = "half of its field, three standard deviations of a normal law; from the model's `+-` if left out";
    let half = t.quantity("half_field", kind.difference(), about).not_negative().optional();
    let values = t.quantities("values", kind, "the values that it takes, instead of a field");
    let even = (
        t.quantity("from", kind, "first of values at even distances").bounds(bounds).optional(),
        t.quantity("to", kind, "last of them").bounds(bounds).optional(),
        t.count("steps", "how many").between(1, MOST_STEPS).optional(),
    );
    let known = known?;
    let has_field = law.is_some() || centre.is_some() || half.is_some();
    let even = match even {
        (Some(from), Some(to), Some(steps)) => Some(evenly(from, to, steps)),
        (None, None, None) => None,
        _ => {
            t.problem("", "even values need `from`, `to` and `steps`", "give all three of them");
            return None;
        }
    };
    if u8::from(has_field) + u8::from(values.is_some()) + u8::from(even.is_some()) > 1 {
        t.problem("", "the values are said twice", "give a field, `values`, or `from`, `to` and `steps`");
        return None;
    }
    let list = values.or(even);
    let spread = match (list, way) {
        (Some(list), _) => {
            if list.is_empty() || list.iter().any(|value| !bounds.admits(*value)) {
                t.problem("values", format!("`{}` cannot take all of these", known.path), "list what it may be");
            }
            Spread::List(list)
        }
        (None, Way::Grid) => {
            let help = "add values = [...], or from, to and steps";
            t.problem("", format!("a grid needs the values of `{}`", known.path), help);
            return None;
        }
        (None, _) => {
            let law = law.unwrap_or(Law::Normal);
            let rough = match known.quantity.knowledge {
                Knowledge::Rough(std) => Some(law.half_field(std)),
                _ => None,
            };
            let Some(half) = half.or(rough) else {
                let message = format!("nothing says how far `{}` scatters", known.path);
                t.problem("", message, "add `half_field`, or write the quantity with `+-` in the model");
                return None;
            };
            Spread::Field { law, centre: centre.unwrap_or(known.quantity.value), half }
        }
    };
    let input = Input { path: known.path.clone(), kind, bounds, spread };
    if let Spread::Field { centre, half, .. } = &input.spread {
        let (low, high) = input.cut();
        if centre.is_nan() {
            t.problem("", format!("`{}` is unknown in the model", known.path), "add `value`, the middle of its field");
        } else if (*half == 0.0 && !bounds.admits(*centre)) || high - low <= 0.0 {
            t.problem("", format!("the field of `{}` lies outside of what it may be", known.path), "move its middle");
        }
    }
    Some(input)
}

/// The quantity at a path of the model.
fn known<'m>(t: &Reader, model: &'m Model, path: &str) -> Option<&'m Parameter> {
    let found = model.quantity(path);
    if found.is_none() {
        let (message, help) = no_quantity(model, path);
        t.problem("quantity", message, help);
    }
    found
}

fn evenly(from: f64, to: f64, steps: usize) -> Vec<f64> {
    let last = steps.saturating_sub(1).max(1) as f64;
    (0..steps).map(|i| from + (to - from) * i as f64 / last).collect()
}

/// Adds what the model marks `+-` to the inputs of a drawn design of runs; a fit is to find it.
fn complete(mut inputs: Vec<Input>, model: &Model, task: Task, chosen: &Chosen) -> Vec<Input> {
    if task != Task::Run || !matches!(chosen.way, Way::Drawn(_)) {
        return inputs;
    }
    for parameter in &model.parameters {
        let Knowledge::Rough(std) = parameter.quantity.knowledge else { continue };
        if inputs.iter().all(|input| input.path != parameter.path) {
            let law = Law::Normal;
            let (centre, half) = (parameter.quantity.value, law.half_field(std));
            let spread = Spread::Field { law, centre, half };
            let (path, kind, bounds) = (parameter.path.clone(), parameter.kind, parameter.bounds);
            inputs.push(Input { path, kind, bounds, spread });
        }
    }
    inputs
}

fn check_design(reader: &Reader, inputs: &[Input], chosen: &Chosen) {
    let Way::Drawn(sampler) = chosen.way else { return };
    if inputs.is_empty() && reader.is_sound() {
        let help = "add an [[input]], or mark quantities of the model `+-`";
        reader.problem("design", "nothing varies", help);
    }
    let dimensions = inputs.len() * if chosen.indices { 2 } else { 1 };
    if sampler == Sampler::Sobol && dimensions > MOST_DIMENSIONS {
        let message = format!("{dimensions} dimensions are more than the {MOST_DIMENSIONS} of the sequence");
        reader.problem("design", message, "take \"latin-hypercube\" or \"random\", or fewer inputs");
    }
}

fn check_data(reader: &Reader, task: Task, data: &[std::path::PathBuf]) {
    match task {
        Task::Run if !data.is_empty() => {
            reader.problem(
                "data",
                "a run has no measurements",
                "remove them, or let `task` be \"fit\" or \"diagnose\"",
            );
        }
        Task::Fit | Task::Diagnose if data.is_empty() => {
            let help = "add data = \"measured.csv\" or \"parts/*.csv\" by the folder of the plan, or a table with a column `data`";
            let message = if reader.has("data") { "there is no such file" } else { "the measurements are missing" };
            reader.problem("data", message, help);
        }
        _ => {}
    }
}

/// Quantities that are unknown, and that a run needs.
fn unknown<'m>(model: &'m Model, inputs: &[Input], task: Task) -> Vec<&'m Parameter> {
    let is_open =
        |p: &&Parameter| p.quantity.knowledge == Knowledge::Free && inputs.iter().all(|input| input.path != p.path);
    let open = model.parameters.iter().filter(is_open);
    if task == Task::Run { open.collect() } else { Vec::new() }
}

/// Results on offer from the jobs.
struct Offer {
    usual: Vec<Offered>,
    /// Of a run, in which values within lists and records have names too.
    report: Option<RunReport>,
}

fn offer(model: &Model, task: Task, inputs: &[Input], points: &Points) -> Result<Offer, String> {
    let first = points.at(0);
    let middles = inputs.iter().zip(&first).map(|(input, first)| input.middle().unwrap_or(*first));
    let values: Vec<(&str, f64)> =
        inputs.iter().zip(middles).map(|(input, told)| (&*input.path, input.kind.to_si(told))).collect();
    let model = model.with_values(&values).map_err(|failure| failure.message)?;
    match task {
        Task::Run => {
            let report = model.report(&Progress::default()).map_err(|failure| failure.message)?;
            Ok(Offer { usual: job::of_report(&report), report: Some(report) })
        }
        task => Ok(Offer { usual: job::of_measured(task, &model), report: None }),
    }
}

fn read_wanted(t: &Reader, offer: Option<&Offer>) -> Option<Wanted> {
    let name = t.text("figure", "figure and entry of a run: largest.value; or a name of a fit: chi2_per_dof");
    if name.is_none() && !t.has("figure") {
        t.problem("", "`figure` is missing", "add figure = \"largest.value\"");
    }
    let found = offer.zip(name.as_deref()).and_then(|(offer, name)| find(t, offer, name));
    if found.is_none() && !t.is_described() {
        t.accept_any();
        return None;
    }
    let kind = found.as_ref().and_then(|found| found.kind).unwrap_or(NUMBER);
    let tolerance = t.optional_table("tolerance", "what the result may be", |t| {
        let lower = t.quantity("lower", kind, "least value that is accepted").optional();
        let upper = t.quantity("upper", kind, "largest value that is accepted").optional();
        match (lower, upper) {
            (None, None) => t.problem("", "the tolerance has no end", "give `lower`, `upper` or both"),
            (Some(lower), Some(upper)) if upper <= lower => {
                t.problem("upper", "the tolerance is empty", "let `upper` be above `lower`");
            }
            _ => {}
        }
        (lower.unwrap_or(f64::NEG_INFINITY), upper.unwrap_or(f64::INFINITY))
    });
    let offered = found?;
    if offered.is_word && tolerance.is_some() {
        t.problem("tolerance", format!("`{}` is a word, and has no tolerance", offered.name), "remove it");
    }
    Some(Wanted { offered, tolerance })
}

/// The result of a name; a figure alone stands for the first number that it tells.
fn find(t: &Reader, offer: &Offer, name: &str) -> Option<Offered> {
    let is_first = |o: &&Offered| !o.is_word && o.name.strip_prefix(name).is_some_and(|rest| rest.starts_with('.'));
    let known = offer.usual.iter().find(|o| o.name == name);
    let known = known.or_else(|| offer.report.is_some().then(|| offer.usual.iter().find(is_first)).flatten()).cloned();
    let found = known.or_else(|| offer.report.as_ref().and_then(|report| job::deeper(report, name)));
    if found.is_none() {
        let names = || offer.usual.iter().map(|o| o.name.as_str());
        let listed: Vec<&str> = names().take(LISTED).collect();
        let help = format!("{}there are {}", did_you_mean(name, names(), '`'), listed.join(", "));
        t.problem("figure", format!("there is no result `{name}`"), help);
    }
    found
}
