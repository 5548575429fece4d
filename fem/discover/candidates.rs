//! Laws that somebody has in mind: formulas with ranges in a file, priced in the same search as those of the grammar.

use std::path::{Path, PathBuf};

use nalgebra::DVector;

use super::fitted::{self, Ranked};
use super::law::{Written, quantity};
use super::search::{Bench, Found, PREDICTION, Term};
use super::shape::Shape;
use super::variable::{Factor, Variable};
use crate::fit::{Objective, Solution, StoppingCriterion};
use crate::formula::Formula;
use crate::input::{InputError, Parameter, Problem, Reader, Source, read_tables};
use crate::model::{Data, Model, add_effect};
use crate::units::{NUMBER, Unit, unit_text};

/// Largest file of candidates, bytes.
const LARGEST: u64 = 1_000_000;
/// Places in a range from which a search begins, and places of all ranges of a candidate.
const PLACES: usize = 5;
const MOST_PLACES: usize = 60;
/// Part of a range by which a value may lie beyond its ends: what is written is rounded.
const BEYOND: f64 = 0.005;

/// Why a candidate without any prediction is none.
const NOWHERE: &str = "it cannot be computed in these rows";

/// A law that somebody has in mind.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// Its name, which the effect has.
    pub name: String,
    /// The file that has it.
    pub file: PathBuf,
    written: Written,
    ranges: Vec<Range>,
}

/// A range within which a parameter is sought.
#[derive(Clone, Debug, PartialEq)]
struct Range {
    key: String,
    /// Its ends as they are written, and their unit.
    ends: [f64; 2],
    unit: String,
}

/// What a candidate came to.
#[derive(Clone, Debug, PartialEq)]
pub struct Tried {
    /// Its name.
    pub name: String,
    /// χ² over the degrees of freedom with it, or why it was left out.
    pub result: Result<f64, String>,
}

/// Reads the candidates of files, and of all files of folders whose names end in `.toml`.
///
/// # Errors
/// A file cannot be read or is wrong, or two candidates have one name.
pub fn read_candidates(paths: &[PathBuf]) -> Result<Vec<Candidate>, InputError> {
    let mut all: Vec<Candidate> = Vec::new();
    for path in paths {
        for file in files(path)? {
            let source = Source::read(&file, LARGEST)?;
            let found = read_tables(&source, "a file of candidates", "", |reader, _| read(reader, &file))?;
            for own in found {
                if let Some(other) = all.iter().find(|other| other.name == own.name) {
                    let message = format!("`{}` is a candidate in {} already", own.name, other.file.display());
                    return Err(InputError::one(source, Problem::new(message).help("give one of them another name")));
                }
                all.push(own);
            }
        }
    }
    Ok(all)
}

/// The files of a path: itself, or those of a folder, by name.
fn files(path: &Path) -> Result<Vec<PathBuf>, InputError> {
    if !path.is_dir() {
        return Ok(vec![path.to_path_buf()]);
    }
    let fail = |message: String| {
        let problem = Problem::new(message).help("name a file, or a folder of files whose names end in .toml");
        InputError::one(Source::new(path.display().to_string(), String::new()), problem)
    };
    let entries = std::fs::read_dir(path).map_err(|error| fail(format!("{}: {error}", path.display())))?;
    let mut all: Vec<PathBuf> = entries.filter_map(|entry| Some(entry.ok()?.path())).collect();
    all.retain(|file| file.extension().is_some_and(|own| own == "toml") && file.is_file());
    all.sort();
    if all.is_empty() {
        return Err(fail(format!("the folder {} has no file of candidates", path.display())));
    }
    Ok(all)
}

fn read(reader: &Reader, file: &Path) -> Vec<Candidate> {
    let one = |name: String| {
        reader.table(name.clone(), "a law", |table| {
            let formula = table.text("formula", "what is added to the observed value");
            if formula.is_none() && !table.has("formula") {
                table.problem("formula", "a candidate is a formula", "write formula = \"a*load\" with a = \"? um/kg\"");
            }
            let about = table.text("about", "what it is, for people");
            let (mut settings, mut ranges) = (Vec::new(), Vec::new());
            for key in table.keys().into_iter().filter(|key| key != "formula" && key != "about") {
                let Some(text) = table.text_or_number(key.clone(), "a parameter of the formula") else { continue };
                match range(&key, &text) {
                    Some(Ok(range)) => {
                        settings.push((key, range.near(0.5)));
                        ranges.push(range);
                    }
                    Some(Err(message)) => {
                        table.problem(&key, message, "write a range as \"0.5 to 3\" or \"80 to 120 mm\"")
                    }
                    None => settings.push((key, text)),
                }
            }
            let written = Written { formula: formula?, amplitudes: Vec::new(), about, settings };
            Some(Candidate { name, file: file.to_path_buf(), written, ranges })
        })
    };
    reader.keys().into_iter().filter_map(one).collect()
}

