//! `fem budget`.

use std::sync::Arc;

use super::error::Error;
use super::{args, print, watch};
use crate::budget::{estimate, load};
use crate::output::budget;
use crate::progress::Progress;

pub fn run(args: &args::Budget) -> Result<(), Error> {
    let file = load(&args.file)?;
    let progress = Arc::new(Progress::default());
    let bar = watch::show(&progress);
    let estimate = estimate(&file, &progress)?;
    bar.finish();
    for warning in budget::warnings(&file, estimate.as_ref()) {
        super::say!("warning: {warning}");
    }
    if args.json {
        return print(&format!("{:#}\n", budget::json(&file, estimate.as_ref())));
    }
    print(&budget::text(&file, estimate.as_ref()))
}
