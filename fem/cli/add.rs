//! The command `fem add`.

use super::args;
use super::error::Error;
use super::say::say;
use super::terminal::print;
use crate::model::{Model, add_effect};
use crate::output::files;
use crate::units::Knowledge;

pub fn add(args: &args::Add) -> Result<(), Error> {
    let model = Model::load(&args.model)?;
    let reads = [args.model.clone()];
    files::refuse_reads(&args.output, &reads)?;
    let written = add_effect(&model, &args.effect, &args.settings)?;
    files::write(&args.output, written.text_at(&args.output).as_bytes(), &reads)?;
    let name = args.output.display();
    let prefix = format!("effects.{}.", args.effect);
    let free =
        written.parameters.iter().filter(|p| p.quantity.knowledge == Knowledge::Free && p.path.starts_with(&prefix));
    let unknown: Vec<&str> = free.map(|p| &p.path[prefix.len()..]).collect();
    if !unknown.is_empty() {
        say!("note: unknown (`?`) in {name}: {}; give a value, or let `fem fit` find it", unknown.join(", "));
    }
    let added = written.measurement.get(model.measurement.len()..).and_then(<[_]>::last);
    if let Some(term) = added.filter(|term| term.size.is_nan()) {
        say!("note: unknown (`?`) in {name}: {}; what compares or fits the model estimates it", term.effect.size.key());
    }
    print(&format!("written {name}: {} with {}\n", args.model.display(), args.effect))
}
