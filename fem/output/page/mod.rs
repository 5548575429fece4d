//! One self-contained page: the prediction of a model, and what measurements say of it. It computes nothing: it
//! reads the same reports that text and JSON are written from.

mod answered;
mod causes;
mod evidence;
mod html;
mod prediction;
mod provenance;
mod step;
mod subject;

pub use answered::{Head, answered, fragment, machine_fragment, next_fragment, verdict_sentence};
pub use subject::{Evidence, Subject};

use askama::Template;
use html::Section;

use super::chart::sheet;
use super::run::RunAnswer;
use super::text::micro;
use super::{comparison, diagnosis};
use crate::diagnose::Verdict;
use crate::input::visible;

#[derive(Template)]
#[template(path = "report.html")]
struct Page {
    kicker: String,
    title: String,
    verdict: String,
    /// Class and sign of the verdict.
    mood: &'static str,
    sign: &'static str,
    /// Every cause that is told, and what it is in plain words.
    plain: Vec<(String, String)>,
    facts: Vec<(String, String)>,
    sections: Vec<Section>,
    sheet: &'static str,
    css: &'static str,
    js: &'static str,
    version: &'static str,
    live: Option<u64>,
}

#[derive(Template)]
#[template(path = "trouble.html")]
struct Trouble<'a> {
    told: &'a str,
    css: &'static str,
    js: &'static str,
    live: u64,
}

const CSS: &str = include_str!("../../../templates/report.css");
const JS: &str = concat!(include_str!("../../../templates/figures.js"), include_str!("../../../templates/report.js"));

/// Writes the page that stands in the place of a served one while its files are wrong.
pub fn trouble(told: &str, live: u64) -> String {
    // A template writes into memory, which does not fail.
    Trouble { told, css: CSS, js: JS, live }.render().unwrap_or_default()
}

/// Writes the page; a served one asks whether it is still the `live` version.
pub fn page(subject: &Subject, live: Option<u64>) -> String {
    let model = subject.model();
    let (verdict, mood) = verdict(subject);
    let page = Page {
        kicker: kicker(subject),
        title: model.title.clone().unwrap_or_else(|| model.stem().display().to_string()),
        verdict,
        mood,
        sign: match mood {
            "good" => "\u{2713}",
            "bad" => "\u{26a0}",
            _ => "\u{25b8}",
        },
        plain: plain(subject),
        facts: subject.evidence.as_ref().map_or(Vec::new(), evidence::facts),
        sections: sections(subject),
        sheet: sheet(),
        css: CSS,
        js: JS,
        version: env!("CARGO_PKG_VERSION"),
        live,
    };
    // A template writes into memory, which does not fail. A name may hold what a terminal obeys, to which the page is written
    // too by whoever prints it.
    visible(&page.render().unwrap_or_default()).into_owned()
}

/// All sections that say something.
fn sections(subject: &Subject) -> Vec<Section> {
    let mut all = subject.evidence.as_ref().map_or(Vec::new(), |found| evidence::sections(subject, found));
    all.extend(prediction::sections(subject));
    all.push(provenance::section(subject));
    all.retain(|section| section.blocks.iter().any(|block| !block.is_empty()));
    all
}

fn kicker(subject: &Subject) -> String {
    let model = subject.model();
    let names: Vec<&str> = subject.models.iter().map(|m| &*m.source.name).collect();
    let about = format!("{}: {}", model.process.name(), model.process.about());
    match &subject.evidence {
        Some(found) => format!("{} against {} \u{b7} {about}", names.join(", "), found.data.name),
        None => format!("{} \u{b7} {about}", names.join(", ")),
    }
}

/// The causes in plain words.
fn plain(subject: &Subject) -> Vec<(String, String)> {
    let found = subject.evidence.as_ref().and_then(|found| found.diagnosis);
    let missing = found.map_or(&[][..], |d| &d.missing);
    missing.iter().map(|own| (diagnosis::label(own), html::sentence(&own.effect.about))).collect()
}

/// The verdict as a sentence, and whether it is good news.
fn verdict(subject: &Subject) -> (String, &'static str) {
    let (text, mood) = match &subject.evidence {
        Some(Evidence { diagnosis: Some(d), data: found, .. }) => {
            let mood = match d.verdict {
                Verdict::Adequate | Verdict::MissingEffect => "good",
                Verdict::PartlyExplained | Verdict::Unexplained => "bad",
                Verdict::NotJudged => "",
            };
            (diagnosis::verdict(found, d), mood)
        }
        Some(Evidence { comparisons, all, .. }) => match comparisons.last() {
            Some(c) => {
                let mood = if c.adequate() { "good" } else { "bad" };
                (format!("{}: {}", c.model, comparison::verdict(c, all)), mood)
            }
            None => (String::new(), ""),
        },
        None => {
            let first = subject.run.and_then(|RunAnswer(_, run, _)| run.report.figures.first());
            let told = first.map(|f| format!("predicted: {}: {}", f.label.trim(), f.lines.join("; ")));
            (told.unwrap_or_default(), "")
        }
    };
    (micro(&html::sentence(&text)), mood)
}
