//! `fem report`.

use super::args;
use super::error::Error;
use super::serve::serve;
use super::terminal::{notes, print};
use super::watch::watched;
use crate::ask::Depth;
use crate::output::files;

pub fn run(args: &args::Report) -> Result<(), Error> {
    if args.serve {
        return serve(args);
    }
    let Some(output) = &args.output else { return Ok(()) };
    let named = [&args.models[..], &args.with].concat();
    files::page_guard(output, &named, args.force).check(output)?;
    let progress = args.limit.progress();
    let made = watched(&progress, || args.page(Depth::Diagnosed, None, &progress))?;
    // What has come there meanwhile is looked at anew.
    files::write_page(output, &made.html, &made.files, args.force)?;
    notes(&made.notes);
    print(&format!("written {}\n", output.display()))
}
