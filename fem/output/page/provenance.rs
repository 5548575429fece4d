//! Where the page comes from: versions, files with their hashes, commands that do it again.

use super::html::{self, Section};
use super::subject::Subject;
use crate::output::block::{Cell, Column, Table};
use crate::output::diagnosis::{commands, quoted, with};

/// The last section.
pub fn section(subject: &Subject) -> Section {
    let files = subject.files.iter().map(|(name, hash)| vec![Cell::Text(name.clone()), Cell::Text(hash.clone())]);
    let files = Table::new(["file", "SHA-256"].map(Column::wide), files);
    let models: Vec<String> = subject.models.iter().map(|m| quoted(&m.source.name)).collect();
    let (models, last) = (models.join(" "), quoted(&subject.model().source.name));
    let mut lines = Vec::new();
    let mut blocks = vec![
        html::paragraph("", &format!("Written by fem {}.", env!("CARGO_PKG_VERSION"))),
        html::table(&Table { caption: "Files that were read".into(), ..files }),
    ];
    match &subject.evidence {
        None => lines.extend([format!("fem report {models} -o report.html"), format!("fem run {last}")]),
        Some(found) => {
            let data = with(found.data);
            lines.push(format!("fem report {models} {data} -o report.html"));
            lines.push(format!("fem compare {models} {data}"));
            lines.push(format!("fem diagnose {last} {data}"));
        }
    }
    blocks.push(html::heading("To see the same again"));
    blocks.push(html::commands(&lines));
    if let Some((found, d)) = subject.evidence.as_ref().and_then(|found| Some((found, found.diagnosis?))) {
        let lines = commands(found.data, d);
        if !lines.is_empty() {
            blocks.push(html::heading("To go on"));
            blocks.push(html::commands(&lines));
        }
        let notes = found.data.notes_of_fit();
        blocks.push(html::list(&notes));
    }
    Section { id: "provenance".into(), title: "Where this comes from".into(), blocks }
}
