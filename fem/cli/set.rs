//! `fem set`.

use super::args;
use super::error::Error;
use super::terminal::print;
use crate::ask::revised;
use crate::model::Model;
use crate::output::files::{self, Guard};

pub fn run(args: &args::Set) -> Result<(), Error> {
    let model = Model::load(&args.model)?;
    let reads = [args.model.clone()];
    let guard = Guard { reads: &reads, force: args.force };
    guard.check(&args.output)?;
    let written = revised(&model, &args.values, &args.without)?;
    files::write(&args.output, written.text_at(&args.output).as_bytes(), guard)?;
    let values = args.values.iter().map(|set| format!("with {} = {}", set.key, set.value));
    let changes: Vec<String> = values.chain(args.without.iter().map(|name| format!("without {name}"))).collect();
    print(&format!("written {}: {} {}\n", args.output.display(), args.model.display(), changes.join(", ")))
}
