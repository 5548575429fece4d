//! Predicts a batch of shafts: what a run found, and what each effect changes. `cargo run --example predict`

use std::path::Path;

use fem::{Error, Model, Progress};

fn main() -> Result<(), Error> {
    let model = Model::load(Path::new("models/lathe.toml"))?;
    let run = model.run(&Progress::default())?;
    for figure in &run.report.figures {
        println!("{:<24} {}", figure.label, figure.lines.join("; "));
    }
    for contribution in &run.contributions {
        let kind = contribution.kind(model.process.observables());
        println!("{:<24} {:.3} {} rms", contribution.name, kind.from_si(contribution.rms), kind.unit);
    }
    Ok(())
}
