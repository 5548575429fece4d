//! Reads `[[input]]` of a budget file: what varies in its models.

use super::{Input, ModelPart, Target};
use crate::budget::Law;
use crate::input::{Bounds, Reader, nearest};
use crate::units::{Kind, Knowledge};

/// Reads the inputs that are given, and adds what the models mark `+-` beside them. A quantity of one file varies
/// in all its figures at once.
pub fn read(reader: &Reader, parts: &[ModelPart]) -> Vec<Input> {
    let about = "what varies in the models, beside what they mark `+-`";
    let own = reader.list("input", about, |t, _| read_input(t, parts));
    let mut inputs: Vec<Input> = own.into_iter().flatten().collect();
    let given = inputs.len();
    for (number, part) in parts.iter().enumerate() {
        for (i, parameter) in part.model.parameters.iter().enumerate() {
            let Knowledge::Rough(std) = parameter.quantity.knowledge else { continue };
            let target = (number, Target::Parameter(i));
            if inputs[..given].iter().any(|input| input.targets.contains(&target)) {
                continue;
            }
            let is_of_file = |input: &&mut Input| {
                let (first, at) = input.targets[0];
                parts[first].model.source.name == part.model.source.name && at == Target::Parameter(i)
            };
            if let Some(known) = inputs[given..].iter_mut().find(is_of_file) {
                known.targets.push(target);
                continue;
            }
            inputs.push(Input {
                name: called(&parameter.path, number, parts),
                targets: vec![target],
                centre: parameter.quantity.value,
                half: Law::Normal.half_field(std),
                law: Law::Normal,
                bounds: parameter.bounds,
            });
        }
    }
    inputs
}

/// Name of a parameter: its path, with the file where another file has the same.
fn called(path: &str, number: usize, parts: &[ModelPart]) -> String {
    let file = &parts[number].model.source.name;
    let is_elsewhere = |part: &ModelPart| {
        part.model.source.name != *file && part.model.parameters.iter().any(|parameter| parameter.path == path)
    };
    if parts.iter().any(is_elsewhere) { format!("{file}: {path}") } else { path.to_string() }
}

fn read_input(t: &Reader, parts: &[ModelPart]) -> Option<Input> {
    let parameter = t.text("parameter", "path of a quantity that a model marks `+-`: effects.tool-wear.rate");
    let coordinate = t.text("coordinate", "a coordinate of the observed rows that varies: radial_force");
    let law = Law::read(t, "how it scatters", Law::Normal).unwrap_or(Law::Normal);
    let model = t.text("model", "the model in which it varies, by its name; all that have it if left out");
    let chosen: Vec<usize> =
        (0..parts.len()).filter(|i| model.as_ref().is_none_or(|name| parts[*i].name == *name)).collect();
    if let (Some(unknown), true) = (&model, chosen.is_empty()) {
        let names: Vec<&str> = parts.iter().map(|part| part.name.as_str()).collect();
        t.accept_any();
        t.problem(
            "model",
            format!("`{unknown}` is no model of this budget"),
            format!("known are {}", names.join(", ")),
        );
        return None;
    }
    match (parameter, coordinate) {
        (Some(path), None) => read_parameter(t, (parts, &chosen), &path, law),
        (None, Some(name)) => read_varying(t, (parts, &chosen), &name, law),
        _ => {
            t.accept_any();
            t.problem("", "an input is a parameter or a coordinate", "give one of `parameter` and `coordinate`");
            None
        }
    }
}

fn files(parts: &[ModelPart], chosen: &[usize]) -> String {
    let mut names: Vec<&str> = chosen.iter().map(|i| &*parts[*i].model.source.name).collect();
    names.dedup();
    names.join(" or ")
}

fn read_parameter(t: &Reader, (parts, chosen): (&[ModelPart], &[usize]), path: &str, law: Law) -> Option<Input> {
    let place = |i: &usize| parts[*i].model.parameters.iter().position(|p| p.path == path).map(|at| (*i, at));
    let found: Vec<(usize, usize)> = chosen.iter().filter_map(place).collect();
    let Some((first, at)) = found.first().copied() else {
        t.accept_any();
        let paths = chosen.iter().flat_map(|i| parts[*i].model.parameters.iter().map(|p| &*p.path));
        let meant = nearest(path, paths).map_or(String::new(), |near| format!("did you mean `{near}`? "));
        let message = format!("{} does not mark `{path}` as not exactly known", files(parts, chosen));
        t.problem("parameter", message, format!("{meant}write it there as \"60 +- 5 N/um\" is written"));
        return None;
    };
    let known = &parts[first].model.parameters[at];
    let Knowledge::Rough(std) = known.quantity.knowledge else { return None };
    if found.iter().any(|(i, at)| parts[*i].model.parameters[*at].quantity != known.quantity) {
        let help = "write one [[input]] for each, with `model`";
        t.problem("parameter", format!("the models know `{path}` differently"), help);
    }
    let about = "half of its field; from the model's `+-` if left out";
    let half = t.quantity("half_field", known.kind.difference(), about).not_negative().or(law.half_field(std));
    Some(Input {
        name: path.to_string(),
        targets: found.into_iter().map(|(i, at)| (i, Target::Parameter(at))).collect(),
        centre: known.quantity.value,
        half,
        law,
        bounds: known.bounds,
    })
}

fn read_varying(t: &Reader, (parts, chosen): (&[ModelPart], &[usize]), name: &str, law: Law) -> Option<Input> {
    let coordinates = |i: usize| parts[i].model.process.coordinates();
    let column = |i: usize| {
        let at = coordinates(i).iter().position(|c| c.name == name)?;
        Some((i, at, coordinates(i)[at].holds.kind()?))
    };
    let found: Vec<(usize, usize, Kind)> = chosen.iter().filter_map(|i| column(*i)).collect();
    let Some(&(first, at, kind)) = found.first() else {
        t.accept_any();
        let quantities = |i: &usize| coordinates(*i).iter().filter(|c| c.holds.kind().is_some()).map(|c| &*c.name);
        let mut listed: Vec<&str> = chosen.iter().flat_map(quantities).collect();
        listed.sort_unstable();
        listed.dedup();
        let mut processes: Vec<&str> = chosen.iter().map(|i| parts[*i].model.process.name()).collect();
        processes.dedup();
        let message = format!("`{name}` is no quantity under which `{}` is observed", processes.join("` or `"));
        t.problem("coordinate", message, format!("known are {}", listed.join(", ")));
        return None;
    };
    let usual = parts[first].model.system.resolved(&parts[first].rows).columns[at][0];
    let centre = t.quantity("value", kind, "middle of its field; the model's if left out").or(usual);
    let half = t.quantity("half_field", kind.difference(), "half of its field").not_negative().required();
    for &(i, at, _) in found.iter().filter(|_| t.is_sound()) {
        let wrong = [centre - half, centre + half].into_iter().find_map(|value| {
            let mut moved = parts[i].rows.clone();
            moved.columns[at].fill(value);
            parts[i].model.system.misplaced(&moved).into_iter().next()
        });
        if let Some(wrong) = wrong {
            t.problem("half_field", wrong.message, "narrow the field, or move its middle");
            break;
        }
    }
    // A quantity that is above zero all over its field is so beyond it too.
    let bounds = if centre - half >= 0.0 { Bounds::NotNegative } else { Bounds::Any };
    Some(Input {
        name: name.to_string(),
        targets: found.into_iter().map(|(i, at, _)| (i, Target::Coordinate(at))).collect(),
        centre,
        half,
        law,
        bounds,
    })
}
