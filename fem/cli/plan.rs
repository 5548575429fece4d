//! `fem plan`.

use super::compare::check_places;
use super::error::Error;
use super::{args, print};
use crate::diagnose::{plan, programme};
use crate::input::Problem;
use crate::measure::Measurements;
use crate::model::Model;
use crate::output;
use crate::process::{Observable, Process};
use crate::units::{Kind, Knowledge, Quantity};

pub fn run(args: &args::Plan) -> Result<(), Error> {
    let model = Model::load(&args.model)?;
    let design = match &args.with {
        Some(path) => {
            let design = Measurements::load_design(path, model.process)?;
            check_places(&model, &design, path)?;
            design
        }
        None => programme(&model),
    };
    let sigma = noise(model.process, &args.noise)?;
    if design.uncertainty.is_none() {
        let assumed = design.seen.iter().filter(|s| sigma[s.position].is_none()).map(|s| format!("1 {}", s.kind.unit));
        let assumed: Vec<String> = assumed.collect();
        if !assumed.is_empty() {
            super::say!("note: a noise of {} is assumed; say --noise or add a column u", assumed.join(" and "));
        }
    }
    let usual = |(o, sigma): (&Observable, &Option<f64>)| sigma.unwrap_or_else(|| o.error_kind().to_si(1.0));
    let sigma: Vec<f64> = model.process.observables().iter().zip(&sigma).map(usual).collect();
    let plan = plan(&model, &design, &sigma)?;
    if args.json {
        return print(&format!("{:#}\n", output::plan::json(&model, &design, &plan)));
    }
    print(&output::plan::text(&model, &design, &plan))
}

/// The noise of each observable, SI, as far as it is said: each size stands for the observables that are told in its unit.
fn noise(process: &dyn Process, said: &[String]) -> Result<Vec<Option<f64>>, Error> {
    let kinds: Vec<Kind> = process.observables().iter().map(Observable::error_kind).collect();
    let mut all = vec![None; kinds.len()];
    for text in said {
        let wrong = |message: String| {
            let units: Vec<String> = kinds.iter().map(|k| format!("'1 {}'", k.unit)).collect();
            Error::Request(Problem::new(message).help(format!("write --noise {}", units.join(" or "))))
        };
        let parsed: Vec<_> = kinds.iter().map(|k| Quantity::parse(text, k)).collect();
        if let Some(Err(error)) = parsed.iter().find(|_| parsed.iter().all(Result::is_err)) {
            return Err(wrong(format!("--noise {text}: {}", error.message)));
        }
        for (sigma, quantity) in all.iter_mut().zip(parsed.into_iter().map(Result::ok)) {
            let Some(quantity) = quantity else { continue };
            if quantity.knowledge != Knowledge::Known || quantity.value <= 0.0 {
                return Err(wrong("the noise is no positive quantity".into()));
            }
            *sigma = Some(quantity.value);
        }
    }
    Ok(all)
}
