//! What holds for every effect of every process.

#![allow(clippy::unwrap_used, clippy::expect_used)]

mod changed;
mod edits;
mod estimates;
mod formula;
mod look_alikes;
mod roles;

use std::collections::HashSet;

use fem::input::Source;
use fem::model::Model;
use fem::process::{Active, Description, Neutral, Process};
use fem::processes::ALL;
use fem::progress::Progress;
use fem::units::Unit;

/// Models on which between them every effect of a process can act.
fn models(process: &dyn Process) -> Vec<Model> {
    let start = process.starting_model();
    let variants = match process.name() {
        "turning" => vec![
            start.to_string(),
            start.replace("\"centres\"", "\"chuck-and-centre\""),
            start.replace("type = \"centres\"", "type = \"centres\"\nguideway_spacing = \"300 mm\""),
            start.replace("type = \"centres\"", &format!("type = \"centres\"\n{REST}")),
            start.replace(SEGMENT, STEPPED),
            format!("{start}\n[edge]\nclearance_angle = \"8 deg\"\nwear_land = \"0.1 mm\"\n"),
        ],
        "ring" => vec![
            start.to_string(),
            start.replace("\"least-squares-circle\"", "\"absolute\""),
            start.replace("jaws = 3 ", "jaws = 4 "),
        ],
        "contour" => vec![start.to_string(), equipped(start)],
        "fixture" => {
            let tilted = start.replace("# depth = \"1 mm\"", "diameter = \"80 mm\"\ndepth = \"20 um\"");
            vec![start.to_string(), tilted, PLANE_PART.to_string()]
        }
        "rotary" => vec![start.to_string(), tilting(start), JOINT.to_string()],
        _ => vec![start.to_string()],
    };
    variants.into_iter().map(|text| Model::parse(Source::new("model.toml", text)).unwrap()).collect()
}

/// What stands under a shaft.
const REST: &str = "steady_rests = [{ at = \"150 mm\", stiffness = \"40 N/um\" }]";

/// The shaft, and one with a shoulder that the pass climbs.
const SEGMENT: &str = "{ length = \"500 mm\", diameter = \"40 mm\" }";
const STEPPED: &str = "{ length = \"200 mm\", diameter = \"50 mm\" }, { length = \"300 mm\", diameter = \"40 mm\" }";

/// A contour with what some effects need: screws, a frequency, and the force of a cut.
fn equipped(start: &str) -> String {
    let screw = "{ screw = { material = \"steel\", diameter = \"32 mm\", fixed_at = \"-400 mm\" } }";
    let drives = format!("[drives]\nfrequency = \"3 Hz\"\nx = {screw}\ny = {screw}");
    start.replace("[drives]", &drives) + "\n[cut]\nnormal_force = \"200 N\"\ntangential_force = \"120 N\"\n"
}

/// A plate bent between two pads, as a plane body.
const PLANE_PART: &str = "process = \"fixture\"\nmesh = { element_size = \"20 mm\" }\n\
    workpiece = { material = \"steel\", length = \"300 mm\", width = \"60 mm\", height = \"40 mm\" }\n\
    support = [{ at = \"20 mm\", width = \"10 mm\" }, { at = \"280 mm\", width = \"10 mm\" }]\n\
    clamp = [{ at = \"150 mm\", width = \"20 mm\", force = \"5 kN\" }]\nsweep = { positions = 11 }\n";

/// A joint of a robot behind gears, on which a torque acts: rigid but for what effects make of it.
const JOINT: &str = "process = \"rotary\"\naxis = { range = \"180 deg\" }\n\
    drive = { type = \"gears\", stages = [{ driving = 18, driven = 72 }, { driving = 20, driven = 100 }] }\n\
    test = { spacing = \"staggered\", torque = \"40 N*m\" }\n";

/// A rotary axis that lies, with a scale.
fn tilting(start: &str) -> String {
    start.replace("\"vertical\"", "\"horizontal\"") + "\n[scale]\nradius = \"60 mm\"\nlines = 9000\n"
}

