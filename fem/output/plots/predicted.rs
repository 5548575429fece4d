//! Charts of a prediction.

use super::about::About;
use super::layout::Layout;
use super::positioning;
use crate::input::Name;
use crate::knowledge::Band;
use crate::model::{Contribution, Model, Run};
use crate::output::chart::{Axis, Chart, Form, Plane, Series, draw};
use crate::process::Rows;
use crate::units::Kind;

/// The programme of a model, laid out.
fn layouts(model: &Model, rows: &Rows) -> Vec<Layout> {
    let all: Vec<usize> = (0..model.process.coordinates().len()).collect();
    let seen: Vec<usize> = (0..model.process.observables().len()).filter(|o| rows.observable.contains(o)).collect();
    Layout::each(&*model.process, rows, &all, &seen)
}

/// The prediction along its coordinates, around its circle, over its pairs, as its standard draws it; with its band and what
/// a drawing allows.
pub fn predicted(model: &Model, run: &Run, band: Option<&Band>) -> Vec<Chart> {
    let rows = model.system.programme();
    if let Some(test) = model.system.positioning() {
        return vec![positioning::chart((test, &rows), &run.prediction, "predicted", None)];
    }
    let limits = model.system.limits(&rows);
    let charts = |layout: &Layout| {
        let kind = model.process.observables()[layout.observable].kind;
        let value = |row: usize| kind.from_si(run.prediction[layout.rows[row]]);
        let ends = |own: [f64; 2]| own.map(|si| kind.from_si(si));
        let interval = |row: usize| band.map(|band| ends(band.interval[layout.rows[row]]));
        let limits = |row: usize| limits[layout.rows[row]].map(|own| ends([own.lower, own.upper]));
        of_one(layout, &value, &About { interval: &interval, limits: &limits })
    };
    layouts(model, &rows).iter().flat_map(charts).collect()
}

fn of_one(layout: &Layout, value: &dyn Fn(usize) -> f64, about: &About) -> Vec<Chart> {
    let (x, y) = layout.axes();
    let title = format!("predicted {} over {}", y.name, x.name);
    let named = |name: &str| format!("{name}{}", layout.end);
    let lines = layout.lines(value);
    let chosen = layout.chosen().len();
    let (limits, of_limits) = about.limits(layout, &lines);
    let bands = about.bands(layout);
    let of_bands = if bands.is_empty() { None } else { Some("areas hold 95 %".to_string()) };
    let of_colours = match layout.labels.len() {
        all if all > chosen => Some(format!("{chosen} of {all} curves in colour, the others in grey")),
        _ => None,
    };
    let note = of_colours.into_iter().chain(of_bands).chain(of_limits).collect::<Vec<_>>().join("; ");
    let series: Vec<Series> = bands.into_iter().chain(limits).chain(lines).collect();
    let mut charts = Vec::new();
    if layout.is_around() {
        let plane =
            Plane::Polar { y: y.clone(), series: series.iter().filter(|s| s.form == Form::Line).cloned().collect() };
        let title = format!("predicted {} around", y.name);
        let note = "outwards from the grey circle is positive, magnified".to_string();
        charts.push(Chart { name: named("polar"), title, note, plane });
    }
    let name = named(if layout.is_loop() { "loop" } else { "profile" });
    charts.push(Chart { name, title, note, plane: Plane::Curves { x, y, series } });
    let across = layout.telling.iter().copied().find(|at| {
        let variable = &layout.variables[*at];
        variable.levels.len() > 2 && variable.axis.words.is_empty()
    });
    let beside = across.map(|at| (0, at)).filter(|_| !layout.is_loop());
    let maps = beside.map(|pair| (pair, "map")).into_iter().chain(layout.plane().map(|pair| (pair, "field")));
    charts.extend(maps.map(|(pair, name)| map(layout, pair, value, named(name))));
    charts
}

/// A map over a pair of variables; of what else varies, the last.
fn map(layout: &Layout, (a, b): (usize, usize), value: &dyn Fn(usize) -> f64, name: String) -> Chart {
    let others: Vec<usize> = layout.telling.iter().copied().chain([0]).filter(|at| *at != a && *at != b).collect();
    let last = |at: &usize| layout.variables[*at].levels.last().copied().unwrap_or(f64::NAN);
    let is_last = |row: &usize| {
        others.iter().all(|at| (layout.variables[*at].values[*row] - last(at)).abs() <= 1e-6 * last(at).abs())
    };
    let (x, y) = (&layout.variables[a], &layout.variables[b]);
    let cells: Vec<[f64; 3]> =
        (0..layout.rows.len()).filter(is_last).map(|row| [x.values[row], y.values[row], value(row)]).collect();
    let at: Vec<String> = others
        .iter()
        .map(|at| format!("{} = {}", layout.variables[*at].axis.name, layout.variables[*at].axis.format(last(at))))
        .collect();
    let note = if at.is_empty() { String::new() } else { format!("at {}", at.join(", ")) };
    let title = format!("predicted {} over {} and {}", layout.value.name, x.axis.name, y.axis.name);
    let value = Axis { limits: about_zero(&cells), ..layout.value.clone() };
    Chart { name, title, note, plane: Plane::Map { x: x.axis.clone(), y: y.axis.clone(), value, cells } }
}

