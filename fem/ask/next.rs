//! The next part of a machine, from its log and what was measured today.

use std::sync::Arc;

use toml_edit::Value;

use super::Error;
use crate::input::{InputError, Problem, Source, did_you_mean, name_and_unit};
use crate::measure::{Measurements, is_column};
use crate::next::{Entries, History, Measured, Next, Part, next};
use crate::process::Process;
use crate::progress::Progress;
use crate::units::{Kind, MICRO, TIME};

/// What happens before the next part.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Change {
    /// Another insert.
    pub insert: bool,
    /// Another set-up: the tool is measured or touched anew.
    pub set_up: bool,
    /// How long the machine rests, s.
    pub pause: f64,
    /// Another job, by its name.
    pub job: Option<String>,
}

/// The log of a machine, as it was read.
pub struct Log {
    /// The history that it tells.
    pub history: History,
    /// What is to be told of the log itself.
    pub notes: Vec<String>,
    entries: Entries,
    text: Arc<str>,
}

/// What is added to a log.
pub struct Added {
    /// Bytes of the log that stay.
    pub whole: usize,
    /// What comes behind them; empty where nothing is new.
    pub entry: String,
}

impl Log {
    /// Reads a log from its text.
    ///
    /// # Errors
    /// The log, or a model that it names, is wrong.
    pub fn read(name: &str, text: &[u8]) -> Result<Self, Error> {
        let text: Arc<str> = match std::str::from_utf8(text) {
            Ok(text) => text.into(),
            // Writing may have stopped within a letter: all before it is told apart as usual.
            Err(error) if error.error_len().is_none() => {
                String::from_utf8_lossy(&text[..error.valid_up_to()]).into_owned().into()
            }
            Err(_) => {
                let problem = Problem::new("this is no text").help("a log is TOML in UTF-8");
                return Err(InputError::one(Source::new(name, ""), problem).into());
            }
        };
        let entries = Entries::of(&text);
        let history = History::parse(Source::new(name, &text[..entries.bytes]))?;
        let torn = text.len() - entries.bytes;
        let torn = (torn > 0).then(|| {
            format!("{name}: the last entry was not written to its end ({torn} bytes); it is left out, and goes when the next is written")
        });
        let changed = (!entries.changed.is_empty()).then(|| {
            format!("{name}: somebody has changed entries since they were written: {}", entries.changed.join(", "))
        });
        Ok(Self { history, notes: torn.into_iter().chain(changed).collect(), entries, text })
    }

    /// A job by its name, or that of the parts to come.
    ///
    /// # Errors
    /// There is no such job.
    pub fn job(&self, name: Option<&str>) -> Result<usize, Error> {
        let Some(name) = name else { return Ok(self.history.part(self.history.last() + 1).job) };
        let names = || self.history.jobs.iter().map(|job| &*job.name);
        names().position(|own| own == name).ok_or_else(|| {
            let meant = did_you_mean(name, names(), '`');
            let help = match names().all(str::is_empty) {
                true => "it has one model, and no [[job]]".to_string(),
                false => format!("{meant}it has {}", names().collect::<Vec<_>>().join(", ")),
            };
            Problem::new(format!("the log has no job `{name}`")).help(help).into()
        })
    }

    /// The next part, once measurements of a job are added, which were made with an offset that was `applied` where it was not
    /// that which was advised; and what is to be added to the log for that.
    ///
    /// # Errors
    /// The measurements are none of parts of the job, there is no such job, or the model cannot be computed.
    pub fn next(
        &mut self,
        measured: Option<(usize, &Measurements)>,
        applied: Option<f64>,
        change: &Change,
        progress: &Progress,
    ) -> Result<(Next, Added), Error> {
        let advised = self.history.advised.clone();
        let (mut body, mut about) = match measured {
            Some((job, measurements)) => self.added(job, measurements, applied)?,
            None => (String::new(), Vec::new()),
        };
        let plan = self.plan(change)?;
        let found = rayon::scope(|_| next(&self.history, &plan, progress))?;
        // As they are written: what was read is rounded to that.
        let [was, is] =
            [advised.as_ref(), Some(&found.part)].map(|own| own.map(|part| self.told("advised", "part", part)));
        if was != is {
            about.push(format!("advice for part {}", found.part.number));
            body += &is.unwrap_or_default();
        }
        let entry = match body.is_empty() {
            true => String::new(),
            false => self.entries.next(&self.text, &about.join(", "), &body),
        };
        Ok((found, Added { whole: self.entries.bytes, entry }))
    }

