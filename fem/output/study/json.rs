//! A study as JSON: `fem-study/1`.

use serde_json::{Map, Value as Json, json};

use crate::output::json::finite;
use crate::study::{Extreme, Found, Layout, Nature, Numbers, ResultColumn, Summary};

/// Makes the JSON of a study.
pub fn json(layout: &Layout, summary: &Summary) -> Json {
    let results = layout.results.iter().zip(&summary.results).map(|(column, found)| {
        let mut own = match found {
            Found::Numbers(numbers) => of_numbers(layout, column, numbers),
            Found::Words(words) => {
                json!({ "words": words.iter().map(|(word, n)| (word.clone(), json!(n))).collect::<Map<_, _>>() })
            }
        };
        own["name"] = json!(column.name);
        own
    });
    let failures = summary.failures.iter().map(|(job, message)| json!({ "job": job, "message": message }));
    json!({
        "schema": "fem-study/1",
        "plan": layout.plan,
        "title": layout.title,
        "task": layout.task,
        "design": layout.design,
        "jobs": layout.jobs,
        "rows": summary.rows,
        "failed": summary.failed,
        "failures": failures.collect::<Vec<_>>(),
        "inputs": layout.inputs.iter().map(|(name, unit)| json!({ "name": name, "unit": unit })).collect::<Vec<_>>(),
        "results": results.collect::<Vec<_>>(),
        "caution": Summary::caution(layout.nature),
    })
}

fn of_numbers(layout: &Layout, column: &ResultColumn, numbers: &Numbers) -> Json {
    let extreme = |e: &Extreme| {
        let inputs = layout.inputs.iter().zip(&e.inputs).map(|((name, _), value)| (name.clone(), json!(value)));
        json!({ "value": e.value, "job": e.job, "data": e.data, "inputs": inputs.collect::<Map<_, _>>() })
    };
    let ends = numbers.ends.as_ref();
    let acceptance = numbers.acceptance.map(|a| {
        let interval = (layout.nature != Nature::Listed).then(|| a.interval());
        json!({
            "share": a.share(),
            "interval95": interval.map(|(low, high)| [low, high]),
            "good": a.good,
            "bad": a.bad,
            "failed": a.failed,
        })
    });
    let indices = numbers.indices.as_ref().map(|(indices, _)| {
        let index = layout.inputs.iter().zip(indices).map(|((name, _), i)| {
            json!({
                "input": name,
                "first": i.first,
                "first_standard_error": i.first_error,
                "total": i.total,
                "total_standard_error": i.total_error,
            })
        });
        index.collect::<Vec<_>>()
    });
    json!({
        "name": column.name,
        "unit": column.unit,
        "values": numbers.count,
        "missing": numbers.missing,
        "mean": finite(numbers.mean),
        "std": finite(numbers.std),
        "smallest": ends.map(|ends| extreme(&ends[0])),
        "largest": ends.map(|ends| extreme(&ends[1])),
        "tolerance": column.tolerance.map(|(low, high)| [finite(low), finite(high)]),
        "yield": acceptance,
        "worst": numbers.worst.as_ref().map(extreme),
        "groups": numbers.indices.as_ref().map(|(_, groups)| groups),
        "indices": indices,
    })
}
