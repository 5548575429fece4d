//! `fem report`.

use std::sync::Arc;

use super::error::Error;
use super::serve::serve;
use super::story::{Depth, written};
use super::terminal::{notes, print};
use super::{args, watch};
use crate::output::files;
use crate::progress::Progress;

pub fn run(args: &args::Report) -> Result<(), Error> {
    if args.serve {
        return serve(args);
    }
    let Some(output) = &args.output else { return Ok(()) };
    files::refuse_reads(output, &[&args.models[..], &args.with].concat())?;
    let progress = Arc::new(Progress::default());
    let bar = watch::show(&progress);
    let made = written(args, Depth::Diagnosed, None, &progress);
    bar.finish();
    let made = made?;
    files::write(output, made.html.as_bytes(), &made.files)?;
    notes(&made.notes);
    print(&format!("written {}\n", output.display()))
}
