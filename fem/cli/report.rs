//! `fem report`.

use std::path::Path;
use std::sync::Arc;

use super::args;
use super::error::Error;
use super::serve::serve;
use super::story::{Depth, written};
use super::terminal::{notes, print};
use super::watch::watched;
use crate::output::files::{self, Guard};
use crate::progress::Progress;

/// What every page says of the program that wrote it.
const OWN: &str = "<meta name=\"generator\" content=\"fem ";

pub fn run(args: &args::Report) -> Result<(), Error> {
    if args.serve {
        return serve(args);
    }
    let Some(output) = &args.output else { return Ok(()) };
    let force = args.force || is_own(output);
    Guard { reads: &[&args.models[..], &args.with].concat(), force }.check(output)?;
    let progress = Arc::new(Progress::default());
    let made = watched(&progress, || written(args, Depth::Diagnosed, None, &progress))?;
    files::write(output, made.html.as_bytes(), Guard { reads: &made.files, force })?;
    notes(&made.notes);
    print(&format!("written {}\n", output.display()))
}

/// Whether a file is an earlier page of this program, which the next one may replace.
fn is_own(path: &Path) -> bool {
    std::fs::read_to_string(path).is_ok_and(|text| text.contains(OWN))
}
