//! Which quantities of a model people estimate, so that a diagnosis may doubt them, and which are facts.

use fem::input::{Grows, Parameter, Source};
use fem::model::Model;
use fem::units::Knowledge;

/// Paths of the quantities of a model that people estimate, in alphabetical order.
fn estimated(text: &str) -> Vec<String> {
    let model = Model::parse(Source::new("model.toml", text)).unwrap_or_else(|error| panic!("{error}"));
    let all = model.quantities.iter().filter(|quantity| quantity.doubt.is_some());
    let mut paths: Vec<String> = all.map(|quantity| quantity.path.to_string()).collect();
    paths.sort();
    paths
}

#[test]
fn what_people_estimate_is_doubted_and_what_a_drawing_states_is_not() {
    let rod = r#"
process = "thermal"
[body]
material = { base = "steel", conductivity = "45 W/m/K", density = "7800 kg/m^3" }
segments = [{ length = "200 mm", diameter = "20 mm" }]
[[source]]
at = "200 mm"
power = "15 W"
[environment]
temperature = "0 degC"
[time]
end = "180 min"
"#;
    assert_eq!(estimated(rod), ["body.material.conductivity", "environment.temperature", "source[0].power"]);
    let shaft = r#"
process = "turning"
[workpiece]
material = "steel"
segments = [{ length = "500 mm", diameter = "40 mm" }]
[workholding]
type = "centres"
steady_rests = [{ at = "250 mm", stiffness = "40 N/um", offset = "10 um" }]
[tool]
overhang = "40 mm"
width = "25 mm"
height = "25 mm"
material = "steel"
[cut]
depth = "0.5 mm"
feed = "0.2 mm/rev"
spindle_speed = "600 rpm"
force = { C = 1250.0, x = 0.9, y = 0.75, n = 0.0, HB = 200.0 }
"#;
    let of_rest = ["workholding.steady_rests[0].offset", "workholding.steady_rests[0].stiffness"];
    assert_eq!(estimated(shaft), [&["cut.force.C", "tool.overhang"][..], &of_rest].concat());
}

/// A model to start from states nothing as known that people estimate.
#[test]
fn starting_models_state_no_estimate_as_a_fact() {
    for process in fem::processes::ALL {
        let source = Source::new("new.toml", process.starting_model());
        let model = Model::parse(source).unwrap_or_else(|error| panic!("{}: {error}", process.name()));
        let is_fact = |q: &&Parameter| q.quantity.knowledge == Knowledge::Known;
        let is_estimate = |q: &&Parameter| q.doubt.is_some() || q.path.starts_with("effects.");
        let facts = model.quantities.iter().filter(is_fact).filter(is_estimate);
        let facts: Vec<&str> = facts.map(|q| &*q.path).collect();
        assert!(facts.is_empty(), "{}: {facts:?}", process.name());
        model.require_values().unwrap_or_else(|error| panic!("{}: {error}", process.name()));
    }
}

/// Every doubt has odds below even ones, a usual error and a reason.
#[test]
fn doubts_are_reasonable() {
    for process in fem::processes::ALL {
        let model = Model::parse(Source::new("new.toml", process.starting_model())).unwrap_or_else(|e| panic!("{e}"));
        for (path, doubt) in model.quantities.iter().filter_map(|q| Some((&q.path, q.doubt?))) {
            assert!(doubt.odds > 0.0 && doubt.odds < 1.0 && !doubt.because.is_empty(), "{path}");
            assert!(doubt.off > if doubt.grows == Grows::Evenly { 0.0 } else { 1.0 }, "{path}");
        }
    }
}
