//! Effects that changed within a series: which of them are sought.

use crate::model::{Data, Model};
use crate::process::{Description, change_of, is_size, name_of_change};

/// The order in which changes are sought. From one run or set-up to the next the instrument is set anew as well, and its
/// zeros look like changes of anything: there a change is believed where somebody writes it.
const SOUGHT: &str = "part";

/// The changes that are sought: of every effect that the model has or lacks and that carries nothing over, where the
/// rows are numbered in an order.
pub fn changes(data: &Data, absent: &[Description]) -> Vec<Description> {
    let process = &*data.model.process;
    let Some(along) = process.in_order().filter(|along| *along == SOUGHT) else { return Vec::new() };
    let column = process.coordinates().iter().position(|c| c.name == along);
    let is_one = |column: usize| data.rows.columns[column].iter().all(|number| *number == data.rows.columns[column][0]);
    if data.is_empty() || column.is_none_or(is_one) {
        return Vec::new();
    }
    let present = data.model.effects.iter().map(|effect| &effect.description);
    let is_stated = |d: &Description| present.clone().any(|own| own.name == name_of_change(&d.name));
    let may_change = |d: &&Description| {
        d.changes.is_none()
            && process.carried_over(&d.name).is_none()
            && d.parameters.iter().any(is_size)
            && !is_stated(d)
    };
    present.clone().chain(absent).filter(may_change).map(|d| change_of(d, along, is_size)).collect()
}

/// Whether what an effect changes is there: in the model, or among the `members` of a set. What is no change needs
/// nothing.
pub fn has_its_effect<'d>(
    effect: &Description,
    model: &Model,
    mut members: impl Iterator<Item = &'d Description>,
) -> bool {
    let Some(changes) = &effect.changes else { return true };
    let is_own = |own: &Description| own.name == *changes && own.table == effect.table;
    model.effects.iter().any(|active| is_own(&active.description)) || members.any(is_own)
}
