//! `fem report`.

use std::io::Read;
use std::path::Path;

use super::args;
use super::error::Error;
use super::serve::serve;
use super::story::{Depth, written};
use super::terminal::{notes, print};
use super::watch::watched;
use crate::output::files::{self, Guard};

/// By which a page is known, within so many of its first bytes.
const OWN: &str = "<meta name=\"generator\" content=\"fem ";
const HEAD: u64 = 2000;

pub fn run(args: &args::Report) -> Result<(), Error> {
    if args.serve {
        return serve(args);
    }
    let Some(output) = &args.output else { return Ok(()) };
    let force = args.force || is_own(output);
    let named = [&args.models[..], &args.with].concat();
    Guard { reads: &named, force }.check(output)?;
    let progress = args.limit.progress();
    let made = watched(&progress, || written(args, Depth::Diagnosed, None, &progress))?;
    files::write(output, made.html.as_bytes(), Guard { reads: &made.files, force })?;
    notes(&made.notes);
    print(&format!("written {}\n", output.display()))
}

/// Whether a file is an earlier page, which a newer one may replace.
fn is_own(path: &Path) -> bool {
    let mut head = Vec::new();
    let read = std::fs::File::open(path).and_then(|file| file.take(HEAD).read_to_end(&mut head));
    read.is_ok() && String::from_utf8_lossy(&head).contains(OWN)
}
