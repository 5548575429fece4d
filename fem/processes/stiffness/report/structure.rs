//! The report of a machine that is pushed at several places.

use std::sync::Arc;

use super::super::base::Base;
use super::super::machine::Machine;
use super::super::rows::{BRANCH, COORDINATES, DIAL, FORCE_OF_ROW, LOAD, OBSERVABLES};
use super::super::setup::Setup;
use super::largest::largest;
use crate::process::structure::{Port, Shares};
use crate::process::{
    Animation, Arrow, Cell, Column, Failure, Field, Figure, Forward, Frame, Grid, Part, RunReport, Sketch, Table, View,
};
use crate::solve::structure::Direction;
use crate::units::{FORCE, LENGTH, STIFFNESS};

/// Steps in which a force rises where it is shown.
const STEPS: usize = 10;
/// More places than anybody watches.
const MOST_SHOWN: usize = 20;

/// Everything that a run reports.
///
/// # Errors
/// The joints of the structure found no equilibrium.
pub fn report(machine: &Machine, base: &Arc<Base>, forward: &Forward) -> Result<RunReport, Failure> {
    let most = machine.setup.max_force;
    let mut shares = Shares::new(&base.drawn);
    for load in 0..base.loads.len() {
        shares.add(&base.pushed(load, most)?, most);
    }
    let figures = vec![largest(forward), pushed(base, &shares)];
    Ok(RunReport {
        profile: Table::of_rows(
            (COORDINATES, &[LOAD, DIAL, FORCE_OF_ROW, BRANCH]),
            forward.programme,
            &OBSERVABLES[0],
            forward.prediction,
        ),
        tables: vec![("compliance", compliance(base, most)?), ("structure", table(&shares))],
        figures,
        sketch: Some(sketch(&machine.setup, base)?),
        animations: vec![animation(&machine.setup, base.clone())],
        ..RunReport::default()
    })
}

/// The name of a place: that of its node, with the direction.
fn name(base: &Base, port: &Port) -> String {
    let way = match port.at.direction {
        Direction::X => " along x",
        Direction::Y => "",
        Direction::Turn => " turning",
    };
    let from = port.from.map(|node| format!(" from {}", base.drawn.nodes[node])).unwrap_or_default();
    format!("{}{way}{from}", base.drawn.nodes[port.at.node])
}

/// What gives way under a force at each place.
fn pushed(base: &Base, shares: &Shares) -> Figure {
    let mut figure = Figure::new("pushed", "structure, pushed").unit("stiffness_unit", STIFFNESS);
    for (load, (port, compliance)) in base.loads.iter().zip(shares.whole()).enumerate() {
        let (stiffness, number) = (1.0 / compliance, load + 1);
        figure = figure
            .line(format!("{:.1} at {}: {}", STIFFNESS.shown(stiffness), name(base, port), shares.told(load)))
            .quantity(format!("stiffness_{number}"), STIFFNESS, stiffness);
        for (part, share) in shares.under(load) {
            figure = figure.entry(format!("{part}_{number}"), share);
        }
    }
    figure
}

/// Reading of every dial per force at every place, under the largest (N).
fn compliance(base: &Base, most: f64) -> Result<Table, Failure> {
    let all = || (0..base.loads.len()).flat_map(|load| (0..base.dials.len()).map(move |dial| (load, dial)));
    let numbers = |of: fn((usize, usize)) -> usize| all().map(|pair| 1.0 + of(pair) as f64).collect();
    let readings = (0..base.loads.len()).map(|load| base.readings(load, most)).collect::<Result<Vec<_>, Failure>>()?;
    let values = readings.concat().iter().map(|reading| 1e9 * reading / most).collect();
    Ok(Table {
        columns: vec![
            Column::numbers("load", None, numbers(|pair| pair.0)),
            Column::numbers("dial", None, numbers(|pair| pair.1)),
            Column::numbers("compliance", Some("um/kN"), values),
        ],
    })
}

/// What every part adds, place by place.
fn table(shares: &Shares) -> Table {
    let whole = shares.whole();
    let loads = Column::numbers("load", None, (0..whole.len()).map(|load| 1.0 + load as f64).collect());
    let all = Column::numbers("compliance", Some("um/kN"), whole.iter().map(|v| 1e9 * v).collect());
    Table { columns: [loads, all].into_iter().chain(shares.columns()).collect() }
}

/// A force at a place, as an arrow.
fn along(port: &Port, force: f64) -> [f64; 2] {
    match port.at.direction {
        Direction::X => [force, 0.0],
        Direction::Y | Direction::Turn => [0.0, force],
    }
}

/// The machine pushed at the first place.
fn sketch(setup: &Setup, base: &Base) -> Result<Sketch, Failure> {
    let nodes = &base.drawn.factored.structure().nodes;
    let mut parts = base.drawn.sketch(&base.pushed(0, setup.max_force)?);
    let Some(first) = base.loads.first() else { return Ok(Sketch::default()) };
    let label = format!("{:.0}", FORCE.shown(setup.max_force));
    parts.push(Part::Force { at: nodes[first.at.node], force: along(first, setup.max_force), label });
    Ok(Sketch { title: format!("the machine pushed at {}", name(base, first)), parts })
}

/// A force that rises at every place, one after the other.
fn animation(setup: &Setup, base: Arc<Base>) -> Animation {
    let (most, places) = (setup.max_force, base.loads.len().min(MOST_SHOWN));
    let frames = places * STEPS;
    let frame = move |i: usize| {
        let (load, step) = (i / STEPS, i % STEPS + 1);
        let pushed = most * (step as f64 / STEPS as f64);
        // Under the largest force an equilibrium was found, and less leads to it.
        let Ok(displaced) = base.pushed(load, pushed) else { return Frame::default() };
        let mut grid = Grid::default();
        let bodies = base.drawn.bodies(0);
        let mut displacement = base.drawn.draw(&displaced, &mut grid);
        let mut force = vec![[0.0; 3]; displacement.len()];
        let structure = base.drawn.factored.structure();
        let mut point = |node: usize, acting: [f64; 3]| {
            grid.push(Cell::Vertex, &[grid.points.len() as u32]);
            let ([x, y], [u, v, _]) = (structure.nodes[node], displaced.node(node));
            grid.points.push([x, y, 0.0]);
            displacement.push([u, v, 0.0]);
            force.push(acting);
        };
        let port = &base.loads[load];
        let [x, y] = along(port, pushed);
        point(port.at.node, [x, y, 0.0]);
        base.dials.iter().for_each(|dial| point(dial.at.node, [0.0; 3]));
        let arrow = grid.points.len() - 1 - base.dials.len();
        grid.point_fields =
            vec![Field::vector("displacement", LENGTH, displacement), Field::vector("force", FORCE, force)];
        Frame {
            time: (load * STEPS + step) as f64,
            caption: format!("{:.0} at {}", FORCE.shown(pushed), name(&base, port)),
            arrows: vec![Arrow::new(arrow, 0.0)],
            bodies,
            grid,
        }
    };
    Animation {
        name: "machine",
        shown: "displacement",
        time: "step of the test",
        view: View::Oblique,
        telling: STEPS - 1,
        most_magnified: f64::INFINITY,
        frames,
        frame: Box::new(frame),
    }
}
