//! The effects of several tests: those that tests share once, and each test's own.

use std::cmp::Ordering;

use super::layout::Layout;
use crate::input::{Name, Parameter, Problem};
use crate::model::Model;
use crate::process::{Active, Belongs, Description, UnitRole};
use crate::units::{Kind, Knowledge, Quantity};

/// An effect as it acts in the tests of one machine.
#[derive(Clone, Debug, PartialEq)]
pub struct Shared {
    /// Its description among all tests, with the name that tells it from others.
    pub description: Description,
    /// The tests in which it acts, by their numbers.
    pub acts: Vec<(usize, Acting)>,
}

/// Form that a shared effect takes in one test.
#[derive(Clone, Debug, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "tests have some dozens of them, and nobody moves them about")]
pub enum Acting {
    /// An effect of its process.
    Effect(Description),
    /// A quantity of its tables, by its path.
    Quantity(&'static str),
}

/// Key under which effects of several tests are one.
#[derive(Clone, Debug, PartialEq)]
enum Identity<'m> {
    /// Of one test.
    Own(usize, Name),
    /// Of the machine, as tests of a process see it.
    OfMachine(&'static str, Name),
    /// Of a unit of the machine.
    OfUnit(&'m str, UnitRole),
}

/// The effects of tests, in the order in which they are met.
pub fn gather(names: &[Name], models: &[Model], layout: &Layout) -> Vec<Shared> {
    let mut all: Vec<(Identity, Shared)> = Vec::new();
    for (test, own) in catalogues(models) {
        let identity = identity(test, &models[test], &own);
        match all.iter_mut().find(|(other, _)| *other == identity) {
            Some((_, shared)) => shared.acts.push((test, Acting::Effect(own))),
            None => {
                let description = described(&identity, &own, test, layout);
                all.push((identity, Shared { description, acts: vec![(test, Acting::Effect(own))] }));
            }
        }
    }
    for (test, model) in models.iter().enumerate() {
        let Some(unit) = model.system.unit() else { continue };
        for (path, role) in model.process.of_unit() {
            let same = all.iter_mut().find(|(identity, _)| *identity == Identity::OfUnit(unit, *role));
            same.into_iter().for_each(|(_, shared)| shared.acts.push((test, Acting::Quantity(path))));
        }
    }
    let mut effects: Vec<Shared> = all.into_iter().map(|(_, shared)| shared).collect();
    name_apart(&mut effects, names);
    effects
}

/// The effects that can act in each test, by its number: those of the processes first that name their units
/// themselves, for their names say most.
fn catalogues(models: &[Model]) -> Vec<(usize, Description)> {
    let of_model = |(test, model): (usize, &Model)| {
        let formulas = model.effects.iter().filter(|e| e.formula.is_some()).map(|e| e.description.clone());
        let known = model.process.effects().into_iter().filter(|own| model.system.admits(&own.name).is_ok());
        known.chain(formulas).map(|own| (test, own)).collect::<Vec<_>>()
    };
    let all = models.iter().enumerate().flat_map(of_model);
    let (tested, others): (Vec<_>, Vec<_>) = all.partition(|(_, own)| matches!(own.belongs, Belongs::Tested(_)));
    [others, tested].concat()
}

fn identity<'m>(test: usize, model: &'m Model, own: &Description) -> Identity<'m> {
    match own.belongs {
        Belongs::Test => Identity::Own(test, own.name.clone()),
        Belongs::Machine => Identity::OfMachine(model.process.name(), own.name.clone()),
        Belongs::Unit(unit, role) => Identity::OfUnit(unit, role),
        Belongs::Tested(role) => model
            .system
            .unit()
            .map_or_else(|| Identity::Own(test, own.name.clone()), |unit| Identity::OfUnit(unit, role)),
    }
}

/// An effect as it is told among those of all tests.
fn described(identity: &Identity, own: &Description, test: usize, layout: &Layout) -> Description {
    let name = match (identity, own.belongs) {
        (Identity::OfUnit(unit, _), Belongs::Tested(_)) => format!("{unit}-{}", own.name).into(),
        _ => own.name.clone(),
    };
    let parameters = own.parameters.iter().map(|p| {
        let along = p.along.as_ref().and_then(|along| layout.named(test, along));
        crate::process::Parameter { along, ..p.clone() }
    });
    Description { name, parameters: parameters.collect(), ..own.clone() }
}

/// Gives effects of the same name, which are not one, the names of their tests as well.
fn name_apart(effects: &mut [Shared], names: &[Name]) {
    let all: Vec<Name> = effects.iter().map(|e| e.description.name.clone()).collect();
    for effect in effects {
        let name = &effect.description.name;
        if let (true, Some((test, _))) = (all.iter().filter(|n| *n == name).count() > 1, effect.acts.first()) {
            effect.description.name = format!("{name}-{}", names[*test]).into();
        }
    }
}

