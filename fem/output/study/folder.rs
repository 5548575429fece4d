//! The folder of a study: rows that are appended, and found again after any end of the program.

use std::fs::{File, TryLockError};
use std::io::{self, BufRead, BufReader, BufWriter, Seek, SeekFrom, Write};
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use cap_std::fs::Dir;

use super::own::opened;
use super::sums::{self, Sums};
use super::{layout, rows};
use crate::input::Problem;
use crate::output::OutputError;
use crate::output::files::{self, Account, Guard, Way, read_plain, reader};
use crate::study::{Layout, Shard, Summary};

/// Names of the rows, finished and not.
const ROWS: &str = "rows.csv";
const PARTIAL: &str = "rows.partial.csv";
/// Files from which a finished study is read.
pub(super) const FILES: [&str; 2] = [ROWS, layout::FILE];
/// Times after which rows are handed to the system, and to the disk.
const WRITTEN_AFTER: Duration = Duration::from_millis(20);
const SYNCED_AFTER: Duration = Duration::from_secs(5);

/// A folder that cannot be used.
#[derive(Debug)]
pub enum StudyError {
    /// The folder's content does not fit.
    Refused(Problem),
    /// It cannot be read or written.
    Output(OutputError),
}

impl From<OutputError> for StudyError {
    fn from(error: OutputError) -> Self {
        Self::Output(error)
    }
}

/// Treatment of rows that stand in a folder already.
#[derive(Clone, Copy, Debug, Default)]
pub struct Earlier {
    /// They are dropped, instead of gone on with.
    pub restart: bool,
    /// Also where this account has not begun them.
    pub force: bool,
}

/// The folder of a study that is being done.
pub struct StudyFolder {
    directory: PathBuf,
    /// The folder that stood there when the work began.
    dir: Dir,
    layout: Layout,
    jobs: Range<u64>,
    next: u64,
    /// Rows that are not finished; `None` where all are.
    out: Option<(BufWriter<File>, sums::Writer)>,
    /// Number of the first job, from 1, whose row was not as it was written, where one was not.
    altered: Option<u64>,
    written: Instant,
    synced: Instant,
    /// Held as long as somebody works here.
    _lock: Option<File>,
}

