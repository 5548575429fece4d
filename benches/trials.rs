//! One trial of a fit in every process: its starting model with every effect that it admits, equipped anew
//! and asked for all rows of its programme. And what it costs to add five effects to a model one after the other: as
//! edits, and with the text of each model read again, as a chain of `fem add` does.
//!
//! A lathe of 100 members whose joint is tried: read, factored and condensed anew, with a sweep of 200 positions. A part as
//! a plane body of some 5000 unknowns, of which what presses it is tried, or its shape, for which it is factored anew.
//!
//! `cargo bench --bench trials`, or `-- contour` for one process, `-- five`, `-- structure` or `-- plate`.

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

/// The lathe on its bed with the bed in 94 members.
fn drawn(members: usize) -> String {
    let text = include_str!("../models/lathe-on-bed.toml").replace("positions = 101", "positions = 200");
    let (before, bed) = text.split_once("[structure.bed-b]").unwrap();
    let after = &bed[bed.find("[structure.bed-c]").unwrap()..];
    let end = |i: usize| match i {
        0 => "under-headstock".to_string(),
        i if i == members => "under-tailstock".to_string(),
        i => format!("bed{i}"),
    };
    let nodes: String = (1..members)
        .map(|i| format!("bed{i} = [\"{} mm\", \"-350 mm\"]\n", -200.0 + 920.0 * i as f64 / members as f64))
        .collect();
    let pieces: String = (0..members)
        .map(|i| {
            let (from, to) = (end(i), end(i + 1));
            let section = "width = \"350 mm\"\nheight = \"220 mm\"\nwall = \"18 mm\"\n";
            format!("[structure.bed-b{i}]\nbetween = [\"{from}\", \"{to}\"]\n{section}\n")
        })
        .collect();
    let names: String = (0..members).map(|i| format!("\"bed-b{i}\", ")).collect();
    let before = before.replace("[structure.nodes]\n", &format!("[structure.nodes]\n{nodes}"));
    let before =
        before.replace("\"bed-b\", ", &names).replace("to = \"0 mm\"\n", "to = \"0 mm\"\n[sweep]\npositions = 200\n");
    format!("{before}{pieces}{after}")
}

fn structure(criterion: &mut Criterion) {
    tried(criterion, "structure, 100 members, 200 positions", drawn(94));
}

fn plate(criterion: &mut Criterion) {
    let text = include_str!("../models/bracket.toml").replace("\"5 mm\"", "\"3.8 mm\"");
    let pressed = text.replace("\"3 kN\"", "\"3 +- 0.1 kN\"").replace("\"0.15\"", "\"0.15 +- 0.01\"");
    tried(criterion, "plate, other forces", pressed);
    tried(criterion, "plate, another shape", text.replace("\"25 mm\"", "\"25 +- 0.1 mm\""));
}

/// A trial of all values that are uncertain, as a search makes it.
fn tried(criterion: &mut Criterion, name: &str, model: String) {
    let model = Model::parse(Source::new("model.toml", model)).unwrap();
    let rows = model.system.programme();
    let values: Vec<f64> = model.parameters.iter().map(|own| own.quantity.value).collect();
    let mut moved = 0.0;
    criterion.bench_function(name, |b| {
        b.iter(|| {
            // What was asked for before may be known.
            moved += 1e-9;
            let trial: Vec<f64> = values.iter().map(|value| value * (1.0 + moved)).collect();
            model.forward_at(&trial).unwrap().observe(&rows).unwrap()
        })
    });
}

criterion_group!(benches, trials, additions, structure, plate);
criterion_main!(benches);
