//! Reports for people.

use std::fmt::Write;

use super::report::{Detail, Format, Report};
use super::{OutputError, budget, comparison, compensation, diagnosis, fit, measurement, plan, plot, study};
use crate::model::{Contribution, Model, Run};
use crate::noise::MeasurementEffect;
use crate::process::{Description, Neutral, Observable, Parameter, Process};
use crate::validation::{Case, Tolerance};

/// One page of plain text per report.
#[derive(Clone, Copy, Debug)]
pub struct Text {
    /// Columns that curves may take.
    pub columns: usize,
}

impl Default for Text {
    /// As wide as any terminal.
    fn default() -> Self {
        Self { columns: plot::USUAL }
    }
}

impl Format for Text {
    fn write(&self, report: &Report) -> Result<String, OutputError> {
        let page = match report {
            Report::Run(model, found) => run(model, found, self.columns),
            Report::Comparison(models, measurements, comparisons) => {
                let [first, ..] = models else { return Ok(String::new()) };
                comparison::text(&*first.process, measurements, comparisons, self.columns)
            }
            Report::Fit(data, found) => fit::text(data, found),
            Report::Diagnosis(data, found) => diagnosis::text(data, found, self.columns),
            Report::Plan(design, found) => plan::text(design, found),
            Report::Compensation(data, found, supplied) => compensation::text(data, found, supplied),
            Report::Budget(file, estimate) => budget::text(file, *estimate),
            Report::Study(layout, summary) => study::text(layout, summary),
            Report::Effects(entries, of_measurement, Detail::Line) => catalogue(entries, of_measurement),
            Report::Effects(entries, of_measurement, Detail::Page) => {
                let own = entries.iter().map(|(process, e)| effect(process.name(), e));
                own.chain(of_measurement.iter().map(|e| measurement::page(e))).collect::<Vec<_>>().join("\n")
            }
            Report::Validation(cases, total) => validation(cases, *total),
        };
        Ok(page + &left_undone(&report.left_undone()))
    }
}

/// Lists the steps that the time limit has cut off.
fn left_undone(undone: &[String]) -> String {
    match undone {
        [] => String::new(),
        undone => format!("\nthe time was over; left undone:\n  {}\n", undone.join("\n  ")),
    }
}

/// The terminal summary of a run.
fn run(model: &Model, run: &Run, columns: usize) -> String {
    let mut text = String::new();
    let title = model.title.as_deref().unwrap_or(&model.source.name).replace(|c: char| c.is_control(), " ");
    // Writing to a String does not fail, here and below.
    let _ = writeln!(text, "{title}\n{}: {}\n", model.process.name(), model.process.about());
    for figure in &run.report.figures {
        // The first line stands behind the label, the others below it.
        let lines = figure.lines.join(&format!("\n{:27}", ""));
        let _ = writeln!(text, "  {:<24} {lines}", figure.label);
    }
    let own = measurement::at_work(&model.source.name, &model.measurement, &*model.process, None);
    if !own.is_empty() {
        let _ = writeln!(text, "\n{own}a run predicts the part, and leaves the instrument aside");
    }
    let observables = model.process.observables();
    for shares in run.contributions.chunk_by(|a, b| a.observable == b.observable) {
        changes(&mut text, observables, shares);
    }
    for plot in &run.report.plots {
        let _ = writeln!(text, "\n{}", plot::lines(plot, columns).join("\n"));
    }
    text
}

/// Tabulates contributions to one observable, which all of `shares` have in common.
fn changes(text: &mut String, observables: &[Observable], shares: &[Contribution]) {
    let Some(first) = shares.first() else { return };
    let title = format!("what changes {}", observables[first.observable].words);
    let (whole, change) = (observables[first.observable].kind.unit, observables[first.observable].error_kind().unit);
    let unit = if whole == change { whole.to_string() } else { format!("{whole}, changes in {change}") };
    let _ = writeln!(text, "\n  {title:<27} {:>10} {:>10} {:>10}   {unit}", "rms", "from", "to");
    for share in shares {
        let name = if share.name == "ideal" { "without any effect" } else { &share.name };
        let kind = share.kind(observables);
        let [rms, low, high] = [share.rms, share.smallest, share.largest].map(|si| kind.from_si(si));
        let _ = writeln!(text, "  {name:<27} {rms:>10.3} {low:>+10.3} {high:>+10.3}");
    }
}