impl Shared {
    /// Form of the effect in a test; `None` where it does not act there.
    pub fn in_test(&self, test: usize) -> Option<&Acting> {
        self.acts.iter().find(|(own, _)| *own == test).map(|(_, acting)| acting)
    }

    /// The effect as the models have it, with what they know of its parameters; `None` where none of them has it.
    ///
    /// # Errors
    /// Two of them know it, and differently.
    pub fn stated(&self, models: &[Model]) -> Result<Option<(Active, Vec<Parameter>)>, Problem> {
        let said: Vec<(&Model, Vec<Quantity>, Option<&Active>)> =
            self.acts.iter().filter_map(|(test, acting)| said(&models[*test], acting)).collect();
        let Some((_, first, _)) = said.first() else { return Ok(None) };
        let mut known = first.clone();
        for (model, others, _) in &said[1..] {
            for (i, other) in others.iter().enumerate() {
                let (entry, before) = (&self.description.parameters[i], said[0].0);
                let name = format!("{}.{}", self.description.name, entry.name);
                known[i] = agreed((&name, entry.kind), (before, known[i]), (model, *other))?;
            }
        }
        let formula = said.iter().find_map(|(_, _, active)| active.and_then(|a| a.formula.clone()));
        let values = known.iter().map(|q| q.value).collect();
        let uncertain = self.description.parameters.iter().zip(&known).filter(|(_, q)| q.knowledge != Knowledge::Known);
        let parameters = uncertain.map(|(entry, quantity)| Parameter {
            path: self.description.path(entry),
            kind: entry.kind,
            quantity: *quantity,
            bounds: entry.bounds,
            span: None,
            doubt: None,
        });
        let parameters = parameters.collect();
        Ok(Some((Active { formula, ..self.description.with(values) }, parameters)))
    }
}

/// Values that a model gives for an effect, with the effect itself if it is one of its process; `None` where the model
/// lacks it. A quantity that every model has to have, and that is unknown here, counts as lacking.
fn said<'m>(model: &'m Model, acting: &Acting) -> Option<(&'m Model, Vec<Quantity>, Option<&'m Active>)> {
    let written = |path: &str| model.quantity(path).map(|q| q.quantity);
    match acting {
        Acting::Effect(own) => {
            let active = model.effects.iter().find(|e| e.description.name == own.name)?;
            let entries = active.description.parameters.iter().zip(&active.values);
            let quantity = |(p, value): (_, &f64)| written(&own.path(p)).unwrap_or(Quantity::known(*value));
            Some((model, entries.map(quantity).collect(), Some(active)))
        }
        Acting::Quantity(path) => {
            let quantity = written(path).filter(|q| q.knowledge != Knowledge::Free)?;
            Some((model, vec![quantity], None))
        }
    }
}

/// Reconciles a quantity in the tables of some tests, which no effect here is: the most exact value.
///
/// # Errors
/// Two of them know it, and differently.
pub fn agreed_among<'m>(models: impl Iterator<Item = &'m Model>, parameter: &Parameter) -> Result<Quantity, Problem> {
    let mut said = models.filter_map(|model| Some((model, model.quantity(&parameter.path)?.quantity)));
    let Some(mut known) = said.next() else { return Ok(parameter.quantity) };
    for other in said {
        known.1 = agreed((&parameter.path, parameter.kind), known, other)?;
    }
    Ok(known.1)
}

/// Reconciles two models' values of one quantity: the more exact of them, or either if they are the same.
fn agreed(
    (name, kind): (&str, Kind),
    (one_model, one): (&Model, Quantity),
    (other_model, other): (&Model, Quantity),
) -> Result<Quantity, Problem> {
    /// Relative difference that is round-off of units.
    const ROUND_OFF: f64 = 1e-9;
    let rank = |q: &Quantity| match q.knowledge {
        Knowledge::Known => 2,
        Knowledge::Rough(_) => 1,
        Knowledge::Free => 0,
    };
    let is_same = |a: f64, b: f64| a == b || (a - b).abs() <= ROUND_OFF * a.abs().max(b.abs());
    let std = |q: &Quantity| if let Knowledge::Rough(std) = q.knowledge { std } else { 0.0 };
    match (rank(&one).cmp(&rank(&other)), one.knowledge) {
        (Ordering::Greater, _) => Ok(one),
        (Ordering::Less, _) => Ok(other),
        (Ordering::Equal, Knowledge::Free) => Ok(if one.value.is_nan() { other } else { one }),
        _ if is_same(one.value, other.value) && is_same(std(&one), std(&other)) => Ok(one),
        _ => {
            let shown = |q: &Quantity| match std(q) {
                0.0 => kind.shown(q.value).to_string(),
                std => format!("{} +- {}", kind.shown(q.value), kind.shown(std)),
            };
            let (one_file, other_file) = (&one_model.source.name, &other_model.source.name);
            let (one, other) = (shown(&one), shown(&other));
            let problem = Problem::new(format!("`{name}` is {one} in {one_file} and {other} in {other_file}"));
            Err(problem.help("a machine has one: write the same in both, or `?` in one of them"))
        }
    }
}
