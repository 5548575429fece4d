//! `fem fit`.

use super::compare::check_places;
use super::error::Error;
use super::{args, print};
use crate::fit::{fit, fitted_before, fitted_text};
use crate::input::{Problem, Source};
use crate::measure::Measurements;
use crate::model::Model;
use crate::output::{self, files};

pub fn run(args: &args::Fit) -> Result<(), Error> {
    let model = Model::load(&args.model)?;
    if let Some(new) = &args.add_to {
        super::add::refuse_itself(&args.model, new)?;
        super::add::refuse_itself(&args.with, new)?;
    }
    if model.parameters.is_empty() {
        let problem = Problem::new(format!("{} has nothing to fit", model.source.name));
        return Err(Error::Request(problem.help("mark what is not exactly known: \"60 +- 15 N/um\" or \"? N/um\"")));
    }
    let mut measurements = Measurements::load(&args.with, model.process)?;
    check_places(&model, &measurements, &args.with)?;
    measurements.notes.extend(fitted_before(&model, &measurements));
    let fit = fit(&model, &measurements)?;
    if let Some(new) = &args.add_to {
        let text = fitted_text(&model, &measurements, &fit);
        // A fitted value outside its bounds would make a file that cannot be read: better none.
        let fitted = Model::parse(Source::new(model.source.name.clone(), text))?;
        files::write(new, fitted.text_at(new).as_bytes())?;
        super::say!("written {}", new.display());
        for open in fit.estimates.iter().filter(|e| !e.is_closed()) {
            super::say!("note: {} stays as it was: the data leave its interval open", open.parameter.path);
        }
    }
    for note in &measurements.notes {
        super::say!("note: {note}");
    }
    if args.json {
        return print(&format!("{:#}\n", output::fit::json(&model, &measurements, &fit)));
    }
    print(&output::fit::text(&model, &measurements, &fit))
}