    /// Adds measurements to the history, and tells the entry of what is new, and what it is about.
    fn added(
        &mut self,
        job: usize,
        measurements: &Measurements,
        applied: Option<f64>,
    ) -> Result<(String, Vec<String>), Error> {
        let readings = self.readings(job, measurements)?;
        let is_told = applied.is_some() || self.history.last() > 0 || self.history.advised.is_some();
        let (parts, rows) = self.history.add(readings, applied);
        let count = |number: usize| format!("{number} reading{}", if number == 1 { "" } else { "s" });
        let known = measurements.len() - rows.len();
        let name = measurements.name.replace(['\n', '\r'], " ");
        if known > 0 {
            self.notes.push(format!("{} of {name} stood in the log already", count(known)));
        }
        if !is_told && !parts.is_empty() {
            let note = "no offset was told for these parts: taken as 0, the programme as it stands (else: --applied)";
            self.notes.push(note.into());
        }
        if rows.is_empty() {
            return Ok((String::new(), Vec::new()));
        }
        let told: String = parts.iter().map(|part| self.told("part", "number", part)).collect();
        let body = told + &self.rows_of(job, measurements, &rows);
        Ok((body, vec![format!("{} of {name}", count(rows.len()))]))
    }

    /// The part that comes next.
    fn plan(&self, change: &Change) -> Result<Part, Error> {
        let last = self.history.part(self.history.last());
        let mut plan = self.history.part(self.history.last() + 1);
        if change.insert {
            plan.insert = last.insert + 1;
        }
        if change.set_up {
            plan.set_up = last.set_up + 1;
        }
        if change.pause > 0.0 {
            plan.pause = change.pause;
        }
        if let Some(name) = &change.job {
            plan.job = self.job(Some(name))?;
        }
        Ok(plan)
    }

    fn readings(&self, job: usize, measurements: &Measurements) -> Result<Measured, Error> {
        let own = &self.history.jobs[job];
        let refuse = |problem| Error::Data(InputError::one(Source::new(measurements.name.clone(), ""), problem));
        if !measurements.given.contains(&own.number) {
            let name = &own.model.process.coordinates()[own.number].name;
            let problem = Problem::new("the file does not tell which part was measured");
            return Err(refuse(problem.help(format!("add a column `{name}` with its number on the machine"))));
        }
        let readings = own.readings(job, measurements).map_err(Error::Data)?;
        let last = self.history.last();
        for row in 0..readings.errors.len() {
            let number = readings.number(own.number, row);
            let made = &self.history.jobs[self.history.part(number).job].name;
            if number <= last && *made != own.name {
                let message = format!("{}: part {number} is one of the job `{made}`", measurements.place(row));
                return Err(refuse(Problem::new(message).help(format!("name the job: --job {made}"))));
            }
        }
        Ok(readings)
    }

    /// A part as an entry tells it.
    fn told(&self, table: &str, number: &str, part: &Part) -> String {
        let Part { number: own, job, offset, insert, set_up, pause } = part;
        let job = match &*self.history.jobs[*job].name {
            "" => String::new(),
            name => format!("job = {}\n", Value::from(name)),
        };
        let pause = if *pause > 0.0 { format!("pause = \"{}\"\n", exact(&TIME, *pause)) } else { String::new() };
        let offset = exact(&MICRO, *offset);
        format!(
            "[[{table}]]\n{number} = {own}\n{job}offset = \"{offset}\"\ninsert = {insert}\nset_up = {set_up}\n{pause}\n"
        )
    }

    /// Rows of a file as an entry tells them: what the process knows of its columns.
    fn rows_of(&self, job: usize, measurements: &Measurements, rows: &[usize]) -> String {
        let own = &self.history.jobs[job];
        let process: &dyn Process = &*own.model.process;
        let header = &measurements.header;
        let kept: Vec<usize> = (0..header.len()).filter(|i| is_column(process, name_and_unit(&header[*i]).0)).collect();
        let mut text = line(kept.iter().map(|i| &*header[*i]));
        let mut reader = measurements.records.reader();
        for row in rows {
            let record = reader.read(measurements.record(*row) - 1);
            text += &line(kept.iter().map(|i| &record[*i]));
        }
        let job = if own.name.is_empty() { String::new() } else { format!("job = {}\n", Value::from(&*own.name)) };
        format!("[[measured]]\n{job}rows = \"\"\"\n{}\"\"\"\n\n", text.replace('\\', "\\\\").replace('"', "\\\""))
    }
}

/// A line of a file; cells with a comma are quoted.
fn line<'a>(cells: impl Iterator<Item = &'a str>) -> String {
    let cell = |cell: &'a str| match cell.contains([',', '"', '\n']) {
        true => format!("\"{}\"", cell.replace('"', "\"\"")),
        false => cell.to_string(),
    };
    cells.map(cell).collect::<Vec<_>>().join(",") + "\n"
}

/// A quantity as a log has it: nothing finer than a billionth of a unit is meant.
fn exact(kind: &Kind, si: f64) -> String {
    let rounded = (kind.from_si(si) * 1e9).round() / 1e9 + 0.0;
    format!("{rounded} {}", kind.unit)
}