/// Ends of a scale about zero, where values lie on both of its sides.
fn about_zero(cells: &[[f64; 3]]) -> Option<(f64, f64)> {
    let (low, high) = cells.iter().map(|c| c[2]).fold((0.0f64, 0.0f64), |(a, b), v| (a.min(v), b.max(v)));
    let most = high.max(-low);
    (low < -0.1 * most && high > 0.1 * most).then_some((-most, most))
}

/// Change by each effect along the abscissa: for each effect by its name a chart of the groups.
pub fn changes(model: &Model, contributions: &[Contribution]) -> Vec<(Name, Chart)> {
    let layouts = layouts(model, &model.system.programme());
    let observables = model.process.observables();
    let mut charts = Vec::new();
    for share in contributions.iter().filter(|c| c.name != "ideal") {
        let Some(layout) = layouts.iter().find(|layout| layout.observable == share.observable) else { continue };
        let kind: Kind = share.kind(observables);
        let value = |row: usize| kind.from_si(share.changes.get(row).copied().unwrap_or(f64::NAN));
        let series: Vec<Series> = layout.lines(&value);
        let (mut x, mut y) = layout.axes();
        let changed = if layout.is_loop() { &mut x } else { &mut y };
        (changed.name, changed.unit) = (format!("change of {}", changed.name), kind.unit.to_string());
        let title = format!("what {} changes", share.name);
        let note = "the prediction with all effects less that without this one".to_string();
        charts.push((
            share.name.clone(),
            Chart { name: format!("change-{}", share.name), title, note, plane: Plane::Curves { x, y, series } },
        ));
    }
    charts
}

/// What each effect adds to what is observed, in one figure for each observable that several effects change: of the last of
/// the groups, where what grows has grown most; the largest effects, and all of them together.
pub fn parts(model: &Model, run: &Run) -> Vec<Chart> {
    /// Effects with a colour of their own; the next colour is that of all together.
    const MOST: usize = 5;
    let observables = model.process.observables();
    let chart = |layout: &Layout| {
        let own = || run.contributions.iter().filter(|c| c.observable == layout.observable);
        let ideal = own().find(|c| c.name == "ideal")?;
        let mut effects: Vec<&Contribution> = own().filter(|c| c.name != "ideal").collect();
        if effects.len() < 2 || layout.is_loop() {
            return None;
        }
        effects.sort_by(|a, b| b.rms.total_cmp(&a.rms));
        let left_out = effects.len().saturating_sub(MOST);
        effects.truncate(MOST);
        let kind = observables[layout.observable].error_kind();
        let group = *layout.chosen().last()?;
        let factor = kind.canonical().factor;
        let of = |si: &dyn Fn(usize) -> f64| layout.points(group, &|row| si(row) / factor, &|_| f64::NAN);
        let line = |(colour, effect): (usize, &&Contribution)| {
            let change = |row: usize| effect.changes.get(row).copied().unwrap_or(f64::NAN);
            Series::new(&*effect.name, colour, Form::Line, of(&change))
        };
        let whole = |row: usize| {
            let predicted = run.prediction.get(layout.rows[row]);
            predicted.zip(ideal.changes.get(row)).map_or(f64::NAN, |(all, ideal)| all - ideal)
        };
        let together = Series::new("together", MOST, Form::Dashed, of(&whole));
        let series = [together].into_iter().chain(effects.iter().enumerate().map(line)).collect();
        let (x, mut y) = layout.axes();
        (y.name, y.unit) = (format!("change of {}", y.name), kind.unit.to_string());
        let at = Some(&layout.labels[group]).filter(|label| !label.is_empty());
        let at = at.map_or(String::new(), |label| format!(", {label}"));
        let more = match left_out {
            0 => String::new(),
            1 => "; one that is smaller is not drawn".into(),
            several => format!("; {several} that are smaller are not drawn"),
        };
        let title = format!("what each cause adds to {}{at}", layout.value.name);
        let note = format!("each: the prediction less that without it; together: less that of the ideal machine{more}");
        Some(Chart { name: format!("parts{}", layout.end), title, note, plane: Plane::Curves { x, y, series } })
    };
    layouts(model, &model.system.programme()).iter().filter_map(chart).collect()
}

/// Change by each effect along the curve: the text of an SVG file for each contribution but the ideal system's.
pub fn signatures(model: &Model, contributions: &[Contribution]) -> Vec<String> {
    changes(model, contributions).iter().map(|(_, chart)| draw(chart).file()).collect()
}
