//! Headings that say in words of which run, part or direction their columns are: `Lauf 2 vor [um]`, `Deviation 3`.

use super::heading::{Condition, Heading, plain};
use super::vocabulary::Vocabulary;
use super::{lexicon, words};
use crate::input::Problem;
use crate::process::Holds;
use crate::units::Unit;

/// Most words of which a name is made.
const LONGEST: usize = 4;

/// Reads a heading in any spelling, in words too.
///
/// # Errors
/// As of [`Heading::read`].
pub fn heading(cell: &str, vocabulary: Vocabulary, others: &[String]) -> Result<Heading, Problem> {
    let own = Heading::read(cell, vocabulary, others)?;
    Ok(read(&own, vocabulary).unwrap_or(own))
}

/// Reads a heading that as a whole is no column: the observable, by its name or by the only one that its unit measures, at
/// what the other words say. `None` where a word says nothing of the kind.
fn read(heading: &Heading, vocabulary: Vocabulary) -> Option<Heading> {
    let name = plain(&heading.name);
    let words: Vec<String> = name.split('_').flat_map(parted).collect();
    let mut found = Found { observable: None, at: Vec::new() };
    if heading.is_known || !found.take(&words, vocabulary) || found.at.is_empty() {
        return None;
    }
    let unit = Unit::parse(&heading.unit).ok().filter(|_| !heading.unit.is_empty());
    let observable = found.observable.or_else(|| {
        let measures =
            |i: &usize| Some(vocabulary.observables[*i].kind.canonical().dimension) == unit.map(|u| u.dimension);
        let mut all = (0..vocabulary.observables.len()).filter(measures);
        all.next().filter(|_| all.next().is_none())
    })?;
    let name = vocabulary.observables[observable].name.to_string();
    Some(Heading { name, at: found.at, is_known: true, ..heading.clone() })
}

/// A word and the number behind it: `lauf2` is run 2.
fn parted(word: &str) -> Vec<String> {
    let letters = word.trim_end_matches(|c: char| c.is_ascii_digit());
    let [name, number] = [letters, &word[letters.len()..]].map(str::to_string);
    [name, number].into_iter().filter(|part| !part.is_empty()).collect()
}

struct Found {
    observable: Option<usize>,
    at: Vec<Condition>,
}

impl Found {
    /// Takes words from the front until none is left; false where one says nothing.
    fn take(&mut self, words: &[String], vocabulary: Vocabulary) -> bool {
        if words.is_empty() {
            return true;
        }
        for count in (1..=words.len().min(LONGEST)).rev() {
            let (name, rest) = words.split_at(count);
            let name = name.join("_");
            let own = lexicon::meant(&name, vocabulary).map_or(name.clone(), str::to_string);
            if let Some(observable) = vocabulary.observables.iter().position(|o| o.name == *own) {
                let is_first = self.observable.replace(observable).is_none();
                return is_first && (self.numbered(rest, vocabulary) || self.take(rest, vocabulary));
            }
            if let (Some((number, rest)), Some(i)) = (rest.split_first(), numbers(&own, vocabulary))
                && number.parse::<u32>().is_ok()
            {
                return self.fix(i, number) && self.take(rest, vocabulary);
            }
            let word = vocabulary.coordinates.iter().enumerate().find_map(|(i, coordinate)| match &coordinate.holds {
                Holds::Word(all) => words::meant(&name.replace('_', " "), all).map(|word| (i, word)),
                _ => None,
            });
            if let Some((i, word)) = word.filter(|_| !name.chars().all(|c| c.is_ascii_digit())) {
                return self.fix(i, word) && self.take(rest, vocabulary);
            }
        }
        false
    }

    /// The number of a run behind the name of what is observed.
    fn numbered(&mut self, words: &[String], vocabulary: Vocabulary) -> bool {
        let Some((number, rest)) = words.split_first().filter(|(number, _)| number.parse::<u32>().is_ok()) else {
            return false;
        };
        numbers("run", vocabulary).is_some_and(|i| self.fix(i, number)) && self.take(rest, vocabulary)
    }

    fn fix(&mut self, coordinate: usize, value: &str) -> bool {
        let is_new = self.at.iter().all(|own| own.coordinate != coordinate);
        self.at.push(Condition { coordinate, value: value.to_string(), unit: String::new() });
        is_new
    }
}

/// The coordinate of a name, if it numbers something.
fn numbers(name: &str, vocabulary: Vocabulary) -> Option<usize> {
    let is_own = |coordinate: &crate::process::Coordinate| {
        coordinate.name == *name && matches!(coordinate.holds, Holds::Number(_))
    };
    vocabulary.coordinates.iter().position(is_own)
}
