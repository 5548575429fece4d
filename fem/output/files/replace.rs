//! Putting a set of files into the place of another: a folder that is wholly the program's own in one step, where the
//! system can do that; into any other file by file, so that what belongs to others stays as it is.

use std::collections::{BTreeMap, BTreeSet};
use std::ffi::OsStr;
use std::io;
use std::path::{Path, PathBuf};

use cap_fs_ext::DirExt;
use cap_std::fs::{Dir, Metadata};

use super::account::digits;
use super::way::below;
use super::written::{Entry, LIST};

/// A file on its way into place.
pub struct Move {
    /// Name and content of the file.
    pub new: Entry,
    /// Present occupant of its place, which it replaces.
    pub over: Over,
}

/// Occupant of the place of a file.
pub enum Over {
    /// Nothing.
    Nothing,
    /// A file with this content.
    File(Entry),
    /// A link, which goes with what it names left as it is.
    Link,
}

impl Over {
    /// Looks up the occupant of a name in a folder; `None` where it is no file.
    pub fn at(folder: &Dir, name: &Path) -> Option<Self> {
        match below(folder, name, false).and_then(|(inside, name)| inside.symlink_metadata(name)) {
            Err(_) => Some(Self::Nothing),
            Ok(there) if there.is_symlink() => Some(Self::Link),
            Ok(_) => Entry::of_file(folder, name).map(Self::File),
        }
    }

    /// Whether two are the same.
    fn is_same(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Nothing, Self::Nothing) | (Self::Link, Self::Link) => true,
            (Self::File(a), Self::File(b)) => a.is_same(b),
            _ => false,
        }
    }
}

/// Changes to a folder: files that come, and files that go.
#[derive(Default)]
pub struct Plan {
    /// Files that come; the list of them is the last.
    pub moves: Vec<Move>,
    /// Files that go.
    pub leave: Vec<Entry>,
}

impl Plan {
    /// Moves files from the folder `new` into `folder`, one by one, and takes others away from there. What has been
    /// moved already is left where it is, and so is everything in `folder` that is not as the plan has it.
    ///
    /// # Errors
    /// Something else stands in a place, or it cannot be written; the rest has been done.
    pub fn carry_out(&self, new: &Dir, folder: &Dir) -> Result<(), (PathBuf, io::Error)> {
        self.try_folders(new, folder)?;
        let (mut result, mut is_stopped) = (Ok(()), false);
        for one in &self.moves {
            if let Err(error) = one.carry_out(new, folder) {
                // What somebody has put there meanwhile stays, and the rest goes on.
                is_stopped |= error.kind() != io::ErrorKind::AlreadyExists;
                result = Err((one.new.name.clone(), error));
            }
        }
        if is_stopped {
            return result;
        }
        for entry in self.leave.iter().filter(|entry| entry.is_untouched(folder)) {
            // What is left over does no harm.
            let _ = below(folder, &entry.name, false).and_then(|(inside, name)| inside.remove_file(name));
        }
        result
    }

    /// Moves an empty file into every folder that files come into, and away again: what cannot be moved there shows
    /// before anything is changed.
    fn try_folders(&self, new: &Dir, folder: &Dir) -> Result<(), (PathBuf, io::Error)> {
        let folders: BTreeSet<&Path> = self.moves.iter().filter_map(|one| one.new.name.parent()).collect();
        for inside in folders {
            let tried = || {
                let name = format!(".fem-{}", digits()?);
                let (to, _) = below(folder, &inside.join(&name), true)?;
                new.write(&name, "")?;
                new.rename(&name, &to, &name)?;
                to.remove_file(&name)
            };
            tried().map_err(|error| (inside.to_path_buf(), error))?;
        }
        Ok(())
    }
}

impl Move {
    fn carry_out(&self, new: &Dir, folder: &Dir) -> io::Result<()> {
        let path = &self.new.name;
        if Entry::of_file(new, path).is_none_or(|there| !there.is_same(&self.new)) {
            return Ok(());
        }
        let ((from, name), (to, _)) = (below(new, path, false)?, below(folder, path, true)?);
        // Nothing may have come there since it was looked at.
        if !Over::at(folder, path).is_some_and(|over| over.is_same(&self.over)) {
            return Err(io::ErrorKind::AlreadyExists.into());
        }
        if let (Over::File(_), Ok(there)) = (&self.over, to.symlink_metadata(name)) {
            take_group(&from, name, &there)?;
            from.set_permissions(name, there.permissions())?;
        }
        from.rename(name, &to, name)
    }
}

/// Whether a folder holds the files of `listed` and nothing else, all as they were written, and is itself as the program
/// makes folders: `new` is such a one, with its list.
pub fn is_wholly_own(folder: &Dir, listed: &BTreeMap<&Path, &Entry>, new: &Dir) -> bool {
    let (Ok(as_folder), Ok(as_file)) = (new.dir_metadata(), new.symlink_metadata(LIST)) else { return false };
    let is_own = |inside: &Path| {
        let is_listed = listed.get(inside).is_some_and(|entry| entry.is_untouched(folder));
        is_listed || inside == Path::new(LIST)
    };
    let mut open = vec![PathBuf::new()];
    let mut count = 0;
    while let Some(inside) = open.pop() {
        let here = if inside.as_os_str().is_empty() { folder.try_clone() } else { subfolder(folder, &inside) };
        let Ok(here) = here else { return false };
        let Ok(entries) = here.entries() else { return false };
        let mut is_empty = true;
        if !here.dir_metadata().is_ok_and(|about| is_alike(&about, &as_folder)) {
            return false;
        }
        for entry in entries {
            let Ok(entry) = entry else { return false };
            let (path, Ok(about)) = (inside.join(entry.file_name()), here.symlink_metadata(entry.file_name())) else {
                return false;
            };
            is_empty = false;
            match about.is_dir() {
                true => open.push(path),
                false if about.is_file() && is_alike(&about, &as_file) && is_own(&path) => count += 1,
                false => return false,
            }
        }
        if is_empty {
            return false;
        }
    }
    count == listed.len() + 1
}

