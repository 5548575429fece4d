//! Tests of one machine, each with a model of its own, as one model: what belongs to the machine is there once
//! and acts in every test that sees it. Everything that takes a model takes this one too.

mod data;
mod effects;
mod layout;
mod system;

pub use effects::{Acting, Shared};

use std::collections::HashMap;
use std::path::Path;
use std::sync::Arc;

use toml_edit::Document;

use super::Model;
use crate::input::{Kept, Parameter, Problem, Source};
use crate::noise::{MEASUREMENT, Term};
use crate::process::{Active, Failure, ForwardModel, formula_effect};
use layout::Layout;
use system::{Together, Whole};

/// Tests of one machine.
pub struct Campaign {
    /// The tests, in their order.
    pub tests: Vec<Test>,
    /// Effects that can act in them.
    pub effects: Vec<Shared>,
    layout: Layout,
}

/// One of several tests of a machine.
pub struct Test {
    /// Its name: that of its model without folder and ending, or the next that is free.
    pub name: &'static str,
    /// Its model.
    pub model: Model,
    /// Where each of the model's parameters has its value from.
    origins: Vec<Origin>,
}

/// Where a parameter of a test has its value from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Origin {
    /// A parameter of all tests, by its number.
    Parameter(usize),
    /// A parameter of an effect: of which, and which.
    Effect(usize, usize),
}

impl Model {
    /// Tests of one machine, each with a model, as one model.
    ///
    /// # Errors
    /// A model names no machine, or another one than the first; two of them know the same thing of the machine, and
    /// differently.
    pub fn of_tests(models: Vec<Self>) -> Result<Self, Problem> {
        check_machine(&models)?;
        // Nothing is written of them together.
        let document = Arc::new(Document::parse(String::new()).map_err(|e| Problem::new(e.message()))?);
        let names = names(&models);
        let layout = Layout::new(&names.iter().copied().zip(models.iter().map(|m| m.process)).collect::<Vec<_>>());
        let shared = effects::gather(&names, &models, &layout);
        let (mut active, mut parameters): (Vec<Active>, Vec<Parameter>) = (Vec::new(), Vec::new());
        for effect in &shared {
            if let Some((own, uncertain)) = effect.stated(&models)? {
                active.push(own);
                parameters.extend(uncertain);
            }
        }
        let measurement = names.iter().zip(&models).enumerate().flat_map(|(test, (name, model))| {
            model.measurement.iter().map(|term| among_all(&layout, test, name, term)).collect::<Vec<_>>()
        });
        let measurement = measurement.collect();
        let mut tests = Vec::new();
        for (number, (name, model)) in names.iter().zip(models).enumerate() {
            let origins = origins(number, name, &model, &shared, &mut parameters);
            tests.push(Test { name, model, origins });
        }
        let files: Vec<String> = tests.iter().map(|test| test.model.source.name.to_string()).collect();
        let process = system::process(&layout, &shared);
        let campaign = Arc::new(Campaign { tests, effects: shared, layout });
        Ok(Self {
            source: Source::new(files.join(" and "), ""),
            title: None,
            process,
            system: Arc::new(Whole(campaign.clone())),
            effects: active,
            measurement,
            parameters,
            quantities: Arc::default(),
            machine: campaign.tests[0].model.machine.clone(),
            campaign: Some(campaign),
            entered: HashMap::new(),
            files: Vec::new(),
            kept: Kept::default(),
            document,
        })
    }
}

impl Campaign {
    /// An effect by its name among all tests.
    pub fn effect(&self, name: &str) -> Option<&Shared> {
        self.effects.iter().find(|e| e.description.name == name)
    }

    /// The test of an observable, by its number among all tests.
    pub fn test_of(&self, observable: usize) -> &Test {
        &self.tests[self.number_of(observable)]
    }

    /// The number of that test.
    pub fn number_of(&self, observable: usize) -> usize {
        self.layout.own_observable(observable).0
    }

