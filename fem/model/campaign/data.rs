//! Measurements of several tests as those of one model.

use super::test::Campaign;
use crate::input::{InputError, Problem, Source, name_and_unit};
use crate::measure::{MeasuredFile, MeasuredObservable, Measurements};
use crate::model::{Data, Model};
use crate::noise::{Acts, Term};
use crate::process::{Rows, Values};

impl<'m> Data<'m> {
    /// Measurements of each of the tests that a model is made of, in their order.
    ///
    /// # Errors
    /// As those of [`Data::of`] for each test; or some tests have uncertainties and others have not, or one has a
    /// known covariance.
    pub fn of_tests(model: &'m Model, measured: Vec<Measurements>) -> Result<Self, InputError> {
        let Some(campaign) = model.campaign() else {
            let problem = Problem::new(format!("{} is a single test", model.source.name));
            return Err(InputError::one(model.source.clone(), problem.help("give it its own measurements")));
        };
        if measured.len() != campaign.tests.len() {
            let (tests, files) = (campaign.tests.len(), measured.len());
            let problem = Problem::new(format!("{tests} tests and the measurements of {files}"));
            return Err(InputError::one(model.source.clone(), problem.help("give each test its own")));
        }
        let name = measured.iter().map(|own| &*own.name).collect::<Vec<_>>().join(" and ");
        check(&name, &measured)?;
        let mut all = nothing(model, &name);
        let (mut terms, mut cautions) = (Vec::new(), Vec::new());
        for (test, measured) in measured.into_iter().enumerate() {
            let own = Data::of(&campaign.tests[test].model, measured)?;
            terms.extend(own.terms.iter().flat_map(|term| placed(campaign, test, term, &own, all.len())));
            cautions.extend(own.cautions.iter().cloned());
            let notes = own.notes_of_fit();
            all.notes.extend(notes.into_iter().map(|note| format!("{}: {note}", own.name)));
            append(&mut all, campaign, test, own.into_measurements());
        }
        if terms.iter().any(|term: &Term| term.covariance.is_some()) {
            let problem = Problem::new("a known covariance is that of one file, and these are several tests");
            let help = "leave [measurement.covariance] out, and give the rows a column u";
            return Err(InputError::one(model.source.clone(), problem.help(help)));
        }
        let mut data = Data::within(model, all);
        (data.cautions, data.terms) = (cautions, terms);
        Ok(data)
    }
}

/// Refuses tests of which some have uncertainties and some have not: the one would be weighed by what its
/// instrument can do, the other by what it scatters.
fn check(name: &str, measured: &[Measurements]) -> Result<(), InputError> {
    let (with, without): (Vec<_>, Vec<_>) = measured.iter().partition(|own| own.uncertainty.is_some());
    let (Some(with), Some(without)) = (with.first(), without.first()) else { return Ok(()) };
    let problem = Problem::new(format!("{} has a column u, and {} has none", with.name, without.name));
    let help = "give every test its uncertainties, or leave them out with --columns 'u=-'";
    Err(InputError::one(Source::new(name.to_string(), ""), problem.help(help)))
}

/// No rows yet, of no file.
fn nothing(model: &Model, name: &str) -> Measurements {
    let columns = vec![Values::default(); model.process.coordinates().len()];
    let planned = Measurements::planned(&*model.process, name, Rows { columns, observable: Values::default() });
    Measurements { files: Vec::new(), given: Vec::new(), ..planned }
}

/// Adds the rows of a test.
fn append(all: &mut Measurements, campaign: &Campaign, test: usize, own: Measurements) {
    let layout = &campaign.layout;
    let records = all.records_of.iter().max().map_or(0, |last| last + 1);
    let files = own.files.into_iter();
    all.files.extend(files.map(|file| MeasuredFile { first_record: file.first_record + records, ..file }));
    all.rows = all.rows.and(&layout.among_all(test, &own.rows));
    all.observed.extend(own.observed);
    if let Some(own) = own.uncertainty {
        all.uncertainty.get_or_insert_default().extend(own.iter().copied());
    }
    all.records_of.extend(own.records_of.iter().map(|record| record + records));
    all.lines.extend(own.lines.iter());
    for seen in own.observables {
        let position = layout.observable(test, seen.position);
        let name = layout.observables[position].name.clone();
        let unit = own.header.iter().find(|cell| name_and_unit(cell).0 == seen.name).map(|cell| name_and_unit(cell).1);
        all.header.push(format!("{name} [{}]", unit.unwrap_or_default()));
        all.observables.push(MeasuredObservable { position, name, ..seen });
    }
    let given: Vec<usize> = own.given.iter().map(|i| layout.coordinate(test, *i)).collect();
    all.given.extend(given.iter().copied().filter(|i| !all.given.contains(i)).collect::<Vec<_>>());
    // One set of options reads them all.
    all.said = own.said;
}

/// A term of a test on the rows of all, of which its own begin at `first`. What is said of no observable in
/// particular is said of each of the test's.
fn placed(campaign: &Campaign, test: usize, term: &Term, own: &Data, first: usize) -> Vec<Term> {
    let rows: Vec<usize> = term.rows.iter().map(|row| row + first).collect();
    let term = Term { rows, ..campaign.layout.term(test, &campaign.tests[test].name, term) };
    if term.observable.is_some() || matches!(term.effect.acts, Acts::Weighs) {
        return vec![term];
    }
    let observables = own.observables.iter().map(|seen| campaign.layout.observable(test, seen.position));
    observables.map(|observable| Term { observable: Some(observable), ..term.clone() }).collect()
}
