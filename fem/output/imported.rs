//! The answer of `fem import` where it only shows how a file is read.

use serde_json::{Value as Json, json};

use super::answer::Answer;
use super::block::Block;
use super::quoted;
use crate::input::InputError;
use crate::measure::{Imported, Measurements};
use crate::process::Process;

/// Most cells of a column that are shown.
const SHOWN: usize = 3;

/// Most characters of a cell that is shown.
const WIDEST: usize = 16;

/// A file as it is read.
pub struct ImportAnswer<'a> {
    /// Name of the file.
    pub file: &'a str,
    /// What was made of it.
    pub imported: &'a Imported,
    /// Options by which it was said how it is to be read.
    pub said: &'a [String],
}

impl ImportAnswer<'_> {
    /// What a column is read as, or what becomes of it.
    fn meant(&self, column: usize) -> String {
        let own = self.imported.preview.meant[column].as_deref();
        own.map_or("?".into(), |own| if own == "-" { "left out".into() } else { own.to_string() })
    }

    /// The first cells of a column.
    fn cells(&self, column: usize) -> String {
        let rows = &self.imported.preview.rows;
        let cell = |row: &Vec<String>| row.get(column).map(|cell| cell.chars().take(WIDEST).collect::<String>());
        let mut cells: Vec<String> = rows.iter().take(SHOWN).filter_map(cell).collect();
        cells.extend((self.imported.preview.count > SHOWN).then(|| "…".into()));
        cells.join(" | ")
    }

    /// The columns, a line for each.
    fn columns(&self) -> String {
        let preview = &self.imported.preview;
        let has_cells = |i: &usize| preview.rows.iter().any(|row| row.get(*i).is_some_and(|cell| !cell.is_empty()));
        let is_there = |i: &usize| !preview.headings[*i].is_empty() || has_cells(i);
        let row = |i: usize| [preview.headings[i].clone(), self.cells(i), self.meant(i)];
        let head = ["column", "first rows", "read as"].map(String::from);
        let rows: Vec<[String; 3]> =
            std::iter::once(head).chain((0..preview.headings.len()).filter(is_there).map(row)).collect();
        let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
        let [first, second] = [width(0), width(1)];
        let line = |[name, cells, meant]: &[String; 3]| {
            let padded = |text: &str, width: usize| format!("{text}{}", " ".repeat(width - text.chars().count()));
            format!("  {}   {}   {meant}\n", padded(name, first), padded(cells, second))
        };
        // Apart from what stands above.
        "\n".to_string() + &rows.iter().map(line).collect::<String>()
    }

    /// What goes on from here.
    fn command(&self, process: &dyn Process, more: &str) -> String {
        let said: String = self.said.iter().map(|own| format!(" {}", quoted(own))).collect();
        format!("fem import {} --process {}{said}{more}", quoted(self.file), process.name())
    }

    fn taken(&self, process: &dyn Process, taken: &Measurements) -> Vec<Block> {
        let observed: Vec<&str> = taken.observables.iter().map(|o| &*o.name).collect();
        let rows = if taken.len() == 1 { "observation" } else { "observations" };
        let sentence =
            format!("read as measurements of {}: {} {rows} of {}", process.name(), taken.len(), observed.join(" and "));
        let notes = taken.notes.iter().map(|note| Block::Paragraph(note.clone()));
        let keep = self.command(process, " -o measured.csv");
        let commands = vec![
            keep,
            "# with a model: fem import FILE --model MODEL.toml --keep NEW.toml keeps the options in it".into(),
        ];
        let after = [Block::Heading("to go on".into()), Block::Commands(commands)];
        std::iter::once(Block::Paragraph(sentence)).chain(notes).chain(after).collect()
    }

    /// What is asked, for the file alone does not say it.
    fn asked(&self, process: &dyn Process, refused: &InputError) -> Vec<Block> {
        let problem = |own: &crate::input::Problem| (own.message.clone(), own.help.clone().unwrap_or_default());
        let told = refused.problems.iter().map(problem).flat_map(|(message, help)| [message, help]);
        let heading = format!("not read as {} yet", process.name());
        let told = told.filter(|own| !own.is_empty()).map(Block::Paragraph);
        std::iter::once(Block::Heading(heading)).chain(told).collect()
    }
}

impl Answer for ImportAnswer<'_> {
    fn blocks(&self) -> Vec<Block> {
        let Imported { process, others, preview, taken } = self.imported;
        let rows = if preview.count == 1 { "row" } else { "rows" };
        let numbered = if preview.is_headed { "" } else { ", and no headings: columns are named by their numbers" };
        let mut blocks = vec![Block::Lines(format!("{}: {} {rows}{numbered}\n", self.file, preview.count))];
        // What was taken tells it with all else.
        if !(preview.told.is_empty() || matches!(taken, Some(Ok(_)))) {
            blocks.push(Block::Paragraph(format!("how it is read: {}", preview.told.join("; "))));
        }
        blocks.push(Block::Lines(self.columns()));
        let Some(process) = process else {
            let help = "say what it holds: fem import FILE --process PROCESS; `fem effects` lists processes";
            blocks.push(Block::Caution(format!("no process knows any of these columns; {help}")));
            return blocks;
        };
        if !others.is_empty() {
            let names: Vec<&str> = others.iter().map(|own| own.name()).collect();
            blocks
                .push(Block::Caution(format!("it could be of {} as well: say which with --process", names.join(", "))));
        }
        blocks.extend(match taken {
            Some(Ok(taken)) => self.taken(*process, taken),
            Some(Err(refused)) => self.asked(*process, refused),
            None => Vec::new(),
        });
        blocks
    }

    /// `fem import --json`: `fem-import/1`.
    fn json(&self) -> Json {
        let Imported { process, others, preview, taken } = self.imported;
        let column = |i: usize| {
            let cells: Vec<&str> = preview.rows.iter().map(|row| row.get(i).map_or("", String::as_str)).collect();
            json!({ "heading": preview.headings[i], "cells": cells, "read_as": preview.meant[i] })
        };
        let (taken, refused) = match taken {
            Some(Ok(taken)) => (Some(taken), None),
            Some(Err(error)) => (None, Some(error)),
            None => (None, None),
        };
        let problems = refused.map(|error| {
            let one = |own: &crate::input::Problem| json!({ "message": own.message, "help": own.help });
            error.problems.iter().map(one).collect::<Vec<_>>()
        });
        json!({
            "schema": "fem-import/1",
            "file": self.file,
            "process": process.map(|own| own.name()),
            "others": others.iter().map(|own| own.name()).collect::<Vec<_>>(),
            "headed": preview.is_headed,
            "rows": preview.count,
            "told": preview.told,
            "columns": (0..preview.headings.len()).map(column).collect::<Vec<_>>(),
            "observations": taken.map(Measurements::len),
            "notes": taken.map(|own| &own.notes),
            "problems": problems,
        })
    }
}
