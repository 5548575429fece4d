//! `fem plan`.

use super::args;
use super::error::Error;
use super::terminal::{notes, page, print};
use super::watch::watched;
use crate::ask::plan;
use crate::measure::Measurements;
use crate::model::{Data, Model};
use crate::output::PlanAnswer;

pub fn run(args: &args::Plan) -> Result<(), Error> {
    let model = Model::load(&args.model)?;
    let design = match args.with.is_empty() {
        false => Data::of(&model, Measurements::load_all(&args.with, &*model.process, &args.reading.said()?, true)?)?,
        true => Data::programme(&model)?,
    };
    let design = design.watched(args.limit.progress());
    let (plan, note) = watched(&design.progress, || plan(&design, &args.noise))?;
    notes(note.as_slice());
    print(&page(&PlanAnswer(&design, &plan), args.json))
}
