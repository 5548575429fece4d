//! The folder of a study: rows that are appended, and found again after any end of the program.

use std::fs::{File, OpenOptions, TryLockError};
use std::io::{self, BufRead, BufReader, BufWriter, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use super::{layout, rows};
use crate::input::Problem;
use crate::output::OutputError;
use crate::output::files::{self, Guard};
use crate::study::{Layout, Shard, Summary};

/// Names of the rows, finished and not.
const ROWS: &str = "rows.csv";
const PARTIAL: &str = "rows.partial.csv";
/// Times after which rows are handed to the system, and to the disk.
const WRITTEN_AFTER: Duration = Duration::from_millis(20);
const SYNCED_AFTER: Duration = Duration::from_secs(5);

/// A folder that cannot be used.
#[derive(Debug)]
pub enum StudyError {
    /// What is there does not fit.
    Refused(Problem),
    /// It cannot be read or written.
    Output(OutputError),
}

impl From<OutputError> for StudyError {
    fn from(error: OutputError) -> Self {
        Self::Output(error)
    }
}

/// The folder of a study that is being done.
pub struct StudyFolder {
    directory: PathBuf,
    layout: Layout,
    jobs: Range<u64>,
    next: u64,
    /// Rows that are not finished; `None` where all are.
    out: Option<BufWriter<File>>,
    written: Instant,
    synced: Instant,
    /// Held as long as somebody works here.
    _lock: Option<File>,
}

impl StudyFolder {
    /// Opens or makes the folder, and finds how far an earlier program came; `restart` drops what it did.
    ///
    /// # Errors
    /// The rows there are of another plan or shard, another program works on them, files stand there that are of
    /// no study, or the folder cannot be written.
    pub fn open(
        directory: &Path,
        layout: &Layout,
        shard: Shard,
        restart: bool,
        reads: &[PathBuf],
    ) -> Result<Self, StudyError> {
        let at = |name: &str| directory.join(name);
        let failed = |name: &str| failed(&at(name));
        std::fs::create_dir_all(directory).map_err(failed(""))?;
        let lock = lock(directory)?;
        for name in [ROWS, PARTIAL, layout::FILE] {
            Guard { reads, force: true }.check(&at(name))?;
        }
        match known(directory) {
            None => {
                if let Some(name) = [ROWS, PARTIAL].into_iter().find(|name| at(name).exists()) {
                    return Err(OutputError::Exists { path: at(name) }.into());
                }
            }
            Some(_) if restart => {
                for name in [ROWS, PARTIAL].into_iter().filter(|name| at(name).exists()) {
                    std::fs::remove_file(at(name)).map_err(failed(name))?;
                }
            }
            Some(before) => fits(directory, &before, (layout, shard))?,
        }
        files::write(&at(layout::FILE), layout::text(layout, shard).as_bytes(), Guard { reads, force: true })?;
        let jobs = shard.jobs(layout);
        let now = Instant::now();
        let mut folder = Self {
            directory: directory.to_path_buf(),
            layout: layout.clone(),
            next: jobs.end,
            jobs,
            out: None,
            written: now,
            synced: now,
            _lock: lock,
        };
        if !at(ROWS).exists() {
            let resumed = resume(&at(PARTIAL), layout, folder.jobs.start).map_err(failed(PARTIAL))?;
            folder.next = resumed.1;
            folder.out = Some(BufWriter::with_capacity(1 << 16, resumed.0));
        }
        Ok(folder)
    }

    /// Number of the first job that is not done, from 0.
    pub fn next(&self) -> u64 {
        self.next
    }

    /// Its jobs, from 0.
    pub fn jobs(&self) -> Range<u64> {
        self.jobs.clone()
    }

    /// Appends the line of the next job.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn append(&mut self, line: &[u8]) -> Result<(), OutputError> {
        let failed = failed(&self.directory.join(PARTIAL));
        let Some(out) = &mut self.out else { return Ok(()) };
        out.write_all(line).map_err(&failed)?;
        self.next += 1;
        if self.written.elapsed() >= WRITTEN_AFTER {
            out.flush().map_err(&failed)?;
            self.written = Instant::now();
        }
        if self.synced.elapsed() >= SYNCED_AFTER {
            out.get_ref().sync_data().map_err(&failed)?;
            self.synced = Instant::now();
        }
        Ok(())
    }

    /// Ends the work: where all jobs are done, the rows take their name. Says what they say so far.
    ///
    /// # Errors
    /// The rows cannot be written or read.
    pub fn finish(mut self) -> Result<(PathBuf, Summary), OutputError> {
        let (rows, partial) = (self.directory.join(ROWS), self.directory.join(PARTIAL));
        let mut path = rows.clone();
        if let Some(mut out) = self.out.take() {
            let failed = failed(&partial);
            out.flush().and_then(|()| out.get_ref().sync_all()).map_err(&failed)?;
            drop(out);
            match self.next == self.jobs.end {
                true => std::fs::rename(&partial, &rows).map_err(&failed)?,
                false => path = partial,
            }
        }
        let summary = rows::summary(&path, &self.layout).map_err(failed(&path))?;
        Ok((path, summary))
    }
}

