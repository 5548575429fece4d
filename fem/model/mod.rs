//! A model file: a process, its tables, and the effects that are present.

mod add;
mod campaign;
mod change;
mod data;
mod draft;
mod drawing;
mod edit;
mod entry;
mod files;
mod formula_effect;
mod machine;
mod named;
mod odds;
mod other_set;
mod outline;
mod plausible;
mod process;
mod recorded;
mod require;
mod run;
mod schema;
mod shop;
mod spread;
mod tables;
mod terms;
mod together;
mod trial;
mod usual;
mod way;

pub use add::{Setting, add_effect};
pub use campaign::{Acting, Campaign, Shared, Test};
pub use data::Data;
pub use draft::Draft;
pub use entry::{Edit, Entry};
pub use files::kept;
pub use machine::Machine;
pub use odds::{OwnOdds, VALUES};
pub use other_set::OtherSet;
pub use outline::{Holds, Key, List, Outline};
pub use process::ModelProcess;
pub use run::{Contribution, Run, Untold};
pub use schema::schema;
pub use shop::{Reach, ShopSetting};
pub use spread::Spread;
pub use together::Together;

use std::collections::HashMap;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use toml_edit::Table;

use crate::input::{
    FileKey, Found, InputError, Instead, Kept, Name, Names, Parameter, ParameterId, Problem, Reader, Source,
    did_you_mean, nearest, numbered, stem,
};
use crate::measure::Reading;
use crate::noise::{self, MEASUREMENT, Term};
use crate::process::{Active, Contradiction, Coordinate, Description, ForwardModel, Process, System};
use crate::processes;
use tables::Tables;

/// Largest model file, bytes; people write models by hand.
const LARGEST: u64 = 4_000_000;

/// A model that was read without a problem.
#[derive(Clone)]
pub struct Model {
    /// Name and text of the file.
    pub source: Source,
    /// The key `title`, if the file has it.
    pub title: Option<String>,
    /// Process that it models.
    pub process: ModelProcess,
    /// Ideal system that its tables describe.
    #[doc(hidden)]
    pub system: Arc<dyn System>,
    /// Effects, in the order of the file.
    #[doc(hidden)]
    pub effects: Vec<Active>,
    /// Effects of the measurement, in the order of the file; the rows are records of a file, from 1.
    #[doc(hidden)]
    pub measurement: Vec<Term>,
    /// Parameters that it does not know exactly.
    pub parameters: Vec<Parameter>,
    /// Where the value of each of the parameters belongs.
    places: Vec<Place>,
    /// All quantities that the file has.
    pub quantities: Arc<[Parameter]>,
    /// Odds of effects that it gives itself.
    #[doc(hidden)]
    pub odds: OwnOdds,
    /// Correlations of its values, as far as they were fitted together.
    #[doc(hidden)]
    pub together: Together,
    /// The largest change of its command that the machine may be given, m.
    #[doc(hidden)]
    pub largest_change: Option<f64>,
    /// What a shop can change, as far as it says.
    #[doc(hidden)]
    pub settings: Vec<ShopSetting>,
    /// Machine that it names.
    #[doc(hidden)]
    pub machine: Option<Machine>,
    /// How its measurement files are read where they do not say it themselves.
    #[doc(hidden)]
    pub reading: Reading,
    /// Values (SI) that were entered in place of those of the file, by their quantities.
    entered: HashMap<ParameterId, f64>,
    /// Files that it names.
    files: Vec<FileKey>,
    /// Results of reading that stay from one reading to the next.
    kept: Kept,
    tables: Tables,
}

/// Where the value of a parameter belongs.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Place {
    /// To an effect: which, and which of its parameters.
    Effect(usize, usize),
    /// To an effect of the measurement, as its size.
    Size(usize),
    /// To another table, which is read again with it.
    Table,
}