impl StudyFolder {
    /// Opens or makes the folder, and finds how far an earlier program came.
    ///
    /// # Errors
    /// The rows there are of another plan or shard, another program works on them, files stand there that are of
    /// no study or that this account has not begun, or the folder cannot be written.
    pub fn open(
        directory: &Path,
        layout: &Layout,
        shard: Shard,
        earlier: Earlier,
        reads: &[PathBuf],
    ) -> Result<Self, StudyError> {
        let at = |name: &str| directory.join(name);
        let failed = |name: &str| OutputError::at(&at(name));
        let dir = Way::to(directory, reads)?.make().map_err(failed(""))?;
        let lock = lock(&dir, directory)?;
        for name in [ROWS, PARTIAL, layout::FILE, sums::FILE] {
            Guard { reads, force: true }.check(&at(name))?;
        }
        let account = Account::open().ok();
        let stands = |name: &&&str| stands_in(&dir, name);
        let is_file = |name: &str| dir.symlink_metadata(name).is_ok_and(|about| about.is_file());
        if let Some(name) = [ROWS, PARTIAL].iter().find(|name| stands_in(&dir, name) && !is_file(name)) {
            return Err(OutputError::Special { path: at(name) }.into());
        }
        let text = read_plain(&dir, Path::new(layout::FILE), layout::LONGEST).unwrap_or_default();
        let is_own = earlier.force || account.as_ref().is_some_and(|account| layout::is_own(&text, account));
        match layout::parse(&text).filter(|_| is_own) {
            None => {
                if let Some(name) = [ROWS, PARTIAL, layout::FILE].iter().find(stands) {
                    let there = at(name).display().to_string();
                    let problem = match layout::parse(&text) {
                        Some(_) => Problem::new(format!("{there} is there already, and was not begun on this account"))
                            .help("name another folder (-o, output=), or go on with it all the same (--force)"),
                        None => {
                            let (plan, help) =
                                (layout::FILE, "name another folder (-o, output=), or take the file away");
                            Problem::new(format!(
                                "{there} is there already, and no {plan} beside it says of which plan"
                            ))
                            .help(help)
                        }
                    };
                    return Err(StudyError::Refused(problem));
                }
            }
            Some(_) if earlier.restart => {
                for name in [ROWS, PARTIAL, sums::FILE].iter().filter(|name| stands(name)) {
                    dir.remove_file(name).map_err(failed(name))?;
                }
            }
            Some(before) => {
                fits(directory, &before, (layout, shard))?;
                if has_lost_sums(&dir, &text) {
                    let help = "have all rows computed again (--restart, restart=True)";
                    return Err(StudyError::Refused(lost_sums(directory).help(help)));
                }
            }
        }
        // Rows of an earlier version that are finished have no sums, and get none.
        let has_sums = layout::has_sums(&text) || !stands_in(&dir, ROWS);
        let begun = layout::text(layout, shard, has_sums, account.as_ref());
        files::write(&at(layout::FILE), begun.as_bytes(), Guard { reads, force: true })?;
        let jobs = shard.jobs(layout);
        let now = Instant::now();
        let mut folder = Self {
            directory: directory.to_path_buf(),
            dir,
            layout: layout.clone(),
            next: jobs.end,
            jobs,
            out: None,
            altered: None,
            written: now,
            synced: now,
            _lock: lock,
        };
        if !stands_in(&folder.dir, ROWS) {
            let resumed = resume(&folder.dir, layout, folder.jobs.start).map_err(failed(PARTIAL))?;
            (folder.next, folder.altered) = (resumed.next, resumed.altered);
            folder.out = Some((BufWriter::with_capacity(1 << 16, resumed.file), resumed.sums));
        } else if let Some(job) = altered(directory, &folder.dir, folder.jobs.start).map_err(failed(ROWS))? {
            let message = format!("row {job} in {} is not as it was written", at(ROWS).display());
            let help = "put the file back as it was, or have all rows computed again (--restart, restart=True)";
            return Err(StudyError::Refused(Problem::new(message).help(help)));
        }
        Ok(folder)
    }

    /// Number of the first job that is not done, from 0.
    pub fn next(&self) -> u64 {
        self.next
    }

