//! Reads the log of a machine.

use std::cell::RefCell;

use super::history::{History, Job, Measured, Part};
use crate::input::{InputError, Reader, Source, did_you_mean, read_tables};
use crate::measure::Measurements;
use crate::model::Model;
use crate::units::{MICRO, TIME};

/// Highest number of a part, of an insert and of a set-up.
const MOST: usize = 10_000_000;

impl History {
    /// Reads the log of a machine from its text; the models that it names are relative to the folder of its name.
    ///
    /// # Errors
    /// The log, a model that it names, or measurements in it are wrong; the error lists every problem with its place.
    pub fn parse(source: Source) -> Result<Self, InputError> {
        let remedy = "a log says what was done: offset = \"-3.2 um\"";
        let found = read_tables(&source, "a log", remedy, |reader, broken| read(reader, &source, broken))?;
        found.ok_or_else(|| InputError::new(source, Vec::new()))
    }
}

/// What an entry says of a part; what it leaves out is as before.
struct Said {
    number: usize,
    job: Option<usize>,
    offset: Option<f64>,
    insert: Option<usize>,
    set_up: Option<usize>,
    pause: f64,
}

fn read(reader: &Reader, source: &Source, broken: &RefCell<Option<InputError>>) -> Option<History> {
    let title = reader.text("title", "which machine it is, for people");
    let jobs = read_jobs(reader, broken);
    let names: Vec<&str> = jobs.iter().flatten().map(|job| &*job.name).collect();
    let parts = reader.list("part", "a part that was made", |t, _| read_part(t, "number", &names));
    let advised = reader.list("advised", "what was advised for a part to come", |t, _| read_part(t, "part", &names));
    let texts = reader.list("measured", "what was measured", |t, number| {
        let job = read_job(t, &names).unwrap_or(0);
        let rows = t.text("rows", "a measurement file: part,x [mm],diameter_error [um],u [um]");
        if rows.is_none() && !t.has("rows") {
            t.problem("", "nothing was measured here", "add rows, or leave the entry out");
        }
        (job, number, rows.unwrap_or_default())
    });
    let jobs: Vec<Job> = jobs.into_iter().collect::<Option<_>>()?;
    if !reader.is_sound() || jobs.is_empty() {
        return None;
    }
    let mut history =
        History { source: source.clone(), title, jobs, parts: Vec::new(), measured: Vec::new(), advised: None };
    for said in parts {
        let number = said.number;
        if history.parts.last().is_some_and(|last| last.number >= number) {
            reader.problem("part", format!("part {number} stands behind a later one, or twice"), "let parts rise");
            return None;
        }
        let part = said.after(&history);
        history.parts.push(part);
    }
    let last = history.parts.last().map_or(0, |part| part.number);
    history.advised = advised.into_iter().next_back().filter(|own| own.number > last).map(|own| own.after(&history));
    for (job, number, text) in texts {
        match measured(&history, source, job, number, text) {
            Ok(measured) => history.measured.push(measured),
            Err(error) => {
                broken.replace(Some(error));
                return None;
            }
        }
    }
    Some(history)
}

fn measured(
    history: &History,
    source: &Source,
    job: usize,
    number: usize,
    text: String,
) -> Result<Measured, InputError> {
    let name = format!("{}, [[measured]] number {}", source.name, number + 1);
    let own = &history.jobs[job];
    own.readings(job, &Measurements::parse(Source::new(name, text), &*own.model.process)?)
}

/// The one model, or those of several jobs.
fn read_jobs(reader: &Reader, broken: &RefCell<Option<InputError>>) -> Vec<Option<Job>> {
    let job =
        |name: String, model: Option<Model>| Job::new(name, model?).map_err(|error| broken.replace(Some(error))).ok();
    let about = "the model file of what is made";
    let several = reader.list("job", "one of several things that are made on the machine", |t, _| {
        let name = t.text("name", "its name in the log");
        if name.is_none() && !t.has("name") {
            t.problem("", "the job has no name", "add name = \"shaft\"");
        }
        job(name.unwrap_or_default(), Model::named(t, "model", about, broken))
    });
    match several.is_empty() {
        true => vec![job(String::new(), Model::named(reader, "model", about, broken))],
        false => several,
    }
}

fn read_job(t: &Reader, names: &[&str]) -> Option<usize> {
    let name = t.text("job", "which of the jobs")?;
    let found = names.iter().position(|own| *own == name);
    if found.is_none() {
        let help = match names {
            [""] => "there is one model, and no [[job]]: leave the key out".to_string(),
            _ => format!("{}there are {}", did_you_mean(&name, names.iter().copied(), '`'), names.join(", ")),
        };
        t.problem("job", format!("there is no job `{name}`"), help);
    }
    found
}

fn read_part(t: &Reader, number: &'static str, names: &[&str]) -> Said {
    t.text("when", "when it was made, for people");
    Said {
        number: t.count(number, "number of the part on the machine").between(1, MOST).required(),
        job: read_job(t, names),
        offset: t.quantity("offset", MICRO, "what was added to the programmed radius").optional(),
        insert: t.count("insert", "number of the insert").between(1, MOST).optional(),
        set_up: t.count("set_up", "number of the set-up").between(1, MOST).optional(),
        pause: t.quantity("pause", TIME, "how long the machine rested before it").not_negative().or(0.0),
    }
}

impl Said {
    fn after(self, history: &History) -> Part {
        let before = history.part(self.number);
        Part {
            number: self.number,
            job: self.job.unwrap_or(before.job),
            offset: self.offset.unwrap_or(before.offset),
            insert: self.insert.unwrap_or(before.insert),
            set_up: self.set_up.unwrap_or(before.set_up),
            pause: self.pause,
        }
    }
}
