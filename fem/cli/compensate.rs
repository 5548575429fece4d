//! `fem compensate`.

use super::compare::check_places;
use super::error::Error;
use super::{args, print};
use crate::compensate::compensate;
use crate::input::Problem;
use crate::measure::Measurements;
use crate::model::Model;
use crate::output::compensation;

pub fn run(args: &args::Compensate) -> Result<(), Error> {
    let model = Model::load(&args.model)?;
    let Some(axis) = model.system.positioning() else {
        let problem = Problem::new(format!("{} models {}", model.source.name, model.process.about()));
        let help = "compensation is for axes that are tested by going to targets from both sides";
        return Err(Error::Request(problem.help(help)));
    };
    let measurements = Measurements::load(&args.with, model.process)?;
    check_places(&model, &measurements, &args.with)?;
    let found = compensate(&model, axis, &measurements)?;
    let mut written = Vec::new();
    if let Some(directory) = &args.output {
        for name in compensation::FILES {
            super::add::refuse_itself(&args.with, &directory.join(name))?;
        }
        written = compensation::write(&model, &measurements, &found, directory)?;
        if !written.iter().any(|f| f.ends_with(compensation::LINUXCNC)) {
            super::say!("note: no {}: it takes fewer targets than these", compensation::LINUXCNC);
        }
    }
    for note in &measurements.notes {
        super::say!("note: {note}");
    }
    if args.json {
        return print(&format!("{:#}\n", compensation::json(&model, &measurements, &found)));
    }
    let mut text = compensation::text(&model, &measurements, &found);
    if !written.is_empty() {
        let files: Vec<String> = written.iter().map(|f| format!("  {}", f.display())).collect();
        text.push_str(&format!("\nwritten\n{}\n", files.join("\n")));
    }
    print(&text)
}
