//! `fem diagnose`.

use super::compare::check_places;
use super::error::Error;
use super::{args, print};
use crate::diagnose::diagnose;
use crate::measure::Measurements;
use crate::model::Model;
use crate::output;

pub fn run(args: &args::Diagnose) -> Result<(), Error> {
    let model = Model::load(&args.model)?;
    let measurements = Measurements::load(&args.with, model.process)?;
    check_places(&model, &measurements, &args.with)?;
    let diagnosis = diagnose(&model, &measurements, args.max_effects)?;
    for note in &measurements.notes {
        super::say!("note: {note}");
    }
    if args.json {
        return print(&format!("{:#}\n", output::diagnosis::json(&model, &measurements, &diagnosis)));
    }
    print(&output::diagnosis::text())
}