/// A range, if a text is one.
fn range(key: &str, text: &str) -> Option<Result<Range, String>> {
    let (low, rest) = text.split_once(" to ")?;
    let unit = unit_text(rest).trim().to_string();
    let high = rest.trim().strip_suffix(&unit).unwrap_or(rest);
    let ends = [low, high].map(|end| end.trim().parse::<f64>().ok().filter(|end| end.is_finite()));
    let [Some(low), Some(high)] = ends else {
        return Some(Err(format!("`{key}`: \"{text}\" is no range")));
    };
    if low >= high {
        return Some(Err(format!("`{key}`: the range \"{text}\" has no extent")));
    }
    if !unit.is_empty() && Unit::parse(&unit).is_err() {
        return Some(Err(format!("`{key}`: `{unit}` is no unit")));
    }
    Some(Ok(Range { key: key.into(), ends: [low, high], unit }))
}

impl Range {
    /// The value at a part of it, as an unknown from which a search begins; ranges of ratios are divided by ratios.
    fn near(&self, part: f64) -> String {
        let [low, high] = self.ends;
        let value =
            if low > 0.0 && high > 3.0 * low { low * (high / low).powf(part) } else { low + part * (high - low) };
        format!("? near {value} {}", self.unit).trim_end().into()
    }

    fn has(&self, value: f64) -> bool {
        let [low, high] = self.ends;
        let beyond = BEYOND * (high - low);
        (low - beyond..=high + beyond).contains(&value)
    }

    fn text(&self) -> String {
        format!("{} to {} {}", self.ends[0], self.ends[1], self.unit).trim_end().into()
    }
}

impl Candidate {
    /// Whether a fit of it, under a name, ends within its ranges; else which of them it leaves.
    fn admits(&self, name: &str, with: &Objective, position: &DVector<f64>) -> Result<(), String> {
        for range in &self.ranges {
            let is_own = |p: &Parameter| fitted::is_parameter_of(name, p) && p.path.key() == range.key;
            let Some(i) = with.parameters.iter().position(is_own) else { continue };
            let kind = with.parameters[i].kind;
            let found = kind.from_si(with.variables[i].value(position[i]));
            if !range.has(found) {
                let at = quantity(found, kind);
                return Err(format!("{} fits best at {at}, beyond {}", range.key, range.text()));
            }
        }
        Ok(())
    }

    /// The law with its search beginning at each of some places in its ranges.
    fn starts(&self) -> Vec<Written> {
        let ways = PLACES.pow(self.ranges.len().min(8) as u32);
        let every = ways.div_ceil(MOST_PLACES);
        let at = |way: usize| {
            let mut written = self.written.clone();
            let mut rest = way;
            for range in &self.ranges {
                let part = (rest % PLACES) as f64 / (PLACES - 1) as f64;
                rest /= PLACES;
                let own = written.settings.iter_mut().find(|(key, _)| *key == range.key);
                own.into_iter().for_each(|(_, value)| *value = range.near(part));
            }
            written
        };
        (0..ways).step_by(every).map(at).collect()
    }
}

/// The law of a candidate beside the model, and what it adds to the rows as a variable of its own; or why it is none.
pub fn ranked(
    start: (&Objective, &Solution),
    bench: &Bench,
    (candidate, of): (&Candidate, usize),
    number: usize,
) -> Result<(Ranked, Variable), String> {
    let objective = start.0;
    let name = fitted::free_name(objective.data.model, &candidate.name);
    let Settled { written, open, position, chi2 } = settled(start, candidate, &name)?;
    let own = objective.data.beside(&open).map_err(|error| error.to_string())?;
    let with = Objective::new(&own).map_err(|error| error.message)?;
    candidate.admits(&name, &with, &position)?;
    let added = added((objective, &start.1.position), (&with, &position)).ok_or(NOWHERE)?;
    let (observable, variable) = variable(&name, &written, bench, (objective.data, &added))?;
    let freedom = with.parameters.iter().filter(|p| fitted::is_parameter_of(&name, p)).count();
    let is_of_prediction = variable.made_of.iter().any(|v| bench.variables[*v].is_prediction);
    let price = bench.price(freedom, (of as f64).ln()) + if is_of_prediction { PREDICTION } else { 0.0 };
    let factor =
        Factor { variable: number, other: None, shape: Shape::Proportional, constants: Vec::new(), is_known: true };
    let terms = vec![Term { observable, factors: vec![factor] }];
    let criterion = bench.misfit(chi2) + price;
    let found = Found { terms, gain: bench.residual.norm_squared() - chi2, freedom, criterion, price };
    let mut variables: Vec<String> = variable.made_of.iter().map(|v| bench.variables[*v].name.to_string()).collect();
    variables.sort();
    let ranked = Ranked {
        name,
        observable,
        written,
        variables,
        is_candidate: true,
        criterion,
        found,
        open,
        apart: None,
        position,
    };
    Ok((ranked, variable))
}