    /// What an observable, by its number among all tests, is called in its own.
    pub fn name_in_test(&self, observable: usize) -> &'static str {
        let (test, own) = self.layout.own_observable(observable);
        self.tests[test].model.process.observables()[own].name
    }

    /// The tests with these parameters, SI, and effects.
    pub(super) fn forward(&self, values: &[f64], effects: &[Active]) -> Result<Box<dyn ForwardModel>, Failure> {
        let part = |(number, test): (usize, &Test)| {
            let value = |origin: &Origin| match *origin {
                Origin::Parameter(parameter) => values[parameter],
                Origin::Effect(effect, parameter) => {
                    let shared = &self.effects[effect].description;
                    let present = effects.iter().find(|e| e.description.name == shared.name);
                    present.map_or_else(|| shared.neutral().values[parameter], |e| e.values[parameter])
                }
            };
            let values: Vec<f64> = test.origins.iter().map(value).collect();
            let own = self.own_effects(number, effects);
            test.model.forward_of(&values, |_| own)
        };
        let parts = self.tests.iter().enumerate().map(part).collect::<Result<_, _>>()?;
        Ok(Box::new(Together { parts, layout: self.layout.clone() }))
    }

    /// The effects of all tests, and readings of instruments, that act in one of them, as its process knows them.
    fn own_effects(&self, test: usize, effects: &[Active]) -> Vec<Active> {
        let own = |active: &Active| {
            let description = match active.description.table {
                MEASUREMENT => self.own_reading(test, active)?,
                _ => match self.effect(active.description.name)?.in_test(test)? {
                    Acting::Effect(own) => own.clone(),
                    Acting::Quantity(_) => return None,
                },
            };
            Some(Active { description, ..active.clone() })
        };
        effects.iter().filter_map(own).collect()
    }

    /// What an instrument does to a test, as its process tells it; `None` where it is another test's.
    fn own_reading(&self, test: usize, reading: &Active) -> Option<crate::process::Description> {
        let Some(name) = reading.description.observable else { return Some(reading.description.clone()) };
        let number = self.layout.observables.iter().position(|o| o.name == name)?;
        let (of, own) = self.layout.own_observable(number);
        let observable = Some(self.tests[test].model.process.observables().get(own)?.name);
        (of == test).then(|| crate::process::Description { observable, ..reading.description.clone() })
    }
}

/// A term of a test among those of all, in records of its file.
fn among_all(layout: &Layout, test: usize, name: &str, term: &Term) -> Term {
    let mut term = term.clone();
    term.table = format!("{name}.{}", term.table);
    term.by.iter_mut().for_each(|by| *by = layout.coordinate(test, *by));
    term.along.iter_mut().for_each(|along| along.coordinate = layout.coordinate(test, along.coordinate));
    term.observable = term.observable.map(|own| layout.observable(test, own));
    term
}

/// Where the parameters of a test have their values from; those that are the test's own join `parameters`.
fn origins(
    test: usize,
    name: &str,
    model: &Model,
    shared: &[Shared],
    parameters: &mut Vec<Parameter>,
) -> Vec<Origin> {
    let of_effect = |path: &str| {
        shared.iter().enumerate().find_map(|(number, effect)| match effect.in_test(test)? {
            Acting::Quantity(own) => (*own == path).then_some(Origin::Effect(number, 0)),
            Acting::Effect(own) => {
                let entry = own.parameters.iter().position(|p| own.path(p) == path)?;
                Some(Origin::Effect(number, entry))
            }
        })
    };
    let mut origin = |parameter: &Parameter| {
        of_effect(&parameter.path).unwrap_or_else(|| {
            parameters.push(Parameter { path: format!("{name}.{}", parameter.path), span: None, ..parameter.clone() });
            Origin::Parameter(parameters.len() - 1)
        })
    };
    model.parameters.iter().map(&mut origin).collect()
}

/// Names of tests: those of their files, made apart.
fn names(models: &[Model]) -> Vec<&'static str> {
    let mut names: Vec<&'static str> = Vec::new();
    for model in models {
        let stem = model.stem().to_string_lossy().replace(|c: char| !c.is_alphanumeric() && c != '_', "-");
        let further = (2..).map(|number| format!("{stem}-{number}"));
        let mut all = std::iter::once(stem.clone()).chain(further).map(|name| formula_effect::name(&name));
        names.extend(all.find(|name| !names.contains(name)));
    }
    names
}

/// Refuses models that do not name one machine.
fn check_machine(models: &[Model]) -> Result<(), Problem> {
    let nameless = models.iter().find(|model| model.machine.is_none());
    let machines = || models.iter().filter_map(|m| Some((m, m.machine.as_ref()?)));
    let mut others = machines().skip(1);
    match (nameless, machines().next()) {
        (Some(model), first) => {
            let file = first.map_or("lathe.toml".into(), |(_, machine)| machine.path.display().to_string());
            let problem = Problem::new(format!("{} names no machine", model.source.name));
            let form = "a file with [machine], a name, and a table for each unit: [machine.tailstock]";
            Err(problem.help(format!("several tests are of one machine: write machine = \"{file}\" at its top; {form}")))
        }
        (None, Some((one, first))) => match others.find(|(_, machine)| !machine.is(first)) {
            Some((other, machine)) => {
                let [first, second] = [first, machine].map(|m| m.path.display().to_string());
                let (one, other) = (&one.source.name, &other.source.name);
                let problem = Problem::new(format!("{one} is of {first}, and {other} of {second}"));
                Err(problem.help("tests of different machines share nothing: diagnose each by itself"))
            }
            None => Ok(()),
        },
        (None, None) => Err(Problem::new("there is no model").help("name one")),
    }
}

impl Test {
    /// The file of its model, as people call it.
    pub fn file(&self) -> String {
        let path = Path::new(&*self.model.source.name);
        path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
    }
}
