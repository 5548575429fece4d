//! `fem add`.

use super::args;
use super::error::Error;
use super::print;
use crate::input::{Problem, Source};
use crate::model::{Model, add_effect};
use crate::output::files;
use crate::units::Knowledge;

pub fn add(args: &args::Add) -> Result<(), Error> {
    let model = Model::load(&args.model)?;
    if same_file(&args.model, &args.output) {
        let problem = Problem::new(format!("{} is the model itself", args.output.display()));
        return Err(Error::Request(problem.help("name another file with -o; the model is never overwritten")));
    }
    let text = add_effect(&model, &args.effect, &args.settings)?;
    files::write(&args.output, text.as_bytes())?;
    let name = args.output.display();
    let written = Model::parse(Source::new(name.to_string(), text))?;
    let prefix = format!("effects.{}.", args.effect);
    let free =
        written.parameters.iter().filter(|p| p.quantity.knowledge == Knowledge::Free && p.path.starts_with(&prefix));
    let unknown: Vec<&str> = free.map(|p| &p.path[prefix.len()..]).collect();
    if !unknown.is_empty() {
        super::say!("note: unknown (`?`) in {name}: {}; give a value, or let `fem fit` find it", unknown.join(", "));
    }
    print(&format!("written {name}: {} with {}\n", args.model.display(), args.effect))
}

/// Whether two paths lead to the same file, which for a file that does not exist yet they do not.
pub fn same_file(a: &std::path::Path, b: &std::path::Path) -> bool {
    match (a.canonicalize(), b.canonicalize()) {
        (Ok(a), Ok(b)) => a == b,
        _ => false,
    }
}