/// The places of parameters among effects, of the machine and of the measurement.
fn places(parameters: &[Parameter], effects: &[Active], measurement: &[Term]) -> Vec<Place> {
    let place = |parameter: &Parameter| {
        let of_term = || measurement.iter().position(|term| noise::is_size_of(&parameter.path, term)).map(Place::Size);
        let of_effect = place_among(effects, &parameter.path).map(|(effect, own)| Place::Effect(effect, own));
        of_effect.or_else(of_term).unwrap_or(Place::Table)
    };
    parameters.iter().map(place).collect()
}

/// The effect to which a quantity belongs, and its position there, by its path.
fn place_among(effects: &[Active], path: &str) -> Option<(usize, usize)> {
    let (effect, name) = path.strip_prefix("effects.")?.rsplit_once('.')?;
    let effect = effects.iter().position(|e| e.description.name == effect)?;
    let parameters = &effects[effect].description.parameters;
    Some((effect, parameters.iter().position(|p| p.name == name)?))
}

impl Model {
    /// Reads a model file.
    ///
    /// # Errors
    /// The file is wrong; the error lists every problem with its place and remedy.
    pub fn load(path: &Path) -> Result<Self, InputError> {
        Self::parse(Source::read(path, LARGEST)?)
    }

    /// Reads a model from its text.
    ///
    /// # Errors
    /// The text is wrong; the error lists every problem.
    pub fn parse(source: Source) -> Result<Self, InputError> {
        Draft::parse(source)?.with(&[])
    }

    /// The model of rows that have these further columns.
    ///
    /// # Errors
    /// A column contradicts what the model says of it.
    pub fn with_recorded(&self, recorded: &[Coordinate]) -> Result<Self, InputError> {
        if self.campaign().is_some() || self.recorded() == recorded {
            return Ok(self.clone());
        }
        let problem = |problem| InputError::one(self.source.clone(), problem);
        self.read_again(self.tables.clone(), recorded).map_err(problem)
    }

    /// The further columns of the rows that it is made for.
    pub fn recorded(&self) -> &[Coordinate] {
        match &self.process {
            ModelProcess::Recorded(own) => own.of_files(),
            ModelProcess::Catalogue(_) | ModelProcess::Tests(_) => &[],
        }
    }

    /// Reads a model from its tables, with what was kept from readings before.
    fn of_tables(source: Source, tables: Tables, kept: Kept, recorded: &[Coordinate]) -> Result<Self, Vec<Problem>> {
        let process = find_process(tables.now()).map_err(|problem| vec![problem])?;
        let kept = kept.with_other_tables();
        let (
            (
                process,
                (title, machine, system, effects, measurement, (odds, together, settings, largest_change, reading)),
            ),
            found,
        ) = Reader::of_file(tables.now(), source.folder(), &kept, Instead::default(), |model| {
            let process = ModelProcess::of(process, recorded, recorded::read(model, process, recorded));
            (process.clone(), read(model, &*process))
        });
        let Found { parameters, quantities, files, problems } = found;
        let Some(system) = system.filter(|_| problems.is_empty()) else { return Err(problems) };
        let places = places(&parameters, &effects, &measurement);
        Ok(Self {
            title,
            process,
            system,
            effects,
            measurement,
            parameters,
            places,
            quantities: quantities.into(),
            odds,
            together,
            largest_change,
            settings,
            machine,
            reading,
            entered: HashMap::new(),
            files,
            source,
            kept,
            tables,
        })
    }

    /// A forward model as the instrument of these terms shows it.
    fn behind(&self, part: Box<dyn ForwardModel>, terms: &[Term]) -> Box<dyn ForwardModel> {
        noise::behind(part, terms, &*self.process, noise::time_of(&*self.process))
    }

    /// Forward model as it is written, with what its instrument shows of measured rows.
    #[doc(hidden)]
    pub fn forward(&self) -> Box<dyn ForwardModel> {
        self.behind(self.system.with_effects(&self.effects), &self.measurement)
    }

    /// The tests of which it is made, where it is made of several.
    pub fn campaign(&self) -> Option<&Campaign> {
        match &self.process {
            ModelProcess::Tests(campaign) => Some(campaign),
            ModelProcess::Catalogue(_) | ModelProcess::Recorded(_) => None,
        }
    }

