//! The tool's sweep along a shaft: as many elements, all of different length and section, as positions.
//!
//! `cargo bench --bench sweep`. What a sweep must at least do: about 40 floating-point operations and 80
//! bytes per cut and direction, two directions, one division per position.

#![allow(clippy::unwrap_used, clippy::expect_used)]
#![allow(missing_docs)]

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use fem::element::{BeamPiece, Round};
use fem::joint::{Contact, Joint, Rubbing};
use fem::process::{Assembled, Definition};
use fem::processes::turning::{Turning, condense, deflections};
use fem::progress::Progress;
use fem::solve::{Hold, Shaft, solve_joints};

/// 0.6 m of steel in `n` pieces of Ø40 to Ø50 mm.
fn shaft(n: usize, hold: Hold) -> Shaft {
    let piece = |i: usize| {
        let section = Round { diameter: 0.04 + 0.01 * ((i as f64) * 0.7).sin().powi(2), bore: 0.0 };
        BeamPiece {
            length: 0.6 / n as f64,
            flexural_rigidity: 210e9 * section.inertia(),
            shear_rigidity: section.shear_coefficient(0.3) * 80.77e9 * section.area(),
        }
    };
    Shaft { pieces: (0..n).map(piece).collect(), hold, tailstock: true, rests: Vec::new() }
}

fn positions(n: usize) -> Vec<f64> {
    (1..=n).map(|i| 0.6 * i as f64 / n as f64).collect()
}

fn joints(contact: bool) -> [Joint; 2] {
    let contacts = if contact { vec![Contact { coefficient: 2e-7, exponent: 0.5 }] } else { Vec::new() };
    [6e7, 4e7].map(|k: f64| Joint { spring_compliance: 1.0 / k, contacts: contacts.clone() })
}

/// Deflections under 500 N at every position.
fn sweep(shaft: &Shaft, joints: &[Joint; 2], at: &[f64]) -> f64 {
    let condensed = shaft.condense(at).expect("the shaft is held");
    let joints = &joints.each_ref().map(Rubbing::free);
    let mut sum = 0.0;
    for i in 0..at.len() {
        let g = condensed.influence[i];
        let y = solve_joints(joints, g, &condensed.constraint, (500.0, [0.0; 2]), None)
            .expect("the joints find an equilibrium")
            .displacements;
        sum += condensed.compliance[i] * 500.0 + g[0] * y[0] + g[1] * y[1];
    }
    sum
}

/// The whole path of `fem run`: a model of 1000 segments with contact joints and force feedback, in both
/// holdings.
fn lathe(held: &str) -> Assembled<Turning> {
    let segments: String =
        (0..1000).map(|i| format!("{{ length = \"0.6 mm\", diameter = \"{} mm\" }},", 40 + i % 11)).collect();
    let text = format!(
        r#"process = "turning"
        workpiece = {{ material = "steel", segments = [{segments}] }}
        workholding = {{ type = "{held}" }}
        cut = {{ depth = "0.5 mm", feed = "0.2 mm/rev", spindle_speed = "600 rpm", radial_force = "500 N" }}
        effects.headstock-contact = {{ c = "0.2 um/N^n", n = 0.5 }}
        effects.tailstock-contact = {{ c = "0.2 um/N^n", n = 0.5 }}
        effects.carriage-contact = {{ c = "0.2 um/N^n", n = 0.5 }}
        effects.force-feedback = {{ exponent = 0.75 }}"#
    );
    let model = fem::model::Model::parse(fem::input::Source::new("bench.toml", text)).expect("the model is right");
    let document = toml_edit::Document::parse(&*model.source.text).expect("the model is TOML");
    let (setup, ..) = fem::input::Reader::document(document.as_table(), <Turning as Definition>::read);
    Assembled::new(setup.expect("the model is right").into(), &model.effects)
}

fn bench(c: &mut Criterion) {
    let mut linear = c.benchmark_group("linear: elements x positions");
    for n in [1000usize, 10_000, 100_000] {
        let (shaft, joints, at) = (shaft(n, Hold::Free), joints(false), positions(n));
        linear.throughput(Throughput::Elements(n as u64));
        linear.bench_function(BenchmarkId::from_parameter(n), |b| b.iter(|| sweep(&shaft, &joints, &at)));
    }
    linear.finish();
    let mut nonlinear = c.benchmark_group("1000 x 1000, nonlinear");
    for (name, hold) in [("contacts, centres", Hold::Free), ("contacts, chuck and centre", Hold::Compliance(0.0))] {
        let (shaft, joints, at) = (shaft(1000, hold), joints(true), positions(1000));
        nonlinear.bench_function(name, |b| b.iter(|| sweep(&shaft, &joints, &at)));
    }
    for held in ["centres", "chuck-and-centre"] {
        let (lathe, at) = (lathe(held), positions(1000));
        nonlinear.bench_function(format!("contacts and force feedback, {held}"), |b| {
            b.iter(|| {
                let shaft = condense(lathe.machine(), &at).expect("the shaft is held");
                let deflections = deflections(lathe.machine(), &shaft, &at, &Progress::default());
                deflections.expect("there is an equilibrium").len()
            });
        });
    }
    nonlinear.finish();
}

criterion_group!(benches, bench);
criterion_main!(benches);
