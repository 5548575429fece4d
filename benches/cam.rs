//! Time of a cam: reading with its programme, a prediction all around, a trial of a fit, and a whole run.

#![allow(clippy::unwrap_used)]

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use fem::input::Source;
use fem::model::Model;
use fem::process::Rows;
use fem::progress::Progress;

/// The cam of seed 003 in so many blocks, or with another choice.
fn text(program: &str) -> String {
    let text = include_str!("../models/cam.toml").replace("step = \"0.5 mm\"", program);
    [", blocks = 1 }", ", blocks = 4 }"].iter().fold(text, |text, own| text.replace(own, " }"))
}

fn model(program: &str) -> Model {
    Model::parse(Source::new("cam.toml", text(program))).unwrap()
}

const EFFECTS: &str = r#"
    [effects]
    wheel-wear = { loss = "20 um" }
    servo-lag = { time = "1 ms" }
    infeed-backlash = { gap = "10 um" }
    centre-height = { height = "100 um" }
    grinding-deflection = { stiffness = "50 N/um" }
"#;

fn cam(c: &mut Criterion) {
    for blocks in [360, 3600] {
        let program = format!("blocks = {blocks}");
        c.bench_function(&format!("{blocks} blocks, read"), |b| b.iter(|| black_box(model(&program))));
        let model = model(&program);
        c.bench_function(&format!("{blocks} blocks, predict"), |b| {
            b.iter(|| black_box(model.forward().predict(&Progress::default()).unwrap()))
        });
        let all = Model::parse(Source::new("cam.toml", format!("{}{EFFECTS}", text(&program)))).unwrap();
        let rows = measured(300);
        c.bench_function(&format!("{blocks} blocks, a trial of 300 rows with all effects"), |b| {
            b.iter(|| black_box(all.forward().observe(&rows).unwrap()))
        });
        c.bench_function(&format!("{blocks} blocks, every block reported"), |b| {
            b.iter(|| {
                let forward = model.forward();
                let prediction = forward.predict(&Progress::default()).unwrap();
                black_box(forward.report(prediction).unwrap())
            })
        });
    }
    c.bench_function("fewest blocks within 1 um, read", |b| b.iter(|| black_box(model("tolerance = \"1 um\""))));
}

/// Rows evenly around, as the model runs.
fn measured(count: usize) -> Rows {
    let angles = (0..count).map(|i| std::f64::consts::TAU * i as f64 / count as f64).collect();
    Rows::new([angles, vec![f64::NAN; count], vec![0.0; count]], vec![0; count])
}

criterion_group! { name = benches; config = Criterion::default().sample_size(20); targets = cam }
criterion_main!(benches);
