//! The measurements of a session: files are opened, explained, dropped on the page, and rows struck out.

use std::path::PathBuf;
use std::sync::Arc;

use serde_json::{Value as Json, json};

use super::bench::Bench;
use super::refusal::Refusal;
use super::session::Session;
use crate::measure::{Decimal, Measurements, Preview, Reading, open};
use crate::model::ModelProcess;
use crate::output::quoted;
use crate::process::Process;

/// Rows of a file up to which it is tried whether it fits the model.
const MANY: usize = 100_000;

/// A file whose first rows are asked for.
pub struct Previewed {
    name: String,
    path: PathBuf,
    process: Option<ModelProcess>,
    said: Reading,
}

impl Previewed {
    /// Reads them, and whether the file fits the model that is open.
    ///
    /// # Errors
    /// It is no table.
    pub fn read(&self) -> Result<Json, Refusal> {
        let said = &self.said;
        let file = open(&self.path, said)?;
        let own = Preview::of(&file, self.process.as_ref().map(|own| &**own as &dyn Process), said)?;
        let process = self.process.as_ref().filter(|_| own.count < MANY);
        let fits = process.map(|process| Measurements::of_file(&file, &**process, said).is_ok());
        Ok(json!({
            "file": self.name,
            "headings": own.headings,
            "meant": self.process.as_ref().map(|_| own.meant),
            "rows": own.rows,
            "lines": own.count,
            "sheets": file.sheets,
            "told": own.told,
            "fits": fits,
        }))
    }
}

impl Session {
    /// Opens files of measurements of the folder, to be read as `said`, or else as was said of them before.
    ///
    /// # Errors
    /// They are none, or do not fit the model.
    pub fn open_data(&mut self, names: &[String], said: Option<Reading>) -> Result<(), Refusal> {
        let mut next = self.now.clone();
        let stay = !next.files.is_empty() && next.files.iter().all(|own| names.contains(own));
        next.reading = said.unwrap_or_else(|| if stay { next.reading.clone() } else { Reading::default() });
        next.reading =
            std::mem::take(&mut next.reading).over(next.model.as_ref().map_or(&Reading::default(), |own| &own.reading));
        let Some(model) = &next.model else {
            return Err(Refusal::new("no model is open", "open the model first: it says what its measurements are"));
        };
        next.struck.clear();
        next.files = names.to_vec();
        (next.measured, next.diagnosed) = (None, None);
        if !names.is_empty() {
            let read = self.load(names, &*model.process, &next.reading)?;
            let model = model.with_recorded(&read.recorded)?;
            // What lies off the model is told now.
            let measured = Arc::new(read);
            Bench::data(&model, (*measured).clone(), &Arc::default())?;
            (next.model, next.measured) = (Some(model), Some(measured));
        }
        next.steps.clear();
        next.compare();
        next.note(next.file.clone());
        let command = (!names.is_empty()).then(|| format!("fem compare {} {}", quoted(&next.by_commands), next.with()));
        self.step("open measurements", command, next);
        Ok(())
    }

    /// How files are to be read, as `told::reading` tells it.
    ///
    /// # Errors
    /// There is no such mark, or a column is said to be two things.
    pub fn reading(said: &Json) -> Result<Reading, Refusal> {
        let decimal = match said["decimal"].as_str() {
            None => None,
            Some("comma") => Some(Decimal::Comma),
            Some("point") => Some(Decimal::Point),
            Some(other) => return Err(Refusal::new(format!("`{other}` is no decimal mark"), "say comma or point")),
        };
        let pair = |own: &Json| Some((own[0].as_str()?.to_string(), own[1].as_str()?.to_string()));
        let columns = said["columns"].as_array().into_iter().flatten().filter_map(pair).collect();
        let header = said["header"].as_u64().map(|line| usize::try_from(line).ok().filter(|line| *line > 0));
        let sheet = said["sheet"].as_str().filter(|name| !name.is_empty()).map(str::to_string);
        let as_typed = said["as_typed"].as_bool().unwrap_or(false);
        Ok(Reading::of_columns(columns, decimal)?.within(header, sheet).as_typed(as_typed))
    }

