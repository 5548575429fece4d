//! Layout of the rows of a study, as JSON: beside the rows, so that shards find together without plan and model.

use serde_json::{Value as Json, json};

use crate::output::files::Account;
use crate::study::{Layout, Nature, ResultColumn, Shard};

/// Name of the file.
pub const FILE: &str = ".fem-study.json";
const SCHEMA: &str = "fem-study-rows/1";
/// A file that is longer was not written by this program.
pub const LONGEST: u64 = 1 << 28;

/// The text of the file, sealed where there is a key; `has_sums` where each row has a sum beside it.
pub fn text(layout: &Layout, shard: Shard, has_sums: bool, account: Option<&Account>) -> String {
    let word = Nature::WORDS.iter().find(|(_, nature)| *nature == layout.nature).map_or("", |(word, _)| word);
    let end = |value: f64| if value.is_finite() { json!(value) } else { Json::Null };
    let result = |r: &ResultColumn| {
        json!({
            "name": r.name,
            "unit": r.unit,
            "is_word": r.is_word,
            "tolerance": r.tolerance.map(|(low, high)| [end(low), end(high)]),
        })
    };
    let value = json!({
        "schema": SCHEMA,
        "facts": layout.facts,
        "title": layout.title,
        "plan": layout.plan,
        "task": layout.task,
        "design": layout.design,
        "jobs": layout.jobs,
        "group": layout.group,
        "nature": word,
        "inputs": layout.inputs,
        "has_data": layout.has_data,
        "results": layout.results.iter().map(result).collect::<Vec<_>>(),
        "shard": [shard.number, shard.of],
        "sums": has_sums,
    });
    let text = format!("{value:#}\n");
    account.map_or(text.clone(), |account| account.sealed_json(SCHEMA, &text))
}

/// Whether this account has sealed the text of a file.
pub fn is_own(text: &[u8], account: &Account) -> bool {
    account.has_sealed_json(SCHEMA, text)
}

/// Whether the text of a file says that each row has a sum beside it; those of earlier versions have none.
pub fn has_sums(text: &[u8]) -> bool {
    serde_json::from_slice(text).is_ok_and(|all: Json| all["sums"] == true)
}

/// Reads the text of the file; `None` where it is no such file.
pub fn parse(text: &[u8]) -> Option<(Layout, Shard)> {
    let all: Json = serde_json::from_slice(text).ok()?;
    if all["schema"] != SCHEMA {
        return None;
    }
    let word = |value: &Json| value.as_str().map(str::to_string);
    let pairs = |value: &Json| {
        let pair = |pair: &Json| Some((word(&pair[0])?, word(&pair[1])?));
        value.as_array()?.iter().map(pair).collect::<Option<Vec<_>>>()
    };
    let result = |r: &Json| {
        let ends = r["tolerance"].as_array();
        let end = |i: usize, open: f64| ends.map(|ends| ends.get(i).and_then(Json::as_f64).unwrap_or(open));
        Some(ResultColumn {
            name: word(&r["name"])?,
            unit: word(&r["unit"])?,
            is_word: r["is_word"].as_bool()?,
            tolerance: end(0, f64::NEG_INFINITY).zip(end(1, f64::INFINITY)),
        })
    };
    let layout = Layout {
        facts: pairs(&all["facts"])?,
        title: word(&all["title"]),
        plan: word(&all["plan"])?,
        task: word(&all["task"])?,
        design: word(&all["design"])?,
        jobs: all["jobs"].as_u64()?,
        group: all["group"].as_u64().filter(|group| *group > 0)?,
        nature: Nature::WORDS.iter().find(|(word, _)| all["nature"] == **word)?.1,
        inputs: pairs(&all["inputs"])?,
        has_data: all["has_data"].as_bool()?,
        results: all["results"].as_array()?.iter().map(result).collect::<Option<_>>()?,
    };
    let shard = Shard { number: all["shard"][0].as_u64()?, of: all["shard"][1].as_u64()? };
    (1..=shard.of).contains(&shard.number).then_some((layout, shard))
}
