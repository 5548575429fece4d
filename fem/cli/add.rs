//! The command `fem add`.

use super::args;
use super::error::Error;
use super::say::say;
use super::terminal::{notes, print};
use crate::ask::{read, usual_said, with_usual};
use crate::measure::Measurements;
use crate::model::{Model, add_effect};
use crate::output::files::{self, Guard};
use crate::units::Knowledge;

pub fn add(args: &args::Add) -> Result<(), Error> {
    let model = model(args)?;
    let reads: Vec<_> = std::iter::once(&args.model).chain(&args.with).cloned().collect();
    let guard = Guard { reads: &reads, force: args.force };
    guard.check(&args.output)?;
    let written = with_usual(add_effect(&model, &args.effect, &args.settings)?)?;
    files::write(&args.output, written.text_at(&args.output).as_bytes(), guard)?;
    let name = args.output.display();
    let prefixes = [format!("effects.{}.", args.effect), format!("measurement.{}.", args.effect)];
    let own = |path: &str| prefixes.iter().find_map(|prefix| path.strip_prefix(prefix.as_str())).map(str::to_string);
    let free = written.parameters.iter().filter(|p| p.quantity.knowledge == Knowledge::Free);
    let unknown: Vec<String> = free.filter_map(|p| own(&p.path)).collect();
    if !unknown.is_empty() {
        say!("note: unknown (`?`) in {name}: {}; give a value, or let `fem fit` find it", unknown.join(", "));
    }
    notes(&usual_said(&written, &model));
    let added = written.measurement.get(model.measurement.len()..).unwrap_or_default();
    let sizes: Vec<&str> = added.iter().filter(|t| written.is_unknown(t)).map(|t| t.effect.size.key()).collect();
    if !sizes.is_empty() {
        say!("note: unknown (`?`) in {name}: {}; what compares or fits the model estimates it", sizes.join(", "));
    }
    print(&format!("written {name}: {} with {}\n", args.model.display(), args.effect))
}

/// The model, whose formulas may name what the measurements record beside the columns of the process.
fn model(args: &args::Add) -> Result<Model, Error> {
    if args.with.is_empty() {
        return Ok(Model::load(&args.model)?);
    }
    let said = args.reading.said()?;
    let (model, _) = read(&args.model, |process, kept| {
        Measurements::load_all(&args.with, process, &said.over(kept), false).map_err(Error::from)
    })?;
    Ok(model)
}
