//! `fem plan`.

use super::compare::check_places;
use super::error::Error;
use super::{args, print};
use crate::diagnose::{plan, programme};
use crate::input::Problem;
use crate::measure::Measurements;
use crate::model::Model;
use crate::output;
use crate::units::{Knowledge, Quantity};

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
    let kind = design.kind;
    let noise = match &args.noise {
        Some(text) => Quantity::parse(text, &kind).map_err(|e| {
            Problem::new(format!("--noise {text}: {}", e.message)).help(format!("write --noise '1 {}'", kind.unit))
        })?,
        None => Quantity::known(kind.to_si(1.0)),
    };
    if noise.knowledge != Knowledge::Known || noise.value <= 0.0 {
        let problem = Problem::new("the noise is no positive quantity");
        return Err(Error::Request(problem.help(format!("write --noise '1 {}'", kind.unit))));
    }
    if design.uncertainty.is_none() && args.noise.is_none() {
        super::say!("note: a noise of 1 {} is assumed; say --noise or add a column u", kind.unit);
    }
    let plan = plan(&model, &design, noise.value)?;
    if args.json {
        return print(&format!("{:#}\n", output::plan::json(&model, &design.name, &plan, kind)));
    }
    print(&output::plan::text(&model, &design.name, &plan, kind))
}