    /// Number of the first job, from 1, whose unfinished row was not as it was written: it is computed again, with all behind it.
    pub fn altered(&self) -> Option<u64> {
        self.altered
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
        let failed = OutputError::at(&self.directory.join(PARTIAL));
        let Some((out, sums)) = &mut self.out else { return Ok(()) };
        // What does not fit into the buffer goes on to the file, and its sum has to be there.
        if out.buffer().len() + line.len() > out.capacity() {
            sums.flush().map_err(&failed)?;
        }
        out.write_all(line).and_then(|()| sums.add(line)).map_err(&failed)?;
        self.next += 1;
        if self.written.elapsed() >= WRITTEN_AFTER {
            sums.flush().and_then(|()| out.flush()).map_err(&failed)?;
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
        if let Some((mut out, mut sums)) = self.out.take() {
            let failed = OutputError::at(&partial);
            sums.flush().and_then(|()| out.flush()).and_then(|()| out.get_ref().sync_all()).map_err(&failed)?;
            drop(out);
            match self.next == self.jobs.end {
                true if stands_in(&self.dir, ROWS) => return Err(OutputError::Exists { path: rows }),
                true => self.dir.rename(PARTIAL, &self.dir, ROWS).map_err(&failed)?,
                false => path = partial,
            }
        }
        let summary = rows::summary(&path, &self.layout).map_err(OutputError::at(&path))?;
        Ok((path, summary))
    }
}

/// Layout and shard of the rows of a folder.
pub fn known(directory: &Path) -> Option<(Layout, Shard)> {
    let path = directory.join(layout::FILE);
    let is_sound = |about: &std::fs::Metadata| about.is_file() && about.len() <= layout::LONGEST;
    layout::parse(&std::fs::read(path.symlink_metadata().ok().filter(is_sound).map(|_| path)?).ok()?)
}

/// The finished rows of a folder, behind their header; `None` where they are not finished.
pub fn finished(directory: &Path) -> Option<(PathBuf, BufReader<File>)> {
    let path = directory.join(ROWS);
    // A pipe would be waited for.
    let path = path.symlink_metadata().is_ok_and(|about| about.is_file()).then_some(path)?;
    let mut reader = BufReader::with_capacity(1 << 16, File::open(&path).ok()?);
    reader.read_until(b'\n', &mut Vec::new()).ok()?;
    Some((path, reader))
}

/// Number of the first job of a finished folder, from 1, whose row is not as it was written; `first` is that of the first, from 0.
///
/// # Errors
/// The rows cannot be read.
pub fn altered(directory: &Path, dir: &Dir, first: u64) -> io::Result<Option<u64>> {
    let Some((_, reader)) = finished(directory) else { return Ok(None) };
    Ok(Sums::of(dir).first_altered(reader)?.map(|number| first + number + 1))
}

/// Whether the rows of a folder had sums, by the text of its layout, and have none any more.
fn has_lost_sums(dir: &Dir, text: &[u8]) -> bool {
    let has_rows = || [ROWS, PARTIAL].iter().any(|name| stands_in(dir, name));
    layout::has_sums(text) && has_rows() && !stands_in(dir, sums::FILE)
}

fn lost_sums(directory: &Path) -> Problem {
    let place = directory.join(sums::FILE);
    Problem::new(format!("{} is gone: nothing tells whether the rows are as they were written", place.display()))
}

/// The problem of finished rows whose sums are gone.
pub fn without_sums(directory: &Path, dir: &Dir) -> Option<Problem> {
    let text = read_plain(dir, Path::new(layout::FILE), layout::LONGEST).unwrap_or_default();
    has_lost_sums(dir, &text).then(|| lost_sums(directory))
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

/// Whether anything stands in a folder under a name.
fn stands_in(dir: &Dir, name: &str) -> bool {
    dir.symlink_metadata(name).is_ok()
}

fn lock(dir: &Dir, directory: &Path) -> Result<Option<File>, StudyError> {
    // Where folders cannot be locked, nobody is kept off.
    let Some(folder) = reader(dir) else { return Ok(None) };
    match folder.try_lock() {
        Err(TryLockError::WouldBlock) => {
            let problem = Problem::new(format!("another program works on {}", directory.display()));
            Err(StudyError::Refused(problem.help("wait for it, or name another folder (-o, output=)")))
        }
        _ => Ok(Some(folder)),
    }
}

/// Unfinished rows, to be gone on with.
struct Resumed {
    file: File,
    sums: sums::Writer,
    /// Number of the first job that is not done, from 0.
    next: u64,
    /// Number of the first job, from 1, whose row was not as it was written.
    altered: Option<u64>,
}

/// Opens unfinished rows behind the last whole one that is as it was written, which is that of the last job before the next one;
/// what stands behind it is cut off.
fn resume(dir: &Dir, layout: &Layout, first: u64) -> io::Result<Resumed> {
    let mut file = opened(dir, PARTIAL, true)?;
    let header = rows::header(layout);
    let mut reader = BufReader::with_capacity(1 << 16, &mut file);
    let mut line = Vec::new();
    reader.read_until(b'\n', &mut line)?;
    let (mut end, mut next, mut altered) = (0, first, None);
    let mut sums = Sums::of(dir);
    if line == header.as_bytes() {
        end = line.len() as u64;
        loop {
            line.clear();
            reader.read_until(b'\n', &mut line)?;
            if rows::job_of(&line) != Some(next + 1) {
                break;
            }
            if !sums.has(&line) {
                altered = Some(next + 1);
                break;
            }
            end += line.len() as u64;
            next += 1;
        }
    }
    drop(reader);
    // What does not begin as rows do is not torn rows, but somebody's.
    if end == 0 && !line.is_empty() && !header.as_bytes().starts_with(&line) {
        return Err(io::Error::new(io::ErrorKind::AlreadyExists, "it does not begin as the rows of this study do"));
    }
    file.set_len(end)?;
    file.seek(SeekFrom::Start(header.len() as u64))?;
    let sums = sums::Writer::behind(dir, next - first, BufReader::new(&mut file))?;
    file.seek(SeekFrom::Start(end))?;
    if end == 0 {
        file.write_all(header.as_bytes())?;
    }
    Ok(Resumed { file, sums, next, altered })
}