fn subfolder(folder: &Dir, inside: &Path) -> io::Result<Dir> {
    let (above, name) = below(folder, inside, false)?;
    above.open_dir_nofollow(name)
}

/// Exchanges the folder `name` for `new`, which is called `hidden`, both of them in `above`; `stay` are the files that
/// stay from the old one. It is called `hidden` afterwards.
///
/// # Errors
/// The file system knows no links or no exchange; nothing has changed then but for links in `new`.
pub fn exchange(above: &Dir, name: &OsStr, hidden: &OsStr, stay: &[PathBuf]) -> io::Result<()> {
    let (old, new) = (above.open_dir_nofollow(name)?, above.open_dir_nofollow(hidden)?);
    for path in stay {
        let ((from, file), (to, _)) = (below(&old, path, false)?, below(&new, path, true)?);
        from.hard_link(file, &to, file)?;
    }
    swap(above, name, hidden)
}

/// Removes a folder that was exchanged: the files of the program, and folders that are empty then. What somebody put
/// there in the meantime goes into the `new` one if its name is free, and else stays.
pub fn dissolve(above: &Dir, hidden: &OsStr, own: &[PathBuf], new: &Dir) {
    let Ok(old) = above.open_dir_nofollow(hidden) else { return };
    for path in own {
        let _ = below(&old, path, false).and_then(|(inside, name)| inside.remove_file(name));
    }
    empty(&old, new);
    let _ = above.remove_dir(hidden);
}

fn empty(old: &Dir, new: &Dir) {
    for entry in old.entries().into_iter().flatten().flatten() {
        let name = entry.file_name();
        if let Ok(inside) = old.open_dir_nofollow(&name) {
            if let Ok(into) = new.open_dir_nofollow(&name) {
                empty(&inside, &into);
            }
            let _ = old.remove_dir(&name);
        }
        let is_there = old.symlink_metadata(&name).is_ok();
        if is_there && new.symlink_metadata(&name).is_err() {
            let _ = old.rename(&name, new, &name);
        }
    }
}

/// Gives a folder in `above` another name, under which nothing may stand.
///
/// # Errors
/// Something does, or the system refuses.
pub fn rename_new(above: &Dir, from: &OsStr, to: &OsStr) -> io::Result<()> {
    match rename_with(above, from, to, false) {
        // Not every file system can look and rename in one step.
        Err(error) if error.kind() != io::ErrorKind::AlreadyExists && above.symlink_metadata(to).is_err() => {
            above.rename(from, above, to)
        }
        done => done,
    }
}

fn swap(above: &Dir, a: &OsStr, b: &OsStr) -> io::Result<()> {
    rename_with(above, a, b, true)
}

#[cfg(any(target_os = "linux", target_vendor = "apple"))]
fn rename_with(above: &Dir, from: &OsStr, to: &OsStr, exchanges: bool) -> io::Result<()> {
    use rustix::fs::{RenameFlags, renameat_with};
    let flags = if exchanges { RenameFlags::EXCHANGE } else { RenameFlags::NOREPLACE };
    Ok(renameat_with(above, from, above, to, flags)?)
}

#[cfg(not(any(target_os = "linux", target_vendor = "apple")))]
fn rename_with(_: &Dir, _: &OsStr, _: &OsStr, _: bool) -> io::Result<()> {
    Err(io::ErrorKind::Unsupported.into())
}

/// Whether a program stands in a folder, as far as the system tells: it would be left in one that is gone.
pub fn is_stood_in(folder: &Path) -> bool {
    let is_within = |place: PathBuf| place.starts_with(folder);
    // Where the place of the program itself is not known, it may be anywhere.
    let own = std::env::current_dir().and_then(|place| place.canonicalize()).map_or(true, is_within);
    let processes = std::fs::read_dir("/proc").into_iter().flatten().flatten();
    own || processes.filter_map(|p| std::fs::read_link(p.path().join("cwd")).ok()).any(is_within)
}

/// Whether two have one owner, one group and one mode.
#[cfg(unix)]
pub fn is_alike(a: &Metadata, b: &Metadata) -> bool {
    use cap_std::fs::MetadataExt;
    (a.uid(), a.gid(), a.mode()) == (b.uid(), b.gid(), b.mode())
}

#[cfg(not(unix))]
pub fn is_alike(a: &Metadata, b: &Metadata) -> bool {
    a.permissions() == b.permissions()
}

/// Whether two belong to one owner.
#[cfg(unix)]
pub fn have_one_owner(a: &Metadata, b: &Metadata) -> bool {
    use cap_std::fs::MetadataExt;
    a.uid() == b.uid()
}

/// Gives a file the group of the one that it replaces: a folder may give new files another one.
#[cfg(unix)]
fn take_group(folder: &Dir, name: &OsStr, there: &Metadata) -> io::Result<()> {
    use cap_std::fs::MetadataExt;
    use rustix::fs::{AtFlags, Gid, chownat};
    if folder.symlink_metadata(name)?.gid() == there.gid() {
        return Ok(());
    }
    Ok(chownat(folder, name, None, Some(Gid::from_raw(there.gid())), AtFlags::SYMLINK_NOFOLLOW)?)
}

#[cfg(not(unix))]
fn take_group(_: &Dir, _: &OsStr, _: &Metadata) -> io::Result<()> {
    Ok(())
}

#[cfg(not(unix))]
pub fn have_one_owner(_: &Metadata, _: &Metadata) -> bool {
    true
}
