//! Large plane jobs, timed stretch by stretch, with the peak of memory: a ring pressed by three jaws, the
//! orders of elimination, and a heated section.
//!
//! `cargo bench --bench plane -- ring|orders [AROUND ACROSS]` `-- chuck`, `-- rod`, or `-- heat` and
//! `-- triangles [COLUMNS ROWS]`. Sizes default to a ring of 500 000 unknowns and a section of 100 000.

#![allow(missing_docs)]

use std::error::Error;
use std::f64::consts::TAU;
use std::sync::Arc;
use std::time::Instant;

use rayon::prelude::*;

use fem::element::plane::{Capacity, Conduction, Elasticity, PlaneState, Quad4, Quad8, Thickness};
use fem::input::Source;
use fem::mesh::{Grading, Mesh, RectangleMesh, RingMesh};
use fem::model::Model;
use fem::process::Values;
use fem::solve::conduction::{Condition, History, Power, Run, Scheme, ThermalSystem};
use fem::solve::elastic::{ElasticSystem, Loads};
use fem::solve::ring::{Bore, ContactArc, add_jaws};
use fem::solve::sparse::{Analysis, Freedoms, Graph, Matrix, Order, Pattern, Solver};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|a| a != "--bench").collect();
    let size = |index: usize, default: usize| arguments.get(index).map_or(Ok(default), |size| size.parse());
    match arguments.first().map(String::as_str) {
        Some("orders") => orders(&ring([size(1, 1440)?, size(2, 57)?])?),
        Some("chuck") => chuck(),
        Some("rod") => rod(),
        Some("heat") => heat([size(1, 450)?, size(2, 225)?]),
        Some("triangles") => triangles([size(1, 450)?, size(2, 225)?]),
        _ => whole_ring([size(1, 1440)?, size(2, 57)?]),
    }
}

/// Prints what has passed since the last call, s.
struct Clock(Instant);

impl Clock {
    fn lap(&mut self, what: &str) {
        print!("{what} {:.3} ", self.0.elapsed().as_secs_f64());
        self.0 = Instant::now();
    }
}

/// Peak memory of the process so far, MB.
fn peak() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|line| line.starts_with("VmHWM"));
    line.and_then(|line| line.split_whitespace().nth(1)?.parse::<u64>().ok()).unwrap_or(0) / 1024
}

fn ring([circumferential, radial]: [usize; 2]) -> Result<Mesh, Box<dyn Error>> {
    let grading = Grading::uniform();
    let ring = RingMesh { outer_radius: 0.05, inner_radius: 0.04, circumferential, radial, element: &Quad8, grading };
    Ok(ring.build()?)
}

fn steel() -> Result<Elasticity, Box<dyn Error>> {
    Ok(Elasticity::new(PlaneState::Stress, 210e9, 0.3, 11.5e-6, 0.02)?)
}

fn whole_ring(cells: [usize; 2]) -> Result<(), Box<dyn Error>> {
    let start = Instant::now();
    let mut clock = Clock(start);
    let mesh = ring(cells)?;
    clock.lap("mesh");
    let system = ElasticSystem::free(&mesh, steel()?)?;
    clock.lap("assembled and factored");
    let jaw = |jaw: u32| ContactArc { angle: f64::from(jaw) * TAU / 3.0, width: TAU / 36.0, force: 2000.0 };
    let mut loads = Loads::none(&mesh);
    add_jaws(&mut loads, &mesh, &[jaw(0), jaw(1), jaw(2)])?;
    let solution = system.solve(&loads)?;
    clock.lap("solved");
    let bore = Bore::new(&mesh)?;
    let shape = bore.shape(&solution.nodes);
    let at = |degrees: f64| 1e6 * shape.radial(degrees.to_radians());
    println!("total {:.3} s, peak {} MB, {} unknowns", start.elapsed().as_secs_f64(), peak(), 2 * mesh.nodes().len());
    println!("matrix and factor {:?} MB, {:?}", system.bytes().map(|bytes| bytes >> 20), solution.accuracy);
    println!("u_r {:.6} {:.6} {:.6} um (exact -10.025369 -0.532458 6.892577)", at(0.0), at(30.0), at(60.0));
    Ok(())
}

