//! The answer of `fem discover`: the laws that were found.

use serde_json::{Value as Json, json};

use super::answer::Answer;
use super::block::Block;
use crate::discover::Discovery;
use crate::model::Data;

/// What was found, with the data.
pub struct LawsAnswer<'a>(pub &'a Data<'a>, pub &'a Discovery);

impl Answer for LawsAnswer<'_> {
    fn blocks(&self) -> Vec<Block> {
        let Self(_, found) = *self;
        let line = |law: &crate::discover::Law| {
            format!("{}   chi2/dof {:.3}, criterion {:.1}", law.written.formula, law.reduced_chi2, law.criterion)
        };
        vec![
            Block::Sentence(format!("before: chi2/dof {:.3}", found.before)),
            Block::List(found.laws.iter().map(line).collect()),
        ]
    }

    fn json(&self) -> Json {
        let Self(data, found) = *self;
        let laws: Vec<Json> = found
            .laws
            .iter()
            .map(|law| {
                json!({
                    "formula": law.written.formula,
                    "variables": law.variables,
                    "chi2_per_dof": law.reduced_chi2,
                    "criterion": law.criterion,
                })
            })
            .collect();
        let features: Vec<Json> = found
            .told()
            .map(|law| json!({ "coordinate": law.variables.join(" and "), "shape": null, "text": law.written.formula }))
            .into_iter()
            .collect();
        json!({
            "schema": "fem-laws/1",
            "model": &*data.model.source.name,
            "verdict": if found.is_nothing_left { "adequate" } else if found.told().is_none() { "unexplained" } else { "partly-explained" },
            "too_few": found.too_few.as_ref().map(|few| json!({ "settings": few.settings, "variables": few.variables, "more": few.more })),
            "instead": found.instead.iter().map(|term| term.effect.name).collect::<Vec<_>>(),
            "missing": [],
            "features": features,
            "laws": laws,
        })
    }
}
