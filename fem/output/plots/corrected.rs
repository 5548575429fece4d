//! Charts of a correction: what is commanded, what it leaves.

use super::about::About;
use super::layout::Layout;
use crate::correct::Correction;
use crate::model::Model;
use crate::output::chart::{Axis, Chart, Form, Plane, Series};
use crate::units::Kind;

/// What is left with its band between the limits, before the grey errors as they are; and what is added to the command.
pub fn corrected(model: &Model, found: &Correction) -> Vec<Chart> {
    let given: Vec<usize> = found.commanded.apart().chain([found.commanded.along]).collect();
    let layouts = Layout::each(&*model.process, &found.rows, &given, &[found.commanded.observable]);
    let kind = model.process.observables()[found.commanded.observable].error_kind();
    layouts.iter().flat_map(|layout| [left(model, found, layout), change(found, layout, kind)]).collect()
}

fn left(model: &Model, found: &Correction, layout: &Layout) -> Chart {
    let kind = model.process.observables()[found.commanded.observable].kind;
    let of = |values: &[f64], row: usize| kind.from_si(values[layout.rows[row]]);
    let limits = model.system.limits(&found.rows);
    let ends = |own: [f64; 2]| own.map(|si| kind.from_si(si));
    let about = About {
        interval: &|row| (!found.band.is_exact()).then(|| ends(found.band.interval[layout.rows[row]])),
        limits: &|row| limits[layout.rows[row]].map(|own| ends([own.lower, own.upper])),
    };
    let before = layout.lines(&|row| of(&found.before, row));
    let (limits, of_limits) = about.limits(layout, &before);
    let lines = layout.lines(&|row| of(&found.left, row));
    let before = before.into_iter().map(|own| Series { label: String::new(), form: Form::Faint, ..own });
    let note = ["faint: as it is", "lines: with the correction", "areas hold 95 %"].map(str::to_string);
    let note = note.into_iter().take(if found.band.is_exact() { 2 } else { 3 }).chain(of_limits);
    let (x, y) = layout.axes();
    Chart {
        name: "left".into(),
        title: format!("what is left of {}", y.name),
        note: note.collect::<Vec<_>>().join("; "),
        plane: Plane::Curves {
            x,
            y,
            series: about.bands(layout).into_iter().chain(limits).chain(before).chain(lines).collect(),
        },
    }
}

fn change(found: &Correction, layout: &Layout, kind: Kind) -> Chart {
    let changes = found.command.changes();
    let (x, _) = layout.axes();
    let y = Axis::new(found.commanded.key.replace('_', " "), kind.unit);
    Chart {
        name: "change".into(),
        title: format!("what is added to the {}", found.commanded.words),
        note: String::new(),
        plane: Plane::Curves { x, y, series: layout.lines(&|row| kind.from_si(changes[layout.rows[row]])) },
    }
}
