//! The files of one command on their way into a folder.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use cap_fs_ext::{DirExt, MetadataExt};
use cap_std::fs::Dir;

use super::account::Account;
use super::beside::{Beside, is_ending, undisturbed};
use super::guard::Guard;
use super::replace::{self, Move, Over, Plan};
use super::way::{self, Way, below, reader};
use super::work;
use super::written::{self, Entry, LIST};
use crate::output::OutputError;

/// Files on their way into a directory: all of them appear in the place of the earlier ones, or none, none
/// over a file that was read, and without leave none over a file that the program did not write.
pub struct Stage<'a> {
    /// Where they appear, without links.
    directory: PathBuf,
    /// The folder in which the directory stands, and its name there; `None` of the root of all.
    above: Option<(Dir, OsString)>,
    guard: Guard<'a>,
    /// The command whose results these are.
    of: &'static str,
    account: Option<Account>,
    beside: Beside,
    /// Whether the hidden folder stands beside the directory, to take its place.
    is_beside: bool,
    files: Mutex<Vec<Entry>>,
}

/// Present and planned content of the directory.
struct Placing {
    plan: Plan,
    /// All that the program knows to be there.
    old: Vec<Entry>,
    /// Of these, the ones that stay.
    kept: Vec<PathBuf>,
}

impl<'a> Stage<'a> {
    /// Prepares the results of a command: makes what is missing above the directory, and a hidden folder for
    /// what is not finished.
    ///
    /// # Errors
    /// The directory cannot be made or written, or the way to it leads over a link that others may have put there.
    pub fn new(directory: &Path, of: &'static str, guard: Guard<'a>) -> Result<Self, OutputError> {
        let failed = OutputError::at(directory);
        let way = Way::to(directory, guard.reads)?;
        let account = work::account();
        let (path, above) = (way.path(), way.make_above().map_err(&failed)?);
        let into = if way.is_whole() { Some(way.make().map_err(&failed)?) } else { None };
        let mut beside = None;
        if let (Some((above, _)), Some(parent)) = (&above, path.parent()) {
            let is_own = into
                .as_ref()
                .is_none_or(|into| written::read(into, account.as_ref()).is_some() && is_one_device(into, above));
            beside = if is_own { Beside::new_in(above, parent, account.as_ref()).ok() } else { None };
            // A folder with a group or a mode of its own has its files made within it.
            beside = beside.filter(|beside| into.as_ref().is_none_or(|into| is_made_alike(beside.dir(), into)));
        }
        let is_beside = beside.is_some();
        let beside = match beside {
            Some(beside) => beside,
            None => Beside::new_in(&way.make().map_err(&failed)?, &path, account.as_ref()).map_err(&failed)?,
        };
        Ok(Self { directory: path, above, guard, of, account, beside, is_beside, files: Mutex::default() })
    }

    /// Writes a file that will stand at `name` in the directory.
    ///
    /// # Errors
    /// It is a file that was read, or it cannot be written.
    pub fn write(&self, name: &Path, bytes: &[u8]) -> Result<(), OutputError> {
        self.guard.check_reads(&self.directory.join(name))?;
        let failed = OutputError::at(&self.directory.join(name));
        if is_ending() {
            return Err(failed(std::io::ErrorKind::Interrupted.into()));
        }
        let (inside, file) = below(self.beside.dir(), name, true).map_err(&failed)?;
        inside.write(file, bytes).map_err(failed)?;
        let entry = Entry::new(name, self.of, bytes);
        self.files.lock().unwrap_or_else(PoisonError::into_inner).push(entry);
        Ok(())
    }

    /// Puts the files into place, and takes away what an earlier run of the same command left there.
    ///
    /// # Errors
    /// A file stands in the way that the program did not write; a place is taken by a directory, or cannot be
    /// written.
    pub fn publish(mut self) -> Result<(), OutputError> {
        loop {
            let Ok(into) = self.open() else {
                if self.appear()? {
                    return Ok(());
                }
                continue;
            };
            // One program at a time; whoever waited may find another folder under the name.
            let lock = reader(&into);
            // Where folders cannot be locked, nobody is kept off.
            let _ = lock.as_ref().map(|lock| lock.lock());
            if self.open().is_ok_and(|now| is_one(&now, &into)) {
                return self.place(&into);
            }
        }
    }

    /// The directory as it is now.
    fn open(&self) -> std::io::Result<Dir> {
        match &self.above {
            Some((above, name)) => above.open_dir_nofollow(name),
            None => way::open(&self.directory),
        }
    }

    /// Puts the folder where none was; `false` where another program has put one there in the meantime, whose files are
    /// to be looked at under lock.
    fn appear(&mut self) -> Result<bool, OutputError> {
        let failed = OutputError::at(&self.directory);
        let Some((above, name)) = &self.above else { return Ok(false) };
        if !self.is_beside {
            return above.create_dir(name).map(|()| false).map_err(failed);
        }
        self.list(self.files().iter())?;
        match replace::rename_new(above, self.beside.name(), name) {
            Ok(()) => Ok(true),
            Err(_) if above.open_dir_nofollow(name).is_ok() => Ok(false),
            Err(error) => Err(failed(error)),
        }
    }

    /// Puts the files into the place of others.
    fn place(&mut self, into: &Dir) -> Result<(), OutputError> {
        let placing = self.placing(into)?;
        let _undisturbed = undisturbed();
        if self.is_beside && self.exchange(into, &placing) {
            return Ok(());
        }
        if let Some(work) = self.beside.work() {
            // What cannot be noted is not brought to the end if it is interrupted.
            let _ = work.places(&self.directory, &placing.plan);
        }
        let done = placing.plan.carry_out(self.beside.dir(), into);
        done.map_err(|(path, error)| OutputError::at(&self.directory.join(path))(error))
    }

