//! The answer of `fem correct --remedies`: which settings to change, what each gains, and what it costs.

use std::path::Path;

use serde_json::{Value as Json, json};

use super::OutputError;
use super::answer::Answer;
use super::bands;
use super::block::{Block, Cell, Column, Table};
use super::chart::{Svg, named};
use super::correction::CorrectionAnswer;
use super::json::{finite, json as document};
use super::number;
use super::page::{Head, answered};
use super::remedied::{chart, list, table, words};
use super::staged::Staged;
use super::text::titled;
use crate::correct::Correction;
use crate::model::Model;
use crate::remedy::{Change, Remedies, Remedy};
use crate::units::TIME;

/// The remedies of a model.
pub struct RemedyAnswer<'a> {
    /// The model.
    pub model: &'a Model,
    /// What was found.
    pub found: &'a Remedies,
    /// What to command now, where the process has a command that is corrected and it was asked for.
    pub correction: Option<&'a Correction>,
    /// Folder into which files are written.
    pub directory: Option<&'a Path>,
}

impl Answer for RemedyAnswer<'_> {
    fn blocks(&self) -> Vec<Block> {
        let found = self.found;
        let title = titled(self.model.title.as_deref(), &self.model.source.name);
        let offsets = if found.by_offsets { ", with an offset for each part in any case" } else { "" };
        let of_parts = if found.parts > 1 { format!(" of all {} parts", found.parts) } else { String::new() };
        let mut blocks = vec![
            Block::Sentence(format!("{title}: what to change{offsets}")),
            Block::Sentence(format!("errors in {}, minutes{of_parts} beside what they take now", found.kind.unit)),
        ];
        let now = Remedy { changes: Vec::new(), ..found.now.clone() };
        let own = [("as it is", "", "", &now)].into_iter().map(|(a, b, c, r)| self.row(&[a, b, c], r));
        let each = found.alone.iter().flat_map(|remedy| {
            let row = move |own: &Change| {
                let words = [own.from.as_deref().unwrap_or("-"), own.to.as_deref().unwrap_or("as written")];
                self.row(&[&own.setting, words[0], words[1]], remedy)
            };
            remedy.changes.iter().map(row)
        });
        blocks.push(self.table(&["setting", "now", "to"], own.chain(each)));
        if found.alone.is_empty() {
            blocks.push(Block::Sentence("no setting alone makes it better".into()));
        }
        if !found.together.is_empty() {
            blocks.push(Block::Heading("the best few together".into()));
            blocks.push(self.changed(&found.together));
        }
        if found.front.len() > 1 {
            blocks.push(Block::Heading("what minutes buy: no other that was tried leaves less in less time".into()));
            blocks.push(self.changed(&found.front));
        }
        if !found.refused.is_empty() {
            blocks.push(Block::Heading("left out".into()));
            let line = |own: &crate::remedy::Refused| {
                let help = own.help.as_ref().map_or(String::new(), |help| format!("; {help}"));
                (own.name.clone(), format!("{}{help}", own.reason))
            };
            blocks.push(Block::Entries(found.refused.iter().map(line).collect()));
        }
        blocks.extend(self.cautions().into_iter().map(Block::Caution));
        blocks
    }

    /// `fem correct --remedies --json`: `fem-correction/1` with `actions`, `together` and `pareto`; SI, but minutes.
    fn json(&self) -> Json {
        let found = self.found;
        let mut all = match self.correction {
            Some(own) => CorrectionAnswer(self.model, own, None).json(),
            None => json!({
                "schema": "fem-correction/1",
                "model": &*self.model.source.name,
                "process": self.model.process.name(),
                "correction": [],
                "left": [],
                "offsets": [],
                "tolerance": { "probability_in": found.now.probability },
            }),
        };
        let of = |own: &Remedy| -> Json {
            let mut entry = self.judged(own);
            entry["settings"] = own.changes.iter().map(changed).collect();
            entry["text"] = sentence(own).into();
            entry
        };
        let action = |own: &Remedy| -> Json {
            let mut entry = self.judged(own);
            if let Some(change) = own.changes.first() {
                let one = changed(change);
                for key in ["setting", "from", "to", "at_limit", "measured"] {
                    entry[key] = one[key].clone();
                }
            }
            entry["text"] = sentence(own).into();
            entry
        };
        all["now"] = self.judged(&found.now);
        let of_settings: Vec<Json> = found.alone.iter().map(action).collect();
        let known = all["actions"].as_array().cloned().unwrap_or_default();
        all["actions"] = of_settings.into_iter().chain(known).collect();
        all["together"] = found.together.iter().map(of).collect();
        all["pareto"] = found.front.iter().map(of).collect();
        let refused =
            |own: &crate::remedy::Refused| json!({ "setting": own.name, "reason": own.reason, "help": own.help });
        all["refused"] = found.refused.iter().map(refused).collect();
        all["parts"] = found.parts.into();
        all["parts_looked_at"] = found.looked_at.into();
        all["most_minutes"] = found.limit.map(|limit| TIME.from_si(limit)).into();
        all["evaluations"] = found.evaluations.into();
        all
    }

    fn figures(&self) -> Vec<(String, Svg)> {
        let corrected = self.correction.map(|own| CorrectionAnswer(self.model, own, None).figures());
        [named(&chart(self.found))].into_iter().chain(corrected.into_iter().flatten()).collect()
    }

    /// `remedies.csv`, `remedies.svg`, `correction.html`, `remedied.toml` with the best, `correction.json`; `correction.csv` where there is one.
    fn stage(&self, files: &mut Staged) -> Result<(), OutputError> {
        if let Some(own) = self.correction {
            CorrectionAnswer(self.model, own, None).stage_changes(files)?;
        }
        files.text("remedies.csv", &table(self.found))?;
        files.figures(self.figures())?;
        let best = self.found.best().and_then(|own| self.model.edited(&own.edits).ok());
        if let (Some(best), Some(directory)) = (best, self.directory) {
            files.text("remedied.toml", &best.text_at(&directory.join("remedied.toml")))?;
        }
        let head = Head::new(
            "fem correct --remedies",
            self.model.title.as_deref(),
            &self.model.source.name,
            self.found.best().map_or("no setting makes it better".into(), sentence),
        );
        files.text("correction.html", &answered(head, self))?;
        files.text("correction.json", &document(self))
    }
}

