//! `fem plan`.

use super::args;
use super::error::Error;
use super::terminal::{notes, page, print};
use super::watch::watched;
use crate::ask::{plan, read};
use crate::input::InputError;
use crate::measure::{Measurements, Reading};
use crate::model::{Data, Model};
use crate::output::PlanAnswer;
use crate::process::Process;

pub fn run(args: &args::Plan) -> Result<(), Error> {
    let (model, rows) = match args.with.is_empty() {
        true => (Model::load(&args.model)?, None),
        false => {
            let said = args.reading.said()?;
            let rows = |process: &dyn Process, kept: &Reading| {
                Measurements::load_all(&args.with, process, &said.over(kept), true)
            };
            let (model, rows) = read::<InputError>(&args.model, rows)?;
            (model, Some(rows))
        }
    };
    let design = match rows {
        Some(rows) => Data::of(&model, rows)?,
        None => Data::programme(&model)?,
    };
    let design = design.watched(args.limit.progress());
    let (plan, note) = watched(&design.progress, || plan(&design, &args.noise))?;
    notes(note.as_slice());
    print(&page(&PlanAnswer(&design, &plan), args.json))
}