/// What a search pays for each trial of a chucked ring: 108 rows of three set-ups, with every effect.
fn chuck() -> Result<(), Box<dyn Error>> {
    let process = fem::processes::ALL.iter().find(|p| p.name() == "ring").ok_or("no such process")?;
    let model = Model::parse(Source::new("ring.toml", process.starting_model()))?;
    let angles: Vec<f64> = (0..108).map(|i| f64::from(i % 36) * TAU / 36.0).collect();
    let mut rows = model.system.programme();
    let names: Vec<&str> = process.coordinates().iter().map(|c| &*c.name).collect();
    for (column, name) in rows.columns.iter_mut().zip(names) {
        let first = column[0];
        *column = match name {
            "angle" => angles.clone().into(),
            "run" => (0..108).map(|i| f64::from(1 + i / 36)).collect(),
            _ => Values::shared(first, angles.len()),
        };
    }
    rows.observable = Values::shared(rows.observable[0], angles.len());
    let effects: Vec<_> =
        process.effects().iter().filter(|e| model.system.admits(&e.name).is_ok()).map(|e| e.typical()).collect();
    let mut clock = Clock(Instant::now());
    model.system.with_effects(&effects).observe(&rows)?;
    clock.lap("the first trial");
    let trials = 2000;
    for _ in 0..trials {
        model.system.with_effects(&effects).observe(&rows)?;
    }
    println!("a further trial {:.1} us", clock.0.elapsed().as_secs_f64() / f64::from(trials) * 1e6);
    Ok(())
}

/// A trial of a fit: the starting model's rod with 100 elements, 360 steps and some after every switch, all
/// effects at new values, 160 rows; then with a new convection alone.
fn rod() -> Result<(), Box<dyn Error>> {
    let process = fem::processes::ALL.iter().find(|p| p.name() == "thermal").ok_or("no such process")?;
    let model = Model::parse(Source::new("thermal.toml", process.starting_model()))?;
    let mut rows = model.system.programme().some(&(0..160).collect::<Vec<_>>());
    rows.columns[0] = (0..160).map(|row| 270.0 * f64::from(1 + row / 4)).collect();
    let effects: Vec<_> = process
        .effects()
        .iter()
        .map(|e| e.typical())
        .filter(|e| e.description.name != "extra-source" && e.description.name != "contact-resistance")
        .collect();
    let trials = 500;
    let timed = |effects: &[fem::process::Active]| -> Result<f64, Box<dyn Error>> {
        let started = Instant::now();
        for trial in 0..trials {
            let mut own = effects.to_vec();
            // What was asked for before is known.
            own.iter_mut().flat_map(|e| &mut e.values).for_each(|value| *value *= 1.0 + 1e-6 * f64::from(trial));
            model.system.with_effects(&own).observe(&rows)?;
        }
        Ok(started.elapsed().as_secs_f64() / f64::from(trials) * 1e6)
    };
    println!("a trial with all effects {:.1} us, with convection {:.1} us", timed(&effects)?, timed(&effects[..1])?);
    Ok(())
}

fn orders(mesh: &Mesh) -> Result<(), Box<dyn Error>> {
    for order in [Order::Dissection, Order::MinimumDegree] {
        let mut clock = Clock(Instant::now());
        let graph = Graph::new(mesh);
        clock.lap("graph");
        let sequence = order.find(&graph, mesh.nodes())?;
        clock.lap("order");
        let held = [mesh.nearest_node([0.05, 0.0]), mesh.nearest_node([-0.05, 0.0])];
        let freedoms = Freedoms::new(2, &sequence, &[2 * held[0], 2 * held[0] + 1, 2 * held[1] + 1]);
        let pattern = Arc::new(Pattern::new(&graph, &freedoms));
        clock.lap("pattern");
        let law = steel()?;
        let matrix = Matrix::assemble::<2>(mesh, &pattern, &freedoms, |_, sampled, coordinates, square| {
            law.stiffness(sampled, coordinates, square);
        })?;
        clock.lap("assemble");
        let analysis = Analysis::of(&matrix)?;
        clock.lap("symbolic");
        let solver = Solver::new(&analysis, &matrix, &freedoms, mesh.nodes())?;
        clock.lap("numeric");
        let mut b = vec![0.0; freedoms.len()];
        b[17] = 1.0;
        let mut x = vec![0.0; freedoms.len()];
        let accuracy = solver.solve(&matrix, &b, &mut x)?;
        clock.lap("solve");
        let (entries, operations) = (analysis.entries() as f64 * 1e-6, analysis.operations() * 1e-9);
        println!("| {order:?}: {entries:.1}e6 entries, {operations:.2}e9 operations, {accuracy:?}, peak {} MB", peak());
    }
    Ok(())
}

