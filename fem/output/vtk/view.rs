//! The script with which ParaView opens a series as it is meant to be looked at.

use serde_json::{Value, json};

use super::shop_name;
use super::survey::Survey;
use crate::process::{Animation, View};

/// The program that wrote a file.
pub const VERSION: &str = concat!("fem ", env!("CARGO_PKG_VERSION"));

/// Statements of the script, below those that say what it opens.
const BODY: &str = include_str!("view.py");

/// The script for an animation.
pub fn script(animation: &Animation, title: &str, model: &str, survey: &Survey) -> String {
    let ranges: serde_json::Map<String, Value> =
        survey.ranges.iter().map(|r| (shop_name(&r.name, r.kind), json!(r.scale()))).collect();
    let shown = survey.range(animation.shown).map_or(String::new(), |r| shop_name(&r.name, r.kind));
    let lines = [
        ("SERIES", json!(format!("{}-magnified.pvd", animation.name))),
        ("TITLE", json!(title)),
        ("MODEL", json!(model)),
        ("VERSION", json!(VERSION)),
        ("MAGNIFICATION", json!(survey.magnification)),
        ("LARGEST_FORCE_N", json!(survey.force)),
        ("TIME", json!(animation.time)),
        ("SHOWN", json!(shown)),
        ("RANGES", Value::Object(ranges)),
        ("FROM_THE_FRONT", json!(u8::from(animation.view == View::Front))),
        ("TELLING_FRAME", json!(animation.telling)),
    ];
    // JSON of texts, finite numbers, lists and objects of them is Python too.
    let constants: String = lines.iter().map(|(name, value)| format!("{name} = {value}\n")).collect();
    BODY.replace("# CONSTANTS\n", &constants)
}
