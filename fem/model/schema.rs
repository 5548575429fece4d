//! JSON Schema of the model file, made by the functions that read it.

use serde_json::{Value as Json, json};

use super::{read, recorded};
use crate::input::Reader;
use crate::process::Process;
use crate::processes;

/// Makes the schema, for editors: one alternative per process, chosen by `process`.
pub fn schema() -> Json {
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "fem model",
        "description": "A quantity is a string with its unit: \"60 N/um\" is known, \"60 +- 15 N/um\" is known roughly, \"? N/um\" is to be fitted.",
        "oneOf": processes::ALL.iter().map(|p| of_process(*p)).collect::<Vec<_>>(),
    })
}

/// Makes that of the models of one process.
pub fn of_process(process: &'static dyn Process) -> Json {
    let mut shape = Reader::schema(process.about(), |model| {
        recorded::read(model, process, &[]);
        read(model, process)
    });
    shape["properties"]["process"] = json!({ "const": process.name() });
    if let Some(required) = shape["required"].as_array_mut() {
        required.push(json!("process"));
    }
    shape["title"] = json!(process.name());
    shape
}