fn heat(cells: [usize; 2]) -> Result<(), Box<dyn Error>> {
    for scheme in [Scheme::BackwardEuler, Scheme::CrankNicolson, Scheme::Sdirk2] {
        let start = Instant::now();
        let mut clock = Clock(start);
        let mesh = RectangleMesh::uniform([0.10, 0.05], cells, &Quad4).build()?;
        let mut conditions = vec![Condition::Flux { sides: "left".to_owned(), flux: Power::switched(5e4, &[]) }];
        for side in ["bottom", "right", "top"] {
            let ambient = History::Constant(20.0);
            conditions.push(Condition::Convection { sides: side.to_owned(), coefficient: 100.0, ambient });
        }
        clock.lap("mesh");
        let law = Conduction { conductivity: 45.0, heat_capacity: 7850.0 * 470.0, thickness: Thickness::Uniform(1.0) };
        let system = ThermalSystem::new(&mesh, law, Capacity::Consistent, &conditions)?;
        clock.lap("assembled");
        let node = mesh.nearest_node([0.0, 0.025]);
        let mut hot = 0.0;
        let run = Run { scheme, step: 1.0, end: 200.0 };
        let energy = system.run(&vec![20.0; mesh.nodes().len()], &run, |now| hot = now.at(node))?;
        clock.lap("stepped");
        let total = start.elapsed().as_secs_f64();
        println!(
            "total {total:.3} s, {scheme:?}: hot {hot:.6}, imbalance {:.1e}, peak {} MB",
            energy.imbalance(),
            peak()
        );
    }
    Ok(())
}

/// What a solve with the triangles of a heated section reads, against what memory gives: the sum of products of as many
/// numbers, read once by as many threads.
fn triangles(cells: [usize; 2]) -> Result<(), Box<dyn Error>> {
    const TIMES: usize = 30;
    let mesh = RectangleMesh::uniform([0.10, 0.05], cells, &Quad4).build()?;
    let graph = Graph::new(&mesh);
    let order = Order::default().find(&graph, mesh.nodes())?;
    let freedoms = Freedoms::new(1, &order, &[]);
    let pattern = Arc::new(Pattern::new(&graph, &freedoms));
    let law = Conduction { conductivity: 45.0, heat_capacity: 7850.0 * 470.0, thickness: Thickness::Uniform(1.0) };
    let matrix = Matrix::assemble::<1>(&mesh, &pattern, &freedoms, |_, sampled, coordinates, square| {
        law.capacity(Capacity::Consistent, sampled, coordinates, square);
    })?;
    let solver = Solver::new(&Analysis::of(&matrix)?, &matrix, &freedoms, mesh.nodes())?;
    let best = |work: &mut dyn FnMut()| {
        let timed = |_| {
            let start = Instant::now();
            work();
            start.elapsed().as_secs_f64()
        };
        (0..TIMES).map(timed).fold(f64::INFINITY, f64::min)
    };
    let count = solver.factor().bytes() / 8;
    let mut x = vec![1.0; freedoms.len()];
    let solve = best(&mut || solver.solve_unchecked(&mut x));
    let values = vec![1.0f64; count];
    let part = count.div_ceil(rayon::current_num_threads());
    let mut sum = 0.0;
    let read = best(&mut || {
        let of = |part: &[f64]| {
            let mut sums = [0.0; 16];
            for chunk in part.chunks_exact(16) {
                sums.iter_mut().zip(chunk).for_each(|(sum, value)| *sum += value * value);
            }
            sums.iter().sum::<f64>()
        };
        sum += values.par_chunks(part).map(of).sum::<f64>();
    });
    // Forwards and backwards, each reads the factor once.
    let rate = |passes: f64, time: f64| 8e-9 * passes * count as f64 / time;
    let (solved, streamed) = (rate(2.0, solve), rate(1.0, read));
    println!(
        "{} unknowns, factor {:.1} MB, {} threads: a solve {:.2} ms, {solved:.1} GB/s; memory gives {streamed:.1} GB/s; {:.0} %",
        freedoms.len(),
        8e-6 * count as f64,
        rayon::current_num_threads(),
        1e3 * solve,
        100.0 * solved / streamed
    );
    assert!(sum > 0.0 && x.iter().all(|x| x.is_finite()));
    Ok(())
}