/// Layout and shard of the rows of a folder.
pub fn known(directory: &Path) -> Option<(Layout, Shard)> {
    layout::parse(&std::fs::read(directory.join(layout::FILE)).ok()?)
}

/// The finished rows of a folder, behind their header; `None` where they are not finished.
pub fn finished(directory: &Path) -> Option<(PathBuf, BufReader<File>)> {
    let path = directory.join(ROWS);
    let mut reader = BufReader::with_capacity(1 << 16, File::open(&path).ok()?);
    reader.read_until(b'\n', &mut Vec::new()).ok()?;
    Some((path, reader))
}

pub(super) fn failed(path: &Path) -> impl Fn(io::Error) -> OutputError + use<> {
    let path = path.to_path_buf();
    move |error| OutputError::File { path: path.clone(), error }
}

/// Refuses what was begun with another plan.
fn fits(directory: &Path, before: &(Layout, Shard), now: (&Layout, Shard)) -> Result<(), StudyError> {
    let refused = |message: String, help: &str| Err(StudyError::Refused(Problem::new(message).help(help)));
    let place = directory.display();
    let differences = before.0.differences(now.0);
    if !differences.is_empty() {
        let message = format!("the rows in {place} are of another plan: {}", differences.join("; "));
        return refused(message, "name another folder (-o, output=), or drop those rows (--restart, restart=True)");
    }
    if before.1 != now.1 {
        let message = format!("the rows in {place} are those of shard {}, not of {}", before.1, now.1);
        return refused(message, "name another folder (-o, output=)");
    }
    Ok(())
}

fn lock(directory: &Path) -> Result<Option<File>, StudyError> {
    // Where folders cannot be locked, nobody is kept off.
    let Ok(folder) = File::open(directory) else { return Ok(None) };
    match folder.try_lock() {
        Err(TryLockError::WouldBlock) => {
            let problem = Problem::new(format!("another program works on {}", directory.display()));
            Err(StudyError::Refused(problem.help("wait for it, or name another folder (-o, output=)")))
        }
        _ => Ok(Some(folder)),
    }
}

/// Opens unfinished rows behind the last whole one, which is that of the last job before the returned one; what is
/// torn behind it is cut off.
fn resume(path: &Path, layout: &Layout, first: u64) -> io::Result<(File, u64)> {
    let mut file = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path)?;
    let header = rows::header(layout);
    let mut reader = BufReader::with_capacity(1 << 16, &mut file);
    let mut line = Vec::new();
    reader.read_until(b'\n', &mut line)?;
    let (mut end, mut next) = (0, first);
    if line == header.as_bytes() {
        end = line.len() as u64;
        loop {
            line.clear();
            reader.read_until(b'\n', &mut line)?;
            if rows::job_of(&line) != Some(next + 1) {
                break;
            }
            end += line.len() as u64;
            next += 1;
        }
    }
    drop(reader);
    file.set_len(end)?;
    file.seek(SeekFrom::Start(end))?;
    if end == 0 {
        file.write_all(header.as_bytes())?;
    }
    Ok((file, next))
}