    /// Name of the table in which an effect of the measurement is added to the model: its own, or where that
    /// is taken, by the model or among `others`, the next of `zero-shift-2`, `zero-shift-3`, ….
    pub fn free_table(&self, effect: &str, others: &[String]) -> String {
        let is_taken = |name: &String| self.has_measurement(name) || others.contains(name);
        numbered(effect).find(|name| !is_taken(name)).unwrap_or_default()
    }

    /// Whether the model has the table `[measurement.NAME]`.
    fn has_measurement(&self, name: &str) -> bool {
        self.tables.now().get(MEASUREMENT).is_some_and(|tables| tables.get(name).is_some())
    }

    /// Name of the model's file without its folder and ending.
    pub fn stem(&self) -> &OsStr {
        stem(Path::new(&*self.source.name)).unwrap_or("model".as_ref())
    }

    /// File of the model and those that it names.
    pub fn paths(&self) -> Vec<PathBuf> {
        let named = self.files.iter().map(|file| self.source.folder().join(&file.written));
        std::iter::once(PathBuf::from(&*self.source.name)).chain(named).collect()
    }

    /// Effect to which a quantity belongs, and its position there, by its path.
    fn place(&self, path: &str) -> Option<(usize, usize)> {
        place_among(&self.effects, path)
    }

    /// Whether a parameter, by its path, belongs to a formula effect.
    pub fn is_of_formula(&self, path: &str) -> bool {
        self.place(path).is_some_and(|(effect, _)| self.effects[effect].formula.is_some())
    }

    /// Parameter of an effect, by its path, whether of the catalogue or of a formula.
    pub fn effect_parameter(&self, path: &str) -> Option<&crate::process::Parameter> {
        let (effect, parameter) = self.place(path)?;
        Some(&self.effects[effect].description.parameters[parameter])
    }

    /// Value of a parameter of an effect, by its path, SI.
    pub fn value(&self, path: &str) -> Option<f64> {
        let (effect, parameter) = self.place(path)?;
        self.effects[effect].values.get(parameter).copied()
    }

    /// Name of the effect to which a quantity belongs, by its path.
    pub fn effect_of(&self, path: &str) -> Option<&str> {
        self.place(path).map(|(effect, _)| &*self.effects[effect].description.name)
    }

    /// A quantity that the file has, by its path.
    pub fn quantity(&self, path: &str) -> Option<&Parameter> {
        self.quantities.iter().find(|own| *own.path == *path)
    }

    /// Catalogue entry of a parameter of an effect, by its path.
    pub fn catalogue(&self, path: &str) -> Option<&crate::process::Parameter> {
        self.effect_parameter(path).filter(|_| !self.is_of_formula(path))
    }
}

fn find_process(document: &Table) -> Result<&'static dyn Process, Problem> {
    let names = || processes::ALL.iter().map(|p| p.name());
    let listed = || names().map(|n| format!("\"{n}\"")).collect::<Vec<_>>().join(", ");
    let Some(item) = document.get("process") else {
        if document.contains_key("budget") || document.contains_key("error") {
            let problem = Problem::new("this is a budget of errors, and no model");
            return Err(problem.help("`fem budget` adds it up, and says which term to buy down").at(Some(0..0)));
        }
        let example = names().next().unwrap_or_default();
        let problem = Problem::new("the model does not say which process it models");
        return Err(problem
            .help(format!("add process = \"{example}\" at the top; known are {}", listed()))
            .at(Some(0..0)));
    };
    let given = item.as_str().unwrap_or_default();
    processes::ALL.iter().copied().find(|p| p.name() == given).ok_or_else(|| {
        let meant = did_you_mean(given, names(), '"');
        let problem = Problem::new(format!("{} is no process known here", item.to_string().trim()));
        problem.help(format!("{meant}known are {}", listed())).at(item.span())
    })
}

