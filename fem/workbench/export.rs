//! What is given away as a file: the report, the rows, the session as a notebook.

use std::sync::Arc;

use serde_json::{Value as Json, json};

use super::refusal::Refusal;
use super::session::Session;
use crate::ask::{Depth, Page};

impl Session {
    /// The rows with what is predicted of them, as a table.
    ///
    /// # Errors
    /// No model is open, nothing was measured, or values are unknown.
    pub fn table(&self) -> Result<String, Refusal> {
        let Some(Ok(found)) = &self.now.compared else {
            return Err(Refusal::new(
                "there is nothing to show",
                "open a model and measurements, with every value known",
            ));
        };
        Ok(found.csv.clone())
    }

    /// The session as a notebook: the commands that do the same.
    pub fn notebook(&self) -> String {
        let title = format!("# {}\n", self.now.file);
        let first = json!({ "cell_type": "markdown", "metadata": {}, "source": [title] });
        let cell = |command: &str| json!({ "cell_type": "code", "metadata": {}, "execution_count": null, "outputs": [], "source": [format!("!{command}")] });
        let commands = self.steps.commands().map(cell);
        let cells: Vec<Json> = std::iter::once(first).chain(commands).collect();
        let kernel = json!({ "kernelspec": { "name": "python3", "display_name": "Python 3", "language": "python" } });
        json!({ "nbformat": 4, "nbformat_minor": 5, "metadata": kernel, "cells": cells }).to_string()
    }

    /// The page of a report about what is open.
    ///
    /// # Errors
    /// No model is open, or it cannot be computed.
    pub fn report(&self) -> Result<String, Refusal> {
        let model = self.model()?.clone();
        let named = std::iter::once(&self.now.file).chain(&self.now.files);
        let files = named.filter_map(|name| self.folder.file(name).ok()).collect();
        let page = Page {
            models: std::slice::from_ref(&model),
            measurements: self.now.counted(),
            files,
            most_effects: crate::diagnose::MOST_EFFECTS,
            depth: Depth::Compared,
            live: None,
        };
        Ok(page.made(&Arc::default())?.html)
    }
}