    /// Plans the changes to the directory, with the list of its content after them.
    fn placing(&self, into: &Dir) -> Result<Placing, OutputError> {
        let new = self.files();
        let names: BTreeSet<&PathBuf> = new.iter().map(|entry| &entry.name).collect();
        let known = written::read(into, self.account.as_ref());
        let is_own_list = known.is_some();
        let old = known.unwrap_or_default();
        let mut moves = Vec::new();
        for entry in &new {
            moves.push(Move { new: entry.clone(), over: self.over(entry, &old, into)? });
        }
        let is_stale = |e: &Entry| e.of == self.of && !names.contains(&e.name) && e.is_untouched(into);
        let (leave, kept): (Vec<Entry>, Vec<Entry>) = old.iter().cloned().partition(is_stale);
        let kept: Vec<Entry> = kept.into_iter().filter(|e| !names.contains(&e.name)).collect();
        if let Some(list) = self.list(kept.iter().chain(&new))? {
            let path = || self.directory.join(LIST);
            let over = match Over::at(into, &list.name) {
                Some(over) if matches!(over, Over::Nothing) || is_own_list || self.guard.force => over,
                Some(_) => return Err(OutputError::NotOwn { path: path() }),
                None => return Err(OutputError::Special { path: path() }),
            };
            moves.push(Move { new: list, over });
        }
        let kept = kept.into_iter().map(|entry| entry.name).collect();
        Ok(Placing { plan: Plan { moves, leave }, old, kept })
    }

    /// Exchanges the directory for the hidden one if nothing in it, and nobody, would be disturbed.
    fn exchange(&mut self, into: &Dir, placing: &Placing) -> bool {
        let Some((above, name)) = &self.above else { return false };
        let hidden = self.beside.name().to_os_string();
        let listed: BTreeMap<&Path, &Entry> = placing.old.iter().map(|e| (e.name.as_path(), e)).collect();
        let is_own = replace::is_wholly_own(into, &listed, self.beside.dir());
        if !is_own || replace::is_stood_in(&self.directory) {
            return false;
        }
        let is_done = replace::exchange(above, name, &hidden, &placing.kept).is_ok();
        if is_done {
            let own: Vec<PathBuf> = placing.old.iter().map(|e| e.name.clone()).chain([LIST.into()]).collect();
            replace::dissolve(above, &hidden, &own, self.beside.dir());
            self.beside.exchanged();
        }
        is_done
    }

    /// Looks up the occupant of a file's place; refuses one that is not known to be the program's own.
    fn over(&self, entry: &Entry, old: &[Entry], into: &Dir) -> Result<Over, OutputError> {
        let path = self.directory.join(&entry.name);
        let Ok((inside, name)) = below(into, &entry.name, false) else {
            return self.free(entry, into);
        };
        let Ok(there) = inside.symlink_metadata(name) else { return Ok(Over::Nothing) };
        if there.is_dir() {
            return Err(OutputError::at(&path)(std::io::ErrorKind::IsADirectory.into()));
        }
        if !there.is_file() && !there.is_symlink() {
            return Err(OutputError::Special { path });
        }
        let new = self.beside.dir().symlink_metadata(&entry.name);
        let is_own = |o: &Entry| o.name == entry.name && o.is_untouched(into);
        let is_own = old.iter().any(is_own) && new.is_ok_and(|new| replace::have_one_owner(&new, &there));
        if !self.guard.force && !is_own {
            return Err(OutputError::NotOwn { path });
        }
        Over::at(into, &entry.name).ok_or(OutputError::Special { path })
    }

    /// Refuses to make the folders of a file where something else than folders stands in their place.
    fn free(&self, entry: &Entry, into: &Dir) -> Result<Over, OutputError> {
        let mut inside = PathBuf::new();
        for part in entry.name.parent().into_iter().flatten() {
            inside.push(part);
            let path = self.directory.join(&inside);
            match below(into, &inside, false).and_then(|(above, name)| above.symlink_metadata(name)) {
                Ok(there) if there.is_symlink() => {
                    return Err(OutputError::Link { target: path.canonicalize().ok(), path });
                }
                Ok(there) if !there.is_dir() => {
                    return Err(OutputError::at(&path)(std::io::ErrorKind::NotADirectory.into()));
                }
                _ => {}
            }
        }
        Ok(Over::Nothing)
    }

    fn files(&self) -> Vec<Entry> {
        self.files.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Writes the list of these files, if there is a key to seal it with.
    fn list<'e>(&self, entries: impl Iterator<Item = &'e Entry>) -> Result<Option<Entry>, OutputError> {
        let Some(account) = &self.account else { return Ok(None) };
        let text = written::text(&entries.cloned().collect::<Vec<_>>(), account);
        self.beside.dir().write(LIST, &text).map_err(OutputError::at(&self.directory.join(LIST)))?;
        Ok(Some(Entry::new(Path::new(LIST), "", text.as_bytes())))
    }
}

/// Whether two folders have one owner, group and mode.
fn is_made_alike(a: &Dir, b: &Dir) -> bool {
    matches!((a.dir_metadata(), b.dir_metadata()), (Ok(a), Ok(b)) if replace::is_alike(&a, &b))
}

/// Whether two are one folder.
fn is_one(a: &Dir, b: &Dir) -> bool {
    let number = |dir: &Dir| dir.dir_metadata().map(|about| (about.dev(), about.ino()));
    matches!((number(a), number(b)), (Ok(a), Ok(b)) if a == b)
}

/// Whether two stand on one file system.
fn is_one_device(a: &Dir, b: &Dir) -> bool {
    matches!((a.dir_metadata(), b.dir_metadata()), (Ok(a), Ok(b)) if a.dev() == b.dev())
}
