//! The prediction: the machine to scale, what a run finds, what each effect changes.

use super::html::{self, Cell};
use super::section::Section;
use super::subject::Subject;
use crate::output::chart::{Svg, draw};
use crate::output::{pictures, plots};

/// The sections of the best model that is known.
pub fn sections(subject: &Subject) -> Vec<Section> {
    let Some((model, run)) = subject.best() else { return Vec::new() };
    let is_completed = subject.evidence.as_ref().is_some_and(|found| found.completed.is_some());
    let of =
        if is_completed { "Of the completed model, every value re-fitted." } else { "Of the model as it is written." };
    let figures = |all: Vec<(String, Svg)>| html::figures(all.iter().map(|(name, svg)| (name.as_str(), svg)));
    let drawn = pictures::drawings(run);
    let has_drawing = !drawn.is_empty();
    let machine = vec![html::paragraph("note", of), figures(drawn)];
    let charts = plots::predicted(model, run).iter().map(|c| (c.name.clone(), draw(c))).collect();
    let told: Vec<Vec<Cell>> = run
        .report
        .figures
        .iter()
        .map(|f| vec![Cell::Text(f.label.trim().to_string()), Cell::Text(f.lines.join("; "))])
        .collect();
    let mut prediction = vec![html::paragraph("note", of)];
    prediction.extend(run.report.warnings.iter().map(|w| html::paragraph("caution", &format!("Warning: {w}"))));
    prediction.push(figures(charts));
    prediction.push(html::table("What a run finds", &["figure", "value"], &told, false));
    let observables = model.process.observables();
    let share = |s: &crate::model::Contribution| {
        let kind = s.kind(observables);
        let [rms, low, high] = [s.rms, s.smallest, s.largest].map(|si| kind.from_si(si));
        let name = if s.name == "ideal" { "without any effect" } else { &s.name };
        vec![
            Cell::Text(name.into()),
            Cell::Text(observables[s.observable].name.replace('_', " ")),
            Cell::Number(format!("{rms:.3}"), rms),
            Cell::Number(format!("{low:+.3}"), low),
            Cell::Number(format!("{high:+.3}"), high),
            Cell::Text(kind.unit.into()),
        ]
    };
    let shares: Vec<_> = run.contributions.iter().map(share).collect();
    let head = ["effect", "changes", "rms", "from", "to", "unit"];
    let mut changes =
        vec![html::table("The prediction with all effects less that without one of them", &head, &shares, true)];
    // Where causes have cards, their curves stand there.
    if !is_completed {
        changes.push(figures(
            plots::changes(model, &run.contributions).iter().map(|(_, c)| (c.name.clone(), draw(c))).collect(),
        ));
    }
    vec![
        Section { id: "machine", title: "The machine", blocks: if has_drawing { machine } else { Vec::new() } },
        Section { id: "prediction", title: "The prediction", blocks: prediction },
        Section { id: "effects", title: "What each effect changes", blocks: changes },
    ]
}
