//! `fem diagnose`.

use std::sync::Arc;

use super::compare::check_places;
use super::error::Error;
use super::{args, print, watch};
use crate::diagnose::{Diagnosis, diagnose};
use crate::fit::{fitted_before, fitted_text};
use crate::input::Source;
use crate::measure::Measurements;
use crate::model::{Model, add_effect};
use crate::output::{self, files};
use crate::progress::Progress;

pub fn run(args: &args::Diagnose) -> Result<(), Error> {
    let model = Model::load(&args.model)?;
    if let Some(new) = &args.add_to {
        super::add::refuse_itself(&args.model, new)?;
        super::add::refuse_itself(&args.with, new)?;
    }
    let mut measurements = Measurements::load(&args.with, model.process)?;
    check_places(&model, &measurements, &args.with)?;
    measurements.notes.extend(fitted_before(&model, &measurements));
    let progress = Arc::new(Progress::default());
    let bar = watch::show(&progress);
    let diagnosis = diagnose(&model, &measurements, usize::from(args.max_effects), &progress);
    bar.finish();
    let diagnosis = diagnosis?;
    if diagnosis.rows < measurements.len() {
        super::say!("note: {} of {} rows were used, evenly chosen", diagnosis.rows, measurements.len());
    }
    if let Some(directory) = &args.output {
        let json = output::diagnosis::json(&model, &measurements, &diagnosis);
        files::write(&directory.join("diagnosis.json"), format!("{json:#}\n").as_bytes())?;
    }
    if let Some(new) = &args.add_to {
        let better = completed(&model, &measurements, &diagnosis)?;
        files::write(new, better.text_at(new).as_bytes())?;
        super::say!("written {}", new.display());
        let own = diagnosis.fit.estimates.iter().take(model.parameters.len());
        for open in own.filter(|e| !e.is_closed()) {
            super::say!("note: {} stays as it was: the data leave its interval open", open.parameter.path);
        }
    }
    for note in &measurements.notes {
        super::say!("note: {note}");
    }
    if args.json {
        return print(&format!("{:#}\n", output::diagnosis::json(&model, &measurements, &diagnosis)));
    }
    print(&output::diagnosis::text(&model, &measurements, &diagnosis))
}

/// The model with the missing effects and every fitted value.
fn completed(model: &Model, measurements: &Measurements, diagnosis: &Diagnosis) -> Result<Model, Error> {
    let text = fitted_text(model, measurements, &diagnosis.fit);
    let mut better = Model::parse(Source::new(model.source.name.to_string(), text))?;
    for missing in &diagnosis.missing {
        better = add_effect(&better, missing.effect.name, &output::diagnosis::settings(missing, &diagnosis.fit))?;
    }
    Ok(better)
}