/// What must act for an effect to be felt at all: surroundings that drift are felt through what loses heat, a new insert
/// by the wear of the old one, friction by what yields beside it.
fn beside(process: &dyn Process, effect: &Description) -> Vec<Active> {
    let through = match &*effect.name {
        "ambient-drift" => "convection",
        "insert-change" => "tool-wear",
        "headstock-friction" => "headstock-compliance",
        "tailstock-friction" => "tailstock-compliance",
        _ => "",
    };
    process.effects().into_iter().filter(|e| e.name == through).map(|e| e.typical()).collect()
}

/// The first model that admits an effect, without its own effects.
fn host<'a>(models: &'a [Model], effect: &Description) -> &'a Model {
    models.iter().find(|m| m.system.admits(&effect.name).is_ok()).unwrap()
}

fn predict(model: &Model, effects: &[Active]) -> Vec<f64> {
    model.system.with_effects(effects).predict(&Progress::default()).unwrap()
}

#[test]
fn a_neutral_effect_changes_nothing_and_a_plausible_one_something() {
    for process in ALL {
        let models = models(*process);
        for effect in &process.effects() {
            let model = host(&models, effect);
            let beside = beside(*process, effect);
            let with = |own: Active| predict(model, &[beside.clone(), vec![own]].concat());
            let without = predict(model, &beside);
            let (neutral, typical) = (with(effect.neutral()), with(effect.typical()));
            let size = without.iter().fold(1e-9f64, |m, v| m.max(v.abs()));
            let change = |other: &[f64]| without.iter().zip(other).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
            assert!(change(&neutral) <= 1e-12 * size, "{}: neutral changes {:e}", effect.name, change(&neutral));
            assert!(change(&typical) > 1e-8, "{}: a plausible one changes {:e} m", effect.name, change(&typical));
        }
    }
}

#[test]
fn effects_act_in_any_order() {
    for process in ALL {
        for model in models(*process) {
            let admitted = process.effects().into_iter().filter(|e| model.system.admits(&e.name).is_ok());
            let forward: Vec<Active> = admitted.map(|e| e.typical()).collect();
            let backward: Vec<Active> = forward.iter().rev().cloned().collect();
            let (a, b) = (predict(&model, &forward), predict(&model, &backward));
            for (a, b) in a.iter().zip(&b) {
                assert!((a - b).abs() <= 1e-12 * a.abs().max(1e-6), "{a} and {b}");
            }
        }
    }
}

#[test]
fn the_catalogue_is_complete_and_consistent() {
    for process in ALL {
        let effects = process.effects();
        let names: HashSet<&str> = effects.iter().map(|e| &*e.name).collect();
        assert_eq!(names.len(), effects.len(), "two effects share a name");
        for effect in &effects {
            assert!(effect.name.chars().all(|c| c.is_ascii_lowercase() || c == '-'), "{}", effect.name);
            for text in [&*effect.about, &*effect.law, effect.source] {
                assert!(!text.is_empty(), "{} leaves something unsaid", effect.name);
            }
            assert!(!effect.parameters.is_empty(), "{}", effect.name);
            for (other, difference) in effect.look_alikes {
                assert!(names.contains(other), "{} looks like {other}, which does not exist", effect.name);
                assert!(!difference.is_empty());
            }
            for p in &*effect.parameters {
                assert!(Unit::parse(&p.kind.unit).is_ok());
                assert!(p.range.0 < p.range.1, "{}.{}", effect.name, p.name);
                assert!(
                    p.example() >= p.range.0 && p.example() <= p.range.1,
                    "{}.{}: {}",
                    effect.name,
                    p.name,
                    p.example()
                );
                if let Neutral::Value(value) = p.neutral {
                    assert!(value.is_finite());
                }
            }
        }
    }
}

#[test]
fn starting_models_name_every_table_that_the_schema_requires() {
    let schema = fem::model::schema();
    for process in ALL {
        let shape = schema["oneOf"].as_array().unwrap().iter().find(|s| s["title"] == process.name()).unwrap();
        for key in shape["required"].as_array().unwrap() {
            let key = key.as_str().unwrap();
            let text = process.starting_model();
            assert!(text.contains(&format!("[{key}]")) || text.contains(&format!("{key} =")), "{key}");
        }
    }
}
