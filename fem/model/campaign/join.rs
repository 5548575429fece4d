//! Joins the models of tests to one.

use std::collections::{BTreeMap, HashMap};
use std::sync::Arc;

use super::drawing::known_of_drawings;
use super::effects::{self, Acting, Shared};
use super::layout::Layout;
use super::system::Whole;
use super::test::{Campaign, Test, origins};
use crate::input::{Kept, Name, Parameter, Problem, Source, numbered};
use crate::measure::Reading;
use crate::model::odds::OwnOdds;
use crate::model::tables::Tables;
use crate::model::{Model, ModelProcess, Together, places};
use crate::process::Active;

impl Model {
    /// Tests of one machine, each with a model, as one model.
    ///
    /// # Errors
    /// A model names no machine, or another one than the first; two of them know the same thing of the machine, and
    /// differently.
    pub fn of_tests(models: Vec<Self>) -> Result<Self, Problem> {
        check_machine(&models)?;
        let names = names(&models);
        let layout = Layout::new(names.iter().zip(models.iter().map(|m| &*m.process)));
        let shared = effects::gather(&names, &models, &layout);
        let odds = own_odds(&models, &shared)?;
        let (mut active, mut parameters): (Vec<Active>, Vec<Parameter>) = (Vec::new(), Vec::new());
        for effect in &shared {
            if let Some((own, uncertain)) = effect.stated(&models)? {
                active.push(own);
                parameters.extend(uncertain);
            }
        }
        let measurement = names.iter().zip(&models).enumerate().flat_map(|(test, (name, model))| {
            model.measurement.iter().map(|term| layout.term(test, name, term)).collect::<Vec<_>>()
        });
        let measurement = measurement.collect();
        let each = names.iter().enumerate();
        let origins = each.map(|(test, name)| origins((test, name), &models, &shared, &mut parameters));
        let origins = origins.collect::<Result<Vec<_>, Problem>>()?;
        let quantities = known_of_drawings(&models).into();
        let tests =
            names.into_iter().zip(models).zip(origins).map(|((name, model), origins)| Test { name, model, origins });
        let tests: Vec<Test> = tests.collect();
        let files: Vec<String> = tests.iter().map(|test| test.model.source.name.to_string()).collect();
        let campaign = Arc::new(Campaign { tests, effects: shared, layout });
        Ok(Self {
            source: Source::new(files.join(" and "), ""),
            title: None,
            machine: campaign.tests[0].model.machine.clone(),
            system: Arc::new(Whole(campaign.clone())),
            process: ModelProcess::Tests(campaign),
            measurement,
            places: places(&parameters, &active, &[]),
            parameters,
            quantities,
            odds,
            together: Together::default(),
            largest_change: None,
            settings: Vec::new(),
            reading: Reading::default(),
            entered: HashMap::new(),
            files: Vec::new(),
            kept: Kept::default(),
            // Nothing is written of them together.
            tables: Tables::default(),
            effects: active,
        })
    }
}

/// The odds that the models give, by the names that effects have among all tests.
///
/// # Errors
/// Two of them give different odds to one effect.
fn own_odds(models: &[Model], shared: &[Shared]) -> Result<OwnOdds, Problem> {
    let of_effect = |effect: &Shared| {
        let of_test = |(test, acting): &(usize, Acting)| match acting {
            Acting::Effect(own) => Some((effect.description.name.clone(), models[*test].odds.of(&own.name)?)),
            Acting::Quantity(_) => None,
        };
        effect.acts.iter().filter_map(of_test).collect::<Vec<_>>()
    };
    // A scale and a clock are of a test, and have one name in all of them.
    let is_of_process = |model: &Model, name: &Name| model.process.effects().iter().any(|own| own.name == *name);
    let of_others = |model: &Model| {
        let others = model.odds.iter().filter(|(name, _)| !is_of_process(model, name));
        others.map(|(name, odds)| (name.clone(), odds)).collect::<Vec<_>>()
    };
    let mut all = BTreeMap::new();
    for (name, odds) in shared.iter().flat_map(of_effect).chain(models.iter().flat_map(of_others)) {
        if *all.entry(name.clone()).or_insert(odds) != odds {
            let problem = Problem::new(format!("two models give different odds to `{name}`"));
            return Err(problem.help("write the same odds into both, or into one of them"));
        }
    }
    Ok(OwnOdds::new(all))
}

/// Names of tests: those of their files, made apart.
fn names(models: &[Model]) -> Vec<Name> {
    let mut names: Vec<Name> = Vec::new();
    for model in models {
        let stem = model.stem().to_string_lossy().replace(|c: char| !c.is_alphanumeric() && c != '_', "-");
        names.extend(numbered(&stem).map(Name::from).find(|name| !names.contains(name)));
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
            Err(problem
                .help(format!("several tests are of one machine: write machine = \"{file}\" at its top; {form}")))
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
