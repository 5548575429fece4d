//! Machines from the texts of their tables, as a model file would have them: for the validation table and the
//! tests of effects.

use toml_edit::Document;

use super::{Active, Assembled, Definition, Description};
use crate::input::Reader;

/// A machine with its effects from the texts of their tables. `None` where
/// a text is wrong: the row that needs it then holds NaN, and cannot pass.
pub fn assembled<D: Definition>(model: &str, effects: &str) -> Option<Assembled<D>> {
    let model = Document::parse(model).ok()?;
    let (setup, _, problems) = Reader::document(model.as_table(), D::read);
    let effects = Document::parse(effects).ok()?;
    let known: Vec<Description> = D::EFFECTS.iter().map(|e| e.description()).collect();
    let read = |table: &Reader| {
        let active = |(name, _): (&str, _)| {
            let description = known.iter().find(|d| d.name == name)?;
            Some(table.table(description.name.clone(), "", |t| description.read(t)))
        };
        effects.iter().map(active).collect::<Option<Vec<Active>>>()
    };
    let (active, _, more) = Reader::document(effects.as_table(), read);
    (problems.is_empty() && more.is_empty()).then_some(Assembled::new(setup?.into(), &active?))
}

#[cfg(test)]
/// A machine with one effect of its catalogue, values in canonical units.
pub fn with_effect<D: Definition>(model: &str, name: &str, canonical: &[f64]) -> Assembled<D> {
    with_effects(model, &[(name, canonical)])
}

#[cfg(test)]
/// The same with several effects.
pub fn with_effects<D: Definition>(model: &str, all: &[(&str, &[f64])]) -> Assembled<D> {
    let model = Document::parse(model).unwrap();
    let (setup, _, problems) = Reader::document(model.as_table(), D::read);
    assert_eq!(problems, []);
    let active = all.iter().map(|(name, canonical)| {
        let effect = D::EFFECTS.iter().map(|e| e.description()).find(|d| d.name == *name).unwrap();
        let values = effect.parameters.iter().zip(*canonical).map(|(p, v)| p.kind.to_si(*v)).collect();
        effect.with(values)
    });
    Assembled::new(setup.unwrap().into(), &active.collect::<Vec<_>>())
}