    /// Reads files of the folder; from now on they are looked at for changes.
    ///
    /// # Errors
    /// They are none, too large, or no measurements of the process.
    pub(super) fn load(
        &mut self,
        names: &[String],
        process: &dyn Process,
        said: &Reading,
    ) -> Result<Measurements, Refusal> {
        let paths = names.iter().map(|name| self.folder.measurements(name)).collect::<Result<Vec<_>, Refusal>>()?;
        for name in names {
            self.disk.is_other(self.folder.path(), name);
        }
        Ok(Measurements::load_all(&paths, process, said, false)?)
    }

    /// The first rows of a file of the folder as they stand there, to be read; its headings may be said to stand in a line,
    /// its table in a sheet.
    ///
    /// # Errors
    /// It is none, or too large.
    pub fn to_preview(&self, name: &str, said: Reading) -> Result<Previewed, Refusal> {
        let path = self.folder.measurements(name)?;
        let process = self.now.model.as_ref().map(|model| model.process.clone());
        Ok(Previewed { name: name.to_string(), path, process, said })
    }

    /// Stores a file that was dropped on the page, under a name that nothing has yet.
    ///
    /// # Errors
    /// It is no name of a file here, or it cannot be written.
    pub fn store(&mut self, name: &str, bytes: &[u8]) -> Result<String, Refusal> {
        // Dropped again it is the same file.
        if self.folder.file(name).is_ok_and(|path| std::fs::read(path).is_ok_and(|own| own == bytes)) {
            return Ok(name.to_string());
        }
        let (stem, ending) = name.rsplit_once('.').unwrap_or((name, "csv"));
        let free = self.folder.free(stem, ending);
        self.folder.write(&free, bytes, false)?;
        self.version += 1;
        Ok(free)
    }

    /// Strikes rows out by hand, or takes them in again.
    ///
    /// # Errors
    /// There is no such row, or none would be left.
    pub fn strike(&mut self, rows: &[usize], is_struck: bool) -> Result<(), Refusal> {
        let count = self.now.measured.as_ref().map_or(0, |own| own.len());
        if rows.iter().any(|row| *row >= count) {
            return Err(Refusal::new("there is no such row", "name rows of the measurements, from 0"));
        }
        let mut next = self.now.clone();
        for row in rows {
            if is_struck {
                next.struck.insert(*row)
            } else {
                next.struck.remove(row)
            };
        }
        if next.struck.len() == count {
            return Err(Refusal::new("no row would be left", "leave some of them in"));
        }
        next.diagnosed = None;
        next.compare();
        let label = if is_struck { "strike rows out" } else { "take rows in again" };
        // No command leaves rows out: who does the same has to know.
        let lines = self.now.measured.iter().flat_map(|all| next.struck.iter().map(|row| all.line(*row).to_string()));
        let lines: Vec<String> = lines.collect();
        let told = match lines.len() {
            0 => "# no line is struck out any more".to_string(),
            _ => format!("# struck out by hand, to be left out of the file: lines {}", lines.join(", ")),
        };
        self.step(label, Some(told), next);
        Ok(())
    }

    /// Stores rows that were measured, as a file of measurements beside those that are open.
    ///
    /// # Errors
    /// They are no measurements of the model.
    pub fn readings(&mut self, csv: &str) -> Result<(), Refusal> {
        let name = self.folder.free("readings", "csv");
        let path = self.folder.write(&name, csv.as_bytes(), false)?;
        let mut files = self.now.files.clone();
        files.push(name);
        self.open_data(&files, None).inspect_err(|_| {
            // It was ours, and holds nothing that the page has not.
            let _ = std::fs::remove_file(&path);
        })
    }
}