impl RemedyAnswer<'_> {
    /// Whether the drawing asks anything.
    fn is_asked(&self) -> bool {
        self.found.now.left.used.is_some()
    }

    /// A table with what is left and what it costs behind some columns of words.
    fn table(&self, words: &[&str], rows: impl Iterator<Item = Vec<Cell>>) -> Block {
        let words = words.iter().map(|name| Column::wide(*name));
        let numbers = ["rms", "worst", "gain"].map(|name| Column::new(name, 8)).into_iter();
        let asked = ["tolerance", "in"].map(|name| Column::new(name, 9)).into_iter().filter(|_| self.is_asked());
        let minutes = [Column::new("minutes", 9)];
        Block::Table(Table::new(words.chain(numbers).chain(minutes).chain(asked), rows))
    }

    fn row(&self, words: &[&str], own: &Remedy) -> Vec<Cell> {
        let size = |si: f64| {
            let value = self.found.kind.from_si(si);
            Cell::Number(number::fixed(value, 2), value)
        };
        let minutes = TIME.from_si(own.time);
        let is_now = own.changes.is_empty();
        let gain = self.found.kind.from_si(self.found.gain(own));
        let percent = |part: f64| Cell::Number(format!("{} %", number::fixed(100.0 * part, 0)), part);
        let words = words.iter().map(|own| Cell::Text((*own).into()));
        let [gain, minutes] = [(gain, 2), (minutes, 1)].map(|(value, decimals)| match is_now {
            true => Cell::Missing,
            false => Cell::Number(number::signed(value, decimals), value),
        });
        let asked = own.left.surely_used.map(|used| [percent(used), own.probability.map_or(Cell::Missing, percent)]);
        let numbers = [size(own.left.rms), size(own.left.worst), gain, minutes];
        words.chain(numbers).chain(asked.into_iter().flatten()).collect()
    }

    /// Rows of several settings each.
    fn changed(&self, all: &[Remedy]) -> Block {
        let rows = all.iter().map(|own| self.row(&[&list(own)], own));
        self.table(&["change"], rows)
    }

    fn cautions(&self) -> Vec<String> {
        let found = self.found;
        let told = || found.alone.iter().chain(&found.together).chain(&found.front).flat_map(|own| &own.changes);
        let named = |is: &dyn Fn(&&Change) -> bool| {
            let mut names: Vec<String> = told().filter(is).map(words).collect();
            names.sort_unstable();
            names.dedup();
            names.join(", ")
        };
        let mut all: Vec<String> = self
            .correction
            .and_then(|own| bands::failure(&own.band, self.model.process.size_kind()))
            .into_iter()
            .collect();
        if found.looked_at < found.parts {
            let parts = (found.looked_at, found.parts);
            all.push(format!("{} of {} parts were looked at, evenly from the first to the last", parts.0, parts.1));
        }
        let ends = named(&|own| own.is_end);
        if !ends.is_empty() {
            all.push(format!("at the limit that the model states: {ends}; beyond it there may be more"));
        }
        let beyond = named(&|own| own.is_measured == Some(false));
        if !beyond.is_empty() {
            all.push(format!("beyond what the model was held against measurements at: {beyond}; measure there first"));
        }
        let mut unsaid: Vec<&str> = told().filter(|own| own.is_measured.is_none()).map(|own| &*own.setting).collect();
        unsaid.sort_unstable();
        unsaid.dedup();
        if !unsaid.is_empty() {
            all.push(format!(
                "it is not said where the model was held against measurements (`measured` of a setting) of {}: what they \
                 gain is predicted, and the first part shows whether it holds",
                unsaid.join(", ")
            ));
        }
        if found.uncertain == 0 && self.is_asked() {
            all.push("the model knows all its values exactly, so that a part is in or out, and nothing between".into());
        }
        all
    }

    fn judged(&self, own: &Remedy) -> Json {
        json!({
            "gain": finite(self.found.gain(own)),
            "minutes": finite(TIME.from_si(own.time)),
            "rms": finite(own.left.rms),
            "worst": finite(own.left.worst),
            "tolerance_used": own.left.used.map(finite),
            "tolerance_used_95": own.left.surely_used.map(finite),
            "probability_in": own.probability,
        })
    }
}

/// What to do, in a sentence.
fn sentence(own: &Remedy) -> String {
    let one = |own: &Change| match (&own.from, &own.to) {
        (Some(from), Some(to)) => format!("set {} from {from} to {to}", own.setting),
        (None, Some(to)) => format!("{}: {to}", own.setting),
        (_, None) => own.setting.clone(),
    };
    own.changes.iter().map(one).collect::<Vec<_>>().join("; ")
}

fn changed(own: &Change) -> Json {
    json!({
        "setting": own.setting,
        "from": own.from,
        "to": own.to,
        "at_limit": own.is_end,
        "measured": own.is_measured,
    })
}