/// The catalogue, process by process, and what they share: one line per effect.
fn catalogue(entries: &[(&dyn Process, Description)], of_measurement: &[&MeasurementEffect]) -> String {
    let mut text = String::new();
    for of_process in entries.chunk_by(|a, b| a.0.name() == b.0.name()) {
        let process = of_process[0].0;
        let _ = writeln!(text, "{}: {}", process.name(), process.about());
        for (_, effect) in of_process {
            let _ = writeln!(text, "  {:<24} {}", effect.name, effect.about);
        }
    }
    if !of_measurement.is_empty() {
        text.push_str(&measurement::catalogue(of_measurement));
    }
    format!("{text}\n`fem effects NAME` tells all about one of them\n")
}

/// All about one effect.
fn effect(process: &str, effect: &Description) -> String {
    let mut text = format!(
        "{} ({process})\n  {}\n\n  law     {}\n  source  {}\n\n",
        effect.name, effect.about, effect.law, effect.source
    );
    for parameter in &*effect.parameters {
        let _ = writeln!(text, "  {}", parameter_line(parameter));
    }
    if !effect.look_alikes.is_empty() {
        let _ = writeln!(text, "\n  can look the same as");
        for (name, difference) in effect.look_alikes {
            let _ = writeln!(text, "    {name:<22} what separates them: {difference}");
        }
    }
    let _ = writeln!(text, "\n  in a model file\n    [effects.{}]", effect.name);
    for p in &*effect.parameters {
        let number = (p.example() * 1e6).round() / 1e6;
        let value = if p.kind.unit.is_empty() { format!("{number}") } else { format!("\"{number} {}\"", p.kind.unit) };
        let _ = writeln!(text, "    {} = {value}", p.name);
    }
    text
}

fn parameter_line(p: &Parameter) -> String {
    let neutral = match p.neutral {
        Neutral::Value(value) => format!("vanishes at {value}"),
        Neutral::Infinity => "vanishes at infinity".into(),
        Neutral::Shape => "shapes the effect".into(),
    };
    let unit = if p.kind.unit.is_empty() { "-" } else { &p.kind.unit };
    let optional = match (p.default, p.needed_with) {
        (Some(si), _) => format!("; {} if left out", p.kind.from_si(si)),
        (None, Some(other)) => format!("; only with {other}"),
        (None, None) => String::new(),
    };
    format!("{:<14} {:<10} {}; plausible {} to {}; {neutral}{optional}", p.name, unit, p.about, p.range.0, p.range.1)
}

/// The validation table.
fn validation(cases: &[Case], total: usize) -> String {
    let width = cases.iter().map(|c| c.name.chars().count() + c.quantity.chars().count() + 2).max().unwrap_or(0);
    let mut text = format!(
        "{:<width$} {:>16} {:>16} {:<8} {:>9} {:>9}\n",
        "case", "expected", "computed", "unit", "error", "allowed"
    );
    for case in cases {
        let name = format!("{}, {}", case.name, case.quantity);
        let percent = if matches!(case.tolerance, Tolerance::Relative(_)) { " rel" } else { " abs" };
        let verdict = if case.passed() { "" } else { "  FAILED" };
        let _ = writeln!(
            text,
            "{name:<width$} {:>16} {:>16} {:<8} {:>9.1e} {:>9.1e}{percent}  {}{verdict}",
            figure(case.expected),
            figure(case.computed),
            case.unit,
            case.error(),
            case.allowed(),
            case.source,
        );
    }
    let failed = cases.iter().filter(|c| !c.passed()).count();
    let part = if cases.len() < total { format!(" of {total}") } else { String::new() };
    let _ = writeln!(text, "\n{}{part} cases, {failed} failed", cases.len());
    text
}

fn figure(value: f64) -> String {
    match value.abs() {
        a if a == 0.0 || (1e-3..1e6).contains(&a) => format!("{value:.9}"),
        _ => format!("{value:.9e}"),
    }
}