/// A candidate whose constants are found.
struct Settled {
    written: Written,
    open: Model,
    position: DVector<f64>,
    chi2: f64,
}

/// A candidate, under a name, where its fit ends from the best of its starts.
fn settled(
    (objective, solution): (&Objective, &Solution),
    candidate: &Candidate,
    name: &str,
) -> Result<Settled, String> {
    let model = objective.data.model;
    add_effect(model, name, &candidate.written.open()).map_err(|problem| problem.message.clone())?;
    let drafts = candidate.starts().into_iter().filter_map(|written| {
        let open = add_effect(model, name, &written.open()).ok()?;
        let (position, chi2) = fitted::begun((objective, solution), &open)?;
        Some(Settled { written, open, position, chi2 })
    });
    let best = drafts.min_by(|a, b| a.chi2.total_cmp(&b.chi2)).ok_or(NOWHERE)?;
    let start = |_: &Objective| best.position.clone();
    let (position, chi2) = fitted::descended(objective, &best.open, start, StoppingCriterion::FULL).ok_or(NOWHERE)?;
    Ok(Settled { position, chi2, ..best })
}

/// The observable on which a candidate acts, and what it adds to the rows as a variable.
fn variable(
    name: &str,
    written: &Written,
    bench: &Bench,
    (data, added): (&Data, &[f64]),
) -> Result<(usize, Variable), String> {
    let is_of = |o: &usize| (0..data.len()).any(|row| data.rows.observable[row] == *o && added[row] != 0.0);
    let mut observables = bench.metrics.iter().map(|own| own.0);
    let observable = observables.find(is_of).ok_or("it adds nothing to these rows")?;
    let names = Formula::parse(&written.formula).map_err(|error| error.message)?.names;
    let is_named = |own: &Variable| names.iter().any(|name| *name.text == *own.name);
    let made_of: Vec<usize> = (0..bench.variables.len()).filter(|v| is_named(&bench.variables[*v])).collect();
    let factor = data.model.process.observables()[observable].error_kind().canonical().factor;
    let column = added.iter().map(|si| si / factor).collect();
    let variable = Variable::new(name.to_string().into(), NUMBER, 0, column).ok_or("it is the same in all rows")?;
    Ok((observable, Variable { made_of, ..variable }))
}

/// What a law adds to every row at the end of a search, SI.
fn added(
    (without, here): (&Objective, &DVector<f64>),
    (with, position): (&Objective, &DVector<f64>),
) -> Option<Vec<f64>> {
    let of = |(i, p): (usize, &Parameter)| {
        let known = with.parameters.iter().position(|other| other.path == p.path);
        known.map_or(here[i], |at| position[at])
    };
    let alone = DVector::from_iterator(without.variables.len(), without.parameters.iter().enumerate().map(of));
    let (with, without) = (with.predict(position)?, without.predict(&alone)?);
    Some(with.iter().zip(&without).map(|(with, without)| with - without).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_are_read_with_their_unit() {
        let read = |text: &str| range("p", text).map(|own| own.map(|own| (own.ends, own.unit)));
        assert_eq!(read("1 to 3"), Some(Ok(([1.0, 3.0], String::new()))));
        assert_eq!(read("-1e-3 to 0.5 um/K"), Some(Ok(([-1e-3, 0.5], "um/K".into()))));
        assert_eq!(read("? um"), None);
        for wrong in ["3 to 1", "one to three", "1 to 2 parsecs", "1 to inf mm"] {
            assert!(matches!(read(wrong), Some(Err(_))), "{wrong}");
        }
    }

    #[test]
    fn a_range_of_ratios_is_divided_by_ratios() {
        let range = Range { key: "p".into(), ends: [1.0, 100.0], unit: "mm".into() };
        assert_eq!([0.0, 0.5, 1.0].map(|part| range.near(part)), ["? near 1 mm", "? near 10 mm", "? near 100 mm"]);
    }
}
