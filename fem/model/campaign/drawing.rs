//! What several tests draw of their machine: what has one name in two of them is one thing.

use super::effects::agreed_among;
use crate::input::{Parameter, Problem};
use crate::model::Model;
use crate::model::machine::{PORTS, STRUCTURE};
use crate::units::{Knowledge, Quantity};

/// Whether a path is that of a quantity of the drawing, and not of what stands on it in one test.
fn is_drawn(path: &str) -> bool {
    let within = path.strip_prefix(STRUCTURE).and_then(|rest| rest.strip_prefix('.'));
    within.is_some_and(|rest| rest.split('.').next() != Some(PORTS))
}

/// The quantities of a model's drawing by their paths, as all tests together know them.
///
/// # Errors
/// Two of them know one, and differently.
pub fn agreed_of_drawing<'m>(model: &'m Model, models: &[Model]) -> Result<Vec<(&'m str, Quantity)>, Problem> {
    let drawn = model.quantities.iter().filter(|quantity| is_drawn(&quantity.path));
    drawn.map(|quantity| Ok((&*quantity.path, agreed_among(models.iter(), quantity)?))).collect()
}

/// The quantities of their drawings that all tests know which have them: of others the tests say together what they are.
pub fn known_of_drawings(models: &[Model]) -> Vec<Parameter> {
    let is_known = |quantity: &Parameter| quantity.quantity.knowledge == Knowledge::Known;
    let mut known: Vec<Parameter> = Vec::new();
    for quantity in models.iter().flat_map(|model| model.quantities.iter()) {
        let mut said = models.iter().filter_map(|model| model.quantity(&quantity.path));
        if is_drawn(&quantity.path) && known.iter().all(|own| own.path != quantity.path) && said.all(is_known) {
            known.push(Parameter { span: None, ..quantity.clone() });
        }
    }
    known
}
