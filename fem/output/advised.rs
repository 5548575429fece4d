//! The answer of `fem correct` where no command is corrected place by place.

use serde_json::{Value as Json, json};

use super::OutputError;
use super::answer::Answer;
use super::block::Block;
use super::correction::action;
use super::json::{finite, json as document};
use super::page::{Head, answered};
use super::staged::Staged;
use super::text::titled;
use super::{bands, number, tolerance};
use crate::compare::rms;
use crate::correct::Advised;
use crate::model::Model;
use crate::process::range;

/// What to change at a model.
pub struct AdvisedAnswer<'a>(pub &'a Model, pub &'a Advised);

impl Answer for AdvisedAnswer<'_> {
    fn blocks(&self) -> Vec<Block> {
        let Self(model, found) = *self;
        let title = titled(model.title.as_deref(), &model.source.name);
        let mut blocks = vec![Block::Sentence(format!("{title}: what to change")), Block::Sentence(self.now())];
        if !found.band.is_exact() {
            blocks.push(Block::Sentence(bands::lines(model, &found.band).join("; ")));
        }
        blocks.extend(bands::failure(&found.band, model.process.size_kind()).map(Block::Caution));
        let advice: Vec<String> = found.advice.iter().map(|own| own.text.clone()).collect();
        match advice.is_empty() {
            true => blocks.push(Block::Sentence("nothing that this process knows would make it better".into())),
            false => blocks.extend([Block::Heading("what to change".into()), Block::List(advice)]),
        }
        if found.standings.is_empty() {
            let asked = "what the drawing asks is not in the model: with [tolerance] it is held against that";
            blocks.push(Block::Sentence(asked.into()));
        } else {
            blocks.push(Block::Heading("tolerance, as it is".into()));
            blocks.push(Block::List(tolerance::lines(&found.standings)));
        }
        blocks
    }

    /// `fem correct --json`: `fem-correction/1` without a correction.
    fn json(&self) -> Json {
        let Self(model, found) = *self;
        let probability = found.band.probability.as_ref();
        json!({
            "schema": "fem-correction/1",
            "model": &*model.source.name,
            "process": model.process.name(),
            "correction": [],
            "left": [],
            "offsets": [],
            "rms": { "before": finite(rms(&found.values)) },
            "actions": found.advice.iter().map(action).collect::<Vec<_>>(),
            "uncertain_values": found.band.uncertain,
            "unexplained": finite(found.band.unexplained),
            "other_sets": found.band.others,
            "tolerance": {
                "probability_in": probability.map(|own| own.of_all),
                "parts": tolerance::parts(probability),
                "before": tolerance::json(&found.standings),
            },
        })
    }

    /// `correction.html` and `correction.json`.
    fn stage(&self, files: &mut Staged) -> Result<(), OutputError> {
        let head = Head::new("fem correct", self.0.title.as_deref(), &self.0.source.name, self.now());
        files.text("correction.html", &answered(head, self))?;
        files.text("correction.json", &document(self))
    }
}

impl AdvisedAnswer<'_> {
    /// What is made as it is.
    fn now(&self) -> String {
        let Self(model, found) = *self;
        let of = |(observable, values): (usize, Vec<f64>)| {
            let (low, high) = range(values.iter().copied());
            let observable = &model.process.observables()[observable];
            let kind = observable.error_kind();
            let [rms, low, high] = [rms(&values), low, high].map(|si| kind.from_si(si));
            format!(
                "{}: {} {unit} rms, from {} to {} {unit}",
                observable.words,
                number::fixed(rms, 2),
                number::signed(low, 2),
                number::signed(high, 2),
                unit = kind.unit
            )
        };
        let of_rows = |rows: Vec<usize>| rows.into_iter().map(|row| found.values[row]).collect();
        let all = bands::observed(model, &found.rows).into_iter();
        all.map(|(observable, rows)| of((observable, of_rows(rows)))).collect::<Vec<_>>().join("; ")
    }
}
