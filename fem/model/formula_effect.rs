//! Reads a formula effect: `[effects.NAME]` with `formula = "…"` and its parameters.

use std::f64::consts::TAU;

use crate::formula::{self, Formula, FormulaError};
use crate::input::{Bounds, Name, Reader, did_you_mean};
use crate::process::{
    Absent, Active, Belongs, CHANGED, Coordinate, Description, EFFECTS, FormulaLaw, Meaning, Neutral, Odds, Parameter,
    Process, formula_effect,
};
use crate::units::{ANGLE, Dimension, Kind, NUMBER, Quantity, Unit, UnitSymbol, unit_text};

/// What stands in formulas for the prediction without them.
pub const PREDICTION: &str = "prediction";
/// Keys that are no parameters.
pub const WORDS: [&str; 2] = ["about", FORMULA];
/// Tables whose quantities are none of the machine.
const OF_EFFECTS: [&str; 3] = ["effects.", "measurement.", "odds."];
/// Key of the formula.
pub const FORMULA: &str = "formula";

/// Reads a formula effect of a model; `None`, with the problems noted, where it cannot be used.
pub fn read(name: &Name, (table, model): (&Reader, &Reader), process: &dyn Process) -> Option<Active> {
    let about = table.text("about", "what it is, for people").unwrap_or_else(|| "written in the model file".into());
    let text = table.text(FORMULA, "what is added to the observed value, over coordinates and parameters")?;
    let (mut parameters, mut values) = (Vec::new(), Vec::new());
    let is_change = |key: &str| key == CHANGED && table.has_table(CHANGED);
    for key in table.keys().into_iter().filter(|k| !WORDS.contains(&k.as_str()) && !is_change(k)) {
        let key = Name::from(key);
        if process.coordinates().iter().any(|c| c.name == key) {
            let message = format!("`{key}` is a coordinate of {}", process.name());
            table.problem(&key, message, "give the parameter another name");
        }
        if key == PREDICTION {
            let message = format!("`{key}` is what the model predicts without formulas");
            table.problem(&key, message, "give the parameter another name");
        }
        let Some(kind) = kind(table.written(&key)) else {
            let message = format!("the unit of `{key}` has more than {} bytes", UnitSymbol::LONGEST);
            table.problem(&key, message, "write it with fewer factors");
            table.accept_any();
            return None;
        };
        values.push(table.quantity(key.clone(), kind, "a parameter of the formula").required());
        parameters.push(parameter(key, kind));
    }
    let law = law(&text, &parameters, (process, model), |parameter| {
        table.problem(parameter, format!("`{parameter}` does not occur in the formula"), "use it, or leave it out");
    });
    match law {
        Ok(law) => {
            // A phase comes round: of its values the one within half a turn of zero is told.
            for (i, p) in parameters.iter_mut().enumerate() {
                let is_angle = p.kind.canonical().dimension == ANGLE.canonical().dimension;
                p.period = (is_angle && law.repeats_after(i, TAU)).then(|| p.kind.from_si(TAU));
            }
            let description = Description {
                table: EFFECTS,
                name: name.clone(),
                observable: None,
                about: about.into(),
                law: text.into(),
                source: "written in the model file",
                belongs: Belongs::Test,
                odds: Odds::of(1.0, "its author believes in it"),
                parameters: parameters.into(),
                look_alikes: &[],
                changes: None,
            };
            Some(Active { description, values, formula: Some(law.into()) })
        }
        Err(e) => {
            table.problem_within(FORMULA, e.span, e.message, e.help);
            None
        }
    }
}

/// Kind of a written quantity: whatever its unit measures; `None` where that is longer than any symbol.
pub(super) fn kind(written: Option<&str>) -> Option<Kind> {
    let unit = written.map_or("", unit_text).trim();
    match Unit::parse(unit) {
        Ok(_) if !unit.is_empty() => Some(Kind { name: "a quantity", unit: UnitSymbol::written(unit)?, usual: "1" }),
        _ => Some(NUMBER),
    }
}

/// Describes a parameter of which only the kind is known.
fn parameter(name: Name, kind: Kind) -> Parameter {
    Parameter {
        name,
        kind,
        about: "a parameter of the formula",
        neutral: Neutral::Shape,
        range: (f64::MIN, f64::MAX),
        bounds: Bounds::Any,
        default: None,
        needed_with: None,
        along: None,
        period: None,
        is_step: false,
        over: None,
    }
}

