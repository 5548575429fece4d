//! `fem add`.

use std::path::Path;

use super::args;
use super::error::Error;
use super::print;
use crate::input::Problem;
use crate::model::{Model, add_effect};
use crate::output::files;
use crate::units::Knowledge;

pub fn add(args: &args::Add) -> Result<(), Error> {
    let model = Model::load(&args.model)?;
    refuse_itself(&args.model, &args.output)?;
    let written = add_effect(&model, &args.effect, &args.settings)?;
    files::write(&args.output, written.text_at(&args.output).as_bytes())?;
    let name = args.output.display();
    let prefix = format!("effects.{}.", args.effect);
    let free =
        written.parameters.iter().filter(|p| p.quantity.knowledge == Knowledge::Free && p.path.starts_with(&prefix));
    let unknown: Vec<&str> = free.map(|p| &p.path[prefix.len()..]).collect();
    if !unknown.is_empty() {
        super::say!("note: unknown (`?`) in {name}: {}; give a value, or let `fem fit` find it", unknown.join(", "));
    }
    print(&format!("written {name}: {} with {}\n", args.model.display(), args.effect))
}

/// Refuses to write over a file that is read, by whatever path.
pub fn refuse_itself(read: &Path, new: &Path) -> Result<(), Problem> {
    match (read.canonicalize(), new.canonicalize()) {
        (Ok(a), Ok(b)) if a == b => {
            let problem = Problem::new(format!("{} is itself what is read", new.display()));
            Err(problem.help("name another file; models and measurements are never overwritten"))
        }
        _ => Ok(()),
    }
}
