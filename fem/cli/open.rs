//! `fem open`.

use super::args;
use super::error::Error;
use super::say::say;
use super::serve::unserved;
use crate::input::Problem;
use crate::workbench::{Session, serve};

pub fn run(args: &args::Open) -> Result<(), Error> {
    let session = Session::open(&args.path).map_err(|refusal| Problem::new(refusal.text()))?;
    let told = |address: &str| say!("{address} is the workbench, for this computer alone; Ctrl-C ends it");
    serve(session, args.port, told).map_err(|error| unserved(args.port, &error))
}
