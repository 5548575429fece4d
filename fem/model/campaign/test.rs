//! The tests of a machine, and how what is said of all of them is said of each.

use std::path::Path;

use super::drawing::agreed_of_drawing;
use super::effects::{Acting, Shared, agreed_among};
use super::forward::Together;
use super::layout::Layout;
use crate::input::{Name, Parameter, ParameterId, Problem};
use crate::model::Model;
use crate::noise::MEASUREMENT;
use crate::process::{Active, Description, Failure, ForwardModel, ON_TRIAL};
use crate::units::{Knowledge, Quantity};

/// Tests of one machine.
pub struct Campaign {
    /// The tests, in their order.
    pub tests: Vec<Test>,
    /// Effects that can act in them.
    pub effects: Vec<Shared>,
    /// Where the rows of each test stand.
    pub(super) layout: Layout,
}

/// One of several tests of a machine.
pub struct Test {
    /// Its name: that of its model without folder and ending, or the next that is free.
    pub name: Name,
    /// Its model.
    pub model: Model,
    /// Where each of the model's parameters has its value from.
    pub(super) origins: Vec<Origin>,
}

/// Where a parameter of a test has its value from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Origin {
    /// A parameter of all tests, by its number.
    Parameter(usize),
    /// A parameter of an effect: of which, and which.
    Effect(usize, usize),
    /// A value that another test knows, SI.
    Known(f64),
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

    /// Name within its test of an observable, given by its number among all tests.
    pub fn name_in_test(&self, observable: usize) -> &str {
        let (test, own) = self.layout.own_observable(observable);
        &self.tests[test].model.process.observables()[own].name
    }

    /// The tests with these parameters, SI, effects, and values on trial of what they draw.
    pub(in crate::model) fn forward(
        &self,
        values: &[f64],
        effects: &[Active],
    ) -> Result<Box<dyn ForwardModel>, Failure> {
        let part = |(number, test): (usize, &Test)| {
            let value = |origin: &Origin| match *origin {
                Origin::Parameter(parameter) => values[parameter],
                Origin::Known(value) => value,
                Origin::Effect(effect, parameter) => {
                    let shared = &self.effects[effect].description;
                    let present = effects.iter().find(|e| e.description.name == shared.name);
                    present.map_or_else(|| shared.neutral().values[parameter], |e| e.values[parameter])
                }
            };
            let values: Vec<f64> = test.origins.iter().map(value).collect();
            let own = self.own_effects(number, effects);
            let on_trial = effects.iter().filter(|active| active.description.table == ON_TRIAL);
            let drawn = on_trial.filter(|active| test.model.quantity(&active.description.name).is_some());
            let drawn: Vec<(&str, f64)> =
                drawn.filter_map(|active| Some((&*active.description.name, *active.values.first()?))).collect();
            match drawn.is_empty() {
                true => test.model.forward_of(&values, |_| own),
                false => test.model.with_values(&drawn)?.forward_of(&values, |_| own),
            }
        };
        let parts = self.tests.iter().enumerate().map(part).collect::<Result<_, _>>()?;
        Ok(Box::new(Together { parts, layout: self.layout.clone() }))
    }

    /// The effects of all tests, and readings of instruments, that act in one of them, as its process knows them.
    pub fn own_effects(&self, test: usize, effects: &[Active]) -> Vec<Active> {
        let own = |active: &Active| {
            let description = match active.description.table {
                MEASUREMENT => self.own_reading(test, active)?,
                _ => match self.effect(&active.description.name)?.in_test(test)? {
                    Acting::Effect(own) => own.clone(),
                    Acting::Quantity(_) => return None,
                },
            };
            Some(Active { description, ..active.clone() })
        };
        effects.iter().filter_map(own).collect()
    }

    /// Effect of an instrument on a test, with the observable as the test's process names it; `None` where it is
    /// another test's.
    fn own_reading(&self, test: usize, reading: &Active) -> Option<Description> {
        let Some(name) = &reading.description.observable else { return Some(reading.description.clone()) };
        let number = self.layout.observables.iter().position(|o| o.name == *name)?;
        let (of, own) = self.layout.own_observable(number);
        let observable = Some(self.tests[test].model.process.observables().get(own)?.name.clone());
        (of == test).then(|| Description { observable, ..reading.description.clone() })
    }
}

impl Test {
    /// The file of its model, as people call it.
    pub fn file(&self) -> String {
        let path = Path::new(&*self.model.source.name);
        path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
    }
}

/// Where the parameters of a test have their values from; those that are the test's own join `parameters`, and those
/// of a unit that tests share without an effect of theirs once.
pub fn origins(
    (test, name): (usize, &str),
    models: &[Model],
    shared: &[Shared],
    parameters: &mut Vec<Parameter>,
) -> Result<Vec<Origin>, Problem> {
    let of_effect = |path: &str| {
        shared.iter().enumerate().find_map(|(number, effect)| match effect.in_test(test)? {
            Acting::Quantity(own) => (*own == path).then_some(Origin::Effect(number, 0)),
            Acting::Effect(own) => {
                let entry = own.parameters.iter().position(|p| own.path(p) == *path)?;
                Some(Origin::Effect(number, entry))
            }
        })
    };
    let (model, unit) = (&models[test], models[test].system.unit());
    // What the tables of several tests say of one unit, each for itself.
    let tables = model.quantities.iter().filter(|q| model.process.of_unit().iter().any(|(path, _)| q.path == *path));
    let mut of_unit: Vec<(&str, Quantity)> = Vec::new();
    for quantity in tables.filter(|q| of_effect(&q.path).is_none()) {
        if let Some(unit) = unit {
            let of_unit_too = models.iter().filter(|model| model.system.unit() == Some(unit));
            of_unit.push((&quantity.path, agreed_among(of_unit_too, quantity)?));
        }
    }
    let mut own = |path: ParameterId, quantity: Quantity, parameter: &Parameter| {
        let known = parameters.iter().position(|other| other.path == path);
        Origin::Parameter(known.unwrap_or_else(|| {
            parameters.push(Parameter { path, quantity, span: None, ..parameter.clone() });
            parameters.len() - 1
        }))
    };
    let of_drawing = agreed_of_drawing(model, models)?;
    let origin = |parameter: &Parameter| {
        if let Some((_, quantity)) = of_drawing.iter().find(|(path, _)| parameter.path == *path) {
            return match quantity.knowledge {
                Knowledge::Known => Origin::Known(quantity.value),
                _ => own(parameter.path.clone(), *quantity, parameter),
            };
        }
        let shared = of_unit.iter().find(|(path, _)| parameter.path == *path);
        match (of_effect(&parameter.path), shared, unit) {
            (Some(origin), ..) => origin,
            (None, Some((_, quantity)), _) if quantity.knowledge == Knowledge::Known => Origin::Known(quantity.value),
            (None, Some((_, quantity)), Some(unit)) => {
                own(format!("{unit}.{}", parameter.path).into(), *quantity, parameter)
            }
            _ => own(format!("{name}.{}", parameter.path).into(), parameter.quantity, parameter),
        }
    };
    Ok(model.parameters.iter().map(origin).collect())
}
