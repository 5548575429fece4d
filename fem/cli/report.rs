//! `fem report`.

use super::args;
use super::error::Error;
use super::serve::serve;
use super::terminal::{notes, print};
use super::watch::watched;
use crate::ask::Depth;
use crate::output::files::{self, Guard};

pub fn run(args: &args::Report) -> Result<(), Error> {
    if args.serve {
        return serve(args);
    }
    let Some(output) = &args.output else { return Ok(()) };
    // An earlier page may be replaced by a newer one.
    let force = args.force || files::is_sealed(output);
    let named = [&args.models[..], &args.with].concat();
    Guard { reads: &named, force }.check(output)?;
    let progress = args.limit.progress();
    let made = watched(&progress, || args.page(Depth::Diagnosed, None, &progress))?;
    // What has come there meanwhile is looked at anew.
    let force = args.force || files::is_sealed(output);
    files::write(output, files::sealed(&made.html).as_bytes(), Guard { reads: &made.files, force })?;
    notes(&made.notes);
    print(&format!("written {}\n", output.display()))
}
