//! Several files of one process as one: rows of all in order, each of which knows its file and its line.

use std::path::Path;

use super::reading::{Reading, is_meant};
use super::recorded;
use super::records::Records;
use super::{MeasuredObservable, Measurements};
use crate::input::{InputError, Name, Problem, Source, name_and_unit};
use crate::process::Process;
use crate::units::Unit;

/// The file of a row as a grouping, where a coordinate's position could stand: a label that is no coordinate
/// of a process.
pub const FILE: usize = usize::MAX;

/// The word for [`FILE`].
pub const FILE_WORD: &str = "file";

/// A file and where its records begin among those of all.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredFile {
    /// Name as the user gave it.
    pub name: String,
    /// Number, from 0, of its first record.
    pub first_record: usize,
    /// SHA-256 of its bytes, as they were read.
    pub sha256: Option<[u8; 32]>,
}

/// Name of a coordinate by which rows are grouped.
pub fn grouping_name(process: &dyn Process, by: usize) -> Name {
    process.coordinates().get(by).map_or(FILE_WORD.into(), |coordinate| coordinate.name.clone())
}

impl Measurements {
    /// Reads files of measurements of `process`, or of planned rows, as one.
    ///
    /// # Errors
    /// A file is wrong, or files cannot stand together; the error says which and why.
    pub fn load_all<P: AsRef<Path>>(
        paths: &[P],
        process: &dyn Process,
        said: &Reading,
        is_design: bool,
    ) -> Result<Self, InputError> {
        let kept = Reading::default();
        let files: Vec<(&P, &dyn Process, &Reading)> = paths.iter().map(|path| (path, process, &kept)).collect();
        let files = Self::load_each(&files, said, is_design)?;
        let name = files.iter().map(|file| &*file.name).collect::<Vec<_>>().join(", ");
        Self::joined(files).map_err(|problem| InputError::one(Source::new(name, ""), problem))
    }

    /// Reads files of measurements, or of planned rows, each of its own process, read as its own model
    /// keeps it, and each by itself.
    ///
    /// # Errors
    /// A file is wrong, or named twice; none of them has a column of which something is said.
    pub fn load_each<P: AsRef<Path>>(
        files: &[(P, &dyn Process, &Reading)],
        said: &Reading,
        is_design: bool,
    ) -> Result<Vec<Self>, InputError> {
        let said = &said.of_several(files.len() > 1);
        // A file has many names, by different ways.
        let places: Vec<_> = files.iter().map(|(path, ..)| std::fs::canonicalize(path.as_ref())).collect();
        let load = |(path, process, kept): &(P, &dyn Process, &Reading)| {
            let said = said.clone().over(kept);
            match is_design {
                true => Self::load_design(path.as_ref(), *process, &said),
                false => Self::load_as(path.as_ref(), *process, &said),
            }
        };
        let files: Vec<Self> = files.iter().map(load).collect::<Result<_, _>>()?;
        let names: Vec<&str> = files.iter().map(|file| &*file.name).collect();
        let refuse = |problem| InputError::one(Source::new(names.join(", "), ""), problem);
        let is_again =
            |i: &usize| places[..*i].iter().flatten().any(|other| places[*i].as_ref().is_ok_and(|p| p == other));
        if let Some(again) = (0..places.len()).find(is_again) {
            return Err(refuse(twice(names[again])));
        }
        let is_nowhere = |from: &&str| files.iter().all(|f| f.headings.iter().all(|cell| !is_meant(from, cell)));
        if let Some(from) = said.names().find(is_nowhere) {
            let problem = Problem::new(format!("--columns: no file has a column `{from}`"));
            return Err(refuse(problem.help("name a heading as the file writes it")));
        }
        Ok(files)
    }

    /// Joins files, in their order.
    ///
    /// # Errors
    /// A file is named twice, some have uncertainties and some have not, or two hold the same observable under
    /// two names.
    pub fn joined(mut files: Vec<Self>) -> Result<Self, Problem> {
        check(&files)?;
        if files.len() > 1 {
            recorded::keep_shared(&mut files);
        }
        let mut files = files.into_iter();
        let Some(mut all) = files.next() else {
            return Err(Problem::new("there is no file").help("name one: --with DATA.csv"));
        };
        if files.len() > 0 {
            all.notes = named_notes(&all);
        }
        for file in files {
            all.append(file);
        }
        Ok(if all.is_planned() { all } else { all.without_copies_of_files() })
    }

    /// Adds the rows of a file that can stand with these.
    fn append(&mut self, file: Self) {
        self.notes.extend(named_notes(&file));
        self.name = format!("{}, {}", self.name, file.name);
        let before = self.records.len();
        let own = file.files.into_iter();
        self.files.extend(own.map(|f| MeasuredFile { first_record: f.first_record + before, ..f }));
        self.rows = self.rows.and(&file.rows);
        self.observed.extend(file.observed);
        if let (Some(all), Some(own)) = (&mut self.uncertainty, file.uncertainty) {
            all.extend(own.iter().copied());
        }
        self.records_of.extend(file.records_of.iter().map(|record| record + before));
        self.lines.extend(file.lines.iter());
        let is_new = |seen: &MeasuredObservable| self.observables.iter().all(|s| s.position != seen.position);
        let new: Vec<MeasuredObservable> = file.observables.into_iter().filter(is_new).collect();
        self.observables.extend(new);
        let new: Vec<usize> = file.given.into_iter().filter(|i| !self.given.contains(i)).collect();
        self.given.extend(new);
        self.align(&file.header, &file.records);
    }