/// Reads everything that a model file may hold; the schema is made by the same calls.
#[expect(clippy::type_complexity, reason = "the parts of a model, taken apart at once")]
fn read(
    model: &Reader,
    process: &dyn Process,
) -> (
    Option<String>,
    Option<Machine>,
    Option<Arc<dyn System>>,
    Vec<Active>,
    Vec<Term>,
    (OwnOdds, Together, Vec<ShopSetting>, Option<f64>, Reading),
) {
    let title = model.text("title", "what is modelled, for people");
    model.text("process", "which process is modelled");
    model.part("measurement");
    let system: Option<Arc<dyn System>> = process.read(model).map(Arc::from);
    let machine = machine::read(model, system.as_ref().and_then(|system| system.unit()));
    let effects = read_effects(model, process, system.as_deref());
    let odds = OwnOdds::read(model, process);
    let settings = (ShopSetting::all(model), shop::largest_change(model, process.size_kind()));
    let further = (odds, Together::read(model, process.size_kind()), settings.0, settings.1, files::read(model));
    (title, machine, system, effects, noise::read(model, process), further)
}

fn read_effects(model: &Reader, process: &dyn Process, system: Option<&dyn System>) -> Vec<Active> {
    let known = process.effects();
    let names: Vec<Name> = known.iter().map(|d| d.name.clone()).collect();
    let find = |name: &str, is_formula: bool| match names.iter().find(|n| **n == name) {
        Some(known) => Ok(known.clone()),
        None if is_formula => Ok(name.to_string().into()),
        None => Err(unknown_effect(name, process, &names)),
    };
    let read = |name: &Name, table: &Reader| {
        let changed = |effect: Active| {
            let change = change::read(&effect.description, table, process);
            [Some(effect), change].into_iter().flatten().collect::<Vec<_>>()
        };
        let Some(description) = known.iter().find(|d| d.name == *name) else {
            return formula_effect::read(name, (table, model), process).map(changed).unwrap_or_default();
        };
        if let Some(Err(reason)) = system.map(|s| s.admits(name)) {
            table.problem("", reason, "remove the effect, or change what it acts on");
        }
        let effect = description.read(table);
        // A search may ask what would be if the two were not one.
        let said_twice = system.filter(|_| table.is_as_written()).and_then(|s| s.contradiction(&effect));
        if let Some(Contradiction { parameter, message, help }) = said_twice {
            table.problem(parameter, message, help);
        }
        changed(effect)
    };
    let about = "physical effects beyond the ideal system; one of your own has a formula";
    let names = Names { known: &names, mark: "formula", find: &find };
    model.named_tables("effects", about, names, read).into_iter().flatten().collect()
}

fn unknown_effect(name: &str, process: &dyn Process, names: &[Name]) -> Problem {
    let owner = processes::ALL.iter().find(|p| p.effects().iter().any(|d| d.name == name));
    if let Some(owner) = owner {
        let message = format!("`{name}` is an effect of `{}`, not of `{}`", owner.name(), process.name());
        return Problem::new(message).help(format!("`fem effects {}` lists those that fit", process.name()));
    }
    if noise::effects::named(name).is_some() {
        let message = format!("`{name}` is an effect of the measurement, not of `{}`", process.name());
        return Problem::new(message).help(format!("write [measurement.{name}]"));
    }
    let problem = Problem::new(format!("`{name}` is no effect known here"));
    match nearest(name, names.iter().map(Name::as_str).chain(noise::effects::all().map(|e| e.name))) {
        Some(near) => problem.help(format!("did you mean `{near}`? `fem effects {}` lists all", process.name())),
        None => problem.help(format!(
            "`fem effects {}` lists those that are; an effect of your own has a `formula`",
            process.name()
        )),
    }
}

/// Finds an effect of a process by its name.
pub fn effect_of(process: &dyn Process, name: &str) -> Result<Description, Problem> {
    let known = process.effects();
    let names: Vec<Name> = known.iter().map(|d| d.name.clone()).collect();
    known.into_iter().find(|d| d.name == name).ok_or_else(|| unknown_effect(name, process, &names))
}