fn law(
    text: &str,
    parameters: &[Parameter],
    (process, model): (&dyn Process, &Reader),
    unused: impl Fn(&str),
) -> Result<FormulaLaw, FormulaError> {
    let formula = Formula::parse(text)?;
    let coordinates: Vec<&Coordinate> = process.coordinates().iter().collect();
    let (mut meanings, mut dimensions) = (Vec::new(), Vec::new());
    for name in &formula.names {
        let parameter = parameters.iter().position(|p| *p.name == *name.text);
        let coordinate = coordinates.iter().position(|c| *c.name == *name.text);
        let (meaning, dimension) = match (parameter, coordinate) {
            (Some(i), _) => (Meaning::Parameter(i), Some(parameters[i].kind.canonical().dimension)),
            (None, Some(i)) => {
                (of_coordinate(i, coordinates[i]), Some(formula_effect::dimension(&coordinates[i].holds)))
            }
            (None, None) if name.text == PREDICTION => (Meaning::Prediction, None),
            (None, None) if name.text.contains('.') => {
                let (kind, value) = of_model(model, name)?;
                (Meaning::Quantity(value), Some(kind.canonical().dimension))
            }
            (None, None) => {
                let known = || parameters.iter().map(|p| &*p.name).chain(coordinates.iter().map(|c| &*c.name));
                let meant = did_you_mean(&name.text, known(), '`');
                let message =
                    format!("`{}` is neither a coordinate of {} nor a parameter here", name.text, process.name());
                let listed = coordinates.iter().map(|c| &*c.name).collect::<Vec<_>>().join(", ");
                let help = format!(
                    "{meant}the coordinates are {listed}; a parameter is a key of this table, {0} = \"5 um\", a column \
                     that only files have is one of [recorded], {0} = \"20 degC\", and a quantity of another table has \
                     its path, table.key",
                    name.text
                );
                return Err(FormulaError { message, help, span: name.span.clone() });
            }
        };
        meanings.push(meaning);
        dimensions.push(dimension);
    }
    for (i, parameter) in parameters.iter().enumerate() {
        if !meanings.contains(&Meaning::Parameter(i)) {
            unused(&parameter.name);
        }
    }
    let observables = process.observables();
    // A row's own prediction is of what the formula gives.
    let given = |own: Dimension| {
        let of_names: Vec<Dimension> = dimensions.iter().map(|dimension| dimension.unwrap_or(own)).collect();
        formula.dimension(&of_names)
    };
    // Of an angle too, for it is a pure number where it is computed with.
    let mut own = observables.iter().map(|o| o.kind.canonical().dimension.without_angle());
    let dimension = match meanings.contains(&Meaning::Prediction) {
        true => own
            .clone()
            .find(|own| given(*own).is_ok_and(|dimension| dimension == *own))
            .map_or_else(|| given(own.next().unwrap_or(Dimension::NONE)), Ok)?,
        false => given(Dimension::NONE)?,
    };
    let adds_to: Vec<bool> =
        observables.iter().map(|o| o.kind.canonical().dimension.without_angle() == dimension).collect();
    if !adds_to.contains(&true) {
        let seen: Vec<String> = observables.iter().map(|o| format!("{} in {}", o.name, o.kind.unit)).collect();
        return Err(FormulaError {
            message: format!("the formula gives a quantity in {dimension}"),
            help: format!("{} observes {}: let it give that", process.name(), seen.join(" and ")),
            span: 0..text.len(),
        });
    }
    Ok(FormulaLaw::new(formula, meanings, adds_to))
}

/// Kind and value (SI) of the quantity of a model that a formula names by its path: one of the machine, for those of effects
/// differ from one set of effects to another.
fn of_model(model: &Reader, name: &formula::Name) -> Result<(Kind, f64), FormulaError> {
    let path = &*name.text;
    let refused = |message: String, help: String| FormulaError { message, help, span: name.span.clone() };
    let is_of_machine = |path: &str| path.contains('.') && OF_EFFECTS.iter().all(|table| !path.starts_with(table));
    let quantity = |path: &str| {
        let text = model.text_at(path)?;
        let kind = kind(Some(&text))?;
        let value = Quantity::parse(&text, &kind).ok()?.value;
        Some((kind, model.instead_at(path).unwrap_or(value)))
    };
    if !is_of_machine(path) {
        let help = "a formula takes its own parameters, and quantities of other tables, such as `workpiece.length`";
        return Err(refused(format!("`{path}` belongs to an effect"), help.into()));
    }
    quantity(path).ok_or_else(|| {
        let known: Vec<String> =
            model.paths().into_iter().filter(|own| is_of_machine(own) && quantity(own).is_some()).collect();
        let meant = did_you_mean(path, known.iter().map(String::as_str), '`');
        let help = format!("{meant}the quantities that stand in the model are {}", known.join(", "));
        refused(format!("`{path}` is no quantity that stands in the model"), help)
    })
}

/// The meaning of a coordinate in a formula.
fn of_coordinate(position: usize, own: &Coordinate) -> Meaning {
    match own.absent {
        Absent::Value(usual) if own.is_recorded => Meaning::Recorded(position, usual),
        _ => Meaning::Coordinate(position),
    }
}
