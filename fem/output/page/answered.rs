//! The page of an answer by itself: what its text says, and its figures.

use askama::Template;

use super::causes;
use super::html::{self, Section};
use super::{CSS, JS, Page};
use crate::diagnose::Diagnosis;
use crate::model::{Data, Run};
use crate::output::answer::Answer;
use crate::output::block::Block;
use crate::output::chart::sheet;
use crate::output::diagnosis;
use crate::output::run::drawings;
use crate::output::text::titled;

/// What stands above an answer.
pub struct Head {
    /// Of what and by which command.
    kicker: String,
    /// Title.
    title: String,
    /// What it says, in a sentence.
    verdict: String,
}

impl Head {
    /// That of what a command answers about a file, which may have a title.
    pub fn new(command: &str, title: Option<&str>, file: &str, verdict: String) -> Self {
        Self { kicker: format!("{file} \u{b7} {command}"), title: titled(title, file), verdict }
    }
}

/// Writes the page of an answer: its blocks, a section for each heading, then its figures. A first sentence, which says over the
/// text what the page says in its title, is left out.
pub fn answered(head: Head, answer: &impl Answer) -> String {
    let figures = answer.figures();
    let mut sections = vec![Section { id: "s0".into(), title: "In short".into(), blocks: Vec::new() }];
    for (i, block) in answer.blocks().iter().enumerate() {
        match block {
            Block::Sentence(_) if i == 0 => {}
            Block::Heading(title) => {
                let id = format!("s{}", sections.len());
                sections.push(Section { id: id.into(), title: html::capital(title).into(), blocks: Vec::new() });
            }
            own => sections.last_mut().into_iter().for_each(|section| section.blocks.push(html::block(own))),
        }
    }
    sections
        .insert(1, Section { id: "pictures".into(), title: "Pictures".into(), blocks: vec![html::figures(figures)] });
    sections.retain(|section| section.blocks.iter().any(|block| !block.is_empty()));
    let page = Page {
        kicker: head.kicker,
        title: head.title,
        verdict: html::sentence(&head.verdict),
        mood: "",
        sign: "\u{25b8}",
        plain: Vec::new(),
        facts: Vec::new(),
        sections,
        sheet: sheet(),
        css: CSS,
        js: JS,
        version: env!("CARGO_PKG_VERSION"),
        live: None,
    };
    // A template writes into memory, which does not fail.
    page.render().unwrap_or_default()
}

/// An answer within another page: its blocks, then its figures.
pub fn fragment(answer: &impl Answer) -> String {
    let blocks: String = answer.blocks().iter().map(html::block).collect();
    blocks + &html::figures(answer.figures())
}

/// What a run draws: the machine to scale, contours with magnified deviations.
pub fn machine_fragment(run: &Run) -> String {
    html::figures(drawings(run))
}

/// What to measure next.
pub fn next_fragment(d: &Diagnosis) -> String {
    causes::next(d).blocks.concat()
}

/// What a diagnosis says, in a sentence.
pub fn verdict_sentence(data: &Data, d: &Diagnosis) -> String {
    html::sentence(&diagnosis::verdict(data, d))
}
