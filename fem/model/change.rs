//! Reads the change of an effect: `[effects.NAME.changed]`, the number after which its values are others, and those.

use crate::input::Reader;
use crate::process::{Active, CHANGED, Description, Process, change_of};

/// The coordinate along which an effect may change between two numbers.
///
/// # Errors
/// It cannot: the reason, as a sentence.
pub fn along(effect: &str, process: &dyn Process) -> Result<&'static str, String> {
    let Some(along) = process.in_order() else {
        return Err(format!("no coordinate of {} numbers what is made or measured one after another", process.name()));
    };
    match process.carried_over(effect) {
        Some(reason) => Err(format!("`{effect}` {reason}")),
        None => Ok(along),
    }
}

/// Reads the change of an effect from the effect's table, if it stands there.
pub fn read(effect: &Description, table: &Reader, process: &dyn Process) -> Option<Active> {
    let along = along(&effect.name, process);
    if along.is_err() && !table.has(CHANGED) {
        return None;
    }
    let about = "from a part, run or set-up on the effect has these values";
    let read = |own: &Reader| {
        let along = along.inspect_err(|reason| {
            own.accept_any();
            own.problem("", format!("the effect cannot change within a series: {reason}"), "remove this table");
        });
        let mut change = change_of(effect, along.ok()?, |_| true);
        let mut values = Vec::new();
        change.parameters.to_mut().retain(|p| {
            let field = own.quantity(p.name.clone(), p.kind, p.about).bounds(p.bounds);
            let value = if p.is_step { Some(field.required()) } else { field.optional() };
            values.extend(value);
            value.is_some()
        });
        if values.len() < 2 && !own.is_described() {
            let keys: Vec<&str> = effect.parameters.iter().map(|p| &*p.name).collect();
            let help = format!("give a new value for {}", keys.join(" or "));
            own.problem("", "the change of an effect changes nothing", help);
        }
        Some(change.with(values))
    };
    table.optional_table(CHANGED, about, read)?
}
