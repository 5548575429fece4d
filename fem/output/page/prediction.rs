//! The prediction: the machine to scale, what a run finds, what each effect changes.

use super::html::{self, Section};
use super::subject::Subject;
use crate::model::Contribution;
use crate::output::block::{Cell, Column, Table};
use crate::output::chart::named;
use crate::output::run::{RunAnswer, change_of, drawings};
use crate::output::{bands, plots, tolerance};

/// The sections of the best model that is known.
pub fn sections(subject: &Subject) -> Vec<Section> {
    let Some(RunAnswer(model, run, band)) = subject.best() else { return Vec::new() };
    let is_completed = subject.evidence.as_ref().is_some_and(|found| found.completed.is_some());
    let of =
        if is_completed { "Of the completed model, every value re-fitted." } else { "Of the model as it is written." };
    let drawn = drawings(run);
    let has_drawing = !drawn.is_empty();
    let machine = vec![html::paragraph("note", of), html::figures(drawn)];
    let figure = |label: &str, lines: &[String]| vec![Cell::Text(label.trim().into()), Cell::Text(lines.join("; "))];
    let tolerance = tolerance::lines(&run.standings);
    let tolerance = tolerance.iter().map(|line| figure("tolerance", std::slice::from_ref(line)));
    let told = band.map(|band| figure("95 % band", &bands::lines(model, band)));
    let findings = run.report.figures.iter().map(|f| figure(&f.label, &f.lines)).chain(tolerance).chain(told);
    let findings = Table::new(["figure", "value"].map(Column::wide), findings);
    let mut prediction = vec![html::paragraph("note", of)];
    prediction.extend(run.report.warnings.iter().map(|w| html::paragraph("caution", &format!("Warning: {w}"))));
    prediction.push(html::figures(plots::predicted(model, run, band).iter().map(named)));
    prediction.push(html::table(&Table { caption: "What a run finds".into(), ..findings }));
    let observables = model.process.observables();
    let share = |s: &Contribution| {
        let [name, rms, low, high] = change_of(s, observables);
        let observable = observables[s.observable].name.replace('_', " ");
        vec![name, Cell::Text(observable), rms, low, high, Cell::Text(s.kind(observables).unit.into())]
    };
    let head = ["effect", "changes", "rms", "from", "to", "unit"].map(Column::wide);
    let caption = "The prediction with all effects less that without one of them".into();
    let shares = Table { caption, is_sortable: true, ..Table::new(head, run.contributions.iter().map(share)) };
    let parts = html::figures(plots::parts(model, run).iter().map(named));
    let mut changes = vec![parts, html::table(&shares)];
    changes.extend(run.untold.iter().map(|own| html::paragraph("caution", &html::sentence(&own.clause()))));
    // Where causes have cards, their curves stand there.
    if !is_completed {
        changes.push(html::figures(plots::changes(model, &run.contributions).iter().map(|(_, c)| named(c))));
    }
    vec![
        Section {
            id: "machine".into(),
            title: "The machine".into(),
            blocks: if has_drawing { machine } else { Vec::new() },
        },
        Section { id: "prediction".into(), title: "The prediction".into(), blocks: prediction },
        Section { id: "effects".into(), title: "What each effect changes".into(), blocks: changes },
    ]
}
