//! Compares a model with measurements, and asks which effect it lacks. `cargo run --release --example
//! diagnose`

use std::path::Path;

use fem::{Data, Error, Measurements, Model, Progress, compare, diagnose};

fn main() -> Result<(), Error> {
    let model = Model::load(Path::new("models/story/rigid.toml"))?;
    let measurements = Measurements::load(Path::new("models/story/measured.csv"), &*model.process)?;
    let data = Data::of(&model, measurements)?;
    let comparison = compare(&data)?;
    println!("{}: rms {:.3} um, adequate: {}", comparison.model, 1e6 * comparison.rms, comparison.adequate());
    // Causes are sought one by one and in sets of up to three.
    let diagnosis = diagnose(&data, 3, &Progress::default())?;
    println!("{}", diagnosis.verdict.word());
    for missing in &diagnosis.missing {
        println!("{}: with it {:.3} um are left", missing.effect.name, 1e6 * missing.goodness.rms);
        for estimate in &missing.estimates {
            let kind = estimate.parameter.kind;
            println!("  {} = {:.4} {}", estimate.parameter.path, kind.from_si(estimate.value), kind.unit);
        }
        for other in &missing.indistinguishable_from {
            println!("  or {}: these data cannot tell", other.name);
        }
    }
    Ok(())
}
