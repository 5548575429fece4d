//! The report of a run: figures, tables, and shapes for people.

pub mod blocks;
mod contact;
mod figures;
mod interpolation;
mod shapes;
mod tables;

use blocks::Blocks;

use super::machine::Machine;
use super::rows::{self, ANGLE_OF_ROW, COORDINATES, OBSERVABLES, SPEED};
use super::setup::Setup;
use crate::process::{Forward, Plot, Rows, RunReport, Table};
use crate::units::{ANGLE, LENGTH, MICRO};

/// Everything that a run reports.
pub fn report(machine: &Machine, forward: &Forward) -> RunReport {
    let (setup, rows, deviations) = (&machine.setup, forward.programme, forward.prediction);
    let run = machine.run(setup.program.usual());
    let formulas = |places: &[f64], values: &mut [f64]| forward.add_formulas(&rows::at(setup, places), values);
    let blocks = blocks::look(machine, &run, forward.has_formulas().then_some(&formulas));
    RunReport {
        profile: Table::of_rows((COORDINATES, &[ANGLE_OF_ROW, SPEED]), rows, &OBSERVABLES[0], deviations),
        tables: vec![("program", tables::program(setup)), ("blocks", tables::blocks(setup, &blocks.list))],
        figures: figures::figures(setup, &blocks),
        plots: vec![plot(rows, deviations)],
        drawings: vec![shapes::drawing(setup, deviations)],
        sketch: None,
        warnings: warnings(setup, &blocks),
        animations: vec![shapes::animation(setup, run.motion, deviations)],
    }
}

fn plot(rows: &Rows, deviations: &[f64]) -> Plot {
    let angles = rows.columns[ANGLE_OF_ROW].iter().map(|angle| ANGLE.from_si(*angle));
    let mut points: Vec<(f64, f64)> = angles.zip(deviations.iter().map(|d| MICRO.from_si(*d))).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    Plot { title: "deviation [um] over polar angle [deg]".into(), x_unit: "deg", points }
}

/// Reasons not to take the prediction at its word.
fn warnings(setup: &Setup, blocks: &Blocks) -> Vec<String> {
    let mut warnings = Vec::new();
    let [tightest, wheel] = [setup.profile.tightest_hollow(), setup.wheel_radius];
    if tightest < wheel {
        let [tightest, wheel] = [tightest, wheel].map(|radius| LENGTH.shown(radius));
        warnings.push(format!(
            "the tightest hollow of the profile has a radius of {tightest:.3}, and the wheel one of {wheel:.3}: the \
             wheel undercuts its neighbourhood, and no programme avoids it; take a wheel below {tightest:.3}"
        ));
    }
    if let Some((depth, cut, ground)) = blocks.collision {
        let [cut, ground] = [cut, ground].map(|s| ANGLE.shown(setup.profile.angle(s)));
        let depth = MICRO.shown(-depth);
        warnings.push(format!("where the wheel grinds the cam at {ground:.1} it cuts {depth:.1} into it at {cut:.1}"));
    }
    let waves = blocks.list.iter().map(|b| b.thickest.0 - b.thinnest.0).fold(0.0, f64::max);
    if let Some(stock) = setup.stock.filter(|stock| waves > *stock) {
        let [waves, stock] = [waves, stock].map(|height| MICRO.shown(height));
        warnings.push(format!(
            "within a block the cam waves by {waves:.1}, more than the layer of {stock:.1} that is taken off: shorten \
             the blocks"
        ));
    }
    warnings
}
