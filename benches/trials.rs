//! One trial of a fit in every process: its starting model with every effect that it admits, equipped anew
//! and asked for all rows of its programme. And what it costs to add five effects to a model one after the other: as
//! edits, and with the text of each model read again, as a chain of `fem add` does.
//!
//! `cargo bench --bench trials`, or `-- contour` for one process, or `-- five`.

#![allow(clippy::unwrap_used, clippy::expect_used)]
#![allow(missing_docs)]

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use fem::input::{Name, Source};
use fem::model::{Model, add_effect};
use fem::process::Active;
use fem::processes::ALL;

fn trials(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("trial");
    for process in ALL {
        let model = Model::parse(Source::new("model.toml", process.starting_model())).unwrap();
        let admitted = process.effects().into_iter().filter(|e| model.system.admits(&e.name).is_ok());
        let effects: Vec<Active> = admitted.map(|e| e.typical()).collect();
        let rows = model.system.programme();
        group.throughput(Throughput::Elements(rows.len() as u64));
        let mut trial = effects.clone();
        let mut moved = 0.0;
        group.bench_function(process.name(), |b| {
            b.iter(|| {
                // What was asked for before may be known.
                moved += 1e-9;
                for (new, old) in trial.iter_mut().zip(&effects) {
                    new.values.iter_mut().zip(&old.values).for_each(|(new, old)| *new = old * (1.0 + moved));
                }
                model.system.with_effects(&trial).observe(&rows).unwrap()
            })
        });
    }
    group.finish();
}

fn additions(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("five effects");
    for process in ALL {
        let model = Model::parse(Source::new("model.toml", process.starting_model())).unwrap();
        let names = process.effects().into_iter().map(|effect| effect.name);
        let five: Vec<_> = names.filter(|name| add_effect(&model, name, &[]).is_ok()).take(5).collect();
        let add = |model: Model, name: &Name| add_effect(&model, name, &[]).unwrap_or(model);
        group.bench_function(format!("{}, edited", process.name()), |b| {
            b.iter(|| five.iter().fold(model.clone(), add));
        });
        group.bench_function(format!("{}, read again", process.name()), |b| {
            let read = |model: Model| Model::parse(Source::new("model.toml", model.text())).unwrap();
            b.iter(|| five.iter().fold(read(model.clone()), |model, name| read(add(model, name))));
        });
    }
    group.finish();
}

criterion_group!(benches, trials, additions);
criterion_main!(benches);