    /// Adds records under the columns that are there already, in their units, and under new ones.
    fn align(&mut self, header: &[String], records: &Records) {
        let mut columns = Vec::new();
        for cell in header {
            let same = self.header.iter().position(|own| conversion(cell, own).is_some());
            columns.push(same.unwrap_or_else(|| {
                self.header.push(cell.clone());
                self.header.len() - 1
            }));
        }
        // Of several files, none is the text of all records.
        let mut all = Records::written("".into(), self.header.len());
        let mut reader = self.records.reader();
        for number in 0..self.records.len() {
            all.push_written(0, reader.read(number));
        }
        let mut reader = records.reader();
        for number in 0..records.len() {
            let mut cells = vec![String::new(); self.header.len()];
            for ((cell, own), column) in reader.read(number).iter().zip(header).zip(&columns) {
                let convert = conversion(own, &self.header[*column]).flatten();
                cells[*column] = match (convert, cell.parse::<f64>()) {
                    (Some([from, to]), Ok(value)) => {
                        let value = (value * from.factor + from.offset - to.offset) / to.factor;
                        // Round-off of the conversion is no digit of the file.
                        format!("{value:.14e}").parse().unwrap_or(value).to_string()
                    }
                    _ => cell.to_string(),
                };
            }
            all.push_written(0, cells);
        }
        self.records = all;
    }

    /// Name of the file of a record, counted from 0, where there are several.
    pub fn file_of_record(&self, record: usize) -> Option<&str> {
        let number = self.files.partition_point(|file| file.first_record <= record).saturating_sub(1);
        let own = (self.files.len() > 1).then(|| self.files.get(number));
        own.flatten().map(|file| &*file.name)
    }

    /// Number, among the files, of that in which a row stands.
    pub fn file_number(&self, row: usize) -> usize {
        let record = self.records_of.get(row).unwrap_or(0);
        self.files.partition_point(|file| file.first_record <= record).saturating_sub(1)
    }

    /// Name of the file of a row, where there are several.
    pub fn file_of(&self, row: usize) -> Option<&str> {
        self.file_of_record(self.records_of.get(row).unwrap_or(0))
    }

    /// Where a row stands, for people: `line 12`, and of several files `line 12 of b.csv`.
    pub fn place(&self, row: usize) -> String {
        let of = self.file_of(row).map_or(String::new(), |name| format!(" of {name}"));
        format!("line {}{of}", self.line(row))
    }
}

/// Whether files can stand together.
fn check(files: &[Measurements]) -> Result<(), Problem> {
    for (i, file) in files.iter().enumerate() {
        if files[..i].iter().any(|other| other.name == file.name) {
            return Err(twice(&file.name));
        }
    }
    let (with, without): (Vec<_>, Vec<_>) = files.iter().partition(|file| file.uncertainty.is_some());
    if let (Some(with), Some(without)) = (with.first(), without.first()) {
        let problem = Problem::new(format!("{} has a column u, and {} has none", with.name, without.name));
        return Err(problem.help("give every file its uncertainties, or leave them out with --columns 'u=-'"));
    }
    let mut seen: Vec<(&str, &MeasuredObservable)> = Vec::new();
    for file in files {
        for own in &file.observables {
            let same = |other: &&(&str, &MeasuredObservable)| {
                other.1.position != own.position && other.1.observable.is_instead_of(&own.observable)
            };
            if let Some((name, other)) = seen.iter().find(same) {
                let message = format!("{name} holds `{}`, and {} holds `{}`", other.name, file.name, own.name);
                return Err(Problem::new(message).help("they are two ways to tell the same: write one of them"));
            }
            seen.push((&file.name, own));
        }
    }
    Ok(())
}

fn twice(name: &str) -> Problem {
    Problem::new(format!("{name} is named twice")).help("its rows would count twice: name it once")
}

/// Notes of a file with its name.
fn named_notes(file: &Measurements) -> Vec<String> {
    file.notes.iter().map(|note| format!("{}: {note}", file.name)).collect()
}

/// Units in which two headings of one column are written, where they differ; `None` where the columns are
/// two.
fn conversion(cell: &str, own: &str) -> Option<Option<[Unit; 2]>> {
    if cell == own {
        return Some(None);
    }
    let ((name, from), (same, to)) = (name_and_unit(cell), name_and_unit(own));
    let units = Unit::parse(from).ok().zip(Unit::parse(to).ok());
    let alike = units.filter(|(from, to)| name == same && from.dimension == to.dimension);
    alike.map(|(from, to)| Some([from, to]))
}
